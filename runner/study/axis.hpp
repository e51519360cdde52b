#pragma once
// One axis of a study: the values that one parameter of a case takes in turn.
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
  double count = 0;  ///< whole and at least 2, but not yet known to be small
  bool logarithmic = false;

  /// Between the ends rounded, so that a value can be typed in a filter: to six digits, or to as many as keep
  /// the distance between neighbours to a tenth.
  double value(std::size_t index) const;

  /// Distance between neighbours over the largest value.
  double relative_spacing() const;
};

/// The values of a list, each once.
struct AxisList {
  std::vector<nlohmann::json> values;
  std::vector<std::size_t> places;       ///< where each value stands first in the study's list
  std::vector<nlohmann::json> repeated;  ///< the values that stand there more than once
};

class Axis {
 public:
  Axis(std::string parameter, AxisList list) : parameter_(std::move(parameter)), values_(std::move(list)) {}
  Axis(std::string parameter, AxisRange range) : parameter_(std::move(parameter)), values_(range) {}

  const std::string& parameter() const { return parameter_; }
  double size() const;
  nlohmann::json value(std::size_t index) const;
  bool is_list() const { return std::holds_alternative<AxisList>(values_); }
  std::vector<nlohmann::json> repeated() const;

  /// Where (a part of) the value stands in the study: "/axes/Ca/2" in a list, "/axes/Ca" in a range.
  /// \param inner  pointer into the value, for one that is an object
  std::string pointer(std::size_t index, const std::string& inner) const;

 private:
  std::string parameter_;
  std::variant<AxisList, AxisRange> values_;
};

/// Reads what stands at /axes/Ca: a list, or {"from", "to", "count", "scale"}. Nothing after a fault. What a
/// list holds is judged with the cases that come of it.
std::optional<Axis> read_axis(const std::string& parameter, const nlohmann::json& json, Issues& issues);

/// The parameters that may be an axis, in the order in which axes are listed: those of a case, and fidelity.
const std::vector<std::string_view>& axis_parameters();

}  // namespace capstan
