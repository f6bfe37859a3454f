// SPDX-License-Identifier: MIT
#include "matrices/decompositions.h"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace qvgen::matrices {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Singular = Eigen::JacobiSVD<MatrixXd>;

VectorXd singular_values(const MatrixXd& matrix) { return Singular(matrix).singularValues(); }

SingularMotions singular_motions(const MatrixXd& matrix) {
  const Singular parts(matrix, Eigen::ComputeFullV);
  return {parts.singularValues(), parts.matrixV()};
}

Matrix3d rotation_next_to(const Matrix3d& matrix) {
  const Singular parts(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Matrix3d u = parts.matrixU(), v = parts.matrixV();
  const Matrix3d flipped = u * Eigen::Vector3d(1, 1, -1).asDiagonal();
  return (u.determinant() * v.determinant() < 0 ? flipped : u) * v.transpose();
}

PrincipalAxes principal_axes(const Matrix3d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> parts(symmetric);
  return {parts.eigenvalues(), parts.eigenvectors()};
}

VectorXd solve_symmetric(const MatrixXd& a, const VectorXd& b) { return a.ldlt().solve(b); }

MatrixXd solve_symmetric_columns(const MatrixXd& a, const MatrixXd& b) { return a.ldlt().solve(b); }

VectorXd shortest_solution(const MatrixXd& a, const VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

VectorXd least_squares(const MatrixXd& a, const VectorXd& b, double share) {
  Eigen::ColPivHouseholderQR<MatrixXd> parts(a);
  return parts.setThreshold(share).solve(b);
}

VectorXd least_squares(const MatrixXd& a, const VectorXd& b) { return a.colPivHouseholderQr().solve(b); }

PivotedTriangle pivoted_triangle(const MatrixXd& columns, const VectorXd& right_side, double share) {
  Eigen::ColPivHouseholderQR<MatrixXd> parts(columns);
  PivotedTriangle result;
  const Eigen::Index n = columns.cols(), rank = result.rank = parts.setThreshold(share).rank();
  const auto& order = parts.colsPermutation().indices();
  result.order.assign(order.data(), order.data() + n);
  result.upper = MatrixXd::Zero(rank, rank);
  for (Eigen::Index k = 0; k < rank; ++k)
    result.upper.col(k).head(k + 1) = parts.matrixR().col(k).head(k + 1);
  result.beside = parts.matrixR().topRightCorner(rank, n - rank);
  VectorXd side = right_side;
  side.applyOnTheLeft(parts.householderQ().adjoint());
  result.solution = result.upper.triangularView<Eigen::Upper>().solve(side.head(rank));
  return result;
}

MatrixXd solve_upper(const MatrixXd& upper, const MatrixXd& right) {
  return upper.triangularView<Eigen::Upper>().solve(right);
}

MatrixXd upper_triangle(const MatrixXd& rows) {
  const Eigen::HouseholderQR<MatrixXd> reflected(rows);
  MatrixXd triangle = reflected.matrixQR().topRows(std::min(rows.rows(), rows.cols()));
  for (Eigen::Index k = 0; k < triangle.cols(); ++k)
    for (Eigen::Index i = k + 1; i < triangle.rows(); ++i) triangle(i, k) = 0;
  return triangle;
}

}  // namespace qvgen::matrices
