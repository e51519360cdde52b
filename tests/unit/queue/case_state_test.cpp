#include "runner/queue/case_state.hpp"

#include <gtest/gtest.h>

#include "solver/run_directory/run_ending.hpp"

namespace capstan {
namespace {

TEST(CaseState, IsReadBackFromItsWord) {
  for (const auto& [state, word] : kWords<CaseState>)
    EXPECT_EQ(parse_word<CaseState>(to_string(state)), state);
  EXPECT_FALSE(parse_word<CaseState>("interrupted"));
}

/// After a run that ended as done, failed or diverged, the state of the case has the same name.
TEST(CaseState, HasTheWordOfTheEndingThatLedToIt) {
  for (const RunEnding ending : {RunEnding::done, RunEnding::failed, RunEnding::diverged})
    EXPECT_TRUE(has_ended(parse_word<CaseState>(to_string(ending)).value()));
}

}  // namespace
}  // namespace capstan
