#pragma once
// Keys of a case or study file that are not spelt as they should be.
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case/issue.hpp"

namespace capstan {

/// Renames each unknown key of the object that is near to a known key the object lacks, so that a mistyped
/// key is one issue. Returns these issues; none for anything but an object. \param pointer  of the object in
/// its document
Issues rename_mistyped_keys(nlohmann::json& object, const std::vector<std::string_view>& known,
                            const std::string& pointer = "");

}  // namespace capstan
