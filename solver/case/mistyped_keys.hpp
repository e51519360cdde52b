#pragma once
// Keys of a case or study file that are not spelt as they should be.
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case/issue.hpp"

namespace capstan {

/// Renames each unknown key that is near to a known key which is missing in the object. So a mistyped key
/// causes one issue, not two. Returns these issues; none if the value is not an object.
/// \param pointer  to the object in its document
Issues rename_mistyped_keys(nlohmann::json& object, const std::vector<std::string_view>& known,
                            const std::string& pointer = "");

}  // namespace capstan
