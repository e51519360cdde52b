#include "solver/fluid/quasisteady/composite_boxes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace capstan {
namespace {

constexpr Domain kQuarter{.cells = 128, .is_quarter = true}, kWhole{.cells = 128, .is_quarter = false};
constexpr IndexBox kCapsule{{-14, 0, 0}, {12, 9, 14}};
constexpr IndexBox kUnfolded{{-14, -9, -14}, {12, 9, 14}};

void expect_nested(const Domain& domain, const std::vector<IndexBox>& boxes, const IndexBox& capsule) {
  EXPECT_TRUE(boxes[0].contains(capsule));
  for (std::size_t i = 0; i + 1 < boxes.size(); ++i) {
    const IndexBox parents = coarsened(boxes[i]);
    EXPECT_EQ(refined(parents), boxes[i]) << "grid " << i << " is not made of whole coarse cells";
    // The ghosts beyond a side are interpolated from two more coarse cells. Next to a side of the domain the
    // second of them is a ghost of the coarse grid.
    for (int axis = 0; axis < 3; ++axis) {
      const IndexBox all = domain.box(int(i) + 1);
      EXPECT_LE(boxes[i + 1].lo[axis], std::max(parents.lo[axis] - 2, all.lo[axis]));
      EXPECT_GE(boxes[i + 1].hi[axis], std::min(parents.hi[axis] + 2, all.hi[axis]));
    }
  }
  EXPECT_EQ(boxes.back(), domain.box(int(boxes.size()) - 1));
}

TEST(CompositeBoxes, AreNestedAroundTheCapsuleUpToTheDomain) {
  expect_nested(kQuarter, plan_boxes(kQuarter, kCapsule, {}), kCapsule);
  expect_nested(kWhole, plan_boxes(kWhole, kUnfolded, {}), kUnfolded);
}

TEST(CompositeBoxes, InAQuarterAreSymmetricInXAndStartAtYAndZZero) {
  for (const IndexBox& box : plan_boxes(kQuarter, kCapsule, {})) {
    EXPECT_EQ(box.lo[0], -box.hi[0]);
    EXPECT_EQ(box.lo[1], 0);
    EXPECT_EQ(box.lo[2], 0);
  }
}

TEST(CompositeBoxes, AreKeptWhileTheCapsuleMovesByTwoCells) {
  const auto boxes = plan_boxes(kWhole, kUnfolded, {});
  IndexBox moved = kUnfolded;
  moved.hi[0] += 2, moved.lo[2] += 2;
  EXPECT_EQ(plan_boxes(kWhole, moved, boxes), boxes);
  moved.hi[0] += 8;
  const auto followed = plan_boxes(kWhole, moved, boxes);
  EXPECT_NE(followed, boxes);
  expect_nested(kWhole, followed, moved);
}

TEST(CompositeBoxes, StayNestedWhileTheCapsuleMovesCellByCell) {
  IndexBox capsule = kUnfolded;
  auto boxes = plan_boxes(kWhole, capsule, {});
  for (int step = 0; step < 30; ++step) {
    ++capsule.lo[0], ++capsule.hi[0], capsule.hi[step % 3] += step % 2;
    boxes = plan_boxes(kWhole, capsule, boxes);
    expect_nested(kWhole, boxes, capsule);
  }
}

TEST(CompositeBoxes, OfACapsuleNearAWallEndAtTheWall) {
  IndexBox capsule = kUnfolded;
  capsule.hi[1] = 60, capsule.lo[1] = 42;
  const auto boxes = plan_boxes(kWhole, capsule, {});
  expect_nested(kWhole, boxes, capsule);
  EXPECT_EQ(boxes[0].hi[1], 64);
}

TEST(CompositeBoxes, TheCoarsestCoversTheDomainWhateverItsSize) {
  for (int cells : {72, 88, 112, 144, 176, 352})
    for (bool is_quarter : {false, true}) {
      const Domain domain{.cells = cells, .is_quarter = is_quarter};
      const IndexBox capsule =
          is_quarter ? IndexBox{{-9, 0, 0}, {9, 9, 9}} : IndexBox{{-9, -9, -9}, {9, 9, 9}};
      expect_nested(domain, plan_boxes(domain, capsule, {}), capsule);
    }
}

TEST(CompositeBoxes, OfAUniformGridCoverTheDomain) {
  const Domain uniform{.cells = 64, .is_quarter = false, .is_uniform = true};
  const auto boxes = plan_boxes(uniform, kUnfolded, {});
  EXPECT_EQ(int(boxes.size()), uniform.grid_count());
  for (int grid = 0; grid < int(boxes.size()); ++grid) EXPECT_EQ(boxes[grid], uniform.box(grid));
}

}  // namespace
}  // namespace capstan
