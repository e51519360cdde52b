#pragma once
// Studies to submit in tests.
#include "runner/study/study.hpp"

namespace capstan {

/// A study of a red blood cell. \param axes  for example {{"Ca", {0.25, 0.75}}}
inline nlohmann::json study_document(const std::string& name, const nlohmann::json& axes) {
  return {
      {"name", name},
      {"base",
       {{"shape", "biconcave"}, {"law", "skalak"}, {"C", 5}, {"until", {{"kt", 30}}}, {"fidelity", "fast"}}},
      {"axes", axes}};
}

inline Study sample_study(const std::string& name, const nlohmann::json& axes) {
  return parse_study(study_document(name, axes)).value.value();
}

}  // namespace capstan
