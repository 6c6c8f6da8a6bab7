// SPDX-License-Identifier: MIT
#include "study/least_squares.hpp"

#include <cmath>
#include <vector>

#include <Eigen/LU>
#include <gmock/gmock.h>

namespace hackle {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

Residuals all_of(const std::function<VectorXd(const VectorXd&)>& one) {
  return [one](const std::vector<VectorXd>& points) {
    std::vector<VectorXd> values;
    for (const VectorXd& point : points) values.push_back(one(point));
    return values;
  };
}

TEST(LeastSquares, SolvesALinearProblemWithItsUncertainty) {
  MatrixXd a(3, 2);
  a << 1, 2, 3, -1, 0.5, 1;
  const Vector2d right(0.3, -0.7);
  const FitBounds bounds{Vector2d(-2, -2), Vector2d(2, 2)};
  const LeastSquares found =
      least_squares(all_of([&](const VectorXd& x) -> VectorXd { return a * (x - right); }), bounds,
                    Vector2d(0, 0));
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR((found.point - right).norm(), 0.0, 1e-6);
  const MatrixXd covariance = (a.transpose() * a).inverse();
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(*found.uncertainty[static_cast<std::size_t>(k)], std::sqrt(covariance(k, k)), 1e-9);
}

TEST(LeastSquares, FollowsACurvedValley) {
  // Rosenbrock's function as residuals.
  const LeastSquares found = least_squares(
      all_of([](const VectorXd& x) -> VectorXd {
        return Vector2d(10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]);
      }),
      {Vector2d(-2, -2), Vector2d(2, 2)}, Vector2d(-1.2, 1.0), {.difference = 1e-3, .rounds = 60});
  EXPECT_NEAR(found.point[0], 1.0, 1e-2);
  EXPECT_NEAR(found.point[1], 1.0, 2e-2);
}

TEST(LeastSquares, StaysWithinBounds) {
  const LeastSquares found = least_squares(
      all_of([](const VectorXd& x) -> VectorXd { return x.array() - 5.0; }),
      {VectorXd::Constant(1, 0.0), VectorXd::Constant(1, 2.0)}, VectorXd::Constant(1, 1.0));
  EXPECT_EQ(found.point[0], 2.0);
  EXPECT_TRUE(found.at_bound[0]);
}

TEST(LeastSquares, SaysWhatDoesNotMatter) {
  const LeastSquares found = least_squares(
      all_of([](const VectorXd& x) -> VectorXd { return VectorXd::Constant(1, x[0] - 0.25); }),
      {Vector2d(0, 0), Vector2d(1, 1)}, Vector2d(0.5, 0.5));
  EXPECT_NEAR(found.point[0], 0.25, 1e-6);
  EXPECT_TRUE(found.uncertainty[0]);
  EXPECT_FALSE(found.uncertainty[1]);
  EXPECT_EQ(found.jacobian.col(1).norm(), 0.0);
}

TEST(LeastSquares, CopesWithSteps) {
  // Results come in steps of a hundredth: the answer is right to a step.
  const LeastSquares found = least_squares(
      all_of([](const VectorXd& x) -> VectorXd {
        return VectorXd::Constant(1, std::round(100.0 * x[0] * x[0]) - 49.0);
      }),
      {VectorXd::Constant(1, 0.0), VectorXd::Constant(1, 2.0)}, VectorXd::Constant(1, 1.0));
  EXPECT_NEAR(found.point[0], 0.7, 0.5 / 140.0 + 1e-9);
}

}  // namespace
}  // namespace hackle
