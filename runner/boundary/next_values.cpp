#include "runner/boundary/next_values.hpp"

#include <cmath>

#include "runner/boundary/crossings.hpp"
#include "solver/case/significant_digits.hpp"

namespace capstan {
namespace {

/// A change that is to be located.
struct Change {
  Bracket bracket;
  double score;  ///< expected at the change
  double goal;   ///< largest distance of the points around it, in the logarithm of the parameter
};

/// Rounded to as few digits as change it by much less than the goal, so that a user can type it in a filter.
double rounded_value(double value, double goal) {
  return with_significant_digits(value, int(std::ceil(2 + std::log10(1 / goal))));
}

class RowSearch {
 public:
  RowSearch(const BoundarySearch& search, const std::vector<RowPoint>& row)
      : tolerance_(std::log1p(search.tolerance)), points_(labelled(row)) {
    for (const RowPoint& point : row) asked_.push_back(std::log(point.value));
    std::ranges::sort(asked_);
  }

  std::vector<double> next() const {
    std::vector<double> values;
    for (const Crossing& crossing : find_crossings(points_))
      for (const Change& change : changes_of(crossing))
        if (const auto at = next_in(change)) {
          const double value = rounded_value(std::exp(*at), change.goal);
          if (std::ranges::find(values, value) == values.end()) values.push_back(value);
        }
    return values;
  }

  /// Each point divides a bracket by about eight, and one more closes it.
  int expected() const {
    double number = 0;
    for (const Crossing& crossing : find_crossings(points_))
      for (const Change& change : changes_of(crossing)) {
        const auto [below, above] = widest_gap(place(change.bracket.low), place(change.bracket.high));
        if (above - below > change.goal) number += 1 + std::log((above - below) / change.goal) / std::log(8);
      }
    return int(std::lround(number));
  }

 private:
  double place(std::size_t point) const { return std::log(points_[point].value); }

  /// The passage first. A bracket that is that of the passage, too, is not divided twice.
  std::vector<Change> changes_of(const Crossing& crossing) const {
    std::vector<Change> changes;
    const auto add = [&](const Bracket& bracket, double score, double goal) {
      const auto is_same = [&](const Change& known) { return known.bracket == bracket; };
      if (std::ranges::none_of(changes, is_same)) changes.push_back({bracket, score, goal});
    };
    if (crossing.passage) {
      add({crossing.passage->low, crossing.passage->low + 1}, 0, tolerance_);
      add({crossing.passage->high - 1, crossing.passage->high}, 0, tolerance_);
    }
    const double goal = crossing.passage ? std::max(tolerance_, band_of(crossing) / 4) : tolerance_;
    const auto end_of_motion = [](Motion motion) {
      return motion == Motion::tumbling ? kNearRound : -kNearRound;
    };
    if (crossing.from != Motion::transition) add(crossing.begin, end_of_motion(crossing.from), goal);
    if (crossing.to != Motion::transition) add(crossing.end, end_of_motion(crossing.to), goal);
    return changes;
  }

  /// Width of the band; up to the end of the row where it reaches that.
  double band_of(const Crossing& crossing) const {
    const std::size_t begin = crossing.from == Motion::transition ? crossing.first : crossing.begin.low;
    const std::size_t end = crossing.to == Motion::transition ? crossing.last : crossing.end.high;
    return place(end) - place(begin);
  }

  /// Nothing if the change is located.
  std::optional<double> next_in(const Change& change) const {
    const double low = place(change.bracket.low), high = place(change.bracket.high);
    const auto [below, above] = widest_gap(low, high);
    if (above - below <= change.goal) return std::nullopt;
    const bool has_failed_points = below > low || above < high;
    return has_failed_points ? (below + above) / 2 : guess(change);
  }

  /// The widest part of a bracket that has no point inside: also points that have no label stand in the row,
  /// and are not asked for again.
  std::pair<double, double> widest_gap(double low, double high) const {
    std::pair<double, double> widest{low, low};
    for (double below = low; const double above : asked_) {
      if (above <= low) continue;
      if (above - below > widest.second - widest.first) widest = {below, above};
      below = above;
      if (above >= high) break;
    }
    return widest;
  }

  /// The place where the score is expected to pass its value at the change, by linear interpolation; shifted
  /// a little away from the nearer end of the bracket, so that the new point probably closes the bracket on
  /// the other side of the change. The middle, if the scores contradict the labels.
  double guess(const Change& change) const {
    const double low = place(change.bracket.low), high = place(change.bracket.high), half = (high - low) / 2;
    const double at_low = score(points_[change.bracket.low]) - change.score;
    const double at_high = score(points_[change.bracket.high]) - change.score;
    if (!(at_low * at_high < 0)) return low + half;
    const double root = (high - low) * at_low / (at_low - at_high);  // from low
    const bool is_near_low = root < half;
    const double from_end = (is_near_low ? root : 2 * half - root) + 0.4 * change.goal;
    const double step = std::min(half, std::max(from_end, least_step(change.bracket, is_near_low)));
    return is_near_low ? low + step : high - step;
  }

  /// Twice the last step of the nearer end if that was short. So a bracket is closed after few points also
  /// where the interpolation is poor.
  double least_step(const Bracket& bracket, bool is_near_low) const {
    const bool has_neighbour = is_near_low ? bracket.low > 0 : bracket.high + 1 < points_.size();
    if (!has_neighbour) return 0;
    const double last_step = is_near_low ? place(bracket.low) - place(bracket.low - 1)
                                         : place(bracket.high + 1) - place(bracket.high);
    const double half = (place(bracket.high) - place(bracket.low)) / 2;
    return last_step < half ? 2 * last_step : 0;
  }

  double tolerance_;
  std::vector<RowPoint> points_;
  std::vector<double> asked_;
};

}  // namespace

std::vector<double> next_values(const BoundarySearch& search, const std::vector<RowPoint>& row) {
  if (!std::ranges::all_of(row, &RowPoint::has_ended)) return {};
  return RowSearch(search, row).next();
}

int expected_values(const BoundarySearch& search, const std::vector<RowPoint>& row) {
  const auto waiting = std::ranges::count_if(row, [](const RowPoint& point) { return !point.has_ended; });
  return std::max(0, RowSearch(search, row).expected() - int(waiting));
}

}  // namespace capstan
