#include "solver/run_directory/run_ending.hpp"

#include <gtest/gtest.h>

#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

TEST(RunEnding, IsReadBackFromItsWord) {
  for (const auto& [ending, word] : kWords<RunEnding>)
    EXPECT_EQ(parse_word<RunEnding>(to_string(ending)), ending);
  EXPECT_FALSE(parse_word<RunEnding>("running"));
}

TEST(RunEnding, IsReadBackFromTheExitCodeOfSolve) {
  for (const auto& [ending, word] : kWords<RunEnding>) EXPECT_EQ(run_ending_of(exit_code_of(ending)), ending);
}

TEST(RunEnding, IsACrashAfterAnyOtherExitCode) {
  for (const int code : {kExitError, kExitNotFound, 134}) EXPECT_EQ(run_ending_of(code), RunEnding::crashed);
}

}  // namespace
}  // namespace capstan
