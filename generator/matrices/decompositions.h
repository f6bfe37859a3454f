// SPDX-License-Identifier: MIT
// Decompositions of matrices of any size, compiled once for all stages that work with measured or sampled
// numbers: Eigen's templates of each take seconds in every file that asks for one.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace qvgen::matrices {

/// Returns the singular values of a matrix, which has rows, the greatest first.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

struct SingularMotions {
  Eigen::VectorXd values;  ///< the greatest first; none without rows
  Eigen::MatrixXd
      motions;  ///< orthonormal columns in the order of the values, then those that the matrix maps to zero
};

/// Returns the decomposition of a matrix with a column for each joint.
SingularMotions singular_motions(const Eigen::MatrixXd& matrix);

/// Returns the rotation next to a matrix, three by three.
Eigen::Matrix3d rotation_next_to(const Eigen::Matrix3d& matrix);

struct PrincipalAxes {
  Eigen::Vector3d values;  ///< rising
  Eigen::Matrix3d axes;    ///< a column for each value, orthonormal
};

/// Returns the eigenvalues and eigenvectors of a symmetric matrix.
PrincipalAxes principal_axes(const Eigen::Matrix3d& symmetric);

/// Returns x of a x = b, a symmetric and semidefinite.
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// Returns the same for all columns of b.
Eigen::MatrixXd solve_symmetric_columns(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Returns the shortest of all x that make |a x - b| least.
Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Returns an x that makes |a x - b| least, with zeros for columns that depend on others: those that add no
/// more than a share of what the longest has.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double share);
/// Returns the same where rounding alone makes columns depend on others.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// Columns = Q R with the columns in the order of the pivots.
struct PivotedTriangle {
  std::vector<Eigen::Index> order;  ///< of the columns, the independent ones first
  Eigen::Index rank = 0;
  Eigen::MatrixXd upper;     ///< R of the independent columns
  Eigen::MatrixXd beside;    ///< R's rows of these for the dependent columns
  Eigen::VectorXd solution;  ///< of the independent columns for a right side, by least squares
};

/// Returns the decomposition of columns, of which those depend on others that add no more than a share of
/// what the longest has.
PivotedTriangle pivoted_triangle(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right_side,
                                 double share);
/// Returns upper^-1 right.
Eigen::MatrixXd solve_upper(const Eigen::MatrixXd& upper, const Eigen::MatrixXd& right);

/// Returns the upper triangle R of rows = Q R: as many rows as columns, or all if the matrix has fewer.
Eigen::MatrixXd upper_triangle(const Eigen::MatrixXd& rows);

}  // namespace qvgen::matrices
