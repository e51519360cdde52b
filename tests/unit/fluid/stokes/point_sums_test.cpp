#include "solver/fluid/stokes/point_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/fluid/stokes/point_loops.hpp"

namespace capstan {
namespace {

using Points = Eigen::Matrix3Xd;
using Vec3 = Eigen::Vector3d;

PointArray array_of(const Points& values) {
  PointArray array;
  array.assign(values);
  return array;
}

/// Random points and vectors; their number is no multiple of the vector length.
struct Cloud {
  Points x = Points::Random(3, 37), f = Points::Random(3, 37), u = Points::Random(3, 37);
};

Vec3 stokeslets_in_double(const Cloud& cloud, const Vec3& x0) {
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index n = 0; n < cloud.x.cols(); ++n) {
    const Vec3 r = cloud.x.col(n) - x0;
    if (r.norm() > 0) sum += cloud.f.col(n) / r.norm() + r * r.dot(cloud.f.col(n)) / std::pow(r.norm(), 3);
  }
  return sum;
}

Vec3 stresslets_in_double(const Cloud& cloud, const Vec3& x0, const Vec3& u0) {
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index n = 0; n < cloud.x.cols(); ++n) {
    const Vec3 r = cloud.x.col(n) - x0;
    if (r.norm() > 0)
      sum -= 6 * r * r.dot(cloud.u.col(n) - u0) * r.dot(cloud.f.col(n)) / std::pow(r.norm(), 5);
  }
  return sum;
}

TEST(PointSums, StokesletsEqualThoseInDoublePrecision) {
  const Cloud cloud;
  const Vec3 x0(0.1, -0.2, 1.5);
  const Vec3 exact = stokeslets_in_double(cloud, x0);
  const auto sum = sum_stokeslets(array_of(cloud.x), array_of(cloud.f), x0.cast<float>());
  EXPECT_LT((sum.cast<double>() - exact).norm(), 1e-5 * exact.norm());
}

TEST(PointSums, StressletsEqualThoseInDoublePrecision) {
  const Cloud cloud;
  const Vec3 x0(0.1, -0.2, 1.5), u0(0.3, 0.2, 0.1);
  const Vec3 exact = stresslets_in_double(cloud, x0, u0);
  const auto sum = sum_stresslets(array_of(cloud.x), array_of(cloud.f), array_of(cloud.u), x0.cast<float>(),
                                  u0.cast<float>());
  EXPECT_LT((sum.cast<double>() - exact).norm(), 1e-5 * exact.norm());
}

TEST(PointSums, ASourceAtTheTargetContributesNothing) {
  Cloud cloud;
  cloud.x = cloud.x.cast<float>().cast<double>();
  const Vec3 x0 = cloud.x.col(5), u0 = cloud.u.col(5).cast<float>().cast<double>();
  const auto single = sum_stokeslets(array_of(cloud.x), array_of(cloud.f), x0.cast<float>());
  const auto double_ = sum_stresslets(array_of(cloud.x), array_of(cloud.f), array_of(cloud.u),
                                      x0.cast<float>(), u0.cast<float>());
  const Vec3 exact_single = stokeslets_in_double(cloud, x0),
             exact_in_double = stresslets_in_double(cloud, x0, u0);
  EXPECT_LT((single.cast<double>() - exact_single).norm(), 1e-5 * exact_single.norm());
  EXPECT_LT((double_.cast<double>() - exact_in_double).norm(), 1e-4 * exact_in_double.norm());
}

Components components(const PointArray& array) { return {array.x(), array.y(), array.z()}; }

// The program uses the widest instruction set of the processor; here all that the processor has are tested.
TEST(PointSums, EveryInstructionSetGivesTheSumsOfDoublePrecision) {
  Cloud cloud;
  cloud.x = cloud.x.cast<float>().cast<double>();
  const Vec3 x0 = cloud.x.col(5), u0(0.3, 0.2, 0.1);
  const PointArray x = array_of(cloud.x), f = array_of(cloud.f), u = array_of(cloud.u);
  const Eigen::Vector3f at = x0.cast<float>(), with = u0.cast<float>();
  const Vec3 exact_single = stokeslets_in_double(cloud, x0),
             exact_in_double = stresslets_in_double(cloud, x0, u0);
  for (const PointLoops* loops : supported_point_loops()) {
    Eigen::Vector3f single, double_;
    loops->stokeslets(x.padded_size(), components(x), components(f), at.data(), single.data());
    loops->stresslets(x.padded_size(), components(x), components(f), components(u), at.data(), with.data(),
                      double_.data());
    EXPECT_LT((single.cast<double>() - exact_single).norm(), 1e-5 * exact_single.norm()) << loops->unit;
    EXPECT_LT((double_.cast<double>() - exact_in_double).norm(), 1e-4 * exact_in_double.norm())
        << loops->unit;
  }
}

TEST(PointSums, EveryPointHasItsOwnReach) {
  Points x(3, 3);
  x << 1, 2, 3, 0, 0, 0, 0, 0, 0;
  std::vector<float> reach_squared(PointArray::kLanes, 0.f);
  reach_squared[0] = 1.5f, reach_squared[1] = 3.9f, reach_squared[2] = 9.1f;
  std::vector<unsigned char> marks;
  EXPECT_EQ(mark_within_reach(array_of(x), reach_squared, Eigen::Vector3f::Zero(), marks), 2);
  EXPECT_EQ(std::vector<unsigned char>(marks.begin(), marks.begin() + 4),
            (std::vector<unsigned char>{1, 0, 1, 0}));
}

}  // namespace
}  // namespace capstan
