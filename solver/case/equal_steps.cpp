#include "solver/case/equal_steps.hpp"

#include "solver/case/content_id.hpp"

namespace capstan {

std::string steps_id(const Case& c) {
  const Case defaults;
  Case steps = c;
  steps.until = defaults.until;
  steps.companion = defaults.companion;
  steps.outputs.checkpoint_every = defaults.outputs.checkpoint_every;
  return case_id(steps);
}

bool passes_end_of(const Until& earlier, double reached, const Until& later) {
  if (later.classified && !earlier.classified) return false;
  const bool differ_in_at_most = later.classified && earlier.kt == later.kt;
  return reached <= (differ_in_at_most ? later.at_most : later.kt);
}

}  // namespace capstan
