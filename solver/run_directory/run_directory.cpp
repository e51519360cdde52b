#include "solver/run_directory/run_directory.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

std::string read_from(std::ifstream& stream) { return {std::istreambuf_iterator<char>(stream), {}}; }

}  // namespace

/// The case is in the database, so its file need not survive a power failure: one that did not is written
/// again.
void RunDirectory::prepare(const std::string& case_document) const {
  std::filesystem::create_directories(path_);
  std::ifstream there(case_file(), std::ios::binary);
  if (read_from(there) != case_document + "\n") write_atomically(case_file(), case_document + "\n");
}

std::vector<std::filesystem::path> RunDirectory::partial_files() const {
  std::vector<std::filesystem::path> partial;
  std::error_code none;  // the run was killed before it had a directory
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path_, none))
    if (entry.path().extension() == ".partial") partial.push_back(entry.path());
  return partial;
}

void RunDirectory::remove_partial_files() const {
  for (const auto& file : partial_files()) std::filesystem::remove(file);
}

bool RunDirectory::is_worthless() const {
  for (const char* kept : {"result.json", "checkpoint-a.h5", "checkpoint-b.h5"})
    if (std::filesystem::exists(path_ / kept)) return false;
  return true;
}

std::optional<nlohmann::ordered_json> RunDirectory::result() const {
  const std::optional<std::string> text = read_file(result_file());
  if (!text) return std::nullopt;
  nlohmann::ordered_json result = nlohmann::ordered_json::parse(*text, nullptr, false);
  if (!result.is_object()) return std::nullopt;
  return result;
}

std::string RunDirectory::log_tail(std::size_t size) const {
  std::ifstream stream(log_file(), std::ios::binary | std::ios::ate);
  if (!stream) return "";
  const auto length = static_cast<std::size_t>(stream.tellg());
  const std::size_t start = length - std::min(size, length);
  stream.seekg(static_cast<std::streamoff>(start));
  std::string text = read_from(stream);
  if (start > 0) text.erase(0, text.find('\n') + 1);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace capstan
