#pragma once
// What people and programs ask of the database, as the JSON that answers them.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runner/store/database.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

/// A page ends early when its items have as many bytes of JSON as this.
inline constexpr std::size_t kPageBytes = 1 << 20;

/// A part of a list: at most `limit` items, those that come after the item at `after`.
struct PageRequest {
  static constexpr int kMax = 1000;
  int limit = kMax;
  std::optional<std::int64_t> after;
};

struct Page {
  nlohmann::ordered_json items;
  std::optional<std::int64_t> next;  ///< `after` of the next page, if there is one
};

/// The studies, the newest first. Long descriptions are cut.
Page list_studies(Database& database, const PageRequest& wanted);

/// One study: its axes, the number of its points, how many of its distinct cases are in which state and how
/// many of its points are of which motion, and its progress from 0 to 1.
std::optional<nlohmann::ordered_json> find_study(Database& database, const std::string& study_id);

/// Conditions on points, all to be met: {"motion", "tumbling"}, {"state", "done"}, or a parameter and its
/// value: what was asked for, where the parameter is an axis; else what the case has, or the base's word for
/// it.
using CaseFilter = std::vector<std::pair<std::string, std::string>>;

/// The points of a study with their cases, in the study's order. The filter has been checked.
Page find_cases(Database& database, const std::string& study_id, const CaseFilter& filter,
                const PageRequest& wanted);

/// What a phase diagram needs to know of a point.
struct PointMotion {
  std::string case_id;
  std::string state;
  std::string motion;  ///< "" before there is an answer
  nlohmann::json asked;
};
std::vector<PointMotion> find_points(Database& database, const std::string& study_id);

/// One case: parameters, state, motion, evidence and the rest of its result, its attempts and its studies.
std::optional<nlohmann::ordered_json> find_case(Database& database, const std::string& case_id);

/// {"kt": [..], "D_xy": [..], …}: the recorded times of a case; nothing if there is no such case.
std::optional<nlohmann::ordered_json> find_history(Database& database, const std::string& case_id);

/// {"studies": [..], "cases": [..]}: the ids that `word` may stand for, at most twenty each. A study: the one
/// with this id, else those of this name, else those whose id begins so. A case: the one with this id, else
/// those whose id begins so.
nlohmann::ordered_json find_ids(Database& database, const std::string& word);

}  // namespace capstan
