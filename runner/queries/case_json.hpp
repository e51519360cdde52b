#pragma once
// Cases and points as JSON, from the rows of one query.
#include <nlohmann/json.hpp>

#include "runner/store/database.hpp"

namespace capstan {

/// Columns of a query for cases c with their results r; case_json reads them.
inline constexpr const char* kCaseColumns =
    "SELECT c.id, c.state, c.message, c.document, c.kt, c.attempt, c.crashes, r.motion, r.document";
/// Columns of the points s of a study, after those of their cases; point_json reads both.
inline constexpr const char* kPointColumns =
    ", s.position, s.replaces, s.asked,"
    " (SELECT min(position) FROM study_cases f WHERE f.case_id = s.case_id AND f.study_id = s.study_id)";
inline constexpr int kDocumentColumn = 3, kPositionColumn = 9, kAskedColumn = 11;

/// State, motion, progress, parameters and result of a case.
nlohmann::ordered_json case_json(const Statement& row);

/// The same with the number of the point, from 1, and the values asked for there.
nlohmann::ordered_json point_json(const Statement& row);

}  // namespace capstan
