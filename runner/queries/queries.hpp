#pragma once
// Answers of the HTTP API about studies and cases, read from the database, as JSON.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runner/queries/case_filter.hpp"
#include "runner/queries/time_grid.hpp"
#include "runner/store/database.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

/// A page ends early when its items exceed this size, in bytes of JSON.
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

/// One study: axes, number of points, number of distinct cases in each state, number of points of each
/// motion, and progress from 0 to 1. Nothing if there is no such study.
std::optional<nlohmann::ordered_json> find_study(Database& database, const std::string& study_id);

/// The points of a study with their cases, in the order of the study.
/// \param filter  validated: known states, motions and parameters
Page find_cases(Database& database, const std::string& study_id, const CaseFilter& filter,
                const PageRequest& wanted);

/// A point as the phase diagram needs it.
struct PointMotion {
  std::string case_id;
  std::string state;
  std::string motion;  ///< "" before there is an answer
  nlohmann::json asked;
  bool is_confirmed = false;  ///< the motion (schema/run_directory.md)
};
std::vector<PointMotion> find_points(Database& database, const std::string& study_id);

/// One case: parameters, state, motion, evidence and the rest of its result, its attempts and its studies.
std::optional<nlohmann::ordered_json> find_case(Database& database, const std::string& case_id);

/// {"kt": [..], "D_xy": [..], …}: the recorded times of a case; nothing if there is no such case.
std::optional<nlohmann::ordered_json> find_history(Database& database, const std::string& case_id);

/// The points of a study with their histories at the times of the grid:
/// [{"point", "id", "asked", "history": {"D_xy": [..], …}}].
/// \param columns  names of observables
/// \param filter   validated, as of find_cases()
Page find_histories(Database& database, const std::string& study_id, const TimeGrid& grid,
                    const std::vector<std::string>& columns, const CaseFilter& filter,
                    const PageRequest& wanted);

/// {"studies": [..], "cases": [..]}: the ids that `word` may abbreviate, at most twenty each. Studies: the
/// one with this id, else those with this name, else those whose id begins with it. Cases: those whose id
/// begins with it.
nlohmann::ordered_json find_ids(Database& database, const std::string& word);

}  // namespace capstan
