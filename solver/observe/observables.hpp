#pragma once
// The quantities that a run records in time, one a row of kObservables. History files and their parser,
// checkpoints, the database, CSV and HTTP answers all take their columns from this table. A new observable is
// one row here, and the function `measure` of the same name in measure.cpp.
#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace capstan {

struct Observable {
  enum class Type { real, count };  ///< a count is written without a decimal point

  std::string_view
      name;  ///< key in history.jsonl, column everywhere else: a letter, then letters, digits and _
  std::string_view unit;  ///< a: radius of the sphere of equal volume, k: shear rate, mu_a: ambient viscosity
  std::string_view description;
  Type type = Type::real;
  bool is_in_database = true;  ///< and in CSV and HTTP answers; otherwise in the run directory only
};

/// New rows go to the end: checkpoints identify an observable by its index.
inline constexpr Observable kObservables[] = {
    {.name = "kt", .unit = "1", .description = "shear time"},
    {.name = "D_xy",
     .unit = "1",
     .description = "Taylor deformation (L - l)/(L + l) of the inertia ellipsoid in the plane of shear"},
    {.name = "theta", .unit = "radian", .description = "angle of the major axis with x, unwrapped"},
    {.name = "psi",
     .unit = "radian",
     .description =
         "mean angle of the membrane's material points against the major axis, unwrapped, 0 at the start"},
    {.name = "volume", .unit = "a^3", .description = "enclosed volume"},
    {.name = "area", .unit = "a^2", .description = "area of the membrane"},
    {.name = "iterations",
     .unit = "1",
     .description = "flow iterations since the last record",
     .type = Observable::Type::count,
     .is_in_database = false},
    {.name = "error",
     .unit = "1",
     .description = "estimated relative error of the last flow solution",
     .is_in_database = false},
};
inline constexpr std::size_t kObservableCount = std::size(kObservables);

/// Index of a row of the table, from its name. A name that is not in the table does not compile.
struct ObservableRow {
  std::size_t index = 0;

  consteval ObservableRow(const char* name) {
    while (kObservables[index].name != name) ++index;
  }
  explicit constexpr ObservableRow(std::size_t row) : index(row) {}
};

/// The observables at one time: a line of history.jsonl. NaN where a number is missing.
struct Record {
  std::array<double, kObservableCount> values;  ///< in the order of the table

  constexpr Record() { values.fill(std::numeric_limits<double>::quiet_NaN()); }

  /// record["D_xy"]
  constexpr double& operator[](ObservableRow row) { return values[row.index]; }
  constexpr double operator[](ObservableRow row) const { return values[row.index]; }

  bool operator==(const Record&) const = default;
};

/// The records of a run, in the order of time.
using History = std::vector<Record>;

}  // namespace capstan
