#pragma once
// Fencing: of several processes that compute one case, only that of the newest attempt replaces files.
//
// Whoever starts an attempt writes its token to the file `attempt` of the run directory, and passes the same
// token on to the process. On a cluster an earlier process may still compute on a node that was given up. It
// finds another token there, or none, and publishes nothing any more.
#include <filesystem>
#include <stdexcept>
#include <string>

#include "solver/run_directory/run_directory.hpp"

namespace capstan {

/// Environment variable with the token of the attempt.
inline constexpr const char* kTokenVariable = "CAPSTAN_ATTEMPT";

/// 128 random bits: no two attempts share a token. Letters, digits and hyphens only.
std::string new_token();

/// The attempt of this process was replaced by another one, or was withdrawn.
class AttemptWithdrawn : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// From now on this process replaces files (durable_file.hpp) only while the directory has the token of the
/// environment. Does nothing if the environment has none, as in a run that a user starts. Throws
/// AttemptWithdrawn if the directory has another token already.
void publish_only_as_own_attempt(const RunDirectory& directory);

/// Throws AttemptWithdrawn if the directory has another token than this process, or none.
void expect_own_attempt();

/// Name of a temporary file beside `target`, which processes of two attempts do not share.
std::filesystem::path temporary_name(const std::filesystem::path& target);

}  // namespace capstan
