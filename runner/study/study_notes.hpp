#pragma once
// What was done with a study that its author may not expect, in sentences.
#include <map>
#include <string>
#include <vector>

#include "runner/study/dropped_keys.hpp"
#include "runner/study/study.hpp"

namespace capstan {

/// Sentences, each with the number of points that it holds for.
using CountedSentences = std::map<std::string, std::size_t>;

/// Values that stand twice on an axis, keys that were dropped, what the solver chose, settings that make the
/// answer doubtful (case_warnings), points that are the same case.
std::vector<std::string> notes_on(const Study& study, const DroppedKeys& dropped,
                                  const CountedSentences& choices, const CountedSentences& warnings);

}  // namespace capstan
