#include "solver/run_directory/attempt_token.hpp"

#include <cstdlib>
#include <optional>
#include <random>

#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

struct OwnAttempt {
  RunDirectory directory;
  std::string token;
};

/// A process computes one case, so it belongs to one attempt from its start to its end.
std::optional<OwnAttempt>& own_attempt() {
  static std::optional<OwnAttempt> attempt;
  return attempt;
}

}  // namespace

std::string new_token() {
  std::random_device entropy;
  std::string token;
  for (int i = 0; i < 4; ++i) token += std::to_string(entropy()) + (i < 3 ? "-" : "");
  return token;
}

void publish_only_as_own_attempt(const RunDirectory& directory) {
  const char* token = std::getenv(kTokenVariable);
  if (token) own_attempt() = OwnAttempt{directory, token};
  expect_own_attempt();
}

void expect_own_attempt() {
  const auto& own = own_attempt();
  if (own && !own->directory.is_attempt(own->token))
    throw AttemptWithdrawn("another attempt has taken over " + own->directory.path().string());
}

std::filesystem::path temporary_name(const std::filesystem::path& target) {
  const std::string owner = own_attempt() ? "." + own_attempt()->token : "";
  return target.string() + owner + kPartialExtension;
}

}  // namespace capstan
