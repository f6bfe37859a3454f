// SPDX-License-Identifier: MIT
#include "derive/dynamics/common_axis.h"

namespace qvgen::derive::dynamics {
namespace {

using Kind = Rotations::Kind;

/// The constant turn from the frame before to the link's, seen from the link.
Vector3 seen_from(const Link& link, const Vector3& v, dag::Graph& graph) {
  const Vector3 twisted = unrotate(0, circle(link.alpha, graph), v);
  return link.motion == Motion::revolute ? twisted : unrotate(2, circle(link.angle, graph), twisted);
}

Rotations behind(const Rotations& before, const Link& link, dag::Graph& graph) {
  if (link.motion == Motion::free) return {Kind::any, {}};
  Rotations here = before;
  if (here.kind == Kind::about_one_axis) here.axis = seen_from(link, before.axis, graph);
  if (link.motion != Motion::revolute) return here;
  const bool parallel = here.kind == Kind::none || (here.axis[0].is_zero() && here.axis[1].is_zero());
  if (here.kind == Kind::any || !parallel) return {Kind::any, {}};
  return {Kind::about_one_axis, {Scalar(), Scalar(), Scalar(graph, graph.constant(1))}};
}

}  // namespace

std::vector<Rotations> rotations_of(const Chain& chain, dag::Graph& graph) {
  std::vector<Rotations> result;
  for (const Link& link : chain.links) {
    const Rotations before = link.parent == no_link ? Rotations{} : result[link.parent];
    result.push_back(behind(before, link, graph));
  }
  return result;
}

}  // namespace qvgen::derive::dynamics
