#pragma once
// The word that was meant by a mistyped one.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace capstan {

/// The candidate that is nearest to `typed`, if one is near: the same but for capitals, '-' and '_'; or
/// within a few typing errors (a letter too many, missing, wrong, or two exchanged), the more the longer the
/// word; or one that begins with it.
std::optional<std::string> nearest_word(std::string_view typed, const std::vector<std::string>& candidates);

/// The same as the end of a message: `; did you mean "skalak"?`, or nothing.
std::string suggestion(std::string_view typed, const std::vector<std::string>& candidates);

}  // namespace capstan
