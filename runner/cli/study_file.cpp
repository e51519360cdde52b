#include "runner/cli/study_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <system_error>

namespace capstan {

std::optional<Study> read_study_file(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw std::system_error(errno, std::generic_category(), "cannot read " + file);
  ParsedStudy parsed = parse_study_text(text);
  if (!parsed.value) print_issues(std::cerr, file, parsed.issues);
  return std::move(parsed.value);
}

void print_issues(std::ostream& out, const std::string& file, const Issues& issues) {
  out << file << ": " << issues.size() << (issues.size() == 1 ? " fault\n" : " faults\n");
  std::size_t width = 0;
  for (const Issue& issue : issues) width = std::max(width, issue.pointer.size());
  for (const Issue& issue : issues)
    out << "  " << std::left << std::setw(static_cast<int>(width)) << issue.pointer << (width > 0 ? "  " : "")
        << issue.message << '\n';
}

}  // namespace capstan
