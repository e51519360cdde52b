#pragma once
// The states of a case in the queue (job_queue.hpp draws how they follow each other).
#include <array>
#include <optional>
#include <string_view>

namespace capstan {

enum class CaseState { queued, running, done, failed, diverged, cancelled };

inline constexpr std::array kCaseStates = {CaseState::queued, CaseState::running,  CaseState::done,
                                           CaseState::failed, CaseState::diverged, CaseState::cancelled};

/// The word of the database and the API, for example "queued".
std::string_view to_string(CaseState state);
/// Nothing if `word` is none of the six words.
std::optional<CaseState> parse_case_state(std::string_view word);

/// The run of the case has ended, with an answer or without one.
constexpr bool has_ended(CaseState state) {
  return state != CaseState::queued && state != CaseState::running;
}

}  // namespace capstan
