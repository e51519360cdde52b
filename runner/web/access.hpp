#pragma once
// Who may ask: by the names under which the server is known, by the page that asks, and by a token.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/web/head.hpp"

namespace capstan {

struct Access {
  std::vector<std::string> hosts = {};    ///< names besides "localhost" and addresses in digits
  std::optional<std::string> token = {};  ///< asked of everyone, if there is one
};

/// 421 for a name that is not this server's: a page of another site that had its name point here (DNS
/// rebinding). 403 for a page from elsewhere. 401 without the token.
std::optional<Response> refuse_access(const Access& access, const Head& head);

/// Takes the same time wherever they differ.
bool equal_in_constant_time(std::string_view a, std::string_view b);

/// The token that both server and clients use: what the environment variable CAPSTAN_TOKEN holds, or the file
/// that CAPSTAN_TOKEN_FILE names, which nobody but its owner may read. Throws std::invalid_argument for one
/// that is short or has characters that a header cannot carry.
std::optional<std::string> token_of_environment();

}  // namespace capstan
