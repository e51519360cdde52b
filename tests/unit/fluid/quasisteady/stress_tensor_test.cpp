// The stress that a cell passes on: the arithmetic mean of the viscosity, and the harmonic one for the shear
// stress along the normal of the membrane.
#include "solver/fluid/quasisteady/stress_tensor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>

namespace capstan {
namespace {

constexpr double kArithmeticFactor = 0.6, kHarmonicFactor = 0.25;

/// Q, or c P', of one cell with the given normal and symmetric traceless P.
Eigen::Matrix3d passed(const Eigen::Matrix3d& P, const Eigen::Vector3d& n, bool without_shear = false) {
  const std::array<double, 5> p = {P(0, 0), P(1, 1), P(0, 1), P(0, 2), P(1, 2)};
  const std::array<double, 5> interface = {kArithmeticFactor, kHarmonicFactor - kArithmeticFactor, n[0], n[1],
                                           n[2]};
  std::array<double, 5> q{};
  const TensorRow<double> row{.p = p.data(),
                              .q = q.data(),
                              .stress_stride = 1,
                              .interface = interface.data(),
                              .interface_stride = 1,
                              .count = 1,
                              .undisturbed = 0};
  without_shear ? put_stress_without_shear(row, true) : put_passed_stress(row, true);
  Eigen::Matrix3d Q;
  Q << q[0], q[2], q[3], q[2], q[1], q[4], q[3], q[4], -q[0] - q[1];
  return Q;
}

const Eigen::Vector3d kNormal = Eigen::Vector3d(1, -2, 0.5).normalized();
const Eigen::Vector3d kAlong = kNormal.cross(Eigen::Vector3d(0, 0, 1)).normalized();

TEST(StressTensor, ShearAlongTheNormalHasTheHarmonicFactor) {
  const Eigen::Matrix3d P = kNormal * kAlong.transpose() + kAlong * kNormal.transpose();
  EXPECT_LT((passed(P, kNormal) - kHarmonicFactor * P).norm(), 1e-14);
  EXPECT_LT(passed(P, kNormal, true).norm(), 1e-14);
}

TEST(StressTensor, AllOtherStressesHaveTheArithmeticFactor) {
  const Eigen::Vector3d across = kNormal.cross(kAlong);
  for (const Eigen::Matrix3d& P :
       {Eigen::Matrix3d(kAlong * across.transpose() + across * kAlong.transpose()),
        Eigen::Matrix3d(kNormal * kNormal.transpose() - Eigen::Matrix3d::Identity() / 3)}) {
    EXPECT_LT((passed(P, kNormal) - kArithmeticFactor * P).norm(), 1e-14);
    EXPECT_LT((passed(P, kNormal, true) - kArithmeticFactor * P).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace capstan
