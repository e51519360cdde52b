#pragma once
// Settings of a case that can be run, but give a doubtful answer: what is wrong, why, and what to do. Known
// before the run.
#include <string>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

std::vector<std::string> case_warnings(const Case& c);

}  // namespace capstan
