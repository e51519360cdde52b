#pragma once
// A queue in an empty database, with a clock that the test sets.
#include <gtest/gtest.h>

#include <string>

#include "runner/daemon/delete_study.hpp"
#include "runner/daemon/submit_study.hpp"
#include "runner/queue/job_queue.hpp"
#include "tests/support/fake_clock.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {

/// Six points, two cases: Re has no effect on boundary integrals.
inline Study study_of_merged_points() {
  return parse_study(nlohmann::json::parse(R"({"name": "merged", "base": {"fluid": "stokes"},
    "axes": {"Ca": [0.1, 0.2], "Re": [0, 0.05, 0.1]}})"))
      .value.value();
}

class QueueFixture : public ::testing::Test {
 protected:
  Submission submit(const Study& study, const std::string& key = "") {
    return submit_study(database_, clock_, study, key);
  }
  std::optional<Deletion> remove(const std::string& study_id) {
    return delete_study(database_, queue_, study_id);
  }
  std::vector<std::string> delete_unwanted() { return delete_unwanted_cases(database_, 10); }

  std::string state_of(const std::string& case_id) {
    return text("SELECT state FROM cases WHERE id = ?", case_id);
  }
  std::string message_of(const std::string& case_id) {
    return text("SELECT message FROM cases WHERE id = ?", case_id);
  }
  std::string last_ending_of(const std::string& case_id) {
    return text("SELECT ending FROM attempts WHERE case_id = ? ORDER BY attempt DESC", case_id);
  }

  /// The count of the study's tally for a word; 0 if it has none.
  std::int64_t tally(const std::string& study_id, const std::string& word) {
    Statement row =
        database_.query("SELECT count FROM tallies WHERE study_id = ? AND word = ?", study_id, word);
    return row.step() ? row.integer(0) : 0;
  }

  /// First column of the first row of a query with one parameter; "nothing" if there is no row.
  std::string text(const char* sql, const std::string& value) {
    Statement row = database_.query(sql, value);
    return row.step() ? row.text(0) : "nothing";
  }
  std::int64_t count(const char* table) {
    Statement row = database_.query(std::string("SELECT count(*) FROM ") + table);
    row.step();
    return row.integer(0);
  }

  TemporaryDirectory directory_;
  FakeClock clock_;
  Database database_{directory_.path() / "queue.sqlite", Database::Access::write};
  JobQueue queue_{database_, clock_};
  Study two_cases_ = sample_study("two", {{"Ca", {0.25, 0.75}}});
};

}  // namespace capstan
