#pragma once
#include "runner/study/study.hpp"

namespace capstan {

/// `capstan estimate`: prints the time that a study takes on this machine, case by case and in all.
/// \param cores  number of cases that would run side by side  \return the exit code
int estimate_study(const Study& study, int cores, bool json);

}  // namespace capstan
