// SPDX-License-Identifier: MIT
// Linear equations with a mass matrix, by branches. Joints that do not carry one another have a zero in it,
// and eliminating from the tips to the base makes no other entry of them: M = L^T D L, L as sparse as M
// (Featherstone, "Efficient factorization of the joint-space inertia matrix for branched kinematic trees",
// 2005). The branches are a type, so that everything here is straight-line code.
//
//     const qvgen::BranchFactorisation factors(robot::mass_matrix(q), robot::mass_matrix_parents);
//     const auto qdd = factors.solve(torque - bias);
//
// A row of L has entries for the rows that carry it, from the base on. Those of a row that carries it begin
// its own list: rows are kept as such lists, without zeros between, in whole registers.
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

  /// Entries of rows that are on no common branch, and those below the diagonal, are not read.
  explicit BranchFactorisation(const Matrix& mass, Branches = {}) : first_entry_(mass(0, 0)) {
    Lists pivots;  // the rows of D L
    for_each_row(Backwards<Rows>(),
                 [&](auto k) { eliminate<k>(mass, RowsCarriedBy<Branches, k>(), pivots); });
  }

  /// True if the matrix is positive definite, as mass matrices are. Else solutions mean nothing.
  [[nodiscard]] bool is_positive() const {
    for (int k = 0; k < size; ++k)
      if (!(pivots_[k] > Scalar(0))) return false;
    return true;
  }

  /// Returns M(0, 0): the whole mass, where a base floats.
  [[nodiscard]] const Scalar& first_entry() const { return first_entry_; }

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
  [[nodiscard]] Matrix inverse() const {
    Padded x;
    invert(x);
    return x.template topRows<size>();
  }
  /// Writes the inverse to a matrix that is there.
  void invert(Padded& x) const {
    for_each_row(Backwards<Rows>(),
                 [&](auto i) { start_from_unit<i>(Backwards<RowsCarriedBy<Branches, i>>(), x); });
    for_each_row(Rows(), [&](auto k) { finish<k>(Carrying<k>(), x); });
  }

 private:
  using Rows = std::make_integer_sequence<int, size>;
  template <int k>
  using Carrying = RowsCarrying<Branches, k>;
  /// Place of a row in lists of those that it carries: how many carry it.
  template <int row>
  static constexpr int depth = static_cast<int>(Carrying<row>::size());

  template <int... row>
  static constexpr int deepest(std::integer_sequence<int, row...>) {
    return std::max({depth<row>...});
  }
  /// Column k: the list of row k, its own entry at the end, in as many registers as the longest one.
  using Lists = Eigen::Matrix<Scalar, detail::RegistersOf<Scalar, deepest(Rows()) + 1>::lanes, size>;
  template <int row>
  using ListRegisters = detail::RegistersOf<Scalar, depth<row> + 1>;

  template <int k, int... carried>
  void eliminate(const Matrix& mass, std::integer_sequence<int, carried...>, Lists& pivots) {
    ListRegisters<k> row(mass.data() + k * size, RowsCarrying<Branches, k, k + 1>());
    (row.subtract(pivots(depth<k>, carried), &lists_(0, carried)), ...);
    row.store(&pivots(0, k));
    pivots_[k] = pivots(depth<k>, k);
    reciprocals_[k] = Scalar(1) / pivots_[k];
    row.scale(reciprocals_[k]);
    row.store(&lists_(0, k));
    settle(pivots, lists_);
  }

  /// Has matrices that take more than the registers of most machines read from memory.
  template <class... Stored>
  static void settle([[maybe_unused]] const Stored&... stored) {
    if constexpr (lanes / Registers::unit_size * size > 16) (detail::settle(stored.data()), ...);
  }

  /// Entry of L of two rows, the one that carries the other first.
  template <int one, int other>
  [[nodiscard]] const Scalar& factor() const {
    return lists_(depth<std::min(one, other)>, std::max(one, other));
  }

  template <int row, int... other>
  void subtract(std::integer_sequence<int, other...>, Vector& x) const {
    Scalar sum = x[row];
    ((sum -= factor<row, other>() * x[other]), ...);
    x[row] = sum;
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
    (sum.template subtract_some<Carried<other>>(factor<row, other>(), x.data() + other * lanes), ...);
    sum.template store_some<Carried<row>>(x.data() + row * lanes);
    settle(x);
  }
  /// Column k of `x`: row k of right-hand sides, which becomes that of the solutions.
  template <int row, int first, int... other>
  void finish(std::integer_sequence<int, first, other...>, Padded& x) const {
    Registers sum(Carried<row>(), reciprocals_[row], x.data() + row * lanes, factor<row, first>(),
                  x.data() + first * lanes);
    (sum.subtract(factor<row, other>(), x.data() + other * lanes), ...);
    sum.store(x.data() + row * lanes);
    settle(x);
  }
  /// A row that none carries.
  template <int row>
  void finish(std::integer_sequence<int>, Padded& x) const {
    Registers sum;
    sum.template subtract_some<Carried<row>>(-reciprocals_[row], x.data() + row * lanes);
    sum.store(x.data() + row * lanes);
    settle(x);
  }

  Lists lists_;                  ///< the rows of L
  Vector pivots_, reciprocals_;  ///< D, and one by each of it
  Scalar first_entry_;
};

template <class Scalar, int... parents>
BranchFactorisation(const Eigen::Matrix<Scalar, int(sizeof...(parents)), int(sizeof...(parents))>&,
                    Branches<parents...>) -> BranchFactorisation<Scalar, Branches<parents...>>;

}  // namespace qvgen
