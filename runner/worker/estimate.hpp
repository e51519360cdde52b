#pragma once
#include "runner/study/study.hpp"

namespace capstan {

/// What `capstan estimate` prints: how long a study takes on this machine, case by case and in all. \return
/// the exit code
int estimate_study(const Study& study, int cores, bool json);

}  // namespace capstan
