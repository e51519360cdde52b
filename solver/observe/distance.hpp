#pragma once
// How far two runs of one scene lie apart.
#include "solver/observe/observables.hpp"

namespace capstan {

/// Differences of two histories, over the records at the times that both have. NaN where it is not defined.
struct Distance {
  double Q = 0;       ///< largest |Q - Q'|, Q = D_xy (cos 2 theta, sin 2 theta)
  double D_xy = 0;    ///< largest |D_xy - D_xy'|
  double theta = 0;   ///< largest difference of the inclinations (axes, so at most pi/2), radians, where both
                      ///< D_xy are at least kClearlyInclined; NaN if they never are
  double period = 0;  ///< of the time of a half-turn (half_turns.hpp) from kt = 3 on, relative; NaN if one of
                      ///< the runs has less than half of one
  double until_kt = 0;  ///< the last time that both have
};

/// With a smaller D_xy the section is so round that a small error of Q turns its axis by a large angle.
inline constexpr double kClearlyInclined = 0.05;

/// \param run, other  records in the order of time
Distance distance_between(const History& run, const History& other);

}  // namespace capstan
