// SPDX-License-Identifier: MIT
// Two kinds of Newton steps: towards the identified parameters as a wish whose weight grows, which always has
// an interior minimum; and with the identified parameters as equations, which ends only if a body can have
// them.
#include "identify/consistent.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "identify/divergence.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_steps = 60;
constexpr double smallest_weight = 1e-6;
constexpr double equal = 1e-11;
/// The total mass as a wish is off by this share at most.
constexpr double mass_share = 1e-7;

/// The problem in values that may change, each divided by its scale at the prior.
class Problem {
 public:
  Problem(const ArmRegressor& arm, const Estimate& estimate, const Prior& prior)
      : divergence_(prior), start_(divergence_.prior()) {
    place_free(arm);
    const VectorXd curvature = divergence_.hessian(start_).diagonal();
    scale_.resize(size());
    for (Index k = 0; k < size(); ++k) scale_[k] = 1 / std::sqrt(curvature[place(k)]);
    add_identified(arm, estimate);
    if (prior.mass) add_mass(*prior.mass, static_cast<Index>(arm.links));
  }

  [[nodiscard]] Index size() const { return static_cast<Index>(free_.size()); }

  /// All values; those that do not change are the prior's.
  [[nodiscard]] VectorXd values(const VectorXd& y) const { return put_into(start_, y); }
  /// All values; drives that the arm is taken not to have are zero.
  [[nodiscard]] VectorXd result(const VectorXd& y) const {
    return put_into(VectorXd::Zero(start_.size()), y);
  }
  [[nodiscard]] VectorXd start() const {
    VectorXd y(size());
    for (Index k = 0; k < size(); ++k) y[k] = start_[place(k)] / scale_[k];
    return y;
  }

  [[nodiscard]] double distance(const VectorXd& y) const { return divergence_.at(values(y)); }
  [[nodiscard]] VectorXd gradient(const VectorXd& y) const {
    const VectorXd all = divergence_.gradient(values(y));
    VectorXd result(size());
    for (Index k = 0; k < size(); ++k) result[k] = scale_[k] * all[place(k)];
    return result;
  }
  [[nodiscard]] MatrixXd hessian(const VectorXd& y) const {
    const MatrixXd all = divergence_.hessian(values(y));
    MatrixXd result(size(), size());
    for (Index a = 0; a < size(); ++a)
      for (Index b = 0; b < size(); ++b) result(a, b) = scale_[a] * scale_[b] * all(place(a), place(b));
    return result;
  }

  MatrixXd equations;  ///< rows of length one; equations * y = sides
  VectorXd sides;
  MatrixXd wish;  ///< |wish * y - wished|^2 is the growth of the weighted squares
  VectorXd wished;
  Index measured = 0;  ///< rows of the wish that are no prior

 private:
  [[nodiscard]] VectorXd put_into(VectorXd all, const VectorXd& y) const {
    for (Index k = 0; k < size(); ++k) all[place(k)] = scale_[k] * y[k];
    return all;
  }
  [[nodiscard]] Index place(Index k) const { return free_[static_cast<std::size_t>(k)]; }

  void place_free(const ArmRegressor& arm) {
    const Index standard = arm.standard();
    for (Index k = 0; k < start_.size(); ++k) {
      const bool drive = k >= standard;
      const auto kind = static_cast<DriveParameter>(std::max<Index>(0, k - standard) % 4);
      if (!drive || std::find(arm.drives.begin(), arm.drives.end(), kind) != arm.drives.end())
        free_.push_back(k);
    }
  }

  /// The combinations that the data tell: a parameter with its share of those that are not told.
  void add_identified(const ArmRegressor& arm, const Estimate& estimate) {
    const Index n = estimate.value.size();
    std::vector<Index> kept;
    for (Index k = 0; k < n; ++k)
      if (estimate.told[static_cast<std::size_t>(k)]) kept.push_back(k);
    const auto rows = static_cast<Index>(kept.size());
    MatrixXd told(rows, n), weights(estimate.information.rows(), rows);
    sides.resize(rows);
    for (Index a = 0; a < rows; ++a) {
      const Index k = kept[static_cast<std::size_t>(a)];
      told.row(a) = estimate.parts.col(k).transpose();
      told(a, k) = 1;
      weights.col(a) = estimate.information.col(k);
      sides[a] = estimate.value[k];
    }
    MatrixXd combination(arm.combination.rows(), size());
    for (Index k = 0; k < size(); ++k) combination.col(k) = scale_[k] * arm.combination.col(place(k));
    equations = told * combination;
    wish = weights * equations;
    wished = weights * sides;
    measured = wish.rows();
    for (Index a = 0; a < rows; ++a) {
      const double length = equations.row(a).norm();
      equations.row(a) /= length;
      sides[a] /= length;
    }
  }

  void add_mass(double mass, Index links) {
    VectorXd row = VectorXd::Zero(size());
    for (Index i = 0; i < links; ++i) row[10 * i] = scale_[10 * i];
    const double length = row.norm(), weight = 1 / (mass_share * mass);
    const auto append = [](MatrixXd& rows, VectorXd& right, const VectorXd& added, double side) {
      rows.conservativeResize(rows.rows() + 1, Eigen::NoChange);
      right.conservativeResize(right.size() + 1);
      rows.row(rows.rows() - 1) = added;
      right[right.size() - 1] = side;
    };
    append(equations, sides, row / length, mass / length);
    append(wish, wished, row * weight, mass * weight);
  }

  Divergence divergence_;
  VectorXd start_, scale_;
  std::vector<Index> free_;
};

/// Largest share of a step, by halves, that stays inside and lowers `merit`.
template <class Merit>
double share_of(const VectorXd& y, const VectorXd& step, const Merit& merit) {
  const double before = merit(y, 0.0);
  for (double share = 1; share > 1e-12; share /= 2)
    if (merit(y + share * step, share) < before) return share;
  return 0;
}

/// Minimises weight * distance + |wish y - wished|^2 / 2, by Newton's method.
VectorXd towards(const Problem& problem, VectorXd y, double weight) {
  const double root = std::sqrt(weight);
  const Index n = problem.size(), m = problem.wish.rows();
  const auto merit = [&](const VectorXd& at, double) {
    return problem.distance(at) + ((problem.wish * at - problem.wished) / root).squaredNorm() / 2;
  };
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::LLT<MatrixXd> curvature(problem.hessian(y));
    MatrixXd rows(m + n, n);
    rows << problem.wish / root, MatrixXd(curvature.matrixU());
    VectorXd sides(m + n);
    sides << (problem.wished - problem.wish * y) / root, -curvature.matrixL().solve(problem.gradient(y));
    const VectorXd direction = rows.colPivHouseholderQr().solve(sides);
    const double share = share_of(y, direction, merit);
    if (share == 0) break;  // at the border of what bodies can have, as near as numbers tell
    y += share * direction;
    if ((rows * direction).norm() < 1e-6) break;
  }
  return y;
}

/// Newton's method with equations (Boyd and Vandenberghe, Convex Optimization, 10.3).
class WithEquations {
 public:
  WithEquations(const Problem& problem, VectorXd y) : problem_(problem), y_(std::move(y)) {
    multipliers_ = VectorXd::Zero(problem.sides.size());
  }

  /// Returns the minimum, or nothing if the steps end elsewhere.
  std::optional<VectorXd> solve() {
    for (int step = 0; step < most_steps; ++step) {
      const double before = residual(y_, multipliers_);
      take_step();
      const double after = residual(y_, multipliers_);
      if (!(after < before) || after < 1e-10) break;
    }
    for (int repeat = 0; repeat < 3; ++repeat) correct();
    const bool met = missing(y_).cwiseAbs().maxCoeff() < equal * (1 + problem_.sides.cwiseAbs().maxCoeff());
    if (!met || !std::isfinite(problem_.distance(y_))) return std::nullopt;
    return y_;
  }

 private:
  [[nodiscard]] VectorXd missing(const VectorXd& y) const { return problem_.sides - problem_.equations * y; }
  [[nodiscard]] double residual(const VectorXd& y, const VectorXd& multipliers) const {
    if (!std::isfinite(problem_.distance(y))) return std::numeric_limits<double>::infinity();
    return std::hypot((problem_.gradient(y) + problem_.equations.transpose() * multipliers).norm(),
                      missing(y).norm());
  }

  void take_step() {
    const Eigen::LLT<MatrixXd> curvature(problem_.hessian(y_));
    const MatrixXd across = curvature.solve(problem_.equations.transpose());
    const VectorXd down = curvature.solve(problem_.gradient(y_));
    const Eigen::LDLT<MatrixXd> small(problem_.equations * across);
    const VectorXd next = -small.solve(missing(y_) + problem_.equations * down);
    const VectorXd step = -down - across * next;
    const VectorXd turn = next - multipliers_;
    const double share = share_of(
        y_, step, [&](const VectorXd& at, double part) { return residual(at, multipliers_ + part * turn); });
    if (share == 0) return;
    y_ += share * step;
    multipliers_ += share * turn;
  }

  /// Moves to the equations alone; near them this changes nothing but rounding.
  void correct() {
    const Eigen::LLT<MatrixXd> curvature(problem_.hessian(y_));
    const MatrixXd across = curvature.solve(problem_.equations.transpose());
    const VectorXd step = across * (problem_.equations * across).ldlt().solve(missing(y_));
    if (std::isfinite(problem_.distance(y_ + step))) y_ += step;
  }

  const Problem& problem_;
  VectorXd y_, multipliers_;
};

}  // namespace

FullSet closest_consistent(const ArmRegressor& arm, const Estimate& estimate, const Prior& prior) {
  const Problem problem(arm, estimate, prior);
  VectorXd y = problem.start();
  const auto growth = [&](const VectorXd& at) {
    return (problem.wish * at - problem.wished).head(problem.measured).squaredNorm();
  };
  for (double weight = std::max(1.0, growth(y)); weight > smallest_weight; weight /= 10) {
    y = towards(problem, y, weight);
    if (const auto exact = WithEquations(problem, y).solve()) return {problem.result(*exact), true, 0};
  }
  return {problem.result(y), false, growth(y)};
}

}  // namespace qvgen::identify
