#include "runner/study/study_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "solver/case/content_id.hpp"
#include "solver/case/scene_plan.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// Three digits are more than an estimate knows.
double to_three_digits(double number) {
  const double scale = std::pow(10, 2 - std::floor(std::log10(number)));
  return std::round(number * scale) / scale;
}

/// Positive numbers, one a case.
struct Range {
  double min = std::numeric_limits<double>::infinity(), max = 0, total = 0;
  void add(double number) {
    min = std::min(min, number);
    max = std::max(max, number);
    total += number;
  }
};

ordered_json to_json(const Range& range) {
  return {{"min", to_three_digits(range.min)},
          {"max", to_three_digits(range.max)},
          {"total", to_three_digits(range.total)}};
}

struct Costs {
  Range seconds, memory, disk;
  void add(const ScenePlan& plan) {
    seconds.add(plan.seconds);
    memory.add(plan.memory);
    disk.add(plan.disk);
  }
};

ordered_json to_json(const Costs& costs) {
  return {{"seconds", to_json(costs.seconds)},
          {"memory_bytes", std::round(costs.memory.max)},
          {"disk_bytes", std::round(costs.disk.total)}};
}

/// Cases whose plans have the same words. Warnings may differ: they contain numbers of the case.
struct Group {
  std::size_t first;  ///< number of its first case
  ScenePlan plan;     ///< of this case
  std::size_t cases = 0;
  std::map<std::string, std::size_t> warnings = {};  ///< with the number of cases that have it
  Costs costs = {};
  Range kdt = {}, other_seconds = {};
};

void add(Group& group, const ScenePlan& plan) {
  ++group.cases;
  for (const std::string& warning : plan.warnings) ++group.warnings[warning];
  group.costs.add(plan);
  if (plan.kdt) group.kdt.add(*plan.kdt);
  if (plan.other_fluid) group.other_seconds.add(plan.other_fluid->seconds);
}

std::vector<std::string> words_of(const ScenePlan& plan) {
  std::vector<std::string> words = plan.modelled;
  words.insert(words.end(), plan.left_out.begin(), plan.left_out.end());
  words.push_back(plan.error);
  words.push_back(plan.other_fluid ? plan.other_fluid->words : "");
  return words;
}

/// The largest group first.
std::vector<Group> groups_of(const std::vector<ScenePlan>& plans) {
  std::map<std::vector<std::string>, Group> by_words;
  for (std::size_t number = 0; number < plans.size(); ++number)
    add(by_words.try_emplace(words_of(plans[number]), Group{number, plans[number]}).first->second,
        plans[number]);
  std::vector<Group> groups;
  for (auto& [words, group] : by_words) groups.push_back(std::move(group));
  std::ranges::sort(groups, [](const Group& a, const Group& b) {
    return a.cases != b.cases ? a.cases > b.cases : a.first < b.first;
  });
  return groups;
}

/// The warnings of the most cases first. A study can have one of its own for each of its cases.
ordered_json warnings_of(const Group& group) {
  constexpr std::size_t kMaxWarnings = 10;
  std::vector<std::pair<std::string, std::size_t>> sorted(group.warnings.begin(), group.warnings.end());
  std::ranges::stable_sort(sorted, std::greater(), [](const auto& warning) { return warning.second; });
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < std::min(sorted.size(), kMaxWarnings); ++i)
    list.push_back({{"cases", sorted[i].second}, {"text", sorted[i].first}});
  return list;
}

ordered_json time_step_of(const Group& group) {
  if (!group.plan.kdt) return nullptr;
  return {{"min", to_three_digits(group.kdt.min)}, {"max", to_three_digits(group.kdt.max)}};
}

ordered_json other_fluid_of(const Group& group) {
  if (!group.plan.other_fluid) return nullptr;
  return {{"words", group.plan.other_fluid->words},
          {"is_as_accurate", group.plan.other_fluid->is_as_accurate},
          {"seconds", to_json(group.other_seconds)}};
}

ordered_json to_json(const Group& group, const Choices& choices) {
  ordered_json plan = {
      {"cases", group.cases},       {"choices", to_json(choices)},     {"modelled", group.plan.modelled},
      {"kdt", time_step_of(group)}, {"left_out", group.plan.left_out}, {"warnings", warnings_of(group)},
      {"error", group.plan.error}};
  plan.update(to_json(group.costs));
  plan["other_fluid"] = other_fluid_of(group);
  return plan;
}

/// What the solver chose for a case of the study.
Choices choices_for(const Study& study, std::size_t number) {
  const auto point = std::ranges::find(study.points, number) - study.points.begin();
  nlohmann::json asked = study.asked_at(static_cast<std::size_t>(point));
  drop_keys_without_effect(asked);
  return parse_case(asked).choices;
}

ordered_json identity_of(const InputDocument& document) {
  if (document.study)
    return {{"kind", "study"}, {"name", document.study->name}, {"points", document.study->points.size()}};
  return {{"kind", "case"}, {"id", case_id(*document.single_case)}, {"case", to_json(*document.single_case)}};
}

}  // namespace

ordered_json plan_json(const InputDocument& document) {
  constexpr std::size_t kMaxGroups = 20;
  std::vector<ScenePlan> plans;
  for (const Case& c : document.study ? document.study->cases : std::vector{*document.single_case})
    plans.push_back(plan_of(c));
  Costs costs;
  for (const ScenePlan& plan : plans) costs.add(plan);
  const std::vector<Group> groups = groups_of(plans);

  ordered_json plan = identity_of(document);
  plan["cases"] = plans.size();
  plan["grows"] = document.study && (document.study->boundary || document.study->refinement);
  plan.update(to_json(costs));
  plan["number_of_groups"] = groups.size();
  plan["groups"] = ordered_json::array();
  for (std::size_t i = 0; i < std::min(groups.size(), kMaxGroups); ++i)
    plan["groups"].push_back(to_json(
        groups[i], document.study ? choices_for(*document.study, groups[i].first) : document.choices));
  return plan;
}

}  // namespace capstan
