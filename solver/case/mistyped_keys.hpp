#pragma once
// Keys of a case or study file that are not spelt as they should be.
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case/parse.hpp"

namespace capstan {

/// Renames each key of the object that is near a known one that is missing, so that a mistyped key is one
/// fault: the issues. Anything but an object has none. \param pointer  of the object in its document
Issues rename_mistyped_keys(nlohmann::json& object, const std::vector<std::string_view>& known,
                            const std::string& pointer = "");

/// All keys of a case.
const std::vector<std::string_view>& case_keys();

}  // namespace capstan
