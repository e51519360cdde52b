#include "runner/web/request_log.hpp"

#include <gtest/gtest.h>

#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

TEST(RequestLog, ReplacesCharactersThatBreakLines) {
  const TemporaryDirectory directory;
  RequestLog log(directory.path() / "log");
  log.write("GET /\r\nforged line\x1b[2J");
  EXPECT_EQ(file_bytes(directory.path() / "log"), "GET /??forged line?[2J\n");
}

TEST(RequestLog, TakesAtMostTwiceItsMaxBytes) {
  const TemporaryDirectory directory;
  RequestLog log(directory.path() / "log", 1000);
  for (int i = 0; i < 1000; ++i) log.write("ten bytes");
  EXPECT_LE(file_bytes(directory.path() / "log").size(), 1000u);
  EXPECT_EQ(file_bytes(directory.path() / "log.1").size(), 1000u);
}

TEST(RequestLog, ContinuesInANewFileAfterTheOldOneWasMoved) {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory.path() / "requests.log", moved = directory.path() / "moved";
  RequestLog log(file);
  log.write("first");
  std::filesystem::rename(file, moved);
  log.reopen();
  log.write("second");
  EXPECT_EQ(file_bytes(moved), "first\n");
  EXPECT_EQ(file_bytes(file), "second\n");
}

}  // namespace
}  // namespace capstan
