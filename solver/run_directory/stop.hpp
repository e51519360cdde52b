#pragma once
// Why the simulation loop stopped: the word `stop` of result.json (schema/run_directory.md).
#include "solver/case/words.hpp"

namespace capstan {

enum class Stop {
  reached_end,
  classified,     ///< more time would not change the label; or, after until.kt, there is one at last
  steady,         ///< before the end: the shape does not change any more
  diverged,       ///< numbers are not finite, or the membrane has lost its shape
  not_converged,  ///< the flow solver did not reach its tolerance
  interrupted,    ///< on request, with a checkpoint
};
template <>
inline constexpr auto kWords<Stop> = std::to_array<Word<Stop>>({{Stop::reached_end, "reached_end"},
                                                                {Stop::classified, "classified"},
                                                                {Stop::steady, "steady"},
                                                                {Stop::diverged, "diverged"},
                                                                {Stop::not_converged, "not_converged"},
                                                                {Stop::interrupted, "interrupted"}});

/// Whether the run was computed as far as its case requires, so that it has a motion.
constexpr bool has_answer(Stop stop) {
  return stop == Stop::reached_end || stop == Stop::classified || stop == Stop::steady;
}

}  // namespace capstan
