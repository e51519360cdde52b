#include "runner/study/axis.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace capstan {
namespace {

using nlohmann::json;

double rounded_to_six_digits(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.begin(), text.end(), number, std::chars_format::scientific, 5).ptr;
  double rounded = number;
  std::from_chars(text.begin(), end, rounded);
  return rounded;
}

/// Reads one range; its faults gather in `issues`.
class RangeReader {
 public:
  RangeReader(const json& object, std::string pointer, Issues& issues)
      : object_(object), pointer_(std::move(pointer)), issues_(issues) {}

  AxisRange read() {
    AxisRange range{number("from"), number("to"), number("count"), false};
    require(range.count >= 2 && range.count <= 1e6 && range.count == std::floor(range.count), "count",
            "must be a whole number >= 2 and <= 1000000");
    read_scale(range);
    if (range.logarithmic)
      for (const auto& [key, end] : {std::pair{"from", range.from}, std::pair{"to", range.to}})
        require(end > 0, key, "must be > 0 on a logarithmic scale");
    for (const auto& [key, value] : object_.items())
      require(key == "from" || key == "to" || key == "count" || key == "scale", key, "unknown key");
    return range;
  }

 private:
  void require(bool good, const std::string& key, const std::string& message) {
    const std::string place = pointer_ + "/" + key;
    const bool known = !issues_.empty() && issues_.back().pointer == place;
    if (!good && !known) issues_.push_back({place, message});
  }

  double number(const char* key) {
    const auto found = object_.find(key);
    const bool good = found != object_.end() && found->is_number() && std::isfinite(found->get<double>());
    require(good, key, found == object_.end() ? "is missing" : "must be a number");
    return good ? found->get<double>() : 2;  // any value that brings no second fault
  }

  void read_scale(AxisRange& range) {
    const json scale = object_.value("scale", json("linear"));
    require(scale == "linear" || scale == "log", "scale", "must be one of: linear, log");
    range.logarithmic = scale == "log";
  }

  const json& object_;
  std::string pointer_;
  Issues& issues_;
};

}  // namespace

double AxisRange::value(std::size_t index) const {
  if (index == 0) return from;
  const double last = count - 1;
  if (static_cast<double>(index) == last) return to;
  const double fraction = static_cast<double>(index) / last;
  return rounded_to_six_digits(logarithmic ? from * std::pow(to / from, fraction)
                                           : from + (to - from) * fraction);
}

double Axis::size() const {
  if (const auto* range = std::get_if<AxisRange>(&values_)) return range->count;
  return static_cast<double>(std::get<std::vector<json>>(values_).size());
}

json Axis::value(std::size_t index) const {
  if (const auto* range = std::get_if<AxisRange>(&values_)) return range->value(index);
  return std::get<std::vector<json>>(values_)[index];
}

std::string Axis::pointer(std::size_t index, const std::string& inner) const {
  const std::string place = "/axes/" + parameter_;
  return std::holds_alternative<AxisRange>(values_) ? place : place + "/" + std::to_string(index) + inner;
}

std::optional<Axis> read_axis(const std::string& parameter, const json& given, Issues& issues) {
  const std::string pointer = "/axes/" + parameter;
  if (given.is_array() && !given.empty())
    return Axis(parameter, std::vector<json>(given.begin(), given.end()));
  if (given.is_object()) {
    Issues faults;
    const AxisRange range = RangeReader(given, pointer, faults).read();
    if (faults.empty()) return Axis(parameter, range);
    issues.insert(issues.end(), faults.begin(), faults.end());
  } else if (given.is_array()) {
    issues.push_back({pointer, "must have at least one value"});
  } else {
    issues.push_back({pointer, std::string("must be a list or a range, is ") + given.type_name()});
  }
  return std::nullopt;
}

const std::vector<std::string_view>& axis_parameters() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all = scalar_parameters();
    all.push_back("fidelity");
    return all;
  }();
  return names;
}

}  // namespace capstan
