#pragma once
#include <string>
#include <string_view>

namespace capstan {

/// Makes the text of a user or a server safe for a terminal: control characters, marks that reverse the
/// direction of writing and invalid UTF-8 become "?". Newlines and tabs stay.
std::string printable(std::string_view text);

}  // namespace capstan
