#include "runner/study/axis.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "solver/case/mistyped_keys.hpp"
#include "solver/case/nearest_word.hpp"
#include "solver/case/parameters.hpp"
#include "solver/case/significant_digits.hpp"

namespace capstan {
namespace {

using nlohmann::json;

constexpr int kMinDigits = 6, kMaxDigits = 15;  // a double holds 15 decimal digits

/// The digits at which rounding changes the distance of two neighbours by less than a tenth. Rounding to d
/// digits changes a value by at most 0.5 * 10^(1-d) of itself.
double digits_for(double relative_spacing) { return std::ceil(1 + std::log10(10 / relative_spacing)); }

/// -0.0 is 0.
json without_sign_of_zero(const json& value) {
  return value.is_number_float() && value == 0.0 ? json(0.0) : value;
}

AxisList listed_once(const json& given) {
  AxisList list;
  std::map<json, bool> is_repeated;  // 4 and 4.0 are equal keys
  for (std::size_t place = 0; place < given.size(); ++place) {
    const json value = without_sign_of_zero(given[place]);
    const auto [known, is_new] = is_repeated.emplace(value, false);
    if (is_new) {
      list.values.push_back(value);
      list.places.push_back(place);
    } else if (!known->second) {
      known->second = true;
      list.repeated.push_back(value);
    }
  }
  return list;
}

/// Reads one range and adds its issues to a list.
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
    if (issues_.empty()) require_distance(range);
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

  void require_distance(const AxisRange& range) {
    if (range.from == range.to)
      issues_.push_back({pointer_, "from and to are the same number: give a list of one value"});
    else if (!(digits_for(range.relative_spacing()) <= kMaxDigits))
      issues_.push_back({pointer_, "the values lie too close together: 15 digits do not tell them apart"});
  }

  double number(const char* key) {
    const auto found = object_.find(key);
    const bool good = found != object_.end() && found->is_number() && std::isfinite(found->get<double>());
    require(good, key, found == object_.end() ? "is missing" : "must be a number");
    return good ? found->get<double>() + 0.0 : 2;  // any value that causes no second issue
  }

  void read_scale(AxisRange& range) {
    const json scale = object_.value("scale", json("linear"));
    const std::string typed = scale.is_string() ? scale.get<std::string>() : "";
    require(scale == "linear" || scale == "log", "scale",
            "must be one of: linear, log" + suggestion(typed, {"linear", "log"}));
    range.logarithmic = scale == "log";
  }

  const json& object_;
  std::string pointer_;
  Issues& issues_;
};

}  // namespace

double AxisRange::relative_spacing() const {
  const double last = count - 1;
  if (logarithmic) return std::abs(std::pow(to / from, 1 / last) - 1);
  return std::abs(to / last - from / last) / std::max(std::abs(from), std::abs(to));
}

double AxisRange::value(std::size_t index) const {
  if (index == 0) return from;
  const double last = count - 1;
  if (static_cast<double>(index) == last) return to;
  const double fraction = static_cast<double>(index) / last;
  const double exact = logarithmic ? from * std::pow(to / from, fraction) : from + (to - from) * fraction;
  const bool is_rounding_error = !logarithmic && std::abs(exact) < 1e-9 * std::abs(to - from) / last;
  if (is_rounding_error) return 0;
  const double digits = std::max<double>(kMinDigits, digits_for(relative_spacing()));
  return with_significant_digits(exact, static_cast<int>(digits));
}

double Axis::size() const {
  if (const auto* range = std::get_if<AxisRange>(&values_)) return range->count;
  return static_cast<double>(std::get<AxisList>(values_).values.size());
}

json Axis::value(std::size_t index) const {
  if (const auto* range = std::get_if<AxisRange>(&values_)) return range->value(index);
  return std::get<AxisList>(values_).values[index];
}

std::vector<json> Axis::repeated() const {
  const auto* list = std::get_if<AxisList>(&values_);
  return list ? list->repeated : std::vector<json>();
}

std::string Axis::pointer(std::size_t index, const std::string& inner) const {
  const auto* list = std::get_if<AxisList>(&values_);
  return list ? place_ + "/" + std::to_string(list->places[index]) + inner : place_;
}

std::optional<Axis> read_axis(const std::string& parameter, const json& given, const std::string& pointer,
                              Issues& issues) {
  if (given.is_array() && !given.empty()) return Axis(parameter, listed_once(given), pointer);
  if (given.is_object()) {
    json corrected = given;
    Issues found = rename_mistyped_keys(corrected, {"from", "to", "count", "scale"}, pointer);
    const AxisRange range = RangeReader(corrected, pointer, found).read();
    if (found.empty()) return Axis(parameter, range, pointer);
    issues.insert(issues.end(), found.begin(), found.end());
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

bool takes_numbers(std::string_view parameter) {
  const Parameter* found = find_parameter(parameter);
  return found && found->value->takes_numbers();
}

}  // namespace capstan
