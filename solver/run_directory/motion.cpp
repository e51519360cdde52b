#include "solver/run_directory/motion.hpp"

namespace capstan {

std::string_view to_string(Motion motion) {
  switch (motion) {
    case Motion::tumbling:
      return "tumbling";
    case Motion::tank_treading:
      return "tank_treading";
    case Motion::transition:
      return "transition";
    case Motion::undecided:
      break;
  }
  return "undecided";
}

std::optional<Motion> parse_motion(std::string_view word) {
  for (const Motion motion : kMotions)
    if (to_string(motion) == word) return motion;
  return std::nullopt;
}

}  // namespace capstan
