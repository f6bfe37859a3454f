// SPDX-License-Identifier: MIT
// The branches of a robot as a type: which row of its mass matrix carries which is known where the code is
// compiled, so that loops over branches become straight lines.
//
//     inline constexpr qvgen::Branches<-1, 0, 1, 0, 3> mass_matrix_parents{};    // rows 1, 2 and 3, 4 on row
//     0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace qvgen {

/// `parents`: the row before each row on its branch, a smaller index, or -1.
template <int... parents>
struct Branches {
  static constexpr int size = sizeof...(parents);

  static constexpr int parent(int row) {
    constexpr std::array<int, sizeof...(parents)> all{parents...};
    return all[static_cast<std::size_t>(row)];
  }
  /// True if `row` carries `other`, or is it.
  static constexpr bool carries(int row, int other) {
    while (other > row) other = parent(other);
    return other == row;
  }
};

namespace detail {

template <int first, int... rest>
constexpr auto before(std::integer_sequence<int, rest...>) {
  return std::integer_sequence<int, first, rest...>();
}

/// The rows from `row` up to `end` that `Accepts` takes, as a sequence.
template <class Accepts, int row, int end>
constexpr auto rows_from() {
  if constexpr (row >= end) {
    return std::integer_sequence<int>();
  } else if constexpr (Accepts::accepts(row)) {
    return before<row>(rows_from<Accepts, row + 1, end>());
  } else {
    return rows_from<Accepts, row + 1, end>();
  }
}

template <class Branches, int of>
struct CarriedBy {
  static constexpr bool accepts(int row) { return Branches::carries(of, row); }
};
template <class Branches, int of>
struct Carrying {
  static constexpr bool accepts(int row) { return Branches::carries(row, of); }
};
template <class Branches, int of>
struct OnABranchWith {
  static constexpr bool accepts(int row) { return Branches::carries(std::min(row, of), std::max(row, of)); }
};

template <int last, int... rest>
constexpr auto behind(std::integer_sequence<int, rest...>) {
  return std::integer_sequence<int, rest..., last>();
}
constexpr auto reversed(std::integer_sequence<int>) { return std::integer_sequence<int>(); }
template <int first, int... rest>
constexpr auto reversed(std::integer_sequence<int, first, rest...>) {
  return behind<first>(reversed(std::integer_sequence<int, rest...>()));
}

template <int... rows>
constexpr auto chain(std::integer_sequence<int, rows...>) {
  return Branches<(rows - 1)...>();
}

}  // namespace detail

/// Rows in the opposite order, the last one first.
template <class Rows>
using Backwards = decltype(detail::reversed(Rows()));
/// The rows that row `of` carries, from the nearest to the base on.
template <class Branches, int of>
using RowsCarriedBy = decltype(detail::rows_from<detail::CarriedBy<Branches, of>, of + 1, Branches::size>());
/// The rows before `end` that carry row `of`, from the base on.
template <class Branches, int of, int end = of>
using RowsCarrying = decltype(detail::rows_from<detail::Carrying<Branches, of>, 0, end>());
/// The rows in whose column `of` the mass matrix is not zero.
template <class Branches, int of>
using RowsOnABranchWith =
    decltype(detail::rows_from<detail::OnABranchWith<Branches, of>, 0, Branches::size>());

/// The branches of an arm, each of whose joints carries the next.
template <int dof>
using Chain = decltype(detail::chain(std::make_integer_sequence<int, dof>()));

/// Calls f(std::integral_constant<int, row>()) for each row of a sequence.
template <class Function, int... rows>
constexpr void for_each_row(std::integer_sequence<int, rows...>, const Function& f) {
  (f(std::integral_constant<int, rows>()), ...);
}
}  // namespace qvgen
