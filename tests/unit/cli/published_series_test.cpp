#include "runner/cli/published_series.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

class PublishedSeriesTest : public ::testing::Test {
 protected:
  /// What is drawn of a file with this text beside spheres at Ca = 0.05 and 0.1.
  std::vector<PublishedSeries> series_of(const std::string& text) {
    const std::filesystem::path file = directory_.path() / "other_codes.csv";
    std::ofstream(file) << text;
    const std::vector<PicturedCase> cases = {{"", "", {{"shape", "sphere"}, {"Ca", 0.05}, {"V", 1.0}}},
                                             {"", "", {{"shape", "sphere"}, {"Ca", 0.1}, {"V", 1.0}}}};
    return published_series(file, cases);
  }

 protected:
  TemporaryDirectory directory_;
};

TEST_F(PublishedSeriesTest, BoundariesHaveThePointsWithNumbersOnBothAxes) {
  const std::filesystem::path file = directory_.path() / "boundary.csv";
  std::ofstream(file) << "paper,V,Ca\nA 1998,4,0.4\nB 2008,4,0.41\nA 1998,5,none\n";
  const auto boundaries = published_boundaries(file, "Ca", "V");
  ASSERT_EQ(boundaries.size(), 2u);
  EXPECT_EQ(boundaries[0].title, "A 1998");
  EXPECT_EQ(boundaries[0].points, (std::vector<std::array<double, 2>>{{0.4, 4}}));
  EXPECT_THROW(published_boundaries(file, "Ca", "E_b"), std::invalid_argument);
}

TEST_F(PublishedSeriesTest, FileWithoutPointsIsRefused) {
  for (const char* text : {"", "# comment\n", "kt,D_xy\n", "paper,kt,D_xy"})
    EXPECT_THROW(series_of(text), std::invalid_argument) << text;
}

TEST_F(PublishedSeriesTest, IsOneSeriesForEachPaper) {
  const auto series =
      series_of("# comment\npaper,Ca,kt,D_xy\nA 1998,0.05,1,0.23\nB 2008,0.05,1,0.24\nA 1998,0.1,2,0.4\n");
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].title, "A 1998");
  ASSERT_EQ(series[0].points.size(), 2u);
  EXPECT_EQ(series[0].points[1].kt, 2);
  EXPECT_EQ(series[0].points[1].D_xy, 0.4);
  EXPECT_EQ(series[1].title, "B 2008");
}

TEST_F(PublishedSeriesTest, HasOnlyPointsWithTheParametersOfACase) {
  const auto series =
      series_of("shape,Ca,kt,D_xy\nsphere,0.2,1,0.5\noblate,0.05,1,0.3\nsphere,0.05,1,0.23\n");
  ASSERT_EQ(series.size(), 1u);
  ASSERT_EQ(series[0].points.size(), 1u);
  EXPECT_EQ(series[0].points[0].D_xy, 0.23);
}

TEST_F(PublishedSeriesTest, TakesAnEmptyCellForAnyValue) {
  EXPECT_EQ(series_of("C,Ca,kt,D_xy\n,0.05,1,0.23\n").size(), 1u);
}

TEST_F(PublishedSeriesTest, IsNamedAfterTheFileWhereNoPaperIsGiven) {
  EXPECT_EQ(series_of("kt,D_xy\n1,0.23\n").at(0).title, "other codes");
}

TEST_F(PublishedSeriesTest, LeavesOutPointsWithoutATimeAndHasNoThetaWhereThereIsNone) {
  const auto series = series_of("kt,D_xy,theta\nsteady,0.27,0.17\n1,0.23,\n2,0.26,0.18\n");
  ASSERT_EQ(series.at(0).points.size(), 2u);
  EXPECT_TRUE(std::isnan(series[0].points[0].theta_over_pi));
  EXPECT_EQ(series[0].points[1].theta_over_pi, 0.18);
}

TEST_F(PublishedSeriesTest, RefusesAFileWithoutTimesOrDeformations) {
  EXPECT_THROW(series_of("Ca,kt\n0.05,1\n"), std::invalid_argument);
}

}  // namespace
}  // namespace capstan
