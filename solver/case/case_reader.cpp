#include "solver/case/case_reader.hpp"

#include <algorithm>

#include "solver/case/choose_fluid.hpp"
#include "solver/case/grid_size.hpp"
#include "solver/case/ladder.hpp"
#include "solver/case/limits.hpp"
#include "solver/case/nearest_word.hpp"
#include "solver/case/shown_number.hpp"
#include "solver/case/time_step_defaults.hpp"

namespace capstan {
namespace {

using nlohmann::json;

std::vector<std::string_view> keys_of_group(const std::string& group) {
  std::vector<std::string_view> keys;
  if (group == "fidelity") keys.push_back("preset");
  for (const Parameter& parameter : parameters())
    if (parameter.group == group) keys.push_back(parameter.key);
  return keys;
}

/// A preset's settings for a flow model: boundary integrals take its mesh only, and the unsteady flow has one
/// scheme.
Fidelity settings_for(const Case& c, const FidelityPreset& preset) {
  Fidelity fidelity = preset.settings;
  if (c.fluid == Fluid::unsteady) fidelity.scheme = Scheme::tuned;
  if (c.has_grid()) return fidelity;
  fidelity = {};
  fidelity.nodes = preset.settings.nodes;
  fidelity.stepper = Stepper::runge_kutta_chebyshev;
  return fidelity;
}

/// Known keys that the object lacks, sorted.
std::vector<std::string> missing_keys(const json& object, const std::vector<std::string_view>& known) {
  std::vector<std::string> missing;
  for (const std::string_view key : known)
    if (!object.contains(key)) missing.emplace_back(key);
  std::ranges::sort(missing);
  return missing;
}

}  // namespace

Case CaseReader::read() {
  read_scalars();
  settle_fluid();
  for (const ParameterGroup& group : parameter_groups()) read_group(group);
  check_effects();
  if (case_.has_grid()) check_grid();
  check_unknown_keys("", document_, case_keys());
  return case_;
}

void CaseReader::read_scalars() {
  for (const Parameter& parameter : parameters())
    if (parameter.group.empty()) read_parameter(parameter);
}

void CaseReader::read_parameter(const Parameter& parameter) {
  const json* value = given(parameter);
  if (value) {
    const ParameterValue::Reading reading = parameter.value->read(*value, case_);
    if (!reading.issue.empty()) add_issue(parameter.pointer(), reading.issue);
    if (parameter.key == "fluid") has_fluid_ = reading.has_value;
    return;
  }
  const auto is_undecided_one = [&](const Condition& condition) { return is_undecided(condition); };
  const bool is_missing = !parameter.required.empty() && parameter.has_effect(case_) &&
                          std::ranges::none_of(parameter.conditions, is_undecided_one);
  if (is_missing) add_issue(parameter.pointer(), "is missing: " + parameter.required);
}

/// Chooses the flow model where the file leaves the choice to the solver, and checks Re against the model.
void CaseReader::settle_fluid() {
  const json asked = document_.value("fluid", json("auto"));
  const json fidelity = document_.value("fidelity", json());
  const bool has_Re = document_.contains("Re");
  if (!has_Re && needs_inertia(Fluid::quasisteady, fidelity)) case_.Re = kPaperRe;
  const FluidChoice choice = choose_fluid(case_.Re, fidelity);
  if (!has_fluid_) case_.fluid = choice.fluid;
  if (asked == "auto") choices_.push_back({"fluid", asked, to_string(case_.fluid), choice.reason});
  if (!case_.has_grid()) return leave_out_inertia();
  if (!needs_inertia(case_.fluid, fidelity)) return;
  if (!has_Re)
    case_.Re = kPaperRe;
  else if (case_.Re == 0 && !has_issue("/Re"))
    add_issue(
        "/Re",
        "is 0, and this flow model needs inertia; give Re > 0, or take the fluid quasisteady or stokes");
}

void CaseReader::leave_out_inertia() {
  if (case_.Re > kMaxStokesRe)
    add_issue("/Re", "is " + shown(case_.Re) +
                         ", but the fluid \"stokes\" has no inertia: at most 0.1, or another fluid");
  if (case_.Re > 0 && document_.contains("Re"))
    choices_.push_back({"Re", case_.Re, 0, "boundary integrals have no inertia"});
  case_.Re = 0;
}

void CaseReader::read_group(const ParameterGroup& group) {
  if (group.key == "fidelity") return read_fidelity();
  const auto object = document_.find(group.key);
  if (object == document_.end()) return;
  if (!object->is_object())
    return add_issue("/" + group.key, std::string("must be an object, is ") + object->type_name());
  for (const Parameter& parameter : parameters())
    if (parameter.group == group.key) read_parameter(parameter);
  check_unknown_keys("/" + group.key, *object, keys_of_group(group.key));
  if (group.key == "until") choose_latest_end();
}

/// The latest end of a run that goes on while its motion is undecided, if the file leaves it to the solver.
void CaseReader::choose_latest_end() {
  constexpr double kDefault = 3;
  Until& until = case_.until;
  if (until.classified && !document_["until"].contains("at_most"))
    until.at_most = std::min(kDefault * until.kt, kMaxTime);
}

void CaseReader::read_fidelity() {
  case_.fidelity = settings_for(case_, *find_preset("standard"));
  const auto fidelity = document_.find("fidelity");
  if (fidelity != document_.end() && !fidelity->is_object()) {
    start_from_preset("/fidelity", *fidelity);
  } else if (fidelity != document_.end()) {
    if (const auto preset = fidelity->find("preset"); preset != fidelity->end())
      start_from_preset("/fidelity/preset", *preset);
    const double spacing = case_.fidelity.dx;
    for (const Parameter& parameter : parameters())
      if (parameter.group == "fidelity") read_parameter(parameter);
    if (!fidelity->contains("tolerance")) adapt_tolerance(case_, spacing);
    check_unknown_keys("/fidelity", *fidelity, keys_of_group("fidelity"));
  }
  const bool has_box = fidelity != document_.end() && fidelity->contains("box");
  if (case_.has_grid() && !has_box) case_.fidelity.box = usual_box(case_);
  if (case_.fidelity.error > 0 && has_ladder(case_))
    choose_rung();
  else
    choose_time_step();
}

void CaseReader::start_from_preset(const std::string& pointer, const json& name) {
  const std::vector<std::string_view> names = preset_names();
  const WordFound found = find_word(name, {names.begin(), names.end()});
  if (!found.issue.empty()) add_issue(pointer, found.issue);
  if (const FidelityPreset* preset = find_preset(found.word)) case_.fidelity = settings_for(case_, *preset);
}

/// The time step that the file leaves to the solver.
void CaseReader::choose_time_step() {
  Fidelity& fidelity = case_.fidelity;
  const json settings = document_.value("fidelity", json());
  const bool has_stepper = settings.contains("stepper"), has_kdt = settings.contains("kdt");
  if (!has_stepper && !has_kdt) return capstan::choose_time_step(case_);
  if (!has_kdt) fidelity.kdt = kdt_of_stepper(case_);
}

/// An error asked for is met by a rung of the ladder instead of a preset.
void CaseReader::choose_rung() {
  const json settings = document_.value("fidelity", json());
  if (settings.contains("preset"))
    add_issue("/fidelity/preset",
              "has no effect beside error, which chooses the resolution: leave out one of the two");
  case_ = at_expected_rung(case_);
}

void CaseReader::check_effects() {
  for (const Parameter& parameter : parameters()) {
    if (!given(parameter)) continue;
    const auto failed = std::ranges::find_if(
        parameter.conditions, [&](const Condition& condition) { return !condition.holds(case_); });
    if (failed == parameter.conditions.end() || failed->otherwise.empty() || is_undecided(*failed)) continue;
    issues_.push_back({parameter.pointer(), "has no effect: " + failed->otherwise, true});
  }
}

void CaseReader::check_grid() {
  if (const std::string issue = issue_of_grid(case_); !issue.empty()) add_issue("/fidelity", issue);
  if (case_.fidelity.error > 0 && !rung_below(case_))
    add_issue("/fidelity/box", "is " + shown(case_.fidelity.box) +
                                   ", which does not fit two lattices of the ladder; take a multiple of 3.2");
}

void CaseReader::check_unknown_keys(const std::string& pointer, const json& object,
                                    const std::vector<std::string_view>& known) {
  for (const auto& [key, value] : object.items())
    if (std::ranges::find(known, key) == known.end())
      add_issue((json::json_pointer(pointer) / key).to_string(),
                "unknown key" + suggestion(key, missing_keys(object, known)));
}

const json* CaseReader::given(const Parameter& parameter) const {
  const json* object = &document_;
  if (!parameter.group.empty()) {
    const auto group = document_.find(parameter.group);
    if (group == document_.end() || !group->is_object()) return nullptr;
    object = &*group;
  }
  const auto value = object->find(parameter.key);
  return value == object->end() ? nullptr : &*value;
}

void CaseReader::add_issue(const std::string& pointer, std::string message) {
  issues_.push_back({pointer, std::move(message)});
}

bool CaseReader::has_issue(const std::string& pointer) const {
  return std::ranges::any_of(issues_, [&](const Issue& issue) { return issue.pointer == pointer; });
}

bool CaseReader::is_undecided(const Condition& condition) const {
  return !condition.decided_by.empty() && has_issue("/" + condition.decided_by);
}

}  // namespace capstan
