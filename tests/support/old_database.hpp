#pragma once
// The database of a daemon of format 1 that was killed, from its dump tests/reference/queue_format_1.sql.
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <string>

#include "tests/support/file_bytes.hpp"
#include "tests/support/source_directory.hpp"

namespace capstan {

/// \param changed  SQL that changes the tables after the dump is loaded
/// \param format   of the changed database
inline void make_old_database(const std::filesystem::path& file, const std::string& changed = "",
                              int format = 1) {
  const std::string sql = file_bytes(source_directory() / "tests/reference/queue_format_1.sql");
  sqlite3* old = nullptr;
  sqlite3_open(file.c_str(), &old);
  EXPECT_EQ(
      sqlite3_exec(old, (sql + changed + "PRAGMA user_version = " + std::to_string(format) + ";").c_str(),
                   nullptr, nullptr, nullptr),
      SQLITE_OK);
  sqlite3_close(old);
}

}  // namespace capstan
