#pragma once
// Warnings about a case that can be run, but whose settings make its result doubtful. They follow from the
// case alone, before the run.
#include <string>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

/// Sentences: what is wrong, why, and what to do.
std::vector<std::string> case_warnings(const Case& c);

}  // namespace capstan
