// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

/// Decompositions and products that many tests ask for, compiled once: Eigen's templates take seconds in
/// every file.
namespace reference {

/// m = u diag(values) v^T; values fall, u and v are square.
struct SingularValues {
  Eigen::VectorXd values;
  Eigen::MatrixXd u, v;
};
SingularValues singular_values(const Eigen::MatrixXd& m);
/// Returns the singular values alone, falling.
Eigen::VectorXd spectrum(const Eigen::MatrixXd& m);
double smallest_singular_value(const Eigen::MatrixXd& m);
/// Returns how many columns are independent by more than a share of the longest (QR with pivots).
Eigen::Index rank(const Eigen::MatrixXd& m, double share);

double determinant(const Eigen::MatrixXd& m);
Eigen::MatrixXd inverse(const Eigen::MatrixXd& m);
/// Returns D of m = L D L^T with rows exchanged, m symmetric: positive numbers if and only if m is positive
/// definite.
Eigen::VectorXd pivots(const Eigen::MatrixXd& m);
/// Returns a b; matrices of fixed sizes become these.
Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// Returns the largest magnitude of an entry, zero without any, NaN if there is one.
double largest(const Eigen::MatrixXd& m);

/// Returns the shortest turn that brings a direction, a unit vector, onto another one, not opposite to it.
/// Eigen's decomposes a matrix for opposite ones.
Eigen::Matrix3d shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// The shortest of all x that make |a x - b| least.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
/// Returns the same of a matrix whose columns are independent only by more than a share of the longest.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double share);
/// a x = b, a symmetric and positive or negative semidefinite.
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace reference
