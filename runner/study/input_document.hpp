#pragma once
// The text of a study or a case.
#include <optional>
#include <string>

#include "runner/study/study.hpp"

namespace capstan {

/// The content of a file: a study, a case, or neither. A document with a case's parameters and without "base"
/// and "axes" is a case.
struct InputDocument {
  std::optional<Study> study;
  std::optional<Case> single_case;
  Choices choices;  ///< what the solver chose for the case
  Issues issues;    ///< not empty if the document is neither
};
InputDocument parse_document(const std::string& text);

}  // namespace capstan
