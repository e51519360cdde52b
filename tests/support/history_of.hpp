#pragma once
// Runs a case to its end and returns its history.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "solver/simulation/simulation.hpp"
#include "tests/support/memory_output.hpp"
#include "tests/support/parsed_case.hpp"

namespace capstan::testing {

inline History history_of(std::string_view case_text) {
  MemoryOutput output;
  const Outcome outcome = Simulation(parsed_case(case_text)).run(output);
  EXPECT_EQ(outcome.stop, Stop::reached_end) << outcome.message;
  return output.records;
}

/// The record whose time is nearest to kt.
inline Record at(const History& history, double kt) {
  return *std::ranges::min_element(history, {}, [&](const Record& r) { return std::abs(r["kt"] - kt); });
}

}  // namespace capstan::testing
