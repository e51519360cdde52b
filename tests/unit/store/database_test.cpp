#include "runner/store/database.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>
#include <string>

#include "runner/queries/queries.hpp"
#include "runner/queue/job_queue.hpp"
#include "runner/store/readers.hpp"
#include "runner/store/schema.hpp"
#include "tests/support/old_database.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

class DatabaseTest : public ::testing::Test {
 protected:
  std::int64_t count_cases() {
    Statement row = database_.query("SELECT count(*) FROM cases");
    row.step();
    return row.integer(0);
  }

  TemporaryDirectory directory_;
  std::filesystem::path file_ = directory_.path() / "test.sqlite";
  Database database_{file_, Database::Access::write};
};

/// A compiled statement takes some 20 kB: without a limit the memory of a server would grow with the number
/// of different queries.
TEST_F(DatabaseTest, LeastRecentlyUsedStatementsAreDropped) {
  sqlite3* connection = nullptr;
  ASSERT_EQ(sqlite3_open(":memory:", &connection), SQLITE_OK);
  const auto idle = std::make_shared<IdleStatements>();
  for (int i = 0; i < 1000; ++i)
    for (const std::string& sql : {"SELECT " + std::to_string(i), std::string("SELECT 'often'")})
      EXPECT_TRUE(Statement(connection, idle, sql).step());
  std::size_t kept = 0;
  bool has_often = false;
  for (sqlite3_stmt* each = nullptr; (each = sqlite3_next_stmt(connection, each)); ++kept)
    has_often = has_often || sqlite3_sql(each) == std::string("SELECT 'often'");
  EXPECT_EQ(kept, IdleStatements::kMax);
  EXPECT_TRUE(has_often);
  sqlite3_close_v2(connection);
}

TEST_F(DatabaseTest, ValuesComeBackAsTheyWereBound) {
  Statement row =
      database_.query("SELECT ?1, ?2, ?3, ?4", std::int64_t{1} << 60, 0.1, "a \"quoted\" word", NAN);
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.integer(0), std::int64_t{1} << 60);
  EXPECT_EQ(row.real(1), 0.1);
  EXPECT_EQ(row.text(2), "a \"quoted\" word");
  EXPECT_TRUE(row.is_null(3));
  EXPECT_TRUE(std::isnan(row.real(3)));
  EXPECT_FALSE(row.step());
}

TEST_F(DatabaseTest, UncommittedTransactionLeavesNothing) {
  {
    Transaction transaction(database_);
    database_.execute("INSERT INTO cases (id, document) VALUES ('a', '{}')");
  }
  EXPECT_EQ(count_cases(), 0);
}

TEST_F(DatabaseTest, InnerTransactionIsUndoneWithTheOuterOne) {
  {
    Transaction outer(database_);
    Transaction inner(database_);
    database_.execute("INSERT INTO cases (id, document) VALUES ('a', '{}')");
    inner.commit();
  }
  EXPECT_EQ(count_cases(), 0);
}

TEST_F(DatabaseTest, ReaderSeesTheLastCommitWhileTheWriterWrites) {
  Database reader(file_, Database::Access::read);
  Transaction transaction(database_);
  database_.execute("INSERT INTO cases (id, document) VALUES ('a', '{}')");
  EXPECT_FALSE(reader.query("SELECT 1 FROM cases").step());
  transaction.commit();
  EXPECT_TRUE(reader.query("SELECT 1 FROM cases").step());
}

TEST_F(DatabaseTest, ReaderCannotWrite) {
  Database reader(file_, Database::Access::read);
  EXPECT_THROW(reader.execute("DELETE FROM cases"), DatabaseError);
}

TEST_F(DatabaseTest, ReaderSeesASnapshotAndTheNextOneALaterSnapshot) {
  const Database writer(file_, Database::Access::write);
  Readers readers(file_, writer);
  const auto count = [](Database& database) {
    Statement row = database.query("SELECT count(*) FROM cases");
    row.step();
    return row.integer(0);
  };
  const Database* first = nullptr;
  {
    const Readers::Reader reader = readers.take();
    first = reader.get();
    EXPECT_EQ(count(*reader), 0);
    database_.execute("INSERT INTO cases (id, document) VALUES ('a', '{}')");
    EXPECT_EQ(count(*reader), 0);
    EXPECT_EQ(count(*readers.take()), 1) << "another one, taken meanwhile";
  }
  const Readers::Reader again = readers.take();
  EXPECT_EQ(again.get(), first) << "it was not opened anew";
  EXPECT_EQ(count(*again), 1);
}

TEST_F(DatabaseTest, CommitsAreSyncedToTheDisk) {
  Statement row = database_.query("PRAGMA synchronous");
  row.step();
  EXPECT_EQ(row.integer(0), 2);  // FULL
}

TEST_F(DatabaseTest, ReopenedDatabaseKeepsItsContent) {
  database_.execute("INSERT INTO cases (id, document) VALUES ('a', '{}')");
  Database again(file_, Database::Access::write);
  EXPECT_TRUE(again.query("SELECT 1 FROM cases WHERE id = 'a'").step());
}

TEST_F(DatabaseTest, FormatOfALaterProgramIsRefused) {
  database_.execute_script("PRAGMA user_version = 99");
  EXPECT_THROW(Database(file_, Database::Access::write), DatabaseError);
}

TEST(OldDatabase, LosesTheMotionsThatFailedRunsWereGiven) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "old.sqlite";
  make_old_database(file, "UPDATE results SET motion = 'tank_treading' WHERE motion IS NULL;");
  Database database(file, Database::Access::write);
  const nlohmann::ordered_json kept = find_study(database, "kept-8a8f").value();
  EXPECT_EQ(kept["cases"]["diverged"], 2);
  EXPECT_EQ(kept["motions"]["tank_treading"], 1);  // of the case that is done
  Statement failed =
      database.query("SELECT 1 FROM results WHERE motion IS NOT NULL AND document LIKE '%diverged%'");
  EXPECT_FALSE(failed.step());
}

TEST(OldDatabase, IsBroughtToThePresentFormatWithAllItHolds) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "old.sqlite";
  make_old_database(file);
  Database database(file, Database::Access::write);
  const nlohmann::ordered_json kept = find_study(database, "kept-8a8f").value();
  EXPECT_EQ(kept["cases"]["done"], 2);
  EXPECT_EQ(kept["cases"]["failed"], 4);
  EXPECT_EQ(kept["cases"]["diverged"], 2);
  EXPECT_EQ(kept["motions"]["tumbling"], 1);
  const nlohmann::ordered_json other = find_study(database, "other-58cb").value();
  EXPECT_EQ(other["cases"]["queued"], 2);
  EXPECT_EQ(other["cases"]["running"], 2);
  EXPECT_EQ(find_study(database, "dropped-78c0").value()["cases"]["cancelled"], 2);
  SystemClock clock;
  JobQueue queue(database, clock);
  EXPECT_EQ(queue.running().size(), 2u);
  EXPECT_TRUE(queue.claim());
}

/// The database of format 1 is led to each later format by schema/migrations/, and opened from there.
TEST(OldDatabase, OfEachFormatIsBroughtToThePresentOne) {
  std::string steps;
  for (std::size_t format = 1; format < migrations().size(); ++format) {
    if (format > 1) steps += migrations()[format - 1];
    const TemporaryDirectory directory;
    const std::filesystem::path file = directory.path() / "old.sqlite";
    make_old_database(file, steps, static_cast<int>(format));
    Database database(file, Database::Access::write);
    const nlohmann::ordered_json kept = find_study(database, "kept-8a8f").value();
    EXPECT_EQ(kept["points"], 8) << "format " << format;
    EXPECT_EQ(kept["cases"]["done"], 2) << "format " << format;
    EXPECT_EQ(kept["cases"]["failed"], 4) << "format " << format;
    EXPECT_EQ(kept["motions"]["tumbling"], 1) << "format " << format;
    EXPECT_EQ(find_study(database, "other-58cb").value()["cases"]["queued"], 2) << "format " << format;
    SystemClock clock;
    EXPECT_TRUE(JobQueue(database, clock).claim()) << "format " << format;
  }
}

/// Type, name and SQL of each table, index, trigger and view, without comments and spaces.
std::map<std::string, std::string> schema_of(Database& database) {
  static const std::regex comment("--[^\n]*"), space("\\s+");
  std::map<std::string, std::string> schema;
  Statement row = database.query("SELECT type || ' ' || name, sql FROM sqlite_schema WHERE sql IS NOT NULL");
  while (row.step())
    schema[row.text(0)] = std::regex_replace(std::regex_replace(row.text(1), comment, ""), space, "");
  return schema;
}

/// A new database is made from schema/queue.sql, one of format 1 is led through all of schema/migrations/.
TEST_F(DatabaseTest, OldDatabaseAndNewOneHaveTheSameTables) {
  const std::filesystem::path file = directory_.path() / "old.sqlite";
  sqlite3* old = nullptr;
  sqlite3_open(file.c_str(), &old);
  EXPECT_EQ(sqlite3_exec(old, migrations()[0], nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_exec(old, "PRAGMA user_version = 1", nullptr, nullptr, nullptr);
  sqlite3_close(old);
  Database migrated(file, Database::Access::write);
  EXPECT_EQ(schema_of(migrated), schema_of(database_));
}

TEST_F(DatabaseTest, ErrorNamesTheFileAndTheOperation) {
  try {
    database_.execute("INSERT INTO nowhere VALUES (1)");
    FAIL();
  } catch (const DatabaseError& error) {
    EXPECT_NE(std::string(error.what()).find("test.sqlite"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("INSERT INTO nowhere"), std::string::npos);
  }
}

}  // namespace
}  // namespace capstan
