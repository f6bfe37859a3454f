// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "derive/dynamics/scalar.h"
#include "model/robot.h"

namespace qvgen::derive::dynamics {

/// Second moments Sigma = int r r^T dm, first moments h = int r dm and mass of a body, as the symmetric 4x4
/// matrix
/// [[Sigma, h], [h^T, m]]: it transforms like P -> T P T^T, which is what makes regrouping easy.
/// Inertia about the origin: trace(Sigma) 1 - Sigma.
class PseudoInertia {
 public:
  Scalar& at(std::size_t row, std::size_t column) { return entries_[index(row, column)]; }
  [[nodiscard]] const Scalar& at(std::size_t row, std::size_t column) const {
    return entries_[index(row, column)];
  }
  [[nodiscard]] Vector3 first_moments() const { return {at(0, 3), at(1, 3), at(2, 3)}; }
  [[nodiscard]] const Scalar& mass() const { return at(3, 3); }

  friend PseudoInertia operator+(const PseudoInertia& a, const PseudoInertia& b);
  friend PseudoInertia operator-(const PseudoInertia& a, const PseudoInertia& b);

 private:
  static std::size_t index(std::size_t row, std::size_t column) {
    if (row > column) std::swap(row, column);
    return row * 4 + column - row * (row + 1) / 2;
  }
  std::array<Scalar, 10> entries_;
};

/// Displaced by t: r -> r + t.
PseudoInertia shifted(const PseudoInertia& inertia, const Vector3& t);
/// Displaced by t along axis k alone, with the fewest operations: h' = h + m t, Sigma_kk' = Sigma_kk + t (h +
/// h').
PseudoInertia shifted(const PseudoInertia& inertia, std::size_t k, const Scalar& t);
/// Turned about axis k: r -> R r. The in-plane second moments take four multiplications with
/// t = s (Sigma_ii - Sigma_jj) + 2 c Sigma_ij: Sigma_ii - s t, Sigma_jj + s t, c t - Sigma_ij.
PseudoInertia rotated(const PseudoInertia& inertia, std::size_t k, const Circle& by);

/// Returns the pseudo-inertia of a link in its own link frame, from mass, centre of mass and inertia about
/// it.
PseudoInertia from_description(const model::Inertia& inertia, dag::Graph& graph);

/// Returns the pseudo-inertia of a body (model::body_count) with symbols for its standard parameters, in
/// which it is linear.
PseudoInertia from_standard(std::size_t body, dag::Graph& graph);

/// Symbol of a standard parameter: of each body mass, first moments x y z, and the inertia about the origin
/// of the body's frame xx yy zz xy yz xz; ten times the body plus the place in this list.
std::string standard_parameter(std::size_t index);

}  // namespace qvgen::derive::dynamics
