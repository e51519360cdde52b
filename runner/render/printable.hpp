#pragma once
#include <string>
#include <string_view>

namespace capstan {

/// Text of a user or a server, safe on a terminal: control characters, marks that reverse the direction of
/// writing and bytes that are no UTF-8 become "?". Line ends and tabs stay.
std::string printable(std::string_view text);

}  // namespace capstan
