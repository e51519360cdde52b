#pragma once
// Why the simulation loop stopped: the word `stop` of result.json (schema/run_directory.md).
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace capstan {

enum class Stop {
  reached_end,
  classified,     ///< before the end: more time would not change the label
  steady,         ///< before the end: the shape does not change any more
  diverged,       ///< numbers are not finite, or the membrane has lost its shape
  not_converged,  ///< the flow solver did not reach its tolerance
  interrupted,    ///< on request, with a checkpoint
};

inline constexpr std::array kStops = {Stop::reached_end, Stop::classified,    Stop::steady,
                                      Stop::diverged,    Stop::not_converged, Stop::interrupted};

/// The word of result.json, for example "reached_end".
constexpr std::string_view to_string(Stop stop) {
  constexpr std::array<std::string_view, kStops.size()> kWords = {
      "reached_end", "classified", "steady", "diverged", "not_converged", "interrupted"};
  return kWords[static_cast<std::size_t>(stop)];
}

/// Nothing if `word` is none of the six words.
constexpr std::optional<Stop> parse_stop(std::string_view word) {
  const auto found = std::ranges::find(kStops, word, [](Stop stop) { return to_string(stop); });
  return found == kStops.end() ? std::nullopt : std::optional(*found);
}

/// Whether the run was computed as far as its case requires, so that it has a motion.
constexpr bool has_answer(Stop stop) {
  return stop == Stop::reached_end || stop == Stop::classified || stop == Stop::steady;
}

}  // namespace capstan
