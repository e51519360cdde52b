#pragma once
// Writes the results of studies page by page, so that memory does not grow with their number.
#include <iosfwd>
#include <string>
#include <vector>

#include "runner/cli/client.hpp"

namespace capstan {

/// One study: {"study": id, "cases": [..]}. Several: a list of these.
void write_results_json(Client& client, const std::vector<std::string>& study_ids, std::ostream& out);

/// CSV with all columns, one line for each point. Several studies share one table, whose first column is the
/// study. Every page is fetched twice: the set of columns is known only after the last one.
void write_results_csv(Client& client, const std::vector<std::string>& study_ids, std::ostream& out);

/// An aligned table of the parameters that vary and the results. Keeps the few cells of each point in memory.
std::string results_text(Client& client, const std::string& study_id);

}  // namespace capstan
