#include "runner/boundary/crossings.hpp"

namespace capstan {
namespace {

bool turns_over(const RowPoint& point) { return score(point) > 0; }

/// The first and the last point of each part.
std::vector<Bracket> parts_of(const std::vector<RowPoint>& points) {
  std::vector<Bracket> parts;
  std::size_t first = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (has_class(points[i]) || i + 1 == points.size()) {
      parts.push_back({first, i});
      first = i;
    }
  return parts;
}

/// The first pair of neighbours in a part of which only the second differs from the part's first point, and
/// the last pair of which only the first differs from its last point. Nothing if all are alike.
/// \param value  of a point: its label, or the sign of its score
template <class Value>
std::optional<std::pair<Bracket, Bracket>> changes(const Bracket& part, const Value& value) {
  std::size_t after = part.low, before = part.high;
  while (after < part.high && value(after) == value(part.low)) ++after;
  while (before > part.low && value(before) == value(part.high)) --before;
  if (value(after) == value(part.low)) return std::nullopt;
  return std::pair{Bracket{after - 1, after}, Bracket{before, before + 1}};
}

}  // namespace

std::vector<Crossing> find_crossings(const std::vector<RowPoint>& points) {
  std::vector<Crossing> crossings;
  for (const Bracket& part : parts_of(points)) {
    const auto labels = changes(part, [&](std::size_t i) { return *points[i].motion; });
    if (!labels) continue;
    Crossing& crossing = crossings.emplace_back(Crossing{part.low, part.high, *points[part.low].motion,
                                                         *points[part.high].motion, labels->first,
                                                         labels->second, std::nullopt});
    const auto sides = changes(part, [&](std::size_t i) { return turns_over(points[i]); });
    if (sides && turns_over(points[part.low]) != turns_over(points[part.high]))
      crossing.passage = Bracket{sides->first.low, sides->second.high};
  }
  return crossings;
}

}  // namespace capstan
