#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace capstan {

/// A plan for people. \param plan  as plan_json() and the server give it
std::string plan_text(const nlohmann::ordered_json& plan);

}  // namespace capstan
