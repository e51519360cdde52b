#pragma once
// A study file as the commands read it.
#include <iosfwd>
#include <optional>
#include <string>

#include "runner/study/study.hpp"

namespace capstan {

/// A study, or a case: a document that has a case's parameters and no base.
struct InputDocument {
  std::optional<Study> study;
  std::optional<Case> single_case;
  Choices choices;  ///< of the case
  Issues issues;    ///< if it is neither
};
InputDocument parse_document(const std::string& text);

/// The study, or nothing after all its faults went to standard error. Throws when the file cannot be read.
/// \param file  "-" is standard input
std::optional<Study> read_study_file(const std::string& file);

/// One fault a line, pointers aligned.
void print_issues(std::ostream& out, const std::string& file, const Issues& issues);

/// A list of {"pointer", "detail"}, as in the server's answers.
nlohmann::ordered_json to_json(const Issues& issues);

}  // namespace capstan
