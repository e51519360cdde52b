// A new observable is one row of kObservables and its function. CMake compiles this program with both for
// lambda_max, the largest principal stretch; nothing else is changed, and it appears everywhere.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "runner/queries/queries.hpp"
#include "runner/recording/history.hpp"
#include "runner/render/result_columns.hpp"
#include "runner/render/result_tables.hpp"
#include "runner/web/openapi_text.hpp"
#include "solver/mesh/icosphere.hpp"
#include "solver/observe/measure.hpp"
#include "solver/output/checkpoint.hpp"
#include "solver/simulation/history_archive.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Record record_at(double kt, double lambda_max) {
  Record record;
  record["kt"] = kt;
  record["lambda_max"] = lambda_max;
  return record;
}

class NewObservable : public ::testing::Test {
 protected:
  NewObservable() { database().execute("INSERT INTO cases (id, document) VALUES ('a', '{}')"); }

  Database database() const { return {directory_.path() / "test.sqlite", Database::Access::write}; }

  TemporaryDirectory directory_;
};

TEST_F(NewObservable, IsMeasuredFromTheSnapshot) {
  const Icosphere sphere = make_icosphere(3);
  const Points stretched = Vec3(1.5, 0.8, 1).asDiagonal() * sphere.directions;
  const Points none = Points::Zero(3, stretched.cols());
  const Case parameters;
  const Record record = measure_all({.parameters = parameters,
                                     .mesh = sphere.mesh,
                                     .reference = sphere.directions,
                                     .positions = stretched,
                                     .velocities = none,
                                     .forces = none,
                                     .motion = {}});
  EXPECT_NEAR(record["lambda_max"], 1.5, 0.01);
}

TEST_F(NewObservable, IsTheLastKeyOfALineAndIsReadBack) {
  const Record record = record_at(0.5, 1.25);
  EXPECT_THAT(to_json_line(record), HasSubstr(R"("error":null,"lambda_max":1.25})"));
  EXPECT_EQ(parse_record(to_json_line(record)).value()["lambda_max"], 1.25);
}

TEST_F(NewObservable, IsKeptInACheckpoint) {
  StateArchive state;
  put_history(state, {record_at(0, 1), record_at(0.1, 1.25)});
  write_checkpoint(directory_.path(), state, "0123456789abcdef");
  const auto checkpoint = read_newest_checkpoint(directory_.path(), "0123456789abcdef");
  const History history = get_history(checkpoint.value());
  ASSERT_EQ(history.size(), 2u);
  EXPECT_EQ(history[1]["kt"], 0.1);
  EXPECT_EQ(history[1]["lambda_max"], 1.25);
}

TEST_F(NewObservable, IsMissingInTheRecordsOfAnOlderCheckpoint) {
  StateArchive state;
  state.put("history", {0, 0, 0, 0, 4, 12, 1, 1e-4, 0.1, 0.2, 0, 0, 4, 12, 1, 1e-4});
  const History history = get_history(state);
  ASSERT_EQ(history.size(), 2u);
  EXPECT_EQ(history[1]["D_xy"], 0.2);
  EXPECT_TRUE(std::isnan(history[1]["lambda_max"]));
}

TEST_F(NewObservable, IsAColumnOfTheDatabase) {
  Database writer = database();
  store_history(writer, "a", 0, {record_at(0, 1), record_at(0.1, 1.25)});
  EXPECT_EQ(stored_history(writer, "a").at(1)["lambda_max"], 1.25);
}

TEST_F(NewObservable, IsAddedToAnOlderDatabaseWhoseRecordsLackIt) {
  database().execute("ALTER TABLE histories DROP COLUMN lambda_max");
  database().execute("INSERT INTO histories (case_id, record, kt) VALUES ('a', 0, 0.5)");
  Database writer = database();
  store_history(writer, "a", 1, {record_at(1, 1.25)});
  const History history = stored_history(writer, "a");
  EXPECT_EQ(history.at(0)["kt"], 0.5);
  EXPECT_TRUE(std::isnan(history.at(0)["lambda_max"]));
  EXPECT_EQ(history.at(1)["lambda_max"], 1.25);
}

TEST_F(NewObservable, IsMissingInAnOlderDatabaseThatIsOnlyRead) {
  Database writer = database();
  store_history(writer, "a", 0, {record_at(0.5, 1.25)});
  writer.execute("ALTER TABLE histories DROP COLUMN lambda_max");
  EXPECT_TRUE(std::isnan(stored_history(writer, "a").at(0)["lambda_max"]));
}

TEST_F(NewObservable, IsAColumnOfTheHistoryInHttpAndCsv) {
  Database writer = database();
  store_history(writer, "a", 0, {record_at(0.5, 1.25)});
  const auto history = find_history(writer, "a").value();
  EXPECT_EQ(history["lambda_max"].dump(), "[1.25]");
  EXPECT_EQ(history_table(history).columns.back(), "lambda_max");
}

TEST_F(NewObservable, IsAColumnOfTheResults) { EXPECT_THAT(known_columns(), Contains("final.lambda_max")); }

TEST_F(NewObservable, IsDescribedInTheOpenApiDocument) {
  EXPECT_THAT(openapi_text(),
              HasSubstr("lambda_max: {type: array, items: {type: [number, \"null\"]}, "
                        "description: \"largest principal stretch of the membrane, unit 1\"}"));
}

}  // namespace
}  // namespace capstan
