#include "solver/run_directory/recorded_shapes.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <mutex>
#include <optional>
#include <string_view>

#include "solver/run_directory/hdf5_file.hpp"

namespace capstan {
namespace {

std::mutex& hdf5_lock() {
  static std::mutex lock;
  return lock;
}

/// Removes all up to the end of the first `mark` from the text; false if there is none.
bool skip_past(std::string_view mark, std::string_view& text) {
  const std::size_t place = text.find(mark);
  if (place == std::string_view::npos) return false;
  text.remove_prefix(place + mark.size());
  return true;
}

template <class Number>
std::optional<Number> number_at_the_start_of(std::string_view text) {
  Number number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc() ? std::optional(number) : std::nullopt;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::vector<RecordedShape> recorded_shapes(const RunDirectory& run) {
  const std::string index = text_of(run.shape_index_file());
  std::string_view rest = index;
  std::vector<RecordedShape> shapes;
  while (skip_past("<Time Value=\"", rest)) {
    const auto kt = number_at_the_start_of<double>(rest);
    const bool has_positions = skip_past("<Geometry", rest) && skip_past(">shapes/", rest);
    const auto number = number_at_the_start_of<int>(rest);
    if (kt && has_positions && number) shapes.push_back({*kt, *number});
  }
  return shapes;
}

ShapeArrays read_shape(const RunDirectory& run, const RecordedShape& shape) {
  const std::lock_guard lock(hdf5_lock());
  const Hdf5Reader file(run.frame_file(shape.number));
  const std::vector<std::string> names = file.names();
  ShapeArrays arrays{file.read("positions"), file.read("velocities"), file.read("forces"), {}};
  if (std::ranges::count(names, "stretches") > 0) arrays.stretches = file.read("stretches");
  return arrays;
}

std::vector<int> read_triangles(const RunDirectory& run) {
  const std::lock_guard lock(hdf5_lock());
  const std::vector<double> vertices = Hdf5Reader(run.mesh_file()).read("faces");
  return {vertices.begin(), vertices.end()};
}

}  // namespace capstan
