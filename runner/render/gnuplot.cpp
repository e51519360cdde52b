#include "runner/render/gnuplot.hpp"

#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <map>
#include <stdexcept>

#include "solver/case/shown_number.hpp"
#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::string>& terminals() {
  static const std::map<std::string, std::string> by_extension = {
      {".pdf", "pdfcairo"}, {".svg", "svg enhanced"}, {".png", "pngcairo"}};
  return by_extension;
}

/// Size and font of the terminal. The units of svg and png are pixels: 96 an inch on a screen, 300 an inch in
/// print.
std::string size_of(const std::string& extension, double cm, double height) {
  if (extension == ".pdf")
    return " size " + rounded(cm) + "cm," + rounded(cm * height) + "cm font 'DejaVu Sans,7' dashlength 0.6";
  const double per_cm = (extension == ".svg" ? 96 : 300) / 2.54;
  return " size " + std::to_string(int(cm * per_cm)) + "," + std::to_string(int(cm * height * per_cm)) +
         (extension == ".svg" ? " font 'DejaVu Sans,10' dashlength 0.6"
                              : " font 'DejaVu Sans,7' fontscale 3 linewidth 3 pointscale 3 dashlength 0.6");
}

int run_gnuplot(const fs::path& script) {
  std::string program = "gnuplot", file = script.filename().string();
  std::array<char*, 3> arguments = {program.data(), file.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const fs::path folder = fs::absolute(script).parent_path();
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t pid = 0;
  const int error = posix_spawnp(&pid, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw std::runtime_error("gnuplot is not installed (Debian package gnuplot-nox); its script is " +
                             script.string());
  int status = 0;
  waitpid(pid, &status, 0);
  return status;
}

}  // namespace

std::string issue_of_picture_file(const fs::path& file) {
  return terminals().contains(file.extension().string())
             ? ""
             : file.string() + " is no picture: its name must end in .svg, .pdf or .png";
}

std::string picture_head(const PictureFormat& format, double height) {
  const std::string extension = format.file.extension().string();
  const double cm = format.width == PictureWidth::one_column ? 8.5 : 17.5;
  return "# Drawn by capstan figure. To draw it again: gnuplot " + format.file.filename().string() + ".gp\n" +
         "set terminal " + terminals().at(extension) + size_of(extension, cm, height) + "\nset output " +
         quoted_text(format.file.filename().string()) +
         "\nset encoding utf8\nset tics nomirror out scale 0.6\nset border 3 lw 0.8\n";
}

std::string quoted_text(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

std::string symbol(const std::string& name) {
  static const std::map<std::string, std::string> known = {
      {"Ca", "{/:Italic Ca}"},     {"V", "{/:Italic V}"},     {"Re", "{/:Italic Re}"},
      {"E_b", "{/:Italic E}_b"},   {"C", "{/:Italic C}"},     {"kt", "{/:Italic kt}"},
      {"theta", "{/:Italic θ}/π"}, {"psi", "{/:Italic ψ}/π"}, {"D_xy", "{/:Italic D}_{xy}"}};
  const auto found = known.find(name);
  return quoted_text(found == known.end() ? name : found->second);
}

void draw(const std::string& script, const PictureFormat& format) {
  const fs::path beside = format.file.string() + ".gp";
  write_atomically(beside, script);
  if (run_gnuplot(beside) != 0)
    throw std::runtime_error("gnuplot reported an error; its script is " + beside.string());
}

}  // namespace capstan
