#include "solver/fluid/stokes/gmres.hpp"

#include <gtest/gtest.h>

namespace capstan {
namespace {

struct System {
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(30, 30) + 0.1 * Eigen::MatrixXd::Random(30, 30);
  Eigen::VectorXd b = Eigen::VectorXd::Random(30);
  auto apply() const {
    return [this](const Eigen::VectorXd& v) -> Eigen::VectorXd { return A * v; };
  }
};

TEST(Gmres, ReachesTheToleranceAndReportsTheError) {
  const System system;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(30);
  const LinearSolution solution = solve_gmres(system.apply(), system.b, 1e-8, 40, x);
  EXPECT_LE(solution.relative_error, 1e-8);
  EXPECT_NEAR((system.b - system.A * x).norm() / system.b.norm(), solution.relative_error, 1e-10);
}

TEST(Gmres, AnExactGuessCostsOneProduct) {
  const System system;
  Eigen::VectorXd x = system.A.lu().solve(system.b);
  const Eigen::VectorXd guess = x;
  EXPECT_EQ(solve_gmres(system.apply(), system.b, 1e-8, 40, x).products, 1);
  EXPECT_EQ(x, guess);
}

TEST(Gmres, ReportsTheErrorThatTooFewProductsLeave) {
  const System system;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(30);
  const LinearSolution solution = solve_gmres(system.apply(), system.b, 1e-8, 4, x);
  EXPECT_EQ(solution.products, 4);
  EXPECT_GT(solution.relative_error, 1e-8);
  EXPECT_LT(solution.relative_error, 1);
}

TEST(Gmres, ReportsTheResidual) {
  const System system;
  for (double tolerance : {1e-8, 1e-3, 10.}) {  // 10: the initial guess is good enough
    Eigen::VectorXd x = Eigen::VectorXd::Zero(30);
    const LinearSolution solution = solve_gmres(system.apply(), system.b, tolerance, 40, x);
    EXPECT_LT((solution.residual - (system.b - system.A * x)).norm(), 1e-12 * system.b.norm()) << tolerance;
  }
}

TEST(Gmres, StopsUnconvergedOnNumbersThatAreNotFinite) {
  const System system;
  Eigen::VectorXd x = Eigen::VectorXd::Constant(30, NAN);
  EXPECT_FALSE(solve_gmres(system.apply(), system.b, 1e-8, 40, x).relative_error <= 1e-8);
}

}  // namespace
}  // namespace capstan
