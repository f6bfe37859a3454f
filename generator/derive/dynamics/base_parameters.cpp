// SPDX-License-Identifier: MIT
#include "derive/dynamics/base_parameters.h"

#include "derive/dynamics/common_axis.h"

namespace qvgen::derive::dynamics {
namespace {

/// Returns the first moments of a sliding link on which no joint force depends, or depends as if they were
/// fixed to the link before. With all rotations about one axis, these are the moments along it, and all of
/// them if the slide is parallel to it.
Vector3 movable_moments(const Link& link, const Rotations& rotations, dag::Graph& graph) {
  const Vector3 h = link.inertia.first_moments();
  if (rotations.kind == Rotations::Kind::none) return h;
  if (rotations.kind == Rotations::Kind::any) return {};
  const Vector3& axis = rotations.axis;
  if (axis[0].is_zero() && axis[1].is_zero()) return h;
  for (std::size_t k = 0; k < 3; ++k)
    if (!axis[k].is_zero() && graph.is_constant(axis[k].in(graph))) return (h[k] / axis[k]) * axis;
  return {};
}

/// The part of the link's inertia that may as well belong to the link before.
PseudoInertia movable(const Link& link, const Rotations& rotations, dag::Graph& graph) {
  PseudoInertia part;
  if (link.motion == Motion::free) return part;
  if (link.motion == Motion::none) return link.inertia;
  if (link.motion == Motion::revolute) {
    part.at(2, 2) = link.inertia.at(2, 2);
    part.at(2, 3) = link.inertia.at(2, 3);
    part.at(3, 3) = link.inertia.at(3, 3);
    return part;
  }
  const Vector3 moments = movable_moments(link, rotations, graph);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = row; column < 3; ++column) part.at(row, column) = link.inertia.at(row, column);
    part.at(row, 3) = moments[row];
  }
  return part;
}

/// Seen from the link before, at joint position zero (of a movable part it does not matter which).
PseudoInertia seen_from_before(const Link& link, PseudoInertia inertia, dag::Graph& graph) {
  inertia = shifted(inertia, 2, link.d);
  if (link.motion != Motion::revolute) inertia = rotated(inertia, 2, circle(link.angle, graph));
  inertia = rotated(inertia, 0, circle(link.alpha, graph));
  return shifted(inertia, {link.a, link.b, Scalar()});
}

void give_inward(Chain& chain, const Rotations& rotations, dag::Graph& graph, std::size_t j) {
  Link& link = chain.links[j];
  const PseudoInertia part = movable(link, rotations, graph);
  link.inertia = link.inertia - part;
  if (link.parent == no_link) return;
  PseudoInertia& before = chain.links[link.parent].inertia;
  before = before + seen_from_before(link, part, graph);
}

}  // namespace

void regroup(Chain& chain, dag::Graph& graph) {
  const auto rotations = rotations_of(chain, graph);
  for (std::size_t j = chain.links.size(); j-- > 0;) give_inward(chain, rotations[j], graph, j);
}

void shift_mass(Chain& chain, dag::Graph& graph, std::size_t j, std::size_t k) {
  PseudoInertia unit;
  unit.at(3, 3) = Scalar(graph, graph.constant(1));
  const Link& link = chain.links[j];
  const PseudoInertia before = seen_from_before(link, unit, graph);
  PseudoInertia& carrying = chain.links[link.parent].inertia;
  const Scalar mass = carrying.at(k, 3) / before.at(k, 3);
  PseudoInertia point;
  point.at(3, 3) = mass;
  carrying = carrying - seen_from_before(link, point, graph);
  chain.links[j].inertia = chain.links[j].inertia + point;
  const auto rotations = rotations_of(chain, graph);
  for (std::size_t i = j; i-- > 0;) give_inward(chain, rotations[i], graph, i);
}

}  // namespace qvgen::derive::dynamics
