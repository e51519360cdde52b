#pragma once
// Waits until a running daemon has brought a study into some state.
#include <gtest/gtest.h>

#include <string>

#include "runner/cli/client.hpp"
#include "tests/support/wait_until.hpp"

namespace capstan {

/// Requests `path` again and again until the condition holds for the answer, and returns the answer. Fails
/// the test after a minute.
template <class Condition>
nlohmann::ordered_json wait_for(Client& client, const std::string& path, const Condition& condition) {
  nlohmann::ordered_json answer;
  EXPECT_TRUE(wait_until([&] { return condition(answer = client.get(path)); })) << answer.dump(2);
  return answer;
}

/// Waits until `count` cases of the study are in `state`, and returns the study.
inline nlohmann::ordered_json wait_for_cases(Client& client, const std::string& id, const char* state,
                                             int count) {
  return wait_for(client, "/v1/studies/" + id,
                  [&](const nlohmann::ordered_json& study) { return study["cases"][state] == count; });
}

}  // namespace capstan
