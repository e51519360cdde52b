// Shapes of a case as files for other programs.
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "runner/cli/commands.hpp"
#include "runner/cli/resolve.hpp"
#include "runner/render/shape_files.hpp"
#include "runner/study/shown_value.hpp"
#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// "x_0007.vtp" in the folder of "x.pvd".
fs::path file_beside(const fs::path& collection, std::size_t index) {
  char number[16];
  std::snprintf(number, sizeof number, "_%04zu", index);
  return collection.parent_path() / (collection.stem().string() + number + ".vtp");
}

void save_shape(Client& client, const std::string& path, const ordered_json& kt, const std::string& format,
                const fs::path& file) {
  write_atomically(file, client.get_file(path, {{"format", format}, {"kt", shown_value(kt)}}));
}

/// All shapes, each in a file of its own, with an index for ParaView.
void save_collection(Client& client, const std::string& path, const ordered_json& times,
                     const fs::path& collection) {
  std::vector<TimeAndFile> files;
  for (const ordered_json& kt : times) {
    const fs::path file = file_beside(collection, files.size());
    save_shape(client, path, kt, "vtp", file);
    files.push_back({kt, file.filename()});
  }
  write_atomically(collection, as_pvd(files));
}

/// The last recorded time, or the one nearest to the time that was asked for.
ordered_json recorded_time(const ordered_json& times, const std::optional<double>& wanted) {
  if (!wanted) return times.back();
  return *std::ranges::min_element(
      times, {}, [&](const ordered_json& kt) { return std::abs(kt.get<double>() - *wanted); });
}

std::string extension_of(const std::string& file) {
  const std::string extension = fs::path(file).extension();
  for (const char* known : {".vtp", ".stl", ".obj", ".pvd"})
    if (extension == known) return extension.substr(1);
  throw std::invalid_argument("--out must end in .vtp, .stl, .obj or .pvd: \"" + file + "\"");
}

}  // namespace

int save_shapes(const ShapeArguments& arguments) {
  const std::string format = extension_of(arguments.out);
  if (format == "pvd" && arguments.kt)
    throw std::invalid_argument("a collection (.pvd) holds all times: leave out --kt");
  Client client(arguments.server);
  const std::string path = path_of_any(client, arguments.id) + "/shapes";
  if (path.starts_with("/v1/studies/"))
    throw std::invalid_argument("a shape is of a case; capstan results lists those of a study");
  const ordered_json times = client.get(path)["kt"];
  if (times.empty())
    throw std::invalid_argument(
        "the case has recorded no shapes; \"outputs\": {\"shapes_every\": 0.5} in a "
        "case or a study records one each kt = 0.5");
  if (format == "pvd") {
    save_collection(client, path, times, arguments.out);
    std::cout << times.size() << " shapes\n";
    return kExitDone;
  }
  const ordered_json kt = recorded_time(times, arguments.kt);
  save_shape(client, path, kt, format, arguments.out);
  std::cout << "the shape at kt = " << shown_value(kt) << ", of " << times.size() << " that are recorded\n";
  return kExitDone;
}

}  // namespace capstan
