// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <qvgen/inverse/solutions.h>

/// Proofs about the solutions of a pose, by interval arithmetic: no rounding can make them wrong.
///
/// A row. The six joints x of a solution are a zero of f(x), the six equations of the loop that the arm and
/// the pose close (`certified/closure.h` in the runtime's sources). For a box X around the row m, an
/// enclosure F'(X) of all derivatives in it and any matrix Y, Krawczyk's operator K(X) = m - Y f(m) + (I - Y
/// F'(X)) (X - m) encloses every zero in X; if K(X) lies strictly inside X there is a zero in X, and no
/// second one (Krawczyk 1969, Moore 1977). The smallest box for which that is found says how far the solution
/// is from the row, the largest where it is the only one. The derivatives in such a box are regular: a row of
/// a continuum, or one where two solutions have become one, is never proven.
///
/// The count. Two joints of the loop are dropped, by functions of the others that these two cannot change,
/// for which the loop falls into two sides of two joints each: g(a) = h(b). The torus of those four (three)
/// angles is covered with boxes. Each is shown to hold no solution, because the two sides have no value or no
/// linear combination in common, or to lie where all solutions but a proven row's are excluded; else it is
/// halved (`certified/reduced.h`, `certified/cover.h`). Slides are among what is dropped, so that nothing
/// is said of a limited range only.
///
/// All this is about the true arm and the very pose: the numbers of the description are exact (0.4318 lies
/// between two doubles), symbols have the values of `Geometry`, the position is the three doubles given,
/// and the orientation that of the four, whatever their length.
namespace qvgen {

enum class Proof {
  complete,  ///< every solution of the pose is among the rows, each of which is proven, no two the same
  undecided  ///< not proven: the pose is (next to) singular, a row is missing, or the work was not enough
};

/// Lengths of slides count as angles do: metres beside radians.
struct RowProof {
  /// A solution is within `within` of the row in every joint, and no other one within `alone_within`.
  bool proven = false;
  double within = 0;
  double alone_within = 0;
};

/// Rows with what is proven of them.
template <int dof, int capacity>
struct CertifiedSolutions {
  Solutions<dof, capacity> solutions;
  std::array<RowProof, static_cast<std::size_t>(capacity)> rows;  ///< in the same order
  Proof count = Proof::undecided;
  int boxes = 0;  ///< that the count has looked at

  /// Exactly these solutions, no more and no fewer.
  [[nodiscard]] bool is_complete() const { return count == Proof::complete; }
};

}  // namespace qvgen
