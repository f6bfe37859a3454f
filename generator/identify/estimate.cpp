// SPDX-License-Identifier: MIT
#include "identify/estimate.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "matrices/decompositions.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_rounds = 30;
constexpr double settled_noise = 1e-4;
/// Residuals below this share of the torques are rounding.
constexpr double rounding = 1e-13;

/// The triangles in all columns, one below the other; the last column is that of the torques.
struct Stack {
  MatrixXd rows;
  std::vector<Index> first;  ///< row of each joint's triangle, and their count

  Stack(const Equations& equations, Index parameters) {
    first.push_back(0);
    for (const JointEquations& joint : equations)
      first.push_back(first.back() + static_cast<Index>(joint.columns().size()) + 1);
    rows.setZero(first.back(), parameters + 1);
    for (std::size_t i = 0; i < equations.size(); ++i) place(equations[i], first[i]);
  }

  void place(const JointEquations& joint, Index row) {
    const MatrixXd triangle = joint.triangle();
    const Index n = triangle.rows();
    for (Index c = 0; c + 1 < n; ++c)
      rows.block(row, joint.columns()[static_cast<std::size_t>(c)], n, 1) = triangle.col(c);
    rows.block(row, rows.cols() - 1, n, 1) = triangle.col(n - 1);
  }

  [[nodiscard]] auto of(std::size_t joint) const {
    return rows.middleRows(first[joint], first[joint + 1] - first[joint]);
  }
};

/// A factorisation of weighted, scaled columns, and which of them it keeps.
struct Solved {
  VectorXd scale;           ///< lengths of the columns, 1 for empty ones
  std::vector<Index> kept;  ///< in the order of the pivots
  std::vector<Index> rest;
  VectorXd value;    ///< of all parameters
  MatrixXd inverse;  ///< of the triangle of the kept columns, unscaled: value covariance = inverse inverse^T
  MatrixXd relations;  ///< kept x rest: a dependent column is the kept ones times these
  MatrixXd triangle;   ///< of the kept, scaled columns
};

Solved solve(const MatrixXd& weighted) {
  Solved result;
  const Index n = weighted.cols() - 1;
  MatrixXd columns = weighted.leftCols(n);
  result.scale = columns.colwise().norm().transpose();
  for (Index k = 0; k < n; ++k) {
    if (result.scale[k] == 0) result.scale[k] = 1;
    columns.col(k) /= result.scale[k];
  }
  const matrices::PivotedTriangle found =
      matrices::pivoted_triangle(columns, weighted.col(n), dependent_share);
  const Index rank = found.rank;
  result.kept.assign(found.order.begin(), found.order.begin() + rank);
  result.rest.assign(found.order.begin() + rank, found.order.end());
  result.triangle = found.upper;
  result.relations = matrices::solve_upper(found.upper, found.beside);
  result.inverse = matrices::solve_upper(found.upper, MatrixXd::Identity(rank, rank));
  result.value = VectorXd::Zero(n);
  for (Index k = 0; k < rank; ++k) {
    const Index place = result.kept[static_cast<std::size_t>(k)];
    result.value[place] = found.solution[k] / result.scale[place];
    result.inverse.row(k) /= result.scale[place];
  }
  return result;
}

/// The weighted equations, and what each joint's residual has of freedom.
class Weighting {
 public:
  Weighting(const Equations& equations, Index parameters)
      : equations_(equations), stack_(equations, parameters) {}

  [[nodiscard]] MatrixXd weighted(const VectorXd& noise) const {
    MatrixXd rows = stack_.rows;
    for (std::size_t i = 0; i < equations_.size(); ++i)
      if (noise[static_cast<Index>(i)] > 0)
        rows.middleRows(stack_.first[i], stack_.first[i + 1] - stack_.first[i]) /=
            noise[static_cast<Index>(i)];
    return rows;
  }

  /// Sum of squares that a joint's residual has.
  [[nodiscard]] double squares(std::size_t joint, const VectorXd& value) const {
    const auto rows = stack_.of(joint);
    return (rows.leftCols(value.size()) * value - rows.rightCols(1)).squaredNorm();
  }
  [[nodiscard]] double torques(std::size_t joint) const {
    return stack_.of(joint).rightCols(1).squaredNorm();
  }

  /// Noise of all joints by their residuals: each row of a joint that parameters are fitted to has so much
  /// less freedom (the trace of its part of the hat matrix).
  [[nodiscard]] VectorXd noise(const Solved& solved, const VectorXd& before) const {
    VectorXd noise = VectorXd::Zero(before.size());
    for (std::size_t i = 0; i < equations_.size(); ++i) {
      const auto joint = static_cast<Index>(i);
      const auto measured = static_cast<double>(equations_[i].measured());
      if (measured == 0) continue;
      const double freedom = measured - fitted(i, solved) / (before[joint] * before[joint]);
      noise[joint] = std::max(std::sqrt(squares(i, solved.value) / std::max(freedom, 1.0)), floor(i));
    }
    return noise;
  }

  /// Smallest noise that rounding leaves.
  [[nodiscard]] double floor(std::size_t joint) const {
    const auto measured = static_cast<double>(std::max<Index>(1, equations_[joint].measured()));
    const double level = std::sqrt(torques(joint) / measured);
    return level > 0 ? rounding * level : 1;
  }

 private:
  [[nodiscard]] double fitted(std::size_t joint, const Solved& solved) const {
    const auto rows = stack_.of(joint);
    MatrixXd kept(rows.rows(), static_cast<Index>(solved.kept.size()));
    for (Index k = 0; k < kept.cols(); ++k) kept.col(k) = rows.col(solved.kept[static_cast<std::size_t>(k)]);
    return (kept * solved.inverse).squaredNorm();
  }

  const Equations& equations_;
  Stack stack_;
};

void check_rows(const Equations& equations) {
  Index rows = 0, most = 0;
  for (const JointEquations& joint : equations) {
    rows += joint.measured();
    most = std::max(most, static_cast<Index>(joint.columns().size()));
  }
  if (rows <= 2 * most)
    throw std::runtime_error("only " + std::to_string(rows) + " rows for " + std::to_string(most) +
                             " parameters: a log of some hundred samples is the least");
}

double condition_of(const MatrixXd& triangle) {
  if (triangle.size() == 0) return 0;
  const VectorXd values = matrices::singular_values(triangle);
  return values[0] / values[values.size() - 1];
}

void add_covariance(const Solved& solved, Estimate& result) {
  const Index n = result.value.size();
  const MatrixXd small = solved.inverse * solved.inverse.transpose();
  result.covariance.setZero(n, n);
  result.told.assign(static_cast<std::size_t>(n), false);
  for (Index a = 0; a < small.rows(); ++a) {
    const Index row = solved.kept[static_cast<std::size_t>(a)];
    result.told[static_cast<std::size_t>(row)] = true;
    for (Index b = 0; b < small.cols(); ++b)
      result.covariance(row, solved.kept[static_cast<std::size_t>(b)]) = small(a, b);
  }
  result.deviation = result.covariance.diagonal().cwiseSqrt();
}

void add_parts(const Solved& solved, Estimate& result) {
  const Index n = result.value.size();
  result.parts.setZero(n, n);
  for (Index b = 0; b < solved.relations.cols(); ++b) {
    const Index of = solved.rest[static_cast<std::size_t>(b)];
    for (Index a = 0; a < solved.relations.rows(); ++a) {
      const Index in = solved.kept[static_cast<std::size_t>(a)];
      if (std::abs(solved.relations(a, b)) > dependent_share)
        result.parts(of, in) = solved.relations(a, b) * solved.scale[of] / solved.scale[in];
    }
  }
}

}  // namespace

Estimate estimate(const Equations& equations, Index parameters, const std::optional<VectorXd>& given) {
  check_rows(equations);
  const Weighting weighting(equations, parameters);
  VectorXd noise = given.value_or(VectorXd::Zero(static_cast<Index>(equations.size())));
  for (std::size_t i = 0; !given && i < equations.size(); ++i) {
    const auto measured = static_cast<double>(std::max<Index>(1, equations[i].measured()));
    noise[static_cast<Index>(i)] = std::max(std::sqrt(weighting.torques(i) / measured), weighting.floor(i));
  }
  Solved solved = solve(weighting.weighted(noise));
  for (int round = 0; !given && round < most_rounds; ++round) {
    const VectorXd next = weighting.noise(solved, noise);
    const bool same =
        (next - noise).cwiseAbs().cwiseQuotient(next.cwiseMax(1e-300)).maxCoeff() < settled_noise;
    noise = next;
    solved = solve(weighting.weighted(noise));
    if (same) break;
  }
  Estimate result;
  result.value = solved.value;
  result.noise = noise;
  for (const JointEquations& joint : equations) result.measured.push_back(joint.measured());
  result.condition = condition_of(solved.triangle);
  add_covariance(solved, result);
  add_parts(solved, result);
  const MatrixXd weighted = weighting.weighted(noise);
  const MatrixXd triangle = matrices::upper_triangle(weighted);
  const Index rows = std::min(weighted.rows(), parameters);
  result.information = triangle.topLeftCorner(rows, parameters);
  result.right_side = triangle.col(parameters).head(rows);
  return result;
}

VectorXd residuals(const Equations& equations, const VectorXd& parameters) {
  const Weighting weighting(equations, parameters.size());
  VectorXd result(static_cast<Index>(equations.size()));
  for (std::size_t i = 0; i < equations.size(); ++i)
    result[static_cast<Index>(i)] = std::sqrt(
        weighting.squares(i, parameters) / static_cast<double>(std::max<Index>(1, equations[i].measured())));
  return result;
}

VectorXd torque_levels(const Equations& equations) {
  Index parameters = 0;
  for (const JointEquations& joint : equations)
    for (const Index column : joint.columns()) parameters = std::max(parameters, column + 1);
  return residuals(equations, VectorXd::Zero(parameters));
}

}  // namespace qvgen::identify
