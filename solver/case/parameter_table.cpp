// The rows of the table of parameters.
#include "solver/case/ladder.hpp"
#include "solver/case/law_constants.hpp"
#include "solver/case/limits.hpp"
#include "solver/case/parameter_makers.hpp"
#include "solver/case/parameters.hpp"

namespace capstan {
namespace {

Value aspect() {
  const auto range_in = [](const Case& c) -> std::optional<Range> {
    if (c.shape == Shape::oblate) return Range{0.1, 1, " for an oblate shape"};
    if (c.shape == Shape::prolate) return Range{1, 5, " for a prolate shape"};
    return std::nullopt;
  };
  return std::make_shared<NumberValue>(place_of(&Case::aspect), range_in, Range{0.1, 5});
}

Value nodes() {
  return std::make_shared<WholeNumberValue>(
      place_of(&Case::fidelity, &Fidelity::nodes),
      std::vector<int>(std::begin(kIcosphereNodes), std::end(kIcosphereNodes)), "a subdivided icosahedron");
}

Value checkpoint_interval() {
  return std::make_shared<WholeNumberValue>(place_of(&Case::outputs, &Outputs::checkpoint_every),
                                            Range{0, 1000000});
}

Value latest_end() {
  const auto range_in = [](const Case& c) {
    return std::optional(Range{c.until.kt, kMaxTime, ", as it is no earlier than kt"});
  };
  return std::make_shared<NumberValue>(place_of(&Case::until, &Until::at_most), range_in,
                                       Range{kMinTime, kMaxTime});
}

bool has_aspect(const Case& c) { return c.has_aspect(); }
bool has_bending(const Case& c) { return c.has_bending(); }
bool has_grid(const Case& c) { return c.has_grid(); }
bool has_precision(const Case& c) { return c.has_precision(); }
bool can_use_symmetry(const Case& c) { return c.can_use_symmetry(); }
bool solves_for_flow(const Case& c) { return c.solves_for_flow(); }
bool chooses_time_step(const Case& c) { return c.fluid != Fluid::transient; }
bool chooses_stepper(const Case& c) { return c.fluid != Fluid::unsteady; }
bool chooses_scheme(const Case& c) { return c.fluid != Fluid::unsteady; }
bool has_fixed_settings(const Case& c) { return c.fidelity.error == 0; }
bool has_error_asked_for(const Case& c) { return c.fidelity.error > 0; }
bool ends_when_classified(const Case& c) { return c.until.classified; }
bool has_equal_steps(const Case& c) { return c.fidelity.stepper == Stepper::adams_bashforth; }

Condition needs_aspect() { return {has_aspect, "only oblate and prolate shapes have an aspect", "shape"}; }
Condition needs_bending() { return {has_bending, "E_b is 0, so there is no bending resistance", "E_b"}; }
/// With boundary integrals Re may be given. It is ignored, and this is recorded in the choices of the case.
Condition takes_inertia() { return {has_grid, ""}; }
Condition needs_grid() { return {has_grid, "boundary integrals have no grid"}; }
Condition needs_own_time_step() {
  return {chooses_time_step, "the transient flow's time step is set by the lattice"};
}
Condition needs_choice_of_stepper() {
  return {chooses_stepper, "the unsteady flow is solved for once a step, at increasing times, as by ab2"};
}
Condition needs_choice_of_scheme() { return {chooses_scheme, "the unsteady flow has one scheme"}; }
Condition needs_ladder() {
  return {has_ladder, "only boundary integrals and the composite grid have a ladder"};
}
Condition needs_fixed_settings() { return {has_fixed_settings, "it follows from the error asked for"}; }
Condition needs_classification() { return {ends_when_classified, "without classified a run ends at kt"}; }
Condition needs_error_asked_for() { return {has_error_asked_for, ""}; }
Condition needs_equal_steps() { return {has_equal_steps, "rkc2 chooses its steps by their error"}; }
Condition needs_solution() {
  return {solves_for_flow, "at V = 1 boundary integrals give the flow without solving an equation", "V"};
}
Condition needs_symmetry() { return {can_use_symmetry, "this flow is always solved for as a whole"}; }
Condition needs_precision() {
  return {has_precision,
          "only the quasi-steady flow's tuned scheme, the unsteady and the transient flow have a choice"};
}

std::vector<Parameter> in_group(const char* group, std::vector<Parameter> parameters) {
  for (Parameter& parameter : parameters) parameter.group = group;
  return parameters;
}

std::vector<Parameter> shape_parameters() {
  return {
      {.key = "shape",
       .value = word(place_of(&Case::shape)),
       .description = "Shape at rest, scaled to the volume of the unit sphere."},
      {.key = "aspect",
       .value = aspect(),
       .conditions = {needs_aspect()},
       .description =
           "Axis of revolution over equatorial axis, b/a: at most 1 for oblate, at least 1 for prolate; "
           "required for both.",
       .required = "the axis of revolution over the equatorial axis (b/a)"},
  };
}

std::vector<Parameter> number_parameters() {
  return {
      {.key = "Ca",
       .value = number({1e-4, 100}, &Case::Ca),
       .description = "Capillary number: mu_a a k / E_s.",
       .required = "the capillary number"},
      {.key = "V",
       .value = number({0.01, 100}, &Case::V),
       .description = "Viscosity ratio: inside over outside."},
      {.key = "Re",
       .value = number({0, 10}, &Case::Re),
       .conditions = {takes_inertia()},
       .description =
           "Reynolds number: rho k a^2 / mu_a. By default 0; 0.05 with unsteady, transient and the scheme of "
           "the paper, which need inertia. At most 0.1, and without effect, with the fluid stokes."},
      {.key = "E_b",
       .value = number({0, 10}, &Case::E_b),
       .description = "Bending stiffness E_B / (a^2 E_s)."},
  };
}

std::vector<Parameter> model_parameters() {
  return {
      {.key = "bending",
       .value = word(place_of(&Case::bending)),
       .conditions = {needs_bending()},
       .description =
           "Forces that are the exact gradient of a discrete Helfrich energy, or eq. 31 of the paper "
           "read literally. Needs E_b > 0."},
      {.key = "c0",
       .value = std::make_shared<SpontaneousCurvatureValue>(),
       .conditions = {needs_bending()},
       .description =
           "Spontaneous curvature in 1/a, or that of the initial shape: at each vertex (initial) or its "
           "mean (uniform). Needs E_b > 0."},
      {.key = "fluid",
       .value = word(place_of(&Case::fluid), "auto"),
       .description =
           "Steady lattice Boltzmann flow at every step by multigrid (the paper's method), the same with "
           "the time derivative of the flow (unsteady), the standard lattice Boltzmann method in time "
           "(transient), or Stokes flow without walls by boundary integrals. auto takes stokes where Re is "
           "at most 0.1 and fidelity names nothing that only a lattice has (dx, box, scheme, precision, "
           "kdt, preset paper); else quasisteady below Re = 0.1, and unsteady. The result says what was "
           "chosen and why."},
  };
}

std::vector<Parameter> until_parameters() {
  return {
      {.key = "kt",
       .value = number({kMinTime, kMaxTime}, &Case::until, &Until::kt),
       .description = "Shear time."},
      {.key = "classified",
       .value = boolean(&Case::until, &Until::classified),
       .description =
           "End earlier, as soon as more time would not change the label, or the shape is steady; and go on "
           "beyond kt while the motion is undecided."},
      {.key = "at_most",
       .value = latest_end(),
       .conditions = {needs_classification()},
       .description = "Shear time at which a run ends even if it is undecided. By default 3 kt."},
  };
}

std::vector<Parameter> trust_parameters() {
  return {
      {.key = "companion",
       .value = boolean(&Case::companion),
       .conditions = {needs_ladder(), needs_fixed_settings()},
       .description = "Whether the same case is computed at twice the spacing, too, for an estimate of the "
                      "error and a second label. By default true."},
  };
}

std::vector<Parameter> resolution_parameters() {
  return {
      {.key = "error",
       // no smaller error is ever stated (error_estimate.cpp)
       .value = number({1e-3, 0.5}, &Case::fidelity, &Fidelity::error),
       .conditions = {needs_ladder(), needs_error_asked_for()},
       .description = "Instead of a preset: the largest error that the run may have, as the largest change "
                      "over time of Q = "
                      "D_xy (cos 2 theta, sin 2 theta). The run climbs the ladder of resolutions until its "
                      "estimate is below."},
      {.key = "dx",
       .value = number({0.02, 0.5}, &Case::fidelity, &Fidelity::dx),
       .conditions = {needs_grid(), needs_fixed_settings()},
       .description = "Lattice spacing (not with stokes, nor box and scheme); box/dx is a multiple of 8."},
      {.key = "box",
       .value = number({4, 100}, &Case::fidelity, &Fidelity::box),
       .conditions = {needs_grid()},
       .description = "Edge of the cubic domain. By default 25.6; 12.8 with transient and the scheme of the "
                      "paper."},
      {.key = "nodes",
       .value = nodes(),
       .conditions = {needs_fixed_settings()},
       .description = "Membrane vertices."},
      {.key = "stepper",
       .value = word(place_of(&Case::fidelity, &Fidelity::stepper)),
       .conditions = {needs_own_time_step(), needs_choice_of_stepper(), needs_fixed_settings()},
       .description =
           "Adams-Bashforth in equal steps, or Runge-Kutta-Chebyshev in steps after their error (the "
           "default with stokes, and with quasisteady where it takes less time). unsteady takes ab2."},
      {.key = "kdt",
       .value = number({kMinTime, 1}, &Case::fidelity, &Fidelity::kdt),
       .conditions = {needs_own_time_step(), needs_equal_steps(), needs_fixed_settings()},
       .description = "Time step of ab2; chosen for stability if not given."},
  };
}

std::vector<Parameter> flow_solution_parameters() {
  return {
      {.key = "tolerance",
       .value = number({1e-12, 0.1}, &Case::fidelity, &Fidelity::tolerance),
       .conditions = {needs_own_time_step(), needs_solution(), needs_fixed_settings()},
       .description =
           "Relative error of the membrane's velocity. Without effect with transient, and with stokes at "
           "V = 1, where no equation is solved. At least 1e-6 in single precision (with stokes, and with "
           "precision float)."},
      {.key = "scheme",
       .value = word(place_of(&Case::fidelity, &Fidelity::scheme)),
       .conditions = {needs_own_time_step(), needs_grid(), needs_choice_of_scheme(), needs_fixed_settings()},
       .description =
           "Of the quasisteady flow: tuned (fine grids around the capsule only), or the paper's own."},
      {.key = "symmetry",
       .value = word(place_of(&Case::fidelity, &Fidelity::symmetry)),
       .conditions = {needs_symmetry()},
       .description =
           "Solve for a quarter of the flow where the capsule is symmetric (with stokes, unsteady, and "
           "quasisteady's tuned scheme), or for all of it (none). By default auto."},
      {.key = "precision",
       .value = word(place_of(&Case::fidelity, &Fidelity::precision)),
       .conditions = {needs_precision()},
       .description =
           "Of the numbers on the grids of quasisteady's tuned scheme, of unsteady and of transient. By "
           "default float."},
  };
}

std::vector<Parameter> output_parameters() {
  return {
      {.key = "history_every",
       .value = number({kMinTime, 1}, &Case::outputs, &Outputs::history_every),
       .description = "Records at its multiples and at the end."},
      {.key = "shapes_every",
       .value = number({0, 10000, "", kMinTime, "no shapes"}, &Case::outputs, &Outputs::shapes_every),
       .description = "Shapes at its multiples and at the end; 0: none, else at least 1e-6."},
      {.key = "checkpoint_every",
       .value = checkpoint_interval(),
       .description = "Steps, beside the checkpoints that are written as time goes by; 0: those alone."},
  };
}

}  // namespace

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> table = [] {
    std::vector<Parameter> all;
    const std::vector<std::vector<Parameter>> parts = {shape_parameters(),
                                                       {strain_law_parameter()},
                                                       law_constant_parameters(),
                                                       number_parameters(),
                                                       model_parameters(),
                                                       trust_parameters(),
                                                       in_group("until", until_parameters()),
                                                       in_group("fidelity", resolution_parameters()),
                                                       in_group("fidelity", flow_solution_parameters()),
                                                       in_group("outputs", output_parameters())};
    for (const std::vector<Parameter>& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return table;
}

const std::vector<ParameterGroup>& parameter_groups() {
  static const std::vector<ParameterGroup> groups = {
      {"until", "When the run ends."},
      {"fidelity", "Accuracy against speed: a preset, or single settings on top of one."},
      {"outputs", "What is recorded, in intervals of shear time."}};
  return groups;
}

}  // namespace capstan
