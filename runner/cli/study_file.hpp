#pragma once
// Reads files of studies and cases, and prints what is wrong with them.
#include <iosfwd>
#include <optional>
#include <string>

#include "runner/study/input_document.hpp"

namespace capstan {

/// Reads a study. If it is invalid, prints all its issues to standard error and returns nothing. Throws
/// std::system_error if the file cannot be read.
/// \param file  path, or "-" for standard input
std::optional<Study> read_study_file(const std::string& file);

/// Prints the number of issues and one line each, with the JSON pointer and the message.
/// \param file  name of the file, for the heading
void print_issues(std::ostream& out, const std::string& file, const Issues& issues);

/// A list of {"pointer", "detail"}, as in the server's answers.
nlohmann::ordered_json to_json(const Issues& issues);

}  // namespace capstan
