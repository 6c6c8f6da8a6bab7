// SPDX-License-Identifier: MIT
#include "study/least_squares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace hackle {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Below this share of the largest, a parameter moves no residual.
constexpr double insensitive = 1e-9;

// In shares of the ranges, 0 to 1, so that all parameters are of one size.
class Fit {
 public:
  Fit(const Residuals& residuals, const FitBounds& bounds, const LeastSquaresOptions& options)
      : residuals_(residuals), bounds_(bounds), options_(options) {}

  LeastSquares run(const VectorXd& start) {
    point_ = (start - bounds_.from).cwiseQuotient(bounds_.to - bounds_.from);
    point_ = point_.cwiseMax(0.0).cwiseMin(1.0);
    values_ = at({point_}).front();
    LeastSquares result;
    double damping = 1e-2;
    while (result.rounds < options_.rounds && !result.converged) {
      ++result.rounds;
      differentiate();
      result.converged = !improve(damping) && !look_around();
    }
    differentiate();
    tell(result);
    return result;
  }

 private:
  VectorXd unscaled(const VectorXd& share) const {
    return bounds_.from + share.cwiseProduct(bounds_.to - bounds_.from);
  }

  std::vector<VectorXd> at(const std::vector<VectorXd>& shares) const {
    std::vector<VectorXd> points;
    points.reserve(shares.size());
    for (const VectorXd& share : shares) points.push_back(unscaled(share));
    return residuals_(points);
  }

  void differentiate() {
    std::vector<VectorXd> points;
    for (Index k = 0; k < point_.size(); ++k)
      for (const double sign : {-1.0, 1.0}) {
        points.push_back(point_);
        points.back()[k] = std::clamp(point_[k] + sign * options_.difference, 0.0, 1.0);
      }
    const std::vector<VectorXd> all = at(points);
    jacobian_.resize(values_.size(), point_.size());
    for (Index k = 0; k < point_.size(); ++k) {
      const auto low = static_cast<std::size_t>(2 * k);
      jacobian_.col(k) = (all[low + 1] - all[low]) / (points[low + 1][k] - points[low][k]);
    }
    // A point beside it may be better already.
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k].squaredNorm() < best_beside_)
        best_beside_ = all[k].squaredNorm(), beside_ = {points[k], all[k]};
  }

  VectorXd step_with(double damping) const {
    MatrixXd normal = jacobian_.transpose() * jacobian_;
    const double floor = std::max(normal.diagonal().maxCoeff() * 1e-12, 1e-300);
    for (Index k = 0; k < normal.rows(); ++k)
      normal(k, k) += damping * std::max(normal(k, k), floor) + floor;
    return normal.ldlt().solve(-jacobian_.transpose() * values_);
  }

  // Takes the best of three steps. Returns false if none is better, or the best is tiny.
  bool improve(double& damping) {
    constexpr auto factors = std::to_array({0.1, 1.0, 30.0});
    std::vector<VectorXd> trials;
    trials.reserve(factors.size());
    for (const double factor : factors)
      trials.push_back((point_ + step_with(damping * factor)).cwiseMax(0.0).cwiseMin(1.0));
    std::vector<VectorXd> values = at(trials);
    std::size_t best = 0;
    for (std::size_t k = 1; k < values.size(); ++k)
      if (values[k].squaredNorm() < values[best].squaredNorm()) best = k;
    damping = std::clamp(damping * factors[best], 1e-9, 1e9);
    std::pair<VectorXd, VectorXd> next{trials[best], values[best]};
    if (best_beside_ < next.second.squaredNorm()) next = beside_;
    best_beside_ = 1e300;
    if (!(next.second.squaredNorm() < values_.squaredNorm() * (1.0 - 1e-9))) return false;
    const double moved = (next.first - point_).cwiseAbs().maxCoeff();
    std::tie(point_, values_) = std::move(next);
    return moved > options_.tolerance;
  }

  // Where results come in steps, a better point may lie beside one that no slope leads away from.
  bool look_around() {
    std::vector<VectorXd> points;
    for (Index k = 0; k < point_.size(); ++k)
      for (const double factor : {-2.0, -0.5, -0.25, 0.25, 0.5, 2.0}) {
        points.push_back(point_);
        points.back()[k] = std::clamp(point_[k] + factor * options_.difference, 0.0, 1.0);
      }
    const std::vector<VectorXd> values = at(points);
    std::size_t best = 0;
    for (std::size_t k = 1; k < values.size(); ++k)
      if (values[k].squaredNorm() < values[best].squaredNorm()) best = k;
    if (!(values[best].squaredNorm() < values_.squaredNorm() * (1.0 - 1e-9))) return false;
    point_ = points[best];
    values_ = values[best];
    return true;
  }

  void tell(LeastSquares& result) {
    const VectorXd width = bounds_.to - bounds_.from;
    result.point = unscaled(point_);
    result.residuals = values_;
    result.jacobian = jacobian_ * width.cwiseInverse().asDiagonal();
    const auto freedom = static_cast<double>(values_.size() - point_.size());
    const double spread = freedom > 0 ? std::max(1.0, values_.squaredNorm() / freedom) : 1.0;
    for (Index k = 0; k < point_.size(); ++k)
      result.at_bound.push_back(point_[k] <= 0.0 || point_[k] >= 1.0);
    result.uncertainty = deviations(std::sqrt(spread), width);
  }

  // Of the parameters that residuals react to; together they may still not be told apart.
  std::vector<std::optional<double>> deviations(double spread, const VectorXd& width) const {
    std::vector<std::optional<double>> all(static_cast<std::size_t>(point_.size()));
    std::vector<Index> active;
    const double largest = jacobian_.colwise().norm().maxCoeff();
    for (Index k = 0; k < point_.size(); ++k)
      if (jacobian_.col(k).norm() > insensitive * largest) active.push_back(k);
    MatrixXd reduced(jacobian_.rows(), static_cast<Index>(active.size()));
    for (std::size_t k = 0; k < active.size(); ++k)
      reduced.col(static_cast<Index>(k)) = jacobian_.col(active[k]);
    const Eigen::FullPivLU<MatrixXd> normal(reduced.transpose() * reduced);
    if (active.empty() || !normal.isInvertible()) return all;
    const MatrixXd covariance = normal.inverse();
    for (std::size_t k = 0; k < active.size(); ++k) {
      const auto at = static_cast<Index>(k);
      all[static_cast<std::size_t>(active[k])] =
          spread * std::sqrt(covariance(at, at)) * width[active[k]];
    }
    return all;
  }

  const Residuals& residuals_;
  const FitBounds& bounds_;
  LeastSquaresOptions options_;
  VectorXd point_, values_;
  MatrixXd jacobian_;
  double best_beside_ = 1e300;
  std::pair<VectorXd, VectorXd> beside_;
};

}  // namespace

LeastSquares least_squares(const Residuals& residuals, const FitBounds& bounds,
                           const Eigen::VectorXd& start, const LeastSquaresOptions& options) {
  return Fit(residuals, bounds, options).run(start);
}

}  // namespace hackle
