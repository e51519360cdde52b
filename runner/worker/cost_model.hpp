#pragma once
// What a study will cost on this machine, from short runs of some of its cases.
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

/// Seconds of one core that each case takes to its end. A few cases of each kind (flow model and fidelity),
/// spread over the study, run for a moment, two seconds in all: how much longer they take than run_cost says,
/// the cases nearest to them in Ca and V take, too. A run that ends early because its class is certain is
/// cheaper than this says.
std::vector<double> estimated_seconds(const std::vector<Case>& cases);

}  // namespace capstan
