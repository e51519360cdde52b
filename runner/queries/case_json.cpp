#include "runner/queries/case_json.hpp"

#include <algorithm>
#include <string>

#include "runner/queue/case_state.hpp"
#include "solver/case/parse.hpp"

namespace capstan {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr int kReplacesColumn = 10, kFirstPositionColumn = 12;

/// Adds what result.json holds apart from the case itself; null before there is a result.
void add_result(ordered_json& shown, const std::string& document) {
  static const std::initializer_list<std::string> shown_already = {"format", "case", "choices", "message",
                                                                   "motion"};
  for (const char* key : {"stop", "explanation", "evidence", "final", "cost", "trust", "confirmed", "error"})
    shown[key] = nullptr;
  if (document.empty()) return;
  const ordered_json result = ordered_json::parse(document);
  for (const auto& [key, value] : result.items())
    if (std::find(shown_already.begin(), shown_already.end(), key) == shown_already.end()) shown[key] = value;
}

/// Share of the run that is computed, from 0 to 1.
double progress(const std::string& state, double kt, double end_kt) {
  const CaseState parsed = parse_word<CaseState>(state).value();
  return has_ended(parsed) && parsed != CaseState::cancelled ? 1.0 : std::min(1.0, kt / end_kt);
}

/// Keys that were asked for at the point and that its case does not have.
ordered_json keys_without_effect(const json& asked, const ordered_json& parameters) {
  ordered_json keys = ordered_json::array();
  for (const auto& [key, value] : asked.items()) {
    if (!parameters.contains(key)) keys.push_back(key);
    if (key != "fidelity" || !value.is_object()) continue;
    for (const auto& [knob, setting] : value.items())
      if (knob != "preset" && !parameters[key].contains(knob)) keys.push_back(key + "." + knob);
  }
  return keys;
}

/// The choices that the solver makes today for the values asked for. A choice is left out if the case, stored
/// by an older version, has another value.
ordered_json choices_at(json asked, const ordered_json& parameters) {
  drop_keys_without_effect(asked);
  Choices choices = parse_case(asked).choices;
  std::erase_if(choices, [&](const Choice& choice) {
    return parameters.contains(choice.key) && parameters[choice.key] != ordered_json(choice.chosen);
  });
  return to_json(choices);
}

}  // namespace

ordered_json case_json(const Statement& row) {
  const std::string state = row.text(1);
  ordered_json parameters = ordered_json::parse(row.text(kDocumentColumn));
  const double kt = row.real(4);
  ordered_json shown = {{"id", row.text(0)}, {"state", state}, {"message", row.text(2)}};
  shown["motion"] = row.is_null(7) ? ordered_json() : ordered_json(row.text(7));
  shown["progress"] = progress(state, kt, parameters["until"]["kt"].get<double>());
  shown["kt"] = kt;
  shown["parameters"] = std::move(parameters);
  add_result(shown, row.text(8));
  shown["attempt"] = row.integer(5);
  shown["crashes"] = row.integer(6);
  return shown;
}

ordered_json point_json(const Statement& row) {
  ordered_json shown = {{"point", row.integer(kPositionColumn) + 1}};
  const json asked = json::parse(row.text(kAskedColumn));
  shown.update(case_json(row));
  if (row.integer(kFirstPositionColumn) < row.integer(kPositionColumn))
    shown["same_as"] = row.integer(kFirstPositionColumn) + 1;
  if (!row.is_null(kReplacesColumn)) shown["replaces"] = row.text(kReplacesColumn);
  shown["asked"] = asked;
  if (ordered_json keys = keys_without_effect(asked, shown["parameters"]); !keys.empty())
    shown["without_effect"] = std::move(keys);
  shown["choices"] = choices_at(asked, shown["parameters"]);
  return shown;
}

}  // namespace capstan
