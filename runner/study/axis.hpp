#pragma once
// One axis of a study: the values of one parameter.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/case/parse.hpp"

namespace capstan {

/// Evenly spaced values from `from` to `to`, both included: in value, or in logarithm.
struct AxisRange {
  double from = 0;
  double to = 0;
  double count = 0;  ///< a whole number >= 2; can be larger than any integer type
  bool logarithmic = false;

  /// The value at an index. Values between the ends are rounded so that they can be typed in a filter: to six
  /// digits, or to more where the rounding would exceed a tenth of the spacing.
  double value(std::size_t index) const;

  /// Distance between neighbours over the largest value.
  double relative_spacing() const;
};

/// The values of a list, each once.
struct AxisList {
  std::vector<nlohmann::json> values;
  std::vector<std::size_t> places;       ///< index of each value in the list of the study
  std::vector<nlohmann::json> repeated;  ///< values that occur there more than once
};

class Axis {
 public:
  /// \param place  pointer to the values in the study
  Axis(std::string parameter, AxisList list, std::string place)
      : parameter_(std::move(parameter)), place_(std::move(place)), values_(std::move(list)) {}
  Axis(std::string parameter, AxisRange range, std::string place)
      : parameter_(std::move(parameter)), place_(std::move(place)), values_(range) {}

  const std::string& parameter() const { return parameter_; }
  double size() const;
  nlohmann::json value(std::size_t index) const;
  bool is_list() const { return std::holds_alternative<AxisList>(values_); }
  std::vector<nlohmann::json> repeated() const;

  /// Pointer into the study to (a part of) a value: "/axes/Ca/2" in a list, "/axes/Ca" in a range.
  /// \param inner  pointer into the value, for one that is an object
  std::string pointer(std::size_t index, const std::string& inner) const;

 private:
  std::string parameter_;
  std::string place_;
  std::variant<AxisList, AxisRange> values_;
};

/// Reads the values of a parameter: a list, or {"from", "to", "count", "scale"}. Nothing if it has an issue.
/// The values of a list are checked later, with the cases.
/// \param place  pointer to the values in the study: "/axes/Ca"
std::optional<Axis> read_axis(const std::string& parameter, const nlohmann::json& json,
                              const std::string& place, Issues& issues);

/// The parameters that can be an axis, in the order in which axes are listed: the scalar ones and fidelity.
const std::vector<std::string_view>& axis_parameters();

/// Whether an axis of this parameter can be of numbers; false for keys that are no parameters.
bool takes_numbers(std::string_view parameter);

}  // namespace capstan
