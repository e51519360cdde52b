#include "runner/queue/case_state.hpp"

namespace capstan {

std::string_view to_string(CaseState state) {
  switch (state) {
    case CaseState::queued:
      return "queued";
    case CaseState::running:
      return "running";
    case CaseState::done:
      return "done";
    case CaseState::failed:
      return "failed";
    case CaseState::diverged:
      return "diverged";
    case CaseState::cancelled:
      break;
  }
  return "cancelled";
}

std::optional<CaseState> parse_case_state(std::string_view word) {
  for (const CaseState state : kCaseStates)
    if (to_string(state) == word) return state;
  return std::nullopt;
}

}  // namespace capstan
