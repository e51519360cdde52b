#pragma once
// The plan of a case: what its run will model and leave out, what it will cost and how far off it may be. All
// of it follows from the case alone, before the run.
#include <optional>
#include <string>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

struct ScenePlan {
  std::vector<std::string> modelled;  ///< modelled()
  std::vector<std::string> left_out;  ///< left_out(), as in result.json
  std::vector<std::string> warnings;  ///< case_warnings(), as in result.json
  std::string error;                  ///< the expected error in words
  std::optional<double> kdt;          ///< time step; nothing where the stepper chooses it
  double seconds;                     ///< case_cost(), of one core
  double memory, disk;                ///< bytes: run_memory(), run_size()
  /// with_other_fluid(); nothing if the other flow model cannot compute the scene.
  struct OtherFluid {
    std::string words;    ///< flow model, resolution and error
    bool is_as_accurate;  ///< whether its error is not above that of the case
    double seconds;
  };
  std::optional<OtherFluid> other_fluid;
};

ScenePlan plan_of(const Case& c);

}  // namespace capstan
