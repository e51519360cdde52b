#include "solver/observe/explain.hpp"

#include <cmath>

#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

std::string digits(double number) { return rounded(number, 2); }

std::string count(double number, const std::string& noun) {
  return digits(number) + " " + noun + (number == 1 ? "" : "s");
}

double to_tenths(double number) { return std::round(10 * number) / 10; }

std::string needed_kt(const Findings& found) {
  const double kt = found.run.back().kt, seen = turns(found.run);
  constexpr double kEnoughToTell = 0.05;
  if (seen < kEnoughToTell) return "ask for a later until.kt";
  return "at this rate the first one ends at about kt = " +
         std::to_string(std::lround(kStart + (kt - kStart) / seen + 0.5));
}

std::string too_short(const Findings& found) {
  return digits(std::max(0., turns(found.run))) + " half-turns were seen from kt = " + digits(kStart) +
         " on, at least 1 is needed: " + needed_kt(found) + ".";
}

std::string reason_for_transition(const Findings& found) {
  if (found.shares.are_of_both_kinds()) return "Some half-turns were of the shape, others of the membrane.";
  if (found.turned_both())
    return "Shape and membrane both turned: the share of the shape is r = " + digits(found.r) + ".";
  return "The section came near to round: D_min = " + digits(found.D_min) + " is less than " +
         digits(found.required) + ".";
}

std::string what_would_settle_it(const Findings& found) {
  return " It would settle with " + count(kSettled, "half-turn") +
         " of one kind in a row; seen so far: " + count(to_tenths(turns(found.run)), "half-turn") +
         ", the last " + count(found.of_last_kind, "half-turn") + " of one kind.";
}

std::string what_turned(Motion motion) { return motion == Motion::tumbling ? "shape" : "membrane"; }

/// Whether an earlier motion was of another kind than the settled one.
std::string what_came_before(const Findings& found) {
  if (!found.shares.are_of_both_kinds()) return "";
  return " Before them others were of the other kind.";
}

std::string settled(Motion motion, const Findings& found) {
  return "The last " + count(found.of_last_kind, "half-turn") + " were of the " + what_turned(motion) + "." +
         what_came_before(found);
}

std::string clear(Motion motion, const Findings& found) {
  return "Of " + count(to_tenths(turns(found.run)), "half-turn") + " nearly all is of the " +
         what_turned(motion) + " (r = " + digits(found.r) +
         "), and the section kept away from round (D_min = " + digits(found.D_min) + ").";
}

}  // namespace

std::string explanation(Motion motion, const Findings& found) {
  if (motion == Motion::undecided) return too_short(found);
  if (motion == Motion::transition) return reason_for_transition(found) + what_would_settle_it(found);
  if (found.steady) return "The shape is steady, and the membrane turns.";
  return found.settled ? settled(motion, found) : clear(motion, found);
}

std::string explanation_of_none(Samples samples) {
  const bool is_early = samples.empty() || samples.back().kt < kStart;
  if (!is_early) return "The positions are not finite.";
  return "0 half-turns were seen: they are counted from kt = " + digits(kStart) +
         " on. At least 1 is needed: ask for a later until.kt.";
}

}  // namespace capstan
