#pragma once
// Measured errors of the resolutions of the flow models, and what the other flow model takes for the same
// scene at about the same error.
#include <optional>
#include <string>
#include <string_view>

#include "solver/case/case.hpp"

namespace capstan {

/// The range of the errors over the scenes of a study. On the grids and meshes of today's models they are the
/// largest distance of Q = D_xy (cos 2 theta, sin 2 theta) over a run; with the paper's coupling those of
/// D_xy alone, relative. Both are compared as numbers.
struct MeasuredError {
  std::string_view quantity;
  double min, max;
};

/// The error of the coarsest measured resolution that spacing and mesh of the case reach; nothing if they are
/// coarser than all of them.
std::optional<MeasuredError> measured_error(const Case& c);

/// measured_error() in words.
std::string error_in_words(const Case& c);

/// The same scene by the other flow model: by boundary integrals in place of a lattice, and on a lattice in
/// place of boundary integrals. At the coarsest measured resolution whose error is not above that of the
/// case, or at the finest. Nothing if the other model lacks something that the case has: boundary integrals
/// have no inertia.
std::optional<Case> with_other_fluid(const Case& c);

}  // namespace capstan
