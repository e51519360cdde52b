#include "solver/fluid/stokes/initial_guess.hpp"

#include <gtest/gtest.h>

namespace capstan {
namespace {

constexpr double kInverse = 0.4;

struct Equations {
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(30, 30) / kInverse + 0.1 * Eigen::MatrixXd::Random(30, 30);
  Eigen::VectorXd solution_of(const Eigen::VectorXd& b) const { return A.lu().solve(b); }
};

double relative_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).norm() / b.norm();
}

TEST(InitialGuess, ACombinationOfTheLastRightHandSidesIsSolvedExactly) {
  const Equations equations;
  InitialGuess guess(kInverse);
  Eigen::VectorXd combination = Eigen::VectorXd::Zero(30);
  for (double weight : {1., -3., 3.}) {
    const Eigen::VectorXd b = Eigen::VectorXd::Random(30);
    guess.remember(b, equations.solution_of(b));
    combination += weight * b;
  }
  EXPECT_LT(relative_difference(guess.solution_of(combination), equations.solution_of(combination)), 1e-8);
}

TEST(InitialGuess, IsTheInverseOfShortWavesWhereNothingIsRemembered) {
  const Eigen::VectorXd b = Eigen::VectorXd::Random(30);
  EXPECT_EQ(InitialGuess(kInverse).solution_of(b), kInverse * b);
}

// Four points of a cubic in time determine it.
TEST(InitialGuess, ExtrapolatesACurveInTime) {
  const Equations equations;
  const Eigen::MatrixXd coefficients = Eigen::MatrixXd::Random(30, 4);
  const auto at = [&](double t) -> Eigen::VectorXd {
    return coefficients * Eigen::Vector4d(1, t, t * t, t * t * t);
  };
  InitialGuess guess(kInverse);
  for (double t : {0., 0.1, 0.2, 0.3}) guess.remember(at(t), equations.solution_of(at(t)));
  EXPECT_LT(relative_difference(guess.solution_of(at(0.4)), equations.solution_of(at(0.4))), 1e-5);
}

TEST(InitialGuess, IsTheSameAfterSavingAndLoading) {
  InitialGuess guess(kInverse), loaded(kInverse);
  for (int n = 0; n < 3; ++n) guess.remember(Eigen::VectorXd::Random(30), Eigen::VectorXd::Random(30));
  StateArchive archive;
  guess.save(archive);
  loaded.load(archive);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(30);
  EXPECT_EQ(loaded.solution_of(b), guess.solution_of(b));
}

TEST(InitialGuess, CanBeSavedBeforeTheFirstEquation) {
  StateArchive archive;
  InitialGuess(kInverse).save(archive);
  InitialGuess loaded(kInverse);
  loaded.load(archive);
  EXPECT_EQ(loaded.solution_of(Eigen::VectorXd::Ones(3)), kInverse * Eigen::VectorXd::Ones(3));
}

}  // namespace
}  // namespace capstan
