// SPDX-License-Identifier: MIT
#include "reference/linear_algebra.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace reference {
namespace {

/// Pivots of rows and columns: of Eigen's preconditioners the one that takes least time to compile, since it
/// has no blocks.
using Singular = Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::FullPivHouseholderQRPreconditioner>;

}  // namespace

SingularValues singular_values(const Eigen::MatrixXd& m) {
  const Singular parts(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {parts.singularValues(), parts.matrixU(), parts.matrixV()};
}

Eigen::VectorXd spectrum(const Eigen::MatrixXd& m) { return Singular(m).singularValues(); }

double smallest_singular_value(const Eigen::MatrixXd& m) { return spectrum(m).minCoeff(); }

Eigen::Index rank(const Eigen::MatrixXd& m, double share) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed(m);
  return decomposed.setThreshold(share).rank();
}

double determinant(const Eigen::MatrixXd& m) { return m.fullPivLu().determinant(); }

Eigen::MatrixXd inverse(const Eigen::MatrixXd& m) {
  const SingularValues parts = singular_values(m);
  return product(parts.v * parts.values.cwiseInverse().asDiagonal(), parts.u.transpose());
}

Eigen::VectorXd pivots(const Eigen::MatrixXd& m) { return m.ldlt().vectorD(); }

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a.lazyProduct(b); }

double largest(const Eigen::MatrixXd& m) {
  double result = 0;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    const double size = std::abs(m.data()[i]);
    if (std::isnan(size)) return size;
    result = std::max(result, size);
  }
  return result;
}

Eigen::Matrix3d shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double cosine = (from + to).norm() / 2;  // of half the angle
  const Eigen::Vector3d axis = from.cross(to) / (2 * cosine);
  return Eigen::Quaterniond(cosine, axis.x(), axis.y(), axis.z()).toRotationMatrix();
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double share) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> parts;
  parts.setThreshold(share);
  parts.compute(a);
  return parts.solve(b);
}

Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  return a.ldlt().solve(b);
}

}  // namespace reference
