#include "solver/case/output_times.hpp"

#include <gtest/gtest.h>

#include <string>

namespace capstan {
namespace {

TEST(OutputTimes, AreTheDecimalsThatAUserWouldWrite) {
  const OutputTimes tenths(0.1), thousandths(0.001), sevenths(0.7);
  for (int n = 0; n <= 300; ++n) {
    EXPECT_EQ(tenths[n], std::stod(std::to_string(n / 10) + "." + std::to_string(n % 10)));
    EXPECT_EQ(thousandths[n], std::stod("0." +
                                        std::string(n < 10    ? "00"
                                                    : n < 100 ? "0"
                                                              : "") +
                                        std::to_string(n)));
    EXPECT_EQ(sevenths[n], std::stod(std::to_string(7 * n / 10) + "." + std::to_string(7 * n % 10)));
  }
}

}  // namespace
}  // namespace capstan
