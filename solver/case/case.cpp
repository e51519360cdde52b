#include "solver/case/case.hpp"

namespace capstan {

nlohmann::ordered_json to_json(const Case& c) {
  nlohmann::ordered_json j;
  j["shape"] = to_string(c.shape);
  if (c.shape == Shape::oblate || c.shape == Shape::prolate) j["aspect"] = c.aspect;
  j["law"] = to_string(c.law);
  if (c.law == Law::skalak) j["C"] = c.C;
  j["Ca"] = c.Ca;
  j["V"] = c.V;
  if (c.has_grid()) j["Re"] = c.Re;
  j["E_b"] = c.E_b;
  if (c.has_bending()) {
    j["bending"] = to_string(c.bending);
    if (const double* number = std::get_if<double>(&c.c0))
      j["c0"] = *number;
    else
      j["c0"] = std::holds_alternative<UniformCurvature>(c.c0) ? "uniform" : "initial";
  }
  j["fluid"] = to_string(c.fluid);
  j["until"] = {{"kt", c.until.kt}, {"classified", c.until.classified}};
  nlohmann::ordered_json& f = j["fidelity"];
  if (c.has_grid()) {
    f["dx"] = c.fidelity.dx;
    f["box"] = c.fidelity.box;
  }
  f["nodes"] = c.fidelity.nodes;
  if (c.fluid != Fluid::transient) {
    f["stepper"] = to_string(c.fidelity.stepper);
    if (c.fidelity.stepper == Stepper::adams_bashforth) f["kdt"] = c.fidelity.kdt;
    if (c.solves_for_flow()) f["tolerance"] = c.fidelity.tolerance;
  }
  if (c.fluid == Fluid::quasisteady) f["scheme"] = to_string(c.fidelity.scheme);
  if (c.can_use_symmetry()) f["symmetry"] = to_string(c.fidelity.symmetry);
  if (c.has_precision()) f["precision"] = to_string(c.fidelity.precision);
  j["outputs"] = {{"history_every", c.outputs.history_every},
                  {"shapes_every", c.outputs.shapes_every},
                  {"checkpoint_every", c.outputs.checkpoint_every}};
  return j;
}

std::string_view to_string(Shape shape) {
  switch (shape) {
    case Shape::sphere:
      return "sphere";
    case Shape::oblate:
      return "oblate";
    case Shape::prolate:
      return "prolate";
    case Shape::biconcave:
      break;
  }
  return "biconcave";
}

std::string_view to_string(Law law) { return law == Law::skalak ? "skalak" : "neo-hookean"; }

std::string_view to_string(BendingModel model) {
  return model == BendingModel::variational ? "variational" : "helfrich_literal";
}

std::string_view to_string(Fluid fluid) {
  switch (fluid) {
    case Fluid::quasisteady:
      return "quasisteady";
    case Fluid::transient:
      return "transient";
    case Fluid::stokes:
      break;
  }
  return "stokes";
}

}  // namespace capstan
