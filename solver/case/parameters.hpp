#pragma once
// The table of parameters: every key of a case file with its value, the conditions under which it has an
// effect, and its description. The parser, the canonical form, the axes of studies, the HTTP API's filters
// and the JSON schemas are made from it.
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case/case.hpp"
#include "solver/case/parameter_value.hpp"

namespace capstan {

/// A condition under which a parameter has an effect.
struct Condition {
  std::function<bool(const Case&)> holds;
  /// Message for a case that gives the key although the condition does not hold; "" if this is allowed.
  std::string otherwise;
  /// The key that decides whether the condition holds. If the value of that key is wrong, this condition
  /// causes no issue.
  std::string decided_by = "";
};

struct Parameter {
  std::string key = "";  ///< within its group, e.g. "Ca"
  std::shared_ptr<const ParameterValue> value = nullptr;
  std::vector<Condition> conditions = {};  ///< none: it always has an effect
  std::string description = "";            ///< for the JSON schema
  std::string required = "";  ///< a noun for the parameter, if a case must give it where its conditions hold;
                              ///< "" if it is optional
  std::string group = "";     ///< "until", "fidelity" or "outputs"; "" for the keys of the case itself

  bool has_effect(const Case& c) const;
  /// RFC 6901 pointer into a case, e.g. "/fidelity/dx".
  std::string pointer() const { return (group.empty() ? "" : "/" + group) + "/" + key; }
};

/// All parameters, in the order of the canonical form: a parameter comes after those on which its conditions
/// and range depend.
const std::vector<Parameter>& parameters();

/// An object inside a case whose keys are parameters.
struct ParameterGroup {
  std::string key, description;
};
const std::vector<ParameterGroup>& parameter_groups();

/// The parameter with this key and no group; nullptr if there is none.
const Parameter* find_parameter(std::string_view key);

/// The keys of a case whose value is a number or a word and may therefore be an axis of a study.
const std::vector<std::string_view>& scalar_parameters();

/// All keys of a case: the scalar parameters and the groups.
const std::vector<std::string_view>& case_keys();

}  // namespace capstan
