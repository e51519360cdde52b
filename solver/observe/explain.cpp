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

std::string needed_kt(const MotionFeatures& features) {
  const double kt = features.run.back().kt, seen = turns(features.run);
  constexpr double kEnoughToTell = 0.05;
  if (seen < kEnoughToTell) return "ask for a later until.kt";
  return "at this rate the first one ends at about kt = " +
         std::to_string(std::lround(kStart + (kt - kStart) / seen + 0.5));
}

std::string too_short(const MotionFeatures& features) {
  return digits(std::max(0., turns(features.run))) + " half-turns were seen from kt = " + digits(kStart) +
         " on, at least 1 is needed: " + needed_kt(features) +
         ". The same case with a later end goes on from here.";
}

std::string reason_for_transition(const MotionFeatures& features) {
  if (features.shares.are_of_both_kinds())
    return "Some half-turns were of the shape, others of the membrane.";
  if (features.turned_both())
    return "Shape and membrane both turned: the share of the shape is r = " + digits(features.r) + ".";
  return "The section came near to round: D_min = " + digits(features.D_min) + " is less than " +
         digits(features.required) + ".";
}

std::string what_would_settle_it(const MotionFeatures& features) {
  return " It would settle with " + count(kSettled, "half-turn") +
         " of one kind in a row; seen so far: " + count(to_tenths(turns(features.run)), "half-turn") +
         ", the last " + count(features.of_last_kind, "half-turn") + " of one kind.";
}

/// The part of the capsule that turns in this kind of motion.
std::string what_turned(Motion motion) { return motion == Motion::tumbling ? "shape" : "membrane"; }

/// Says that an earlier motion was of the other kind; empty if none was.
std::string what_came_before(const MotionFeatures& features) {
  if (!features.shares.are_of_both_kinds()) return "";
  return " Before them others were of the other kind.";
}

std::string settled(Motion motion, const MotionFeatures& features) {
  return "The last " + count(features.of_last_kind, "half-turn") + " were of the " + what_turned(motion) +
         "." + what_came_before(features);
}

std::string clear(Motion motion, const MotionFeatures& features) {
  return "Of " + count(to_tenths(turns(features.run)), "half-turn") + " nearly all is of the " +
         what_turned(motion) + " (r = " + digits(features.r) +
         "), and the section kept away from round (D_min = " + digits(features.D_min) + ").";
}

}  // namespace

std::string explanation(Motion motion, const MotionFeatures& features) {
  if (motion == Motion::undecided) return too_short(features);
  if (motion == Motion::transition) return reason_for_transition(features) + what_would_settle_it(features);
  if (features.steady) return "The shape is steady, and the membrane turns.";
  return features.settled ? settled(motion, features) : clear(motion, features);
}

std::string explanation_without_features(Samples samples) {
  const bool is_early = samples.empty() || samples.back().kt < kStart;
  if (!is_early) return "The positions are not finite.";
  return "0 half-turns were seen: they are counted from kt = " + digits(kStart) +
         " on. At least 1 is needed: ask for a later until.kt.";
}

}  // namespace capstan
