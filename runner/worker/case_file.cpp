#include "runner/worker/case_file.hpp"

#include <iostream>

#include "runner/study/input_file.hpp"

namespace capstan {

ParsedCase read_case(const std::filesystem::path& path) {
  const ParsedJson json = parse_json(read_input(path));
  const bool is_study = json.value && json.value->is_object() && json.value->contains("base");
  if (json.value && !is_study) return parse_case(*json.value);
  ParsedCase refused;
  refused.issues = json.issues;
  if (is_study)
    refused.issues.push_back({"", "this is a study, not a case: capstan submit FILE computes it"});
  return refused;
}

void print_case_issues(const std::filesystem::path& file, const Issues& issues) {
  for (const Issue& issue : issues)
    std::cerr << input_name(file) << ": " << (issue.pointer.empty() ? "" : issue.pointer + ": ")
              << issue.message << "\n";
}

}  // namespace capstan
