#include "solver/observe/surface_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace capstan {
namespace {

const SurfaceQuality kSmooth{18, 0, 30}, kWrinkled{88, 0.027, 20}, kCrumpled{178, 0.08, 6};

TEST(SurfaceWatch, ASmoothSurfaceIsNeitherFoldedNorLost) {
  SurfaceWatch watch;
  for (int step = 0; step < 10; ++step) watch.add(0.1 * step, kSmooth);
  EXPECT_FALSE(watch.folded_from());
  EXPECT_FALSE(watch.lost_from());
}

TEST(SurfaceWatch, KeepsTheWorstQualityAndTheTimesOfTheFirstFoldAndLoss) {
  SurfaceWatch watch;
  watch.add(0, kSmooth);
  watch.add(1, kWrinkled);
  watch.add(2, kSmooth);
  watch.add(3, kCrumpled);
  watch.add(4, kSmooth);
  EXPECT_EQ(watch.worst(), kCrumpled);
  EXPECT_EQ(watch.folded_from(), 1);
  EXPECT_EQ(watch.lost_from(), 3);
  EXPECT_THAT(watch.description(),
              ::testing::HasSubstr("up to 178 degrees, 8 % of the edges at more than 60"));
}

TEST(SurfaceWatch, TemporaryWrinklesDoNotLoseTheSurface) {
  SurfaceWatch watch;
  for (int step = 0; step < 10; ++step) watch.add(0.1 * step, step % 2 ? kWrinkled : kSmooth);
  EXPECT_TRUE(watch.folded_from());
  EXPECT_FALSE(watch.lost_from());
}

TEST(SurfaceWatch, ALostSurfaceRemovesTheLabelAndKeepsTheEvidence) {
  SurfaceWatch watch;
  watch.add(7.5, kCrumpled);
  Verdict verdict{
      .motion = Motion::tank_treading, .evidence = {}, .certain = true, .steady = true, .explanation = {}};
  verdict.evidence.turns = 2.9;
  verdict.evidence.margin = 0.9;
  const Verdict withdrawn = limited_by_surface(verdict, watch);
  EXPECT_EQ(withdrawn.motion, Motion::undecided);
  EXPECT_EQ(withdrawn.evidence.turns, 2.9);
  EXPECT_EQ(withdrawn.evidence.margin, 0);
  EXPECT_FALSE(withdrawn.certain);
  EXPECT_FALSE(withdrawn.steady);
  EXPECT_THAT(withdrawn.explanation, ::testing::HasSubstr("From kt = 7.5 on the mesh cannot represent"));
}

TEST(SurfaceWatch, FoldedEdgesLowerTheMargin) {
  Verdict verdict;
  verdict.motion = Motion::tumbling;
  verdict.evidence.margin = 0.8;
  const auto margin_at = [&](double dihedral) {
    SurfaceWatch watch;
    watch.add(1, {dihedral, dihedral > kFoldedEdge ? 0.01 : 0, 30});
    EXPECT_EQ(limited_by_surface(verdict, watch).motion, Motion::tumbling);
    return limited_by_surface(verdict, watch).evidence.margin;
  };
  EXPECT_EQ(margin_at(18), 0.8);
  EXPECT_EQ(margin_at(60), 0.8);
  EXPECT_NEAR(margin_at(97.5), 0.4, 1e-12);
  EXPECT_NEAR(margin_at(135), 0, 1e-12);
}

TEST(SurfaceWatch, IsRestoredFromACheckpoint) {
  SurfaceWatch watch, resumed;
  watch.add(1, kWrinkled);
  EXPECT_FALSE(watch.is_due(1.1));
  StateArchive archive;
  watch.save(archive);
  resumed.load(archive);
  EXPECT_EQ(resumed.worst(), kWrinkled);
  EXPECT_EQ(resumed.folded_from(), 1);
  EXPECT_FALSE(resumed.lost_from());
  EXPECT_FALSE(resumed.is_due(1.1));
  EXPECT_TRUE(resumed.is_due(1.25));
}

}  // namespace
}  // namespace capstan
