#include "runner/render/plan_text.hpp"

#include "runner/render/duration.hpp"
#include "runner/render/printable.hpp"
#include "runner/study/shown_value.hpp"
#include "solver/case/choice.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// Of a study that seeks a boundary or refines its grid.
std::string growth_text(const ordered_json& plan) {
  return plan["grows"] == true ? "These are its first cases; further ones follow where the motion changes.\n"
                               : "";
}

std::string count_of_cases(const ordered_json& count) {
  return count.dump() + (count == 1 ? " case" : " cases");
}

std::string bytes_in_words(double bytes) {
  return bytes < 999e6 ? rounded(bytes / 1e6) + " MB" : rounded(bytes / 1e9) + " GB";
}

/// "0.35 s", or "0.35 s to 12 min"
std::string range_of_durations(const ordered_json& range) {
  const std::string min = duration_in_words(range["min"]), max = duration_in_words(range["max"]);
  return min == max ? min : min + " to " + max;
}

/// "12 min of one core (0.35 s to 1.2 s a case), 20 MB of memory, 3 MB on disk"
std::string costs(const ordered_json& plan) {
  const std::string each = plan["cases"] == 1 ? "" : " (" + range_of_durations(plan["seconds"]) + " a case)";
  return duration_in_words(plan["seconds"]["total"]) + " of one core" + each + ", " +
         bytes_in_words(plan["memory_bytes"]) + " of memory" + (plan["cases"] == 1 ? "" : " a case") + ", " +
         bytes_in_words(plan["disk_bytes"]) + " on disk";
}

std::string time_steps(const ordered_json& kdt) {
  const std::string min = shown_value(kdt["min"]), max = shown_value(kdt["max"]);
  return "time step: k dt = " + (min == max ? min : min + " to " + max);
}

std::string part(const std::string& title, const std::vector<std::string>& lines) {
  std::string text = lines.empty() ? "" : "  " + title + "\n";
  for (const std::string& line : lines) text += "    " + line + "\n";
  return text;
}

std::vector<std::string> modelled(const ordered_json& group) {
  auto lines = group["modelled"].get<std::vector<std::string>>();
  if (!group["kdt"].is_null()) lines.push_back(time_steps(group["kdt"]));
  for (const ordered_json& choice : group["choices"])
    lines.push_back(in_words({choice["key"], choice["asked"], choice["chosen"], choice["reason"]}));
  return lines;
}

std::vector<std::string> warnings(const ordered_json& group) {
  std::vector<std::string> lines;
  for (const ordered_json& warning : group["warnings"]) {
    const std::string where = warning["cases"] == group["cases"] ? ""
                                                                 : "at " + warning["cases"].dump() + " of " +
                                                                       group["cases"].dump() + " cases ";
    lines.push_back(where + warning["text"].get<std::string>());
  }
  return lines;
}

/// Cheaper by more than the factor by which estimated costs may be wrong.
bool is_clearly_cheaper(const ordered_json& other, const ordered_json& group) {
  constexpr double kFactor = 4;
  return other["is_as_accurate"] &&
         group["seconds"]["total"] > kFactor * other["seconds"]["total"].get<double>();
}

std::vector<std::string> cost(const ordered_json& group) {
  std::vector<std::string> lines = {costs(group)};
  const ordered_json& other = group["other_fluid"];
  if (!other.is_null())
    lines.push_back("the other flow model, " + other["words"].get<std::string>() + ": " +
                    range_of_durations(other["seconds"]) + " of one core" +
                    (group["cases"] == 1 ? "" : " a case") +
                    (is_clearly_cheaper(other, group) ? "; this is clearly cheaper" : ""));
  return lines;
}

std::string text_of(const ordered_json& group) {
  return part("modelled", modelled(group)) +
         part("left out, and what that changes", group["left_out"].get<std::vector<std::string>>()) +
         part("expected error", {group["error"].get<std::string>()}) + part("expected cost", cost(group)) +
         part("warnings", warnings(group));
}

std::string heading(const ordered_json& plan) {
  if (plan["kind"] == "case") return "case " + plan["id"].get<std::string>() + "\n";
  return "study " + printable(plan["name"].get<std::string>()) + ": " + count_of_cases(plan["cases"]) + ", " +
         costs(plan) + "\n" + growth_text(plan);
}

}  // namespace

std::string plan_text(const ordered_json& plan) {
  std::string text = heading(plan);
  for (const ordered_json& group : plan["groups"])
    text += (plan["kind"] == "case" ? "" : "\n" + count_of_cases(group["cases"]) + "\n") + text_of(group);
  const auto more = plan["number_of_groups"].get<std::size_t>() - plan["groups"].size();
  return more > 0 ? text + "\nand " + std::to_string(more) + " more groups of cases with other words\n"
                  : text;
}

}  // namespace capstan
