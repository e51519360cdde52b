#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace capstan {

/// "Ca: 0.25 0.5 1"; of a long axis the first values and the last.
std::string axis_text(const std::string& parameter, const std::vector<nlohmann::ordered_json>& values);

}  // namespace capstan
