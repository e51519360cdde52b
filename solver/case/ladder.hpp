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

/// The same scene at the next coarser or finer rung. Nothing if there is none whose lattice fits the box.
std::optional<Case> rung_below(const Case& c);
std::optional<Case> rung_above(const Case& c);

/// The case at the rung that is expected to meet the error `c.fidelity.error`: the coarsest whose usual error
/// is not larger, of those with a rung below; the finest if none is. If a membrane without bending stiffness
/// is expected to wrinkle (wrinkling.hpp), the rung has at least 1442 nodes: coarser meshes cannot wrinkle.
Case at_expected_rung(const Case& c);

/// The run at the rung with which the climb to `c.fidelity.error` begins: the coarsest whose usual error is
/// at most four times as large, with as many nodes as wrinkles need. Many scenes are resolved better than
/// usual, and all coarser rungs together cost less than the last. \param c  at its expected rung
Case first_of_climb(const Case& c);

/// All runs that a case usually takes, the coarsest first: its companion and itself; for an error asked for
/// the rung below the first, and from there on all rungs up to the expected one.
std::vector<Case> usual_runs(const Case& c);

}  // namespace capstan
