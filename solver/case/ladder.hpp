#pragma once
// The ladder of resolutions of a flow model. The spacing is divided by two from a rung to the second next
// one: boundary integrals with 42, 92, 162, 362, 642, 1442, 2562, 5762 and 10242 nodes; lattices of dx = 0.4
// to 0.05 with 162 to 10242 nodes. A case at a rung has a companion, the same case at twice the spacing: the
// distance of the two runs gives an estimate of the error (error_estimate.hpp).
#include <optional>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

/// Whether the flow model has a ladder: not the transient lattice, nor the paper's scheme.
bool has_ladder(const Case& c);

/// After a change of dx: a tolerance that is the usual one of the spacing before becomes that of the new one.
void adapt_tolerance(Case& c, double spacing_before);

/// The same scene at twice the spacing, with a quarter of the nodes. Stepper and time step are those that its
/// own case file would get. Nothing if the flow model has no ladder, there is no such rung, or the lattice
/// does not fit the box.
std::optional<Case> coarser(const Case& c);

/// The run of a case itself, without its companion, and at a fixed resolution.
Case single_run(const Case& c);

/// The companion of a case: its run at twice the spacing, which writes no shapes. Nothing if the case
/// switches it off or there is no such rung.
std::optional<Case> companion_of(const Case& c);

/// The case at the first rung to be tried for an error of `c.fidelity.error`: the coarsest whose usual error
/// is not larger, of those with a companion.
Case at_first_rung(const Case& c);

/// The rung to be tried after one whose estimated error was too large: the second next one if it was more
/// than three times too large, else the next one. From one rung to the next the error falls by a factor of
/// two, estimates on coarse meshes by more. Nothing at the finest rung. \param estimate  nothing if it is
/// unknown
std::optional<Case> next_rung(const Case& rung, std::optional<double> estimate, double asked);

/// All runs that a case usually takes, the companion first; for an error asked for, those of its first rung.
std::vector<Case> usual_runs(const Case& c);

}  // namespace capstan
