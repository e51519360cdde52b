#pragma once
// The table of parameters: every key of a case file, its value, when it has an effect and what it means. The
// parser, the canonical form, the axes of studies, the HTTP API's filters and the JSON schemas are made from
// it.
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case/case.hpp"
#include "solver/case/parameter_value.hpp"

namespace capstan {

/// What must hold for a parameter to have an effect.
struct Condition {
  std::function<bool(const Case&)> holds;
  /// Message for a case that gives the key although it does not hold; "": the key is allowed all the same.
  std::string otherwise;
  /// The key that decides. If its value is wrong, nothing is said about this condition.
  std::string decided_by = "";
};

struct Parameter {
  std::string key = "";  ///< within its group, e.g. "Ca"
  std::shared_ptr<const ParameterValue> value = nullptr;
  std::vector<Condition> conditions = {};  ///< none: it always has an effect
  std::string description = "";            ///< for the JSON schema
  std::string required = "";  ///< what it is, where a case must give it if its conditions hold; "": optional
  std::string group = "";     ///< "until", "fidelity" or "outputs"; "" for the keys of the case itself

  bool has_effect(const Case& c) const;
  /// RFC 6901 pointer into a case, e.g. "/fidelity/dx".
  std::string pointer() const { return (group.empty() ? "" : "/" + group) + "/" + key; }
};

/// All parameters, in the order of the canonical form: decisive ones before those that depend on them.
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

/// The value of a case before its file is read: the defaults.
Case default_case();

}  // namespace capstan
