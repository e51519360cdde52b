#include "solver/simulation/output_times.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace capstan {
namespace {

using ::testing::ElementsAre;

std::vector<double> all(const OutputTimes& times) {
  std::vector<double> kt;
  for (long n = 0; n <= times.last(); ++n) kt.push_back(times[n]);
  return kt;
}

TEST(OutputTimes, AreMultiplesOfTheIntervalAndTheEnd) {
  EXPECT_THAT(all({0.7, 1}), ElementsAre(0, 0.7, 1));
  EXPECT_THAT(all({0.1, 0.14}), ElementsAre(0, 0.1, 0.14));
  EXPECT_THAT(all({0.1, 0.3}), ElementsAre(0, 0.1, 0.2, 0.3));
  EXPECT_THAT(all({0.05, 0.02}), ElementsAre(0, 0.02));
}

TEST(OutputTimes, AreTheDecimalsThatAUserWouldWrite) {
  const OutputTimes tenths(0.1, 30), thousandths(0.001, 30), sevenths(0.7, 300);
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

TEST(OutputTimes, IncludeTheEndOnceIfRoundingErrorsSeparateItFromAMultiple) {
  for (int count : {3, 7, 49, 300, 1234567}) {
    for (double end : {0.3, 1.0, 30.0}) {
      const OutputTimes times(end / count, end);
      EXPECT_EQ(times.last(), count);
      EXPECT_EQ(times[count], end);
    }
  }
}

}  // namespace
}  // namespace capstan
