#pragma once
// The states of a case in the queue (job_queue.hpp draws how they follow each other).
#include "solver/case/words.hpp"

namespace capstan {

enum class CaseState { queued, running, done, failed, diverged, cancelled };
/// The words of the database and the API.
template <>
inline constexpr auto kWords<CaseState> = std::to_array<Word<CaseState>>({{CaseState::queued, "queued"},
                                                                          {CaseState::running, "running"},
                                                                          {CaseState::done, "done"},
                                                                          {CaseState::failed, "failed"},
                                                                          {CaseState::diverged, "diverged"},
                                                                          {CaseState::cancelled,
                                                                           "cancelled"}});

/// The run of the case has ended, with an answer or without one.
constexpr bool has_ended(CaseState state) {
  return state != CaseState::queued && state != CaseState::running;
}

}  // namespace capstan
