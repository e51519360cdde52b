#pragma once
// The kinds of values that parameters have: each kind reads a JSON value into the case, writes it and
// describes it in a JSON schema.
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

struct Range {
  double min, max;  ///< both are allowed
  std::string owner =
      "";  ///< " for an oblate shape": whose range it is, where it depends on other parameters
  double min_above_zero = 0;  ///< the smallest value besides 0, where 0 switches something off
  std::string zero = "";      ///< what 0 means then
};

class ParameterValue {
 public:
  struct Reading {
    std::string issue = {};  ///< what is wrong with the value; "" if nothing
    bool has_value = false;  ///< the case has the value, or the one that a mistyped word was meant to be
  };

  virtual ~ParameterValue() = default;
  virtual Reading read(const nlohmann::json& given, Case& c) const = 0;
  virtual nlohmann::ordered_json write(const Case& c) const = 0;
  /// Keywords of JSON Schema for all values that the parameter has in any case.
  virtual nlohmann::ordered_json schema() const = 0;

  virtual bool takes_numbers() const { return false; }
  /// The words that are values, in the order of their table.
  virtual std::vector<std::string> words() const { return {}; }
};

/// Where a case has a value; nullptr in a case that has no such parameter.
template <class T>
using Place = std::function<T*(Case&)>;

class NumberValue final : public ParameterValue {
 public:
  NumberValue(Place<double> place, const Range& range);
  /// \param range_in  the range in one case; nothing where the parameter has no effect
  /// \param whole     from the smallest to the largest value in any case
  NumberValue(Place<double> place, std::function<std::optional<Range>(const Case&)> range_in, Range whole)
      : place_(std::move(place)), range_in_(std::move(range_in)), whole_(std::move(whole)) {}

  Reading read(const nlohmann::json& given, Case& c) const override;
  nlohmann::ordered_json write(const Case& c) const override;
  nlohmann::ordered_json schema() const override;
  bool takes_numbers() const override { return true; }

 private:
  Place<double> place_;
  std::function<std::optional<Range>(const Case&)> range_in_;
  Range whole_;
};

class WholeNumberValue final : public ParameterValue {
 public:
  WholeNumberValue(Place<int> place, Range range) : place_(std::move(place)), range_(std::move(range)) {}
  /// \param allowed  the only values, ascending   \param meaning  of them, in parentheses in messages
  WholeNumberValue(Place<int> place, std::vector<int> allowed, std::string meaning);

  Reading read(const nlohmann::json& given, Case& c) const override;
  nlohmann::ordered_json write(const Case& c) const override;
  nlohmann::ordered_json schema() const override;
  bool takes_numbers() const override { return true; }

 private:
  std::string allowed_in_words() const;

  Place<int> place_;
  Range range_;
  std::vector<int> allowed_ = {};
  std::string meaning_ = {};
};

class BooleanValue final : public ParameterValue {
 public:
  explicit BooleanValue(Place<bool> place) : place_(std::move(place)) {}
  Reading read(const nlohmann::json& given, Case& c) const override;
  nlohmann::ordered_json write(const Case& c) const override;
  nlohmann::ordered_json schema() const override { return {{"type", "boolean"}}; }

 private:
  Place<bool> place_;
};

/// A value with a word for each of its choices.
class WordValue final : public ParameterValue {
 public:
  /// \param set  given a word of `words`   \param also  a word that is read, but leaves the case as it is
  WordValue(std::vector<std::string> words, std::function<void(Case&, std::string_view)> set,
            std::function<std::string_view(const Case&)> get, std::string also = "");

  Reading read(const nlohmann::json& given, Case& c) const override;
  nlohmann::ordered_json write(const Case& c) const override { return get_(c); }
  nlohmann::ordered_json schema() const override { return {{"enum", words_}}; }
  std::vector<std::string> words() const override { return words_; }

 private:
  std::vector<std::string> words_;
  std::function<void(Case&, std::string_view)> set_;
  std::function<std::string_view(const Case&)> get_;
  std::string also_;
};

/// c0: a number, or a word for a curvature of the initial shape.
class SpontaneousCurvatureValue final : public ParameterValue {
 public:
  Reading read(const nlohmann::json& given, Case& c) const override;
  nlohmann::ordered_json write(const Case& c) const override;
  nlohmann::ordered_json schema() const override;
  bool takes_numbers() const override { return true; }
  std::vector<std::string> words() const override { return {"initial", "uniform"}; }
};

/// The one of `words` that a JSON value is; else what is wrong with it and the nearest of them, if one is
/// near.
struct WordFound {
  std::string word, issue;
};
WordFound find_word(const nlohmann::json& given, const std::vector<std::string>& words);

}  // namespace capstan
