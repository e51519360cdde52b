#pragma once
// Why a run has its label, in a sentence or two.
#include <string>

#include "solver/observe/classify.hpp"
#include "solver/observe/findings.hpp"

namespace capstan {

std::string explanation(Motion motion, const Findings& found);

/// For samples of which look_at() finds nothing.
std::string explanation_of_none(Samples samples);

}  // namespace capstan
