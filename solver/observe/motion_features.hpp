#pragma once
// The numbers that the rules of classify.hpp test: half-turns of a run, and the part of it that is
// classified.
#include <optional>
#include <vector>

#include "solver/observe/half_turns.hpp"

namespace capstan {

constexpr double kStart = 3;  ///< kt from which half-turns are counted: earlier motion depends on the start
constexpr int kSettled = 3;   ///< consecutive half-turns of one kind after which a motion counts as settled

struct MotionFeatures {
  Samples run;                      ///< from kStart on
  Samples judged;                   ///< the part of `run` from which the label is determined
  bool steady = false;              ///< rule 1
  bool settled = false;             ///< rule 2
  std::vector<Samples> half_turns;  ///< the last one first
  Shares shares;                    ///< of the shape in the half-turns of the run
  int of_last_kind = 0;  ///< number of consecutive half-turns at the end of the same kind as the last one
  double r = 0;          ///< share of the shape in the judged part
  double D_min = 0;      ///< smallest distance of Q to 0 in the judged part
  double required = 0;   ///< the D_min that rule 4 requires

  bool turned_both() const { return kOfMembrane < r && r < kOfShape; }
  bool came_near_round() const { return D_min < required; }

  /// D_min / required.
  double clearance() const { return required > 0 ? D_min / required : 0; }
};

/// Nothing if the run ended before kStart or has a sample that is not finite.
std::optional<MotionFeatures> motion_features(Samples samples);

}  // namespace capstan
