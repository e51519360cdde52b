#pragma once
// Deletes a study: its own rows at once, its cases in batches, the run directory of a case after its rows.
#include <optional>
#include <string>
#include <vector>

#include "runner/queue/job_queue.hpp"
#include "runner/store/database.hpp"

namespace capstan {

/// The cases of a deleted study.
struct Deletion {
  int deleted = 0;  ///< number of cases that go with the study, with their results
  int kept = 0;     ///< number of cases that other studies contain, too
};

/// Deletes the study. Cases that no other study contains are cancelled and become rows of unwanted_cases.
/// Nothing if there is no such study.
std::optional<Deletion> delete_study(Database& database, JobQueue& queue, const std::string& study_id);

/// Deletes at most `max` unwanted cases that do not run and returns their ids. A case is returned again, also
/// after a restart, until `forget_deleted` confirms that its run directory was removed.
std::vector<std::string> delete_unwanted_cases(Database& database, int max);
void forget_deleted(Database& database, const std::vector<std::string>& case_ids);

}  // namespace capstan
