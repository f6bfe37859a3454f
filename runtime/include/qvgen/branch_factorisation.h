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
        factors_(k, i) = factors_(i, k) = factor;
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

  /// Solves M x = b for many b: from(k) is the k-th one's first number, to(k) where its x goes. They may be
  /// the same place.
  template <class From, class To>
  void solve_all(int columns, const From& from, const To& to) const {
    const Below below(*this);
    Tile x = Tile::Zero();
    for (int first = 0; first < columns; first += tile) {
      const int count = columns - first < tile ? columns - first : tile;
      for (int j = 0; j < count; ++j) {
        const Scalar* const b = from(first + j);
        for (int i = 0; i < dof; ++i) x(j, i) = b[i];
      }
      solve_in_place(x, dof, below);
      for (int j = 0; j < count; ++j) {
        Scalar* const result = to(first + j);
        for (int i = 0; i < dof; ++i) result[i] = x(j, i);
      }
    }
  }

  /// Returns the inverse of M: its upper triangle is computed, which needs no rows below it.
  [[nodiscard]] Matrix inverse() const {
    const Below below(*this);
    Matrix result;
    for (int first = 0; first < dof; first += tile) {
      const int end = dof - first < tile ? dof : first + tile;
      Tile x = Tile::Zero();
      for (int k = first; k < end; ++k) x(k - first, k) = Scalar(1);
      solve_in_place(x, end, below);
      for (int k = first; k < end; ++k)
        for (int i = 0; i <= k; ++i) result(i, k) = result(k, i) = x(k - first, i);
    }
    return result;
  }

 private:
  /// Right-hand sides that are solved side by side: row k of them stands in column k.
  static constexpr int tile = dof < 9 ? 8 : 12;
  using Tile = Eigen::Matrix<Scalar, tile, dof>;
  using Row = Eigen::Matrix<Scalar, tile, 1>;

  /// The rows that each row carries, from the nearest number on: first[k] up to first[k + 1].
  struct Below {
    explicit Below(const BranchFactorisation& factors) {
      for (int k = 0; k < dof; ++k)
        for (int i = factors.parent(k); i >= 0; i = factors.parent(i)) ++first[i + 1];
      for (int k = 0; k < dof; ++k) first[k + 1] += first[k];
      int place[dof];
      for (int k = 0; k < dof; ++k) place[k] = first[k];
      for (int k = 0; k < dof; ++k)
        for (int i = factors.parent(k); i >= 0; i = factors.parent(i)) rows[place[i]++] = k;
    }
    int first[dof + 1] = {};
    int rows[dof * (dof - 1) / 2 + 1];
  };

  /// `count`: rows from the first on, further ones being zero and not wanted.
  void solve_in_place(Tile& x, int count, const Below& below) const {
    for (int i = count - 1; i >= 0; --i) {
      Row sum = x.col(i);
      const Scalar* const factor = factors_.data() + i * dof;
      const int* const end = below.rows + below.first[i + 1];
      for (const int* k = below.rows + below.first[i]; k != end && *k < count; ++k)
        sum -= factor[*k] * x.col(*k);
      x.col(i) = sum;
    }
    for (int k = 0; k < count; ++k) {
      const Scalar* const factor = factors_.data() + k * dof;
      Row sum = x.col(k) / factor[k];
      for (int i = parent(k); i >= 0; i = parent(i)) sum -= factor[i] * x.col(i);
      x.col(k) = sum;
    }
  }

  [[nodiscard]] int parent(int k) const { return parents_[static_cast<std::size_t>(k)]; }

  Matrix factors_;  ///< below the diagonal L, on it D, above it the transpose of L
  Parents parents_;
};

template <class Scalar, int dof>
BranchFactorisation(const Eigen::Matrix<Scalar, dof, dof>&,
                    const std::array<int, static_cast<std::size_t>(dof)>&)
    -> BranchFactorisation<Scalar, dof>;

}  // namespace qvgen
