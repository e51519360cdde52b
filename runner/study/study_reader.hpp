#pragma once
// Reads the document of a study: all but the cases that it expands to.
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "runner/study/issue_collector.hpp"
#include "runner/study/study.hpp"

namespace capstan {

/// The document without its cases.
struct StudyParts {
  Study study;                         ///< without cases and points
  std::optional<nlohmann::json> base;  ///< with what the study adds to it; nothing if it is not usable
  std::set<std::string> invalid_axes;  ///< parameters whose axis has issues: the cases cannot have them
};

/// \param document  an object, in the spelling of parse_study
StudyParts read_study_parts(const nlohmann::json& document, IssueCollector& issues);

}  // namespace capstan
