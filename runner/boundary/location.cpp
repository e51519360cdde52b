#include "runner/boundary/location.hpp"

#include <algorithm>
#include <cmath>

namespace capstan {
namespace {

/// A place along the row and a number that is to become 0.
struct Sample {
  double value, number;
};

/// Linear in the logarithm of the value.
double root_between(const Sample& a, const Sample& b) {
  const double share = a.number / (a.number - b.number);
  return a.value * std::pow(b.value / a.value, share);
}

std::optional<double> passage_value(const std::vector<RowPoint>& points, const Crossing& crossing) {
  if (!crossing.passage) return std::nullopt;
  const RowPoint &below = points[crossing.passage->low], &above = points[crossing.passage->high];
  const double a = score(below), b = score(above);
  return a == b ? std::sqrt(below.value * above.value) : root_between({below.value, a}, {above.value, b});
}

/// How far the score of a point lies on one side of 0 beyond its error; NaN if the error is unknown.
/// \param side  1 where the shape turns over, -1 where the membrane turns
double clearance(const RowPoint& point, int side) { return side * score(point) - point.error; }

/// The limit of the boundary on one side: from there on the errors leave no doubt on which side of it a point
/// lies. Goes outwards, from the boundary to the end of the crossing.
/// \param nearest  the boundary if it is known
/// \param outwards the points, the nearest first
std::optional<double> limit(const std::optional<double>& boundary, const std::vector<RowPoint>& outwards,
                            int side) {
  std::optional<Sample> doubtful;
  if (boundary) doubtful = {*boundary, -outwards.front().error};
  for (const RowPoint& point : outwards) {
    const double beyond = clearance(point, side);
    if (std::isnan(beyond)) return std::nullopt;
    if (beyond > 0) return doubtful ? root_between(*doubtful, {point.value, beyond}) : point.value;
    doubtful = {point.value, beyond};
  }
  return std::nullopt;
}

int side_of(const RowPoint& point) { return score(point) > 0 ? 1 : -1; }

std::vector<RowPoint> part(const std::vector<RowPoint>& points, std::size_t from, std::size_t to) {
  return {points.begin() + std::ptrdiff_t(from), points.begin() + std::ptrdiff_t(to) + 1};
}

std::optional<double> lower_limit(const std::vector<RowPoint>& points, const Crossing& crossing,
                                  const std::optional<double>& boundary) {
  std::vector<RowPoint> outwards =
      part(points, crossing.first, crossing.passage ? crossing.passage->low : crossing.last);
  std::ranges::reverse(outwards);
  return limit(boundary, outwards, side_of(points[crossing.first]));
}

std::optional<double> upper_limit(const std::vector<RowPoint>& points, const Crossing& crossing,
                                  const std::optional<double>& boundary) {
  return limit(boundary,
               part(points, crossing.passage ? crossing.passage->high : crossing.first, crossing.last),
               side_of(points[crossing.last]));
}

std::optional<double> value_if(bool condition, double value) {
  return condition ? std::optional(value) : std::nullopt;
}

}  // namespace

Location locate(const std::vector<RowPoint>& points, const Crossing& crossing) {
  Location at;
  const auto value = [&](std::size_t point) { return points[point].value; };
  at.value = passage_value(points, crossing);
  if (crossing.passage) {
    at.below = value(crossing.passage->low);
    at.above = value(crossing.passage->high);
  }
  if (crossing.passage || crossing.to == Motion::transition) at.low = lower_limit(points, crossing, at.value);
  if (crossing.passage || crossing.from == Motion::transition)
    at.high = upper_limit(points, crossing, at.value);
  at.band_begin = value_if(crossing.from != Motion::transition, value(crossing.begin.low));
  at.band_end = value_if(crossing.to != Motion::transition, value(crossing.end.high));
  at.confirmed_below = value_if(has_class(points[crossing.first]), value(crossing.first));
  at.confirmed_above = value_if(has_class(points[crossing.last]), value(crossing.last));
  return at;
}

}  // namespace capstan
