#pragma once
// Each flow model with each of its steppers, small enough for unit tests.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/parsed_case.hpp"

namespace capstan::testing {

struct Model {
  const char* name;
  const char* knobs;  ///< JSON of fluid and fidelity
};

inline const auto kEveryModel = ::testing::Values(
    Model{"StokesRkc2", R"("fluid": "stokes", "fidelity": {"nodes": 162})"},
    Model{"StokesAb2", R"("fluid": "stokes", "fidelity": {"nodes": 162, "stepper": "ab2", "kdt": 0.02})"},
    Model{"LatticeAb2", R"("fluid": "quasisteady", "fidelity": {"dx": 0.4, "nodes": 162, "kdt": 0.03})"},
    Model{"LatticeRkc2",
          R"("fluid": "quasisteady", "fidelity": {"dx": 0.4, "nodes": 162, "stepper": "rkc2"})"},
    Model{"Unsteady", R"("fluid": "unsteady", "Re": 1, "fidelity": {"dx": 0.4, "nodes": 162, "kdt": 0.03})"},
    Model{"Transient", R"("fluid": "transient", "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 162})"},
    Model{"Paper", R"("fluid": "quasisteady",
                      "fidelity": {"preset": "paper", "dx": 0.4, "box": 6.4, "nodes": 162, "kdt": 0.04})"});

inline std::string name_of_model(const ::testing::TestParamInfo<Model>& model) { return model.param.name; }

/// A sphere with a viscosity ratio, to a time kt.
inline Case case_of_model(const Model& model, double kt, const Outputs& outputs) {
  Case c = parsed_case(std::string(R"({"Ca": 0.1, "V": 2, )") + model.knobs + "}");
  c.until.kt = kt;
  c.outputs = outputs;
  return c;
}

}  // namespace capstan::testing
