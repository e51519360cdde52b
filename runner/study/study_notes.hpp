#pragma once
// What was done with a study that its author may not expect, in sentences.
#include <map>
#include <string>
#include <vector>

#include "runner/study/dropped_keys.hpp"
#include "runner/study/study.hpp"

namespace capstan {

/// Values that stand twice on an axis, keys that were dropped, what the solver chose, points that are the
/// same case. \param choices  in words, each with the number of points where it was made
std::vector<std::string> notes_on(const Study& study, const DroppedKeys& dropped,
                                  const std::map<std::string, std::size_t>& choices);

}  // namespace capstan
