#pragma once
// JSON values as tables and messages show them.
#include <nlohmann/json.hpp>
#include <string>

namespace capstan {

/// Words without quotes, the shortest decimals that read back to the same number ("1", not "1.0"), "" for
/// null.
std::string shown_value(const nlohmann::ordered_json& value);

}  // namespace capstan
