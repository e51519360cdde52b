#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace capstan {

/// "Ca: 0.25 0.5 1". Of more than 8 values the text has only the first 6, the last, and the number of values.
std::string axis_text(const std::string& parameter, const std::vector<nlohmann::ordered_json>& values);

}  // namespace capstan
