#include "runner/cli/study_file.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "runner/render/printable.hpp"
#include "runner/study/input_file.hpp"

namespace capstan {
std::optional<Study> read_study_file(const std::string& file) {
  InputDocument document = parse_document(read_input(file));
  if (document.single_case)
    document.issues.push_back({"",
                               "this is a case, not a study: capstan solve FILE --out DIR computes it; "
                               "in a study it is the \"base\""});
  if (!document.study) print_issues(std::cerr, input_name(file), document.issues);
  return std::move(document.study);
}

void print_issues(std::ostream& out, const std::string& file, const Issues& issues) {
  out << file << ": " << issues.size() << (issues.size() == 1 ? " issue\n" : " issues\n");
  std::size_t width = 0;
  for (const Issue& issue : issues) width = std::max(width, issue.pointer.size());
  for (const Issue& issue : issues)
    out << "  " << std::left << std::setw(static_cast<int>(width)) << printable(issue.pointer)
        << (width > 0 ? "  " : "") << printable(issue.message) << '\n';
}

nlohmann::ordered_json to_json(const Issues& issues) {
  nlohmann::ordered_json errors = nlohmann::ordered_json::array();
  for (const Issue& issue : issues) errors.push_back({{"pointer", issue.pointer}, {"detail", issue.message}});
  return errors;
}

}  // namespace capstan
