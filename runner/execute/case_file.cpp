#include "runner/execute/case_file.hpp"

#include <fstream>
#include <iostream>
#include <iterator>

namespace capstan {
namespace {

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

ParsedCase read_case(const std::filesystem::path& path) {
  const ParsedJson json = parse_json(contents(path));
  return json.value ? parse_case(*json.value) : ParsedCase{std::nullopt, json.issues, {}};
}

void print_faults(const std::filesystem::path& file, const Issues& issues) {
  for (const Issue& issue : issues)
    std::cerr << file.string() << ": " << (issue.pointer.empty() ? "" : issue.pointer + ": ") << issue.message << "\n";
}

}  // namespace capstan
