// SPDX-License-Identifier: MIT
// Linear equations with a mass matrix, by branches. Joints that do not carry one another have a zero in it,
// and eliminating from the tips to the base makes no other entry of them: M = L^T D L, L as sparse as M
// (Featherstone, "Efficient factorization of the joint-space inertia matrix for branched kinematic trees",
// 2005). The branches are a type, so that everything here is straight-line code.
//
//     const qvgen::BranchFactorisation factors(robot::mass_matrix(q), robot::mass_matrix_parents);
//     const auto qdd = factors.solve(torque - bias);
#pragma once

#include <algorithm>
#include <utility>

#include <Eigen/Core>
#include <qvgen/branches.h>
#include <qvgen/detail/side_by_side.h>

namespace qvgen {

template <class Scalar, class RobotBranches>
class BranchFactorisation {
 public:
  using Branches = RobotBranches;
  static constexpr int size = Branches::size;
  using Matrix = Eigen::Matrix<Scalar, size, size>;
  using Vector = Eigen::Matrix<Scalar, size, 1>;

  /// Entries of rows that are on no common branch, and those above the diagonal, are not read.
  explicit BranchFactorisation(const Matrix& mass, Branches = {}) {
    for_each_row(Rows(), [&](auto k) { take<k>(mass, RowsUpTo<k>()); });
    for_each_row(Backwards<Rows>(), [this](auto k) { eliminate<k>(); });
  }

  /// True if the matrix is positive definite, as mass matrices are. Else solutions mean nothing.
  [[nodiscard]] bool is_positive() const {
    for (int k = 0; k < size; ++k)
      if (!(factors_(k, k) > Scalar(0))) return false;
    return true;
  }

  /// Returns x with M x = b.
  [[nodiscard]] Vector solve(const Vector& b) const {
    Vector x = b;
    for_each_row(Backwards<Rows>(), [&](auto i) { subtract<i>(Backwards<RowsCarriedBy<Branches, i>>(), x); });
    x = x.cwiseProduct(reciprocals_);
    for_each_row(Rows(), [&](auto k) { subtract<k>(Carrying<k>(), x); });
    return x;
  }

  /// Columns of `lanes` numbers, of which those behind the first `size` are zero, fill whole registers.
  using Registers = detail::RegistersOf<Scalar, size>;
  static constexpr int lanes = Registers::lanes;
  using Padded = Eigen::Matrix<Scalar, lanes, size>;

  /// Returns the inverse of M, symmetric but for rounding.
  [[nodiscard]] Padded padded_inverse() const {
    Padded x;
    for_each_row(Backwards<Rows>(),
                 [&](auto i) { start_from_unit<i>(Backwards<RowsCarriedBy<Branches, i>>(), x); });
    for_each_row(Rows(), [&](auto k) { subtract<k>(Carrying<k>(), x, reciprocals_[k]); });
    return x;
  }
  [[nodiscard]] Matrix inverse() const { return padded_inverse().template topRows<size>(); }

 private:
  using Rows = std::make_integer_sequence<int, size>;
  template <int k>
  using Carrying = RowsCarrying<Branches, k>;
  template <int k>
  using RowsUpTo = RowsCarrying<Branches, k, k + 1>;

  /// Copies one row of the lower triangle: to copy the whole matrix would take longer than to factorise it.
  template <int k, int... j>
  void take(const Matrix& mass, std::integer_sequence<int, j...>) {
    ((factors_(k, j) = mass(k, j)), ...);
  }

  template <int k>
  void eliminate() {
    reciprocals_[k] = Scalar(1) / factors_(k, k);
    for_each_row(Backwards<Carrying<k>>(), [&](auto i) { eliminate<k, i>(RowsUpTo<i>()); });
  }
  template <int k, int i, int... j>
  void eliminate(std::integer_sequence<int, j...>) {
    const Scalar factor = factors_(k, i) * reciprocals_[k];
    ((factors_(i, j) -= factor * factors_(k, j)), ...);
    factors_(k, i) = factor;
  }

  template <int one, int other>
  static constexpr int place = std::min(one, other) * size + std::max(one, other);

  template <int row, int... other>
  void subtract(std::integer_sequence<int, other...>, Vector& x) const {
    ((x[row] -= factors_.data()[place<row, other>] * x[other]), ...);
  }
  /// Column k of `x`: row k of right-hand sides, which becomes that of the solutions.
  template <int row, int... other>
  void subtract(std::integer_sequence<int, other...>, Padded& x, const Scalar& scale) const {
    Registers sum(x.data() + row * lanes);
    sum.scale(scale);
    (sum.subtract(factors_.data()[place<row, other>], x.data() + other * lanes), ...);
    sum.store(x.data() + row * lanes);
  }

  /// Columns that a row carries: others of its right-hand side are zero as long as nothing came from the
  /// base.
  template <int row>
  struct Carried {
    static constexpr bool any(int begin, int end) {
      for (int column = begin; column < end && column < size; ++column)
        if (Branches::carries(row, column)) return true;
      return false;
    }
  };
  /// Column k of `x` becomes row k of the unit matrix less what later rows make of it.
  template <int row, int... other>
  void start_from_unit(std::integer_sequence<int, other...>, Padded& x) const {
    Registers sum = Registers::template unit<row>();
    (sum.template subtract_some<Carried<other>>(factors_.data()[place<row, other>], x.data() + other * lanes),
     ...);
    sum.store(x.data() + row * lanes);
  }

  Matrix factors_;  ///< below the diagonal L, on it D; the rest is not set
  Vector reciprocals_;
};

template <class Scalar, int... parents>
BranchFactorisation(const Eigen::Matrix<Scalar, int(sizeof...(parents)), int(sizeof...(parents))>&,
                    Branches<parents...>) -> BranchFactorisation<Scalar, Branches<parents...>>;

}  // namespace qvgen
