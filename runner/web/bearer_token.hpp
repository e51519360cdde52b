#pragma once
// The secret that server and clients share: `Authorization: Bearer TOKEN` (RFC 6750).
#include <optional>
#include <string>
#include <string_view>

namespace capstan {

/// The token in the environment variable CAPSTAN_TOKEN, or in the file that CAPSTAN_TOKEN_FILE names; nothing
/// if neither is set. Throws std::invalid_argument for a token that is short or has characters that a header
/// cannot carry, and for a file that cannot be read or that others than its owner can read.
std::optional<std::string> token_of_environment();

/// Takes the same time wherever the texts differ, so that timing reveals nothing about the token.
bool equal_in_constant_time(std::string_view a, std::string_view b);

}  // namespace capstan
