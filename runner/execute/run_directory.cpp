#include "runner/execute/run_directory.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "solver/state/durable_file.hpp"

namespace capstan {
namespace {

std::string read_from(std::ifstream& stream) { return {std::istreambuf_iterator<char>(stream), {}}; }

}  // namespace

void RunDirectory::prepare(const std::string& case_document) const {
  std::filesystem::create_directories(path_);
  if (!std::filesystem::exists(case_file())) write_durably(case_file(), case_document + "\n");
}

std::optional<nlohmann::ordered_json> RunDirectory::result() const {
  std::ifstream stream(result_file(), std::ios::binary);
  if (!stream) return std::nullopt;
  nlohmann::ordered_json result = nlohmann::ordered_json::parse(read_from(stream), nullptr, false);
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
