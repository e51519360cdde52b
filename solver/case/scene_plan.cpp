#include "solver/case/scene_plan.hpp"

#include "solver/case/case_warnings.hpp"
#include "solver/case/equal_accuracy.hpp"
#include "solver/case/ladder.hpp"
#include "solver/case/left_out.hpp"
#include "solver/case/modelled.hpp"
#include "solver/case/run_cost.hpp"
#include "solver/case/run_size.hpp"
#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

std::string resolution_in_words(const Case& c) {
  return (c.has_grid() ? "dx = " + shown(c.fidelity.dx) + " and " : "") + std::to_string(c.fidelity.nodes) +
         " nodes";
}

std::optional<ScenePlan::OtherFluid> other_fluid(const Case& c) {
  const auto other = with_other_fluid(c);
  if (!other) return std::nullopt;
  const auto error = measured_error(c);
  const double others_error = measured_error(*other).value().max;
  return ScenePlan::OtherFluid{std::string(to_string(other->fluid)) + " with " + resolution_in_words(*other) +
                                   ", off by up to " + rounded(others_error),
                               !error || others_error <= error->max, case_cost(*other)};
}

std::string expected_error(const Case& c) {
  if (c.fidelity.error > 0)
    return "Q = D_xy (cos 2 theta, sin 2 theta) is off by at most " + shown(c.fidelity.error) +
           ", as asked for: finer runs follow until the estimate is that small, or none is left";
  const auto companion = companion_of(c);
  return error_in_words(c) +
         (companion ? "; the run estimates its own from a second one, with " + resolution_in_words(*companion)
                    : "");
}

}  // namespace

ScenePlan plan_of(const Case& c) {
  return {.modelled = modelled(c),
          .left_out = left_out(c),
          .warnings = case_warnings(c),
          .error = expected_error(c),
          .kdt = equal_time_step(c),
          .seconds = case_cost(c),
          .memory = run_memory(c),
          .disk = run_size(c),
          .other_fluid = other_fluid(c)};
}

}  // namespace capstan
