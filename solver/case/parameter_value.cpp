#include "solver/case/parameter_value.hpp"

#include <algorithm>
#include <cmath>

#include "solver/case/nearest_word.hpp"
#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using Reading = ParameterValue::Reading;

/// A Place takes a non-const Case. The cast is safe, because the value is only read.
template <class T>
const T& value_at(const Place<T>& place, const Case& c) {
  return *place(const_cast<Case&>(c));
}

std::string issue_with_number(const json& given, const Range& range) {
  if (!given.is_number()) return std::string("must be a number, is ") + given.type_name();
  const double number = given.get<double>();
  if (!std::isfinite(number) || !(number >= range.min) || number > range.max)
    return "is " + shown(number) + ", must be >= " + shown(range.min) + " and <= " + shown(range.max) +
           range.owner;
  if (number > 0 && number < range.min_above_zero)
    return "is " + shown(number) + ", must be 0 (" + range.zero + ") or at least " +
           shown(range.min_above_zero);
  return "";
}

/// A whole number is written as 1, not as 1.0.
ordered_json without_fraction(double number) {
  constexpr double kMaxWhole = 1e9;
  const bool is_whole = std::abs(number) < kMaxWhole && number == std::floor(number);
  return is_whole ? ordered_json(int(number)) : ordered_json(number);
}

ordered_json schema_of_range(const char* type, const Range& range) {
  return {{"type", type}, {"minimum", without_fraction(range.min)}, {"maximum", without_fraction(range.max)}};
}

const Range kSpontaneousCurvature = {-100, 100};

}  // namespace

WordFound find_word(const json& given, const std::vector<std::string>& words) {
  const std::string word = given.is_string() ? given.get<std::string>() : "";
  if (std::ranges::find(words, word) != words.end()) return {word, ""};
  std::string list;
  for (const std::string& each : words) list += (list.empty() ? "" : ", ") + each;
  return {nearest_word(word, words).value_or(""),
          "must be one of: " + list + "; is " + given.dump(-1, ' ', false, json::error_handler_t::replace) +
              suggestion(word, words)};
}

NumberValue::NumberValue(Place<double> place, const Range& range)
    : place_(std::move(place)), range_in_([range](const Case&) { return range; }), whole_(range) {}

Reading NumberValue::read(const json& given, Case& c) const {
  const auto range = range_in_(c);
  if (!range) return {};
  std::string issue = issue_with_number(given, *range);
  if (!issue.empty()) return {std::move(issue)};
  *place_(c) = given.get<double>() + 0.0;  // -0.0 becomes 0
  return {"", true};
}

ordered_json NumberValue::write(const Case& c) const { return value_at(place_, c); }

ordered_json NumberValue::schema() const { return schema_of_range("number", whole_); }

WholeNumberValue::WholeNumberValue(Place<int> place, std::vector<int> allowed, std::string meaning)
    : place_(std::move(place)),
      range_{double(allowed.front()), double(allowed.back())},
      allowed_(std::move(allowed)),
      meaning_(std::move(meaning)) {}

Reading WholeNumberValue::read(const json& given, Case& c) const {
  std::string issue = issue_with_number(given, range_);
  if (!issue.empty()) return {std::move(issue)};
  const double number = given.get<double>();
  const bool is_whole = number == std::floor(number),
             is_listed = std::ranges::find(allowed_, number) != allowed_.end();
  if (!is_whole) return {"must be a whole number"};
  if (!allowed_.empty() && !is_listed) return {"must be " + allowed_in_words()};
  *place_(c) = static_cast<int>(number);
  return {"", true};
}

/// "12, 42 or 162 (a subdivided icosahedron)"
std::string WholeNumberValue::allowed_in_words() const {
  std::string list;
  for (const int number : allowed_)
    list += (list.empty() ? "" : number == allowed_.back() ? " or " : ", ") + std::to_string(number);
  return list + " (" + meaning_ + ")";
}

ordered_json WholeNumberValue::write(const Case& c) const { return value_at(place_, c); }

ordered_json WholeNumberValue::schema() const {
  return allowed_.empty() ? schema_of_range("integer", range_) : ordered_json{{"enum", allowed_}};
}

Reading BooleanValue::read(const json& given, Case& c) const {
  if (!given.is_boolean()) return {std::string("must be true or false, is ") + given.type_name()};
  *place_(c) = given.get<bool>();
  return {"", true};
}

ordered_json BooleanValue::write(const Case& c) const { return value_at(place_, c); }

WordValue::WordValue(std::vector<std::string> words, std::function<void(Case&, std::string_view)> set,
                     std::function<std::string_view(const Case&)> get, std::string also)
    : words_(std::move(words)), set_(std::move(set)), get_(std::move(get)), also_(std::move(also)) {
  if (!also_.empty()) words_.push_back(also_);
}

Reading WordValue::read(const json& given, Case& c) const {
  WordFound found = find_word(given, words_);
  const bool has_value = !found.word.empty() && found.word != also_;
  if (has_value) set_(c, found.word);
  return {std::move(found.issue), has_value};
}

Reading SpontaneousCurvatureValue::read(const json& given, Case& c) const {
  if (given.is_number()) {
    std::string issue = issue_with_number(given, kSpontaneousCurvature);
    if (!issue.empty()) return {std::move(issue)};
    c.c0 = given.get<double>() + 0.0;
  } else if (given == "uniform") {
    c.c0 = UniformCurvature{};
  } else if (given == "initial") {
    c.c0 = InitialCurvature{};
  } else {
    return {"must be a number (in units of 1/a), \"initial\" or \"uniform\"" +
            suggestion(given.is_string() ? given.get<std::string>() : "", words())};
  }
  return {"", true};
}

ordered_json SpontaneousCurvatureValue::write(const Case& c) const {
  if (const double* number = std::get_if<double>(&c.c0)) return *number;
  return std::holds_alternative<UniformCurvature>(c.c0) ? "uniform" : "initial";
}

ordered_json SpontaneousCurvatureValue::schema() const {
  return {{"oneOf", {schema_of_range("number", kSpontaneousCurvature), {{"enum", words()}}}}};
}

}  // namespace capstan
