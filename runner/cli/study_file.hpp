#pragma once
// A study file as the commands read it.
#include <iosfwd>
#include <optional>
#include <string>

#include "runner/study/study.hpp"

namespace capstan {

/// The study, or nothing after all its faults went to standard error. Throws when the file cannot be read.
std::optional<Study> read_study_file(const std::string& file);

/// One fault a line, pointers aligned.
void print_issues(std::ostream& out, const std::string& file, const Issues& issues);

}  // namespace capstan
