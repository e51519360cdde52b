#pragma once
// The results of a study in memory that does not grow with their number: they come in pages and are written
// page by page.
#include <iosfwd>
#include <string>
#include <vector>

#include "runner/cli/client.hpp"

namespace capstan {

/// Of one study {"study": .., "cases": [..]}, of several a list of those.
void write_results_json(Client& client, const std::vector<std::string>& study_ids, std::ostream& out);

/// Everything, a line a point; of several studies one table, whose first column is the study. The pages are
/// asked for twice: which columns there are is known after the last one.
void write_results_csv(Client& client, const std::vector<std::string>& study_ids, std::ostream& out);

/// What varies and what came of it, aligned: of each point its few cells are kept.
std::string results_text(Client& client, const std::string& study_id);

}  // namespace capstan
