#pragma once
// The numerical models of a case: symmetry, flow model and time stepper. solver/case/scene_plan.hpp has them
// in words.
#include <memory>
#include <optional>

#include "solver/case/case.hpp"
#include "solver/fluid/flow_model.hpp"
#include "solver/mesh/in_plane_symmetry.hpp"
#include "solver/simulation/time_step.hpp"

namespace capstan {

/// The symmetry of the initial shape. The run keeps it exactly, because flow model and membrane compute one
/// vertex of each orbit and copy the result to its images. Without symmetry if the case switches it off or
/// the flow model cannot use it.
/// \param initial  3 x #V, the positions at the start
Orbits symmetry_of(const Case& c, const Points& initial);

/// The flow model of the case.
/// \param initial 3 x #V, the positions at the start   \param orbits the symmetry of these positions
std::unique_ptr<FlowModel> make_flow(const Case& c, const TriangleMesh& mesh, const Points& initial,
                                     const Orbits& orbits);

/// \param imposed_kdt  the time step k dt of the flow model, if it imposes one
std::unique_ptr<TimeStepper> make_stepper(const Case& c, std::optional<double> imposed_kdt);

}  // namespace capstan
