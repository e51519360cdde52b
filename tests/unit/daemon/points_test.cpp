#include "runner/daemon/points.hpp"

#include <gtest/gtest.h>

#include "runner/store/schema.hpp"
#include "tests/support/queue_fixture.hpp"

namespace capstan {
namespace {

class PointsTest : public QueueFixture {};

/// A version before format 5 stored each case once, without the values asked for.
TEST_F(PointsTest, PointsOfAnOldStudyAreDerivedFromItsDocument) {
  const std::string id = submit(study_of_merged_points()).study_id;
  database_.execute("DELETE FROM study_cases WHERE position IN (1, 2, 4, 5)");
  database_.execute("UPDATE study_cases SET asked = NULL, position = position / 3");
  database_.execute("UPDATE study_cases SET replaces = 'before' WHERE position = 1");
  database_.execute_script(kRecount);
  derive_old_points(database_);
  EXPECT_EQ(count("study_cases"), 6);
  EXPECT_EQ(text("SELECT asked FROM study_cases WHERE study_id = ? AND position = 4", id),
            R"({"Ca":0.2,"Re":0.05,"fluid":"stokes"})");
  EXPECT_EQ(text("SELECT count(*) FROM study_cases WHERE study_id = ? AND replaces = 'before'", id), "3");
  EXPECT_EQ(tally(id, "points"), 6);
  EXPECT_EQ(tally(id, "queued"), 2);
}

TEST_F(PointsTest, PointsOfAnOldStudyWithAnInvalidDocumentAreThoseOfItsCases) {
  const std::string id = submit(two_cases_).study_id;
  database_.execute("UPDATE study_cases SET asked = NULL");
  database_.execute("UPDATE studies SET document = json_set(document, '$.base.colour', 'red')");
  derive_old_points(database_);
  EXPECT_EQ(
      text("SELECT json_extract(asked, '$.Ca') FROM study_cases WHERE study_id = ? AND position = 1", id),
      "0.75");
}

}  // namespace
}  // namespace capstan
