#pragma once
// Reads the JSON object of a case, parameter by parameter, and collects what is wrong with it.
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "solver/case/case.hpp"
#include "solver/case/choice.hpp"
#include "solver/case/issue.hpp"
#include "solver/case/parameters.hpp"

namespace capstan {

class CaseReader {
 public:
  /// \param document  a JSON object. It, `issues` and `choices` are kept by reference
  CaseReader(const nlohmann::json& document, Issues& issues, Choices& choices)
      : document_(document), issues_(issues), choices_(choices) {}

  /// The case. It is valid if no issue was added; otherwise wrong values are replaced by defaults.
  Case read();

 private:
  void read_scalars();
  void read_parameter(const Parameter& parameter);
  void settle_fluid();
  void leave_out_inertia();
  void read_group(const ParameterGroup& group);
  void choose_latest_end();
  void read_fidelity();
  /// Takes the settings of a preset.
  /// \param pointer  to the name of the preset in the document
  void start_from_preset(const std::string& pointer, const nlohmann::json& name);
  void choose_time_step();
  void choose_rung();
  void check_effects();
  void check_grid();
  /// \param known  keys of the object at `pointer`
  void check_unknown_keys(const std::string& pointer, const nlohmann::json& object,
                          const std::vector<std::string_view>& known);

  /// The value in the document; nullptr if it is not given, or its group is not an object.
  const nlohmann::json* given(const Parameter& parameter) const;
  void add_issue(const std::string& pointer, std::string message);
  bool has_issue(const std::string& pointer) const;
  /// Whether the condition cannot be evaluated, because the value of the key that decides it is wrong.
  bool is_undecided(const Condition& condition) const;

  const nlohmann::json& document_;
  Issues& issues_;
  Choices& choices_;
  Case case_;
  bool has_fluid_ = false;  ///< the file gives the flow model, and it is not "auto"
};

}  // namespace capstan
