#pragma once
// The physics that a case does not compute. Before the run the plan says it, after the run the result does.
#include <string>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

/// One sentence for each part that this case does not require, or that its flow model does not have: which
/// part, and what leaving it out changes. Numbers name the folder in which they were measured.
std::vector<std::string> left_out(const Case& c);

}  // namespace capstan
