#pragma once
// The known word that a mistyped word probably means.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace capstan {

/// The candidate nearest to `typed`; nothing if none is near. Capitals, '-', '_' and spaces are ignored. A
/// candidate is near if it is within a few typing errors (insertion, deletion, substitution, transposition),
/// more for longer words, or if it begins with `typed`.
std::optional<std::string> nearest_word(std::string_view typed, const std::vector<std::string>& candidates);

/// The nearest candidate as the end of a message: `; did you mean "skalak"?`, or nothing.
std::string suggestion(std::string_view typed, const std::vector<std::string>& candidates);

}  // namespace capstan
