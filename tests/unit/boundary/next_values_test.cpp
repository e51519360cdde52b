// The search for the boundary on synthetic phase diagrams, whose boundary is known.
#include "runner/boundary/next_values.hpp"

#include <gmock/gmock.h>

#include <array>
#include <map>
#include <numeric>
#include <set>

#include "runner/boundary/location.hpp"
#include "tests/unit/boundary/synthetic_map.hpp"

namespace capstan {
namespace {

constexpr BoundarySearch kSearch{0.05, 1, 0.01};
constexpr int kExplored = 8;
const double kGap =
    std::pow(kSearch.to / kSearch.from, 1. / (kExplored - 1));  // of explored values: a factor

std::vector<double> explored_values() {
  std::vector<double> values;
  for (int i = 0; i < kExplored; ++i) values.push_back(kSearch.from * std::pow(kGap, i));
  return values;
}

using Row = std::vector<RowPoint>;

/// All points of a row, computed until no more are asked for.
Row searched_row(const SyntheticMap& map, double V) {
  Row row;
  for (std::vector<double> next = explored_values(); !next.empty(); next = next_values(kSearch, row))
    for (const double Ca : next) row.push_back(computed_point(map, Ca, V));
  return row;
}

std::vector<Location> locations_in(const Row& row) {
  const Row points = labelled(row);
  std::vector<Location> locations;
  for (const Crossing& crossing : find_crossings(points)) locations.push_back(locate(points, crossing));
  return locations;
}

/// The places where the exact score passes through 0.
std::vector<double> exact_boundaries(const SyntheticMap& map, double V) {
  constexpr int kSteps = 3000;
  std::vector<double> places;
  const auto at = [](int step) {
    return kSearch.from * std::pow(kSearch.to / kSearch.from, double(step) / kSteps);
  };
  for (int step = 0; step < kSteps; ++step)
    if ((map.score(at(step), V) > 0) != (map.score(at(step + 1), V) > 0)) places.push_back(at(step));
  return places;
}

double random_number(std::mt19937& generator, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(generator);
}

/// A score that falls with the logarithm of Ca, is 0 at `boundary` and levels off far from it.
double falling(double Ca, double boundary, double slope) {
  const double x = slope * std::log(boundary / Ca);
  return 0.4 * std::tanh(x / 0.4);
}

SyntheticMap straight(std::mt19937& random) {
  const double at = random_number(random, 0.1, 0.3), by = random_number(random, 0.02, 0.06),
               slope = random_number(random, 0.2, 1.5);
  return {"straight", [=](double Ca, double V) { return falling(Ca, at + by * (V - 1), slope); }};
}

SyntheticMap curved(std::mt19937& random) {
  const double at = random_number(random, 0.1, 0.2), power = random_number(random, 0.2, 0.9),
               slope = random_number(random, 0.2, 1.5);
  return {"curved", [=](double Ca, double V) {
            const double x = std::log(at * std::pow(V, power) / Ca);
            return 0.4 * std::tanh((slope * x + 0.8 * x * std::abs(x)) / 0.4);
          }};
}

/// Tank-treading inside tumbling, in a range of Ca that is wider than the distance of explored values.
SyntheticMap island(std::mt19937& random) {
  const double width = random_number(random, 1.15, 2) * std::log(kGap), depth = random_number(random, 0.5, 1);
  const double middle = random_number(random, std::log(0.05) + width, std::log(1.) - width);
  return {"island", [=](double Ca, double) {
            const double x = 2 * std::abs(std::log(Ca) - middle) / width;
            return 0.4 * std::tanh(depth * (x * x - 1) / 0.4);
          }};
}

/// Tumbling, a wide transition, tank-treading.
SyntheticMap three_phases(std::mt19937& random) {
  const double at = random_number(random, 0.15, 0.35), width = random_number(random, 0.1, 0.6);
  return {"three phases", [=](double Ca, double V) {
            const double x = std::log(at * (1 + 0.05 * V) / Ca) / width;
            return 0.05 * x + 0.3 * x * x * x / (1 + x * x);
          }};
}

SyntheticMap noisy(std::mt19937& random) {
  SyntheticMap map = straight(random);
  map.kind = "noise";
  map.noise = random_number(random, 0.005, 0.03);
  map.share_failed = 0.05;
  return map;
}

std::vector<SyntheticMap> hundred_maps() {
  std::mt19937 random(1);
  std::vector<SyntheticMap> maps;
  for (int i = 0; i < 20; ++i)
    for (const auto make : {straight, curved, island, three_phases, noisy}) maps.push_back(make(random));
  return maps;
}

constexpr std::array kRows = {1., 2., 4., 8.};

/// Calls `check` with each of the maps at each V, and with its searched row.
void for_each_row(const std::function<void(const SyntheticMap&, double V, const Row&)>& check) {
  for (const SyntheticMap& map : hundred_maps())
    for (const double V : kRows) {
      SCOPED_TRACE(map.kind + " at V = " + std::to_string(V));
      check(map, V, searched_row(map, V));
    }
}

bool lies_between(const std::optional<double>& low, double place, const std::optional<double>& high) {
  return (!low || *low <= place) && (!high || place <= *high);
}

TEST(NextValues, OnAHundredMapsFindEveryBoundaryWithinItsStatedLimits) {
  for_each_row([](const SyntheticMap& map, double V, const Row& row) {
    const std::vector<Location> found = locations_in(row);
    for (const double exact : exact_boundaries(map, V)) {
      const auto contains_it = [&](const Location& at) {
        return at.value && lies_between(at.low, exact, at.high);
      };
      EXPECT_TRUE(std::ranges::any_of(found, contains_it)) << exact;
    }
  });
}

TEST(NextValues, LocateTheBoundaryToTheToleranceUnlessRunsFail) {
  for_each_row([](const SyntheticMap& map, double, const Row& row) {
    if (map.share_failed > 0) return;
    for (const Location& at : locations_in(row)) {
      if (at.value) {
        EXPECT_LE(*at.above / *at.below, 1.0101);
      }
    }
  });
}

TEST(NextValues, LieOnBothSidesOfTheExactBoundaryWithoutNoise) {
  for_each_row([](const SyntheticMap& map, double V, const Row& row) {
    if (map.noise > 0) return;
    const std::vector<Location> found = locations_in(row);
    const auto exact = exact_boundaries(map, V);
    ASSERT_EQ(std::ranges::count_if(found, [](const Location& at) { return at.value.has_value(); }),
              std::ssize(exact));
    for (std::size_t i = 0; i < exact.size(); ++i) {
      EXPECT_LE(*found[i].below, exact[i] * 1.001);
      EXPECT_GE(*found[i].above, exact[i] * 0.999);
    }
  });
}

TEST(NextValues, NeedLessThanATenthOfTheRunsOfAUniformGridOfTheSameError) {
  const double uniform = std::log(kSearch.to / kSearch.from) / std::log1p(kSearch.tolerance);
  std::map<std::string, std::vector<double>> runs;
  for_each_row(
      [&](const SyntheticMap& map, double, const Row& row) { runs[map.kind].push_back(double(row.size())); });
  for (const auto& [kind, numbers] : runs) {
    const double mean = std::accumulate(numbers.begin(), numbers.end(), 0.) / double(numbers.size());
    RecordProperty(kind, std::to_string(mean / uniform));
    EXPECT_LT(mean, 0.1 * uniform) << kind;
  }
}

const SyntheticMap kSimple{"simple", [](double Ca, double) { return falling(Ca, 0.3, 0.5); }};

TEST(NextValues, AreNoneWhileAPointHasNotEnded) {
  Row row;
  for (const double Ca : explored_values()) row.push_back(computed_point(kSimple, Ca, 1));
  ASSERT_THAT(next_values(kSearch, row), ::testing::Not(::testing::IsEmpty()));
  row[3].has_ended = false;
  row[3].motion.reset();
  EXPECT_THAT(next_values(kSearch, row), ::testing::IsEmpty());
}

TEST(NextValues, DoNotDependOnTheOrderOfThePoints) {
  Row row;
  for (const double Ca : explored_values()) row.push_back(computed_point(kSimple, Ca, 1));
  const std::vector<double> next = next_values(kSearch, row);
  std::ranges::reverse(row);
  EXPECT_EQ(next_values(kSearch, row), next);
}

TEST(NextValues, AreNoneInARowOfOneMotion) {
  const SyntheticMap map{"tumbling", [](double, double) { return 0.3; }};
  EXPECT_EQ(searched_row(map, 1).size(), explored_values().size());
}

TEST(NextValues, AreNotThoseThatFailedBefore) {
  SyntheticMap map = kSimple;
  map.share_failed = 0.4;
  const Row row = searched_row(map, 1);
  std::set<double> values;
  for (const RowPoint& point : row) EXPECT_TRUE(values.insert(point.value).second) << point.value;
  EXPECT_LT(row.size(), 60u);
}

TEST(NextValues, EndForPointsThatAllFail) {
  SyntheticMap map = kSimple;
  map.share_failed = 1;
  EXPECT_EQ(searched_row(map, 1).size(), explored_values().size());
}

TEST(NextValues, EndForScoresThatContradictTheLabels) {
  Row row;
  for (std::vector<double> next = explored_values(); !next.empty(); next = next_values(kSearch, row))
    for (const double Ca : next)
      row.push_back({.value = Ca,
                     .has_ended = true,
                     .motion = Ca < 0.31 ? Motion::tumbling : Motion::tank_treading,
                     .r = 0.4,
                     .D_min = 0.2,
                     .error = 0.01});
  EXPECT_LT(row.size(), 30u);
  const Row points = labelled(row);
  const std::vector<Crossing> found = find_crossings(points);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(points[found[0].end.high].value / points[found[0].begin.low].value, 1.0101);
}

}  // namespace
}  // namespace capstan
