// SPDX-License-Identifier: MIT
// The parameters that make residuals smallest, where residuals are results of runs: dear, and steps
// rather than smooth.
// Source: Levenberg-Marquardt with bounds by projection; Nocedal and Wright, Numerical
// Optimization, 10.3; uncertainty after Bates and Watts (1988), 2.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace hackle {

struct FitBounds {
  Eigen::VectorXd from, to;  // from below to, of equal size
};

// Returns the residuals at points, each divided by its standard deviation; all of the same size.
// Points of one call may be computed at the same time.
using Residuals = std::function<std::vector<Eigen::VectorXd>(const std::vector<Eigen::VectorXd>&)>;

struct LeastSquaresOptions {
  double difference = 1.0 / 32.0;  // of a parameter, as a share of its range, to both sides
  double tolerance = 1e-3;         // of a step, as a share of the range, at which it ends
  int rounds = 12;                 // at most
};

struct LeastSquares {
  Eigen::VectorXd point;
  Eigen::VectorXd residuals;  // there
  Eigen::MatrixXd jacobian;   // of the residuals, by the parameters
  // One standard deviation of each: from the curvature, times sqrt(chi^2/degrees of freedom) where
  // that is above 1. Nothing for a parameter that no residual reacts to.
  std::vector<std::optional<double>> uncertainty;
  std::vector<bool> at_bound;
  int rounds = 0;
  bool converged = false;

  double chi_squared() const { return residuals.squaredNorm(); }
};

// Differences are central, one-sided at a bound. Each round tries three sizes of the step at once,
// so that the result does not depend on how many can be computed at the same time. Where none is
// better, it looks around, up to two differences away, and ends if that does not help either.
LeastSquares least_squares(const Residuals& residuals, const FitBounds& bounds,
                           const Eigen::VectorXd& start, const LeastSquaresOptions& options = {});

}  // namespace hackle
