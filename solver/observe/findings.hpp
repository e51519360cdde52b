#pragma once
// What the rules of classify.hpp look at: the half-turns of a run, and which part of it is judged.
#include <optional>
#include <vector>

#include "solver/observe/half_turns.hpp"

namespace capstan {

constexpr double kStart = 3;  ///< kt from which on half-turns are counted: the start is forgotten
constexpr int kSettled = 3;   ///< half-turns of one kind in which a motion settles

struct Findings {
  Samples run;                      ///< from kStart on
  Samples judged;                   ///< the part that the label is about
  bool steady = false;              ///< rule 1
  bool settled = false;             ///< rule 2
  std::vector<Samples> half_turns;  ///< the last one first
  Shares shares;                    ///< of the shape in the half-turns of the run
  int of_last_kind = 0;             ///< how many of the last half-turns are of the kind of the last one
  double r = 0, D_min = 0;          ///< of the judged part
  double required = 0;              ///< the D_min that rule 4 asks for

  bool turned_both() const { return kOfMembrane < r && r < kOfShape; }
  bool came_near_round() const { return D_min < required; }

  /// D_min in units of the one asked for.
  double clearance() const { return required > 0 ? D_min / required : 0; }
};

/// Nothing if the run ended before kStart or is not finite.
std::optional<Findings> look_at(Samples samples);

}  // namespace capstan
