#pragma once
// A study on a running daemon, and waiting for what becomes of it.
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "runner/cli/client.hpp"

namespace capstan {

/// Asks again until the condition holds of the answer, which it must within a minute.
template <class Condition>
nlohmann::ordered_json wait_for(Client& client, const std::string& path, const Condition& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  nlohmann::ordered_json answer = client.get(path);
  while (!condition(answer) && std::chrono::steady_clock::now() < deadline) answer = client.get(path);
  EXPECT_TRUE(condition(answer)) << answer.dump(2);
  return answer;
}

/// The study once `count` of its cases are in `state`.
inline nlohmann::ordered_json wait_for_cases(Client& client, const std::string& id, const char* state,
                                             int count) {
  return wait_for(client, "/v1/studies/" + id,
                  [&](const nlohmann::ordered_json& study) { return study["cases"][state] == count; });
}

}  // namespace capstan
