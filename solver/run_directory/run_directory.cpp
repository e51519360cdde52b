#include "solver/run_directory/run_directory.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

std::string read_from(std::ifstream& stream) { return {std::istreambuf_iterator<char>(stream), {}}; }

}  // namespace

std::array<std::filesystem::path, 2> RunDirectory::checkpoint_paths() const {
  return {path_ / "checkpoint-a.h5", path_ / "checkpoint-b.h5"};
}

std::filesystem::path RunDirectory::frame_file(int frame) const {
  constexpr std::size_t kMinDigits = 4;
  const std::string number = std::to_string(frame);
  const std::size_t zeros = number.size() < kMinDigits ? kMinDigits - number.size() : 0;
  return shapes_directory() / (std::string(zeros, '0') + number + ".h5");
}

RunDirectory RunDirectory::rung(int nodes) const {
  return RunDirectory(rungs_directory() / std::to_string(nodes));
}

bool RunDirectory::is_shape(const std::filesystem::path& file) const {
  return file.parent_path().filename() == shapes_directory().filename() ||
         file.filename().string().starts_with("shapes");
}

bool RunDirectory::is_checkpoint(const std::filesystem::path& file) const {
  return file.filename().string().starts_with("checkpoint");
}

/// Written without a sync: the database holds the case, and a file that a power failure damaged is written
/// again.
void RunDirectory::prepare(const std::string& case_document) const {
  std::filesystem::create_directories(path_);
  std::ifstream present(case_file(), std::ios::binary);
  if (read_from(present) != case_document + "\n") write_atomically(case_file(), case_document + "\n");
}

/// The checkpoints come last: a process that is killed before leaves none, so that this is done again.
void RunDirectory::go_on_from(const RunDirectory& earlier) const {
  std::filesystem::create_directories(path_);
  if (std::filesystem::exists(earlier.rungs_directory()))
    for (const auto& rung : std::filesystem::directory_iterator(earlier.rungs_directory()))
      RunDirectory(rungs_directory() / rung.path().filename()).go_on_from(RunDirectory(rung.path()));
  if (std::filesystem::exists(earlier.shapes_directory()))
    link_files(earlier.shapes_directory(), shapes_directory());
  const auto from = earlier.checkpoint_paths(), to = checkpoint_paths();
  for (std::size_t i = 0; i < from.size(); ++i)
    if (std::filesystem::exists(from[i])) link_file(from[i], to[i]);
}

void RunDirectory::begin_attempt(const std::string& token) const {
  write_atomically(attempt_file(), token + "\n");
}

void RunDirectory::withdraw_attempt() const { std::filesystem::remove(attempt_file()); }

bool RunDirectory::is_attempt(const std::string& token) const {
  const std::string present = read_file(attempt_file()).value_or("");
  return present == token + "\n" || present.starts_with(token + ".");
}

std::vector<std::filesystem::path> RunDirectory::partial_files() const {
  std::vector<std::filesystem::path> partial;
  std::error_code ignored;  // a run that was killed early has no directory
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path_, ignored))
    if (entry.path().extension() == kPartialExtension) partial.push_back(entry.path());
  return partial;
}

void RunDirectory::remove_partial_files() const {
  for (const auto& file : partial_files()) std::filesystem::remove(file);
}

bool RunDirectory::is_worthless() const {
  const auto [first, second] = checkpoint_paths();
  for (const std::filesystem::path& file : {result_file(), first, second})
    if (std::filesystem::exists(file)) return false;
  return true;
}

std::optional<nlohmann::ordered_json> RunDirectory::result() const {
  const std::optional<std::string> text = read_file(result_file());
  if (!text) return std::nullopt;
  nlohmann::ordered_json result = nlohmann::ordered_json::parse(*text, nullptr, false);
  if (!result.is_object()) return std::nullopt;
  return result;
}

std::string RunDirectory::log_tail(std::size_t max_size) const {
  std::ifstream stream(log_file(), std::ios::binary | std::ios::ate);
  if (!stream) return "";
  const auto length = static_cast<std::size_t>(stream.tellg());
  const std::size_t start = length - std::min(max_size, length);
  stream.seekg(static_cast<std::streamoff>(start));
  std::string text = read_from(stream);
  if (start > 0) text.erase(0, text.find('\n') + 1);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace capstan
