#pragma once
// The kinds of values that parameters have: each kind reads a value from JSON into a case, writes it to JSON,
// and describes it in a JSON schema.
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case/case.hpp"

namespace capstan {

struct Range {
  double min, max;            ///< both are allowed
  std::string owner = "";     ///< the cases with this range, if not all, e.g. " for an oblate shape"
  double min_above_zero = 0;  ///< the smallest value except 0, if the value 0 switches something off
  std::string zero = "";      ///< meaning of the value 0 in this case
};

class ParameterValue {
 public:
  struct Reading {
    std::string issue = {};  ///< what is wrong with the value; "" if nothing
    bool has_value = false;  ///< a value, given or nearest to a mistyped word, was stored
  };

  virtual ~ParameterValue() = default;
  virtual Reading read(const nlohmann::json& given, Case& c) const = 0;
  virtual nlohmann::ordered_json write(const Case& c) const = 0;
  /// Keywords of JSON Schema that allow all values that the parameter can have in any case.
  virtual nlohmann::ordered_json schema() const = 0;

  virtual bool takes_numbers() const { return false; }
  /// The words that are allowed as values, in the order of their table.
  virtual std::vector<std::string> words() const { return {}; }
};

/// Returns the address of a value in a case; nullptr if the case has no such parameter.
template <class T>
using Place = std::function<T*(Case&)>;

class NumberValue final : public ParameterValue {
 public:
  NumberValue(Place<double> place, const Range& range);
  /// \param range_in  returns the range in a case; nothing if the parameter has no effect there
  /// \param whole     the range that contains the ranges of all cases
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
  /// \param set  stores one of `words` in a case
  /// \param also  a further word, which leaves the case unchanged
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

/// Result of the search for a JSON value in `words`: the word; or an issue, together with the nearest word if
/// one is near.
struct WordFound {
  std::string word, issue;
};
WordFound find_word(const nlohmann::json& given, const std::vector<std::string>& words);

}  // namespace capstan
