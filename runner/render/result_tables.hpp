#pragma once
// Tables of results and histories.
#include <nlohmann/json.hpp>

#include "runner/queries/phase_diagram.hpp"
#include "runner/render/table.hpp"

namespace capstan {

/// For people: the values of the axes as requested, the other columns that vary, and the main results. One
/// point a row. \param study  as find_study returns it  \param cases  as find_cases returns them
Table summary_table(const nlohmann::ordered_json& study, const nlohmann::ordered_json& cases);

/// For programs: all requested and resolved parameters and all results, one point a row (schema/results.md).
Table full_table(const nlohmann::ordered_json& cases);

/// One row for each point of the diagram: the values of the axes, its motion, state and case.
Table diagram_table(const PhaseDiagram& diagram);

/// One column for each observable, one row a record. \param history  as find_history returns it
Table history_table(const nlohmann::ordered_json& history);

/// One row for each point and time: the point, the values of the axes as requested, kt, then one column for
/// each observable. \param study  as find_study returns it  \param points  as find_histories returns them
Table histories_table(const nlohmann::ordered_json& study, const TimeGrid& grid,
                      const std::vector<std::string>& columns, const nlohmann::ordered_json& points);

}  // namespace capstan
