#pragma once
// Sentences on what the author of a study may not expect.
#include <map>
#include <string>
#include <vector>

#include "runner/study/dropped_keys.hpp"
#include "runner/study/study.hpp"

namespace capstan {

/// Sentences with the number of points that each holds for.
using CountedSentences = std::map<std::string, std::size_t>;

/// Repeated values of an axis, dropped keys, choices of the solver, settings that make the answer doubtful
/// (case_warnings), points that are the same case, and that further points follow.
std::vector<std::string> notes_on(const Study& study, const DroppedKeys& dropped,
                                  const CountedSentences& choices, const CountedSentences& warnings);

}  // namespace capstan
