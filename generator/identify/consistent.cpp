// SPDX-License-Identifier: MIT
// The identified parameters are first a wish whose weight grows: that has a minimum inside whatever the data
// say. From each of these minima a short step is tried to parameters that have them exactly; if it stays
// inside, Newton's method goes on along the exact ones. All steps are in directions in which the curvature of
// the divergence is one, so that they keep their digits next to the border too.
#include "identify/consistent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identify/divergence.h"
#include "matrices/decompositions.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_steps = 200;
/// The wish counts so much more than the divergence at the end, as a share of what it misses.
constexpr double smallest_weight = 1e-9;
/// Steps shorter than this change nothing any more.
constexpr double settled = 1e-6;
constexpr double equal = 1e-12;
/// Share of the greatest parameter below which one is zero in exact data.
constexpr double zero_share = 1e-9;
/// The total mass as a wish is off by this share at most.
constexpr double mass_share = 1e-7;

/// Linear equations of the values.
struct Linear {
  MatrixXd rows;
  VectorXd sides;

  void append(const VectorXd& row, double side) {
    rows.conservativeResize(rows.rows() + 1, Eigen::NoChange);
    sides.conservativeResize(sides.size() + 1);
    rows.bottomRows(1) = row.transpose();
    sides[sides.size() - 1] = side;
  }
  [[nodiscard]] VectorXd missing(const VectorXd& values) const { return sides - rows * values; }
};

/// The combinations that the data tell, each a parameter with its share of those that are not told.
struct Told {
  MatrixXd combinations, weights;
  VectorXd values;
};

Told told_by(const Estimate& estimate) {
  const Index n = estimate.value.size(), count = std::count(estimate.told.begin(), estimate.told.end(), true);
  Told result{MatrixXd(count, n), MatrixXd(estimate.information.rows(), count), VectorXd(count)};
  Index row = 0;
  for (Index k = 0; k < n; ++k) {
    if (!estimate.told[static_cast<std::size_t>(k)]) continue;
    result.combinations.row(row) = estimate.parts.col(k).transpose();
    result.combinations(row, k) = 1;
    result.weights.col(row) = estimate.information.col(k);
    result.values[row++] = estimate.value[k];
  }
  return result;
}

class Problem {
 public:
  Problem(const ArmRegressor& arm, const Estimate& estimate, const Prior& prior) : divergence_(prior) {
    const Told told = told_by(estimate);
    equations.rows = told.combinations * arm.combination;
    equations.sides = told.values;
    leave_out_zero_drives(arm.standard());
    wish.rows = told.weights * equations.rows;
    wish.sides = told.weights * told.values;
    measured_ = wish.rows.rows();
    for (Index k = 0; k < equations.rows.rows(); ++k) {
      const double length = equations.rows.row(k).norm();
      if (length == 0) continue;
      equations.rows.row(k) /= length;
      equations.sides[k] /= length;
    }
    if (prior.mass) add_mass(*prior.mass, static_cast<Index>(arm.links));
    place_fixed(arm);
  }

  [[nodiscard]] VectorXd start() const { return divergence_.prior(); }
  [[nodiscard]] double distance(const VectorXd& values) const { return divergence_.at(values); }
  [[nodiscard]] VectorXd slope(const VectorXd& values) const { return divergence_.slope(values); }
  /// Directions of the values; none for drives that the arm does not have.
  [[nodiscard]] MatrixXd directions(const VectorXd& values) const {
    MatrixXd result = divergence_.directions(values);
    for (const Index k : fixed_) result.col(k).setZero();
    return result;
  }
  /// Growth of the weighted squares.
  [[nodiscard]] double growth(const VectorXd& values) const {
    return wish.missing(values).head(measured_).squaredNorm();
  }
  /// The values with zeros for drives that there are not.
  [[nodiscard]] VectorXd result(VectorXd values) const {
    for (const Index k : fixed_) values[k] = 0;
    return values;
  }

  Linear equations, wish;

 private:
  /// A parameter that is zero, and that drives without offsets alone make up, all with one sign, says that
  /// these are zero: a place at the border, to which no step would lead.
  void leave_out_zero_drives(Index standard) {
    const double greatest = equations.sides.cwiseAbs().maxCoeff();
    for (Index k = 0; k < equations.rows.rows(); ++k) {
      if (std::abs(equations.sides[k]) > zero_share * greatest) continue;
      const VectorXd row = equations.rows.row(k).transpose();
      const double none = zero_share * row.cwiseAbs().maxCoeff();
      bool has_others = row.head(standard).cwiseAbs().maxCoeff() > none;
      for (Index i = standard + 3; i < row.size(); i += 4) has_others = has_others || std::abs(row[i]) > none;
      if (has_others || (row.minCoeff() < -none && row.maxCoeff() > none)) continue;
      equations.sides[k] = 0;
      for (Index i = standard; i < row.size(); ++i)
        if (std::abs(row[i]) > none) {
          equations.rows.col(i).setZero();
          fixed_.push_back(i);
        }
    }
  }

  void add_mass(double mass, Index links) {
    VectorXd row = VectorXd::Zero(equations.rows.cols());
    for (Index i = 0; i < links; ++i) row[10 * i] = 1;
    equations.append(row, mass);
    wish.append(row / (mass_share * mass), 1 / mass_share);
  }

  /// Coulomb friction of a joint that several motors move has no part in any parameter either.
  void place_fixed(const ArmRegressor& arm) {
    for (Index k = arm.standard(); k < equations.rows.cols(); ++k) {
      const auto kind = static_cast<DriveParameter>((k - arm.standard()) % 4);
      const bool is_left_out = std::find(arm.drives.begin(), arm.drives.end(), kind) == arm.drives.end();
      if (is_left_out || arm.combination.col(k).isZero(0)) fixed_.push_back(k);
    }
  }

  Divergence divergence_;
  Index measured_ = 0;
  std::vector<Index> fixed_;
};

/// Adds the largest share of a step, by halves, that lowers `merit` and goes no further than most of the way
/// to the border: from next to it the way back would be long. Returns false if there is none.
template <class Merit>
bool take(const Problem& problem, VectorXd& values, const VectorXd& step, const Merit& merit) {
  constexpr double most = 0.8;
  const double before = merit(values);
  for (double share = 1; share > 1e-9; share /= 2) {
    if (!std::isfinite(problem.distance(values + share / most * step))) continue;
    if (!(merit(values + share * step) < before)) continue;
    while (merit(values + share / 2 * step) < merit(values + share * step)) share /= 2;
    values += share * step;
    return true;
  }
  return false;
}

/// Minimises weight * distance + |missing wish|^2 / 2.
VectorXd towards(const Problem& problem, VectorXd values, double weight) {
  const double root = std::sqrt(weight);
  const Index n = values.size(), m = problem.wish.rows.rows();
  const auto merit = [&](const VectorXd& at) {
    return problem.distance(at) + (problem.wish.missing(at) / root).squaredNorm() / 2;
  };
  for (int step = 0; step < most_steps; ++step) {
    const MatrixXd directions = problem.directions(values);
    MatrixXd rows(m + n, n);
    rows << problem.wish.rows * directions / root, MatrixXd::Identity(n, n);
    VectorXd sides(m + n);
    sides << problem.wish.missing(values) / root, -problem.slope(values);
    // The rows below make every column count.
    const VectorXd along = matrices::least_squares(rows, sides, std::numeric_limits<double>::min());
    if (!take(problem, values, directions * along, merit) || (rows * along).norm() < settled) break;
  }
  return values;
}

/// Returns values near by that meet the equations, if a step shorter than to the border leads there.
std::optional<VectorXd> met(const Problem& problem, VectorXd values) {
  for (int repeat = 0; repeat < 6; ++repeat) {
    const VectorXd missing = problem.equations.missing(values);
    if (missing.cwiseAbs().maxCoeff() <= equal * problem.equations.sides.cwiseAbs().maxCoeff()) return values;
    const MatrixXd directions = problem.directions(values);
    const VectorXd along = matrices::shortest_solution(problem.equations.rows * directions, missing);
    if (!(along.norm() < 1)) return std::nullopt;
    values += directions * along;
  }
  return std::nullopt;
}

/// Minimises the distance along values that meet the equations.
VectorXd along_equations(const Problem& problem, VectorXd values) {
  const auto merit = [&](const VectorXd& at) { return problem.distance(at); };
  for (int step = 0; step < most_steps; ++step) {
    const MatrixXd directions = problem.directions(values);
    const MatrixXd across = (problem.equations.rows * directions).transpose();
    const VectorXd slope = problem.slope(values);
    const VectorXd along = across * matrices::least_squares(across, slope) - slope;
    if (!take(problem, values, directions * along, merit) || along.norm() < settled) break;
  }
  return met(problem, values).value_or(values);
}

}  // namespace

FullSet closest_consistent(const ArmRegressor& arm, const Estimate& estimate, const Prior& prior) {
  const Problem problem(arm, estimate, prior);
  VectorXd values = problem.start();
  for (double weight = std::max(1.0, problem.growth(values));
       weight > smallest_weight * std::max(1.0, problem.growth(values)); weight /= 5) {
    values = towards(problem, values, weight);
    if (const auto exact = met(problem, values))
      return {problem.result(along_equations(problem, *exact)), true, 0};
  }
  return {problem.result(values), false, problem.growth(values)};
}

}  // namespace qvgen::identify
