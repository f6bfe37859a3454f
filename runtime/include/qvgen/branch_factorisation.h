// SPDX-License-Identifier: MIT
// Linear equations with a mass matrix, by branches. Joints that do not carry one another have a zero in it,
// and eliminating from the tips to the base makes no other entry of them: M = L^T D L, L as sparse as M
// (Featherstone, "Efficient factorization of the joint-space inertia matrix for branched kinematic trees",
// 2005).
//
//     const BranchFactorisation factors(robot::mass_matrix(q), robot::mass_matrix_parents);
//     const auto qdd = factors.solve(torque - bias);
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace qvgen {

template <class Scalar, int dof>
class BranchFactorisation {
 public:
  using Matrix = Eigen::Matrix<Scalar, dof, dof>;
  using Vector = Eigen::Matrix<Scalar, dof, 1>;
  /// The row before each row on its branch, a smaller index, or -1.
  using Parents = std::array<int, static_cast<std::size_t>(dof)>;

  /// Entries of rows that are on no common branch are not read.
  BranchFactorisation(const Matrix& mass, const Parents& parents) : factors_(mass), parents_(parents) {
    for (int k = dof - 1; k >= 0; --k)
      for (int i = parent(k); i >= 0; i = parent(i)) {
        const Scalar factor = factors_(k, i) / factors_(k, k);
        for (int j = i; j >= 0; j = parent(j)) factors_(i, j) -= factor * factors_(k, j);
        factors_(k, i) = factor;
      }
  }

  /// True if the matrix is positive definite, as mass matrices are. Else solutions mean nothing.
  [[nodiscard]] bool is_positive() const {
    for (int k = 0; k < dof; ++k)
      if (!(factors_(k, k) > Scalar(0))) return false;
    return true;
  }

  /// Returns x with M x = b.
  [[nodiscard]] Vector solve(const Vector& b) const {
    Vector x = b;
    for (int k = dof - 1; k >= 0; --k)
      for (int i = parent(k); i >= 0; i = parent(i)) x[i] -= factors_(k, i) * x[k];
    for (int k = 0; k < dof; ++k) {
      x[k] /= factors_(k, k);
      for (int i = parent(k); i >= 0; i = parent(i)) x[k] -= factors_(k, i) * x[i];
    }
    return x;
  }

 private:
  [[nodiscard]] int parent(int k) const { return parents_[static_cast<std::size_t>(k)]; }

  Matrix factors_;  ///< below the diagonal L, on it D
  Parents parents_;
};

template <class Scalar, int dof>
BranchFactorisation(const Eigen::Matrix<Scalar, dof, dof>&,
                    const std::array<int, static_cast<std::size_t>(dof)>&)
    -> BranchFactorisation<Scalar, dof>;

}  // namespace qvgen
