#pragma once
// Reads the document of a study: all but the cases that it expands to.
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "runner/study/issue_collector.hpp"
#include "runner/study/study.hpp"

namespace capstan {

/// The document without its cases.
struct StudyParts {
  Study study;                           ///< without cases and points
  const nlohmann::json* base = nullptr;  ///< points into the document; nullptr if that has no usable base
  std::set<std::string> invalid_axes;    ///< parameters whose axis has issues: the cases cannot have them
};

/// \param document  an object, in the spelling of parse_study
StudyParts read_study_parts(const nlohmann::json& document, IssueCollector& issues);

}  // namespace capstan
