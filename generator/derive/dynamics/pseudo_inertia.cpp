// SPDX-License-Identifier: MIT
#include "derive/dynamics/pseudo_inertia.h"

#include "derive/dynamics/chain.h"

namespace qvgen::derive::dynamics {

PseudoInertia operator+(const PseudoInertia& a, const PseudoInertia& b) {
  PseudoInertia sum;
  for (std::size_t i = 0; i < 10; ++i) sum.entries_[i] = a.entries_[i] + b.entries_[i];
  return sum;
}

PseudoInertia operator-(const PseudoInertia& a, const PseudoInertia& b) {
  PseudoInertia difference;
  for (std::size_t i = 0; i < 10; ++i) difference.entries_[i] = a.entries_[i] - b.entries_[i];
  return difference;
}

PseudoInertia shifted(const PseudoInertia& inertia, const Vector3& t) {
  PseudoInertia result = inertia;
  for (std::size_t k = 0; k < 3; ++k) result = shifted(result, k, t[k]);
  return result;
}

PseudoInertia shifted(const PseudoInertia& inertia, std::size_t k, const Scalar& t) {
  if (t.is_zero()) return inertia;
  PseudoInertia result = inertia;
  const Scalar moved = inertia.at(k, 3) + inertia.mass() * t;
  result.at(k, k) = inertia.at(k, k) + t * (inertia.at(k, 3) + moved);
  for (std::size_t i = 0; i < 3; ++i)
    if (i != k) result.at(i, k) = inertia.at(i, k) + t * inertia.at(i, 3);
  result.at(k, 3) = moved;
  return result;
}

PseudoInertia rotated(const PseudoInertia& inertia, std::size_t k, const Circle& by) {
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  const auto& [c, s] = by;
  PseudoInertia result = inertia;
  const Scalar& ii = inertia.at(i, i);
  const Scalar& jj = inertia.at(j, j);
  const Scalar& ij = inertia.at(i, j);
  if (c.is_zero()) {
    result.at(i, i) = jj;
    result.at(j, j) = ii;
    result.at(i, j) = -ij;
  } else {
    const Scalar t = s * (ii - jj) + c * (ij + ij);
    result.at(i, i) = ii - s * t;
    result.at(j, j) = jj + s * t;
    result.at(i, j) = c * t - ij;
  }
  for (const std::size_t q : {k, std::size_t{3}}) {
    result.at(i, q) = c * inertia.at(i, q) - s * inertia.at(j, q);
    result.at(j, q) = s * inertia.at(i, q) + c * inertia.at(j, q);
  }
  return result;
}

std::string standard_parameter(std::size_t index) { return "@" + std::to_string(index); }

PseudoInertia from_standard(std::size_t body, dag::Graph& graph) {
  constexpr std::array<std::array<std::size_t, 2>, 6> places = {
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
  const auto symbol = [&](std::size_t k) {
    return Scalar(graph, graph.symbol(standard_parameter(10 * body + k)));
  };
  const Scalar half(graph, graph.constant(exact::Number(cln::cl_RA(1) / 2)));
  const Scalar half_trace = half * (symbol(4) + symbol(5) + symbol(6));
  PseudoInertia result;
  for (std::size_t i = 0; i < 6; ++i)
    result.at(places[i][0], places[i][1]) = (i < 3 ? half_trace : Scalar()) - symbol(4 + i);
  for (std::size_t i = 0; i < 3; ++i) result.at(i, 3) = symbol(1 + i);
  result.at(3, 3) = symbol(0);
  return result;
}

PseudoInertia from_description(const model::Inertia& inertia, dag::Graph& graph) {
  constexpr std::array<std::array<std::size_t, 2>, 6> places = {
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
  std::array<Scalar, 6> about_centre;
  for (std::size_t i = 0; i < 6; ++i) about_centre[i] = to_scalar(inertia.inertia[i], graph);
  const Scalar half(graph, graph.constant(exact::Number(cln::cl_RA(1) / 2)));
  const Scalar half_trace = half * (about_centre[0] + about_centre[1] + about_centre[2]);
  PseudoInertia result;
  for (std::size_t i = 0; i < 6; ++i)
    result.at(places[i][0], places[i][1]) = (i < 3 ? half_trace : Scalar()) - about_centre[i];
  result.at(3, 3) = to_scalar(inertia.mass, graph);
  Vector3 centre;
  for (std::size_t i = 0; i < 3; ++i) centre[i] = to_scalar(inertia.centre_of_mass[i], graph);
  return shifted(result, centre);
}

}  // namespace qvgen::derive::dynamics
