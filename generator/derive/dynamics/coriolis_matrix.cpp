// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "derive/dynamics/flow.h"
#include "derive/dynamics/followers.h"
#include "model/coordinates.h"

namespace qvgen::derive::dynamics {
namespace {

/// The matrix of Christoffel's symbols. A body's pose as a 4x4 matrix X lies in a flat space whose metric is
/// the body's constant pseudo-inertia, M_ij = sum tr(d_i X P d_j X^T), so that
/// C_ij = sum tr(d_i X P (d/dt d_j X)^T): with S_j the joint's screw and V_j the link's velocity as 4x4
/// matrices in the frame of link j, C_ij = tr(S_i G_j) for i <= j, G_j = P_j (V_j S_j)^T + E_j S_j^T.
/// Below the diagonal C_ji = M'_ij - C_ij.
class ChristoffelSymbols {
 public:
  ChristoffelSymbols(const model::Robot& robot, const FormulationOptions& choices, Formulation& out)
      : robot_(robot),
        graph_(out.function.graph),
        suggest_(out.function),
        p_(parametrise(robot, choices.convention, graph_)),
        inward_(p_, graph_, suggest_) {
    out.constants = p_.constants;
  }

  void run(dag::Function& out) {
    find_rotation_rates();
    std::vector<Behind> all(p_.chain.links.size());
    for (std::size_t j = p_.chain.links.size(); j-- > 0;) {
      const Link& link = p_.chain.links[j];
      auto& [bodies, flow, open] = all[j];
      const PseudoInertia composite = link.inertia + bodies;
      const std::vector<Way> ways = ways_of(link);
      for (const Way& way : ways) open.push_back(opened(j, way, composite, flow));
      for (Open& other : open) {
        for (const Way& way : ways) record(way, other, ways);
        if (link.parent == no_link) continue;
        transform_to_parent(j, other);
        all[link.parent].open.push_back(other);
      }
      if (link.parent == no_link) continue;
      if (link.motion != Motion::none) flow = with_own_motion(flow, link, composite, rate_of(link));
      Behind& before = all[link.parent];
      before.flow = sum(before.flow, carried(inward_, link, flow, graph_));
      before.bodies = before.bodies + inward_.transform_to_parent(j, composite);
    }
    const std::size_t size = model::base_motions(robot_) + robot_.joints.size();
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t k = 0; k < size; ++k) entries_.try_emplace({i, k});
    for (const auto& [place, value] : gathered(robot_, entries_, graph_))
      out.outputs.push_back(
          {"c" + std::to_string(place.first + 1) + "_" + std::to_string(place.second + 1), value.in(graph_)});
  }

 private:
  /// Open column of one joint: its column of M, the column's rate in the frame that it has come to, and its
  /// column of C.
  struct Open {
    Column mass, rate, coriolis;
  };

  /// Sum over the links that a link carries, in its frame.
  struct Behind {
    PseudoInertia bodies;
    Flow flow;
    std::vector<Open> open;
  };

  Scalar rate_of(const Link& link) const {
    const Scalar rate = inward_.symbol(velocity_of(link.variable));
    return link.motion == Motion::prismatic ? p_.per_unit * rate : rate;
  }

  Scalar base_rate(const Way& way) const {
    return inward_.symbol(velocity_of(model::base_coordinate(way.coordinate)));
  }

  void find_rotation_rates() {
    std::vector<Vector3> arriving;
    for (const Link& link : p_.chain.links) {
      const Circle angle = circle(link.angle, graph_), alpha = circle(link.alpha, graph_);
      const bool has_parent = link.parent != no_link;
      if (link.alpha.terms.empty() && link.alpha.pi == 0 && has_parent)
        offer_sum(link.parent, angle, arriving[link.parent]);
      arriving.push_back(unrotate(0, alpha, has_parent ? rotation_rates_[link.parent] : Vector3{}));
      Vector3 w = unrotate(2, angle, arriving.back());
      if (link.motion == Motion::revolute) w[2] = w[2] + rate_of(link);
      for (const Way& way : ways_of(link))
        if (link.motion == Motion::free && !way.slides) w[way.axis] = base_rate(way);
      rotation_rates_.push_back(w);
    }
  }

  /// Two parallel axes in a row: what arrives at the first turned by the sum of both angles.
  void offer_sum(std::size_t before, const Circle& second, const Vector3& arriving) {
    const Circle first = circle(p_.chain.links[before].angle, graph_);
    const Circle both{first.cosine * second.cosine - first.sine * second.sine,
                      first.sine * second.cosine + first.cosine * second.sine};
    suggest_(unrotate(2, both, arriving));
  }

  Open opened(std::size_t j, const Way& way, const PseudoInertia& composite, const Flow& flow) const {
    const Wrench w = coriolis_wrench(way, composite, flow, rotation_rates_[j]);
    const Column coriolis{way.coordinate, way.slides, w.force, w.moment, {}};
    return {column_of(way, composite), column_of(way, rate_of_inertia(flow)), coriolis};
  }

  /// `own`: the ways of the link, among which each pair comes in both orders.
  void record(const Way& way, const Open& outer, const std::vector<Way>& own) {
    const std::size_t i = way.coordinate, j = outer.mass.coordinate;
    const Scalar above = entry(p_, way, outer.coriolis);
    entries_[{i, j}] = above;
    const bool is_own = std::any_of(own.begin(), own.end(), [j](const Way& w) { return w.coordinate == j; });
    if (!is_own) entries_[{j, i}] = entry(p_, way, outer.rate) - above;
  }

  /// The rate of what the joint turns or slides: rate (e_z x column), or rate e_z x force for the moment.
  void transform_to_parent(std::size_t j, Open& outer) {
    const Link& link = p_.chain.links[j];
    if (link.motion != Motion::none) {
      const Scalar rate = rate_of(link);
      const auto turned = [&](const Vector3& v) { return Vector3{-(rate * v[1]), rate * v[0], Scalar()}; };
      const bool slides = link.motion == Motion::prismatic;
      outer.rate.moment = outer.rate.moment + turned(slides ? outer.mass.force : outer.mass.moment);
      if (!slides) outer.rate.force = outer.rate.force + turned(outer.mass.force);
    }
    for (Column* column : {&outer.mass, &outer.rate, &outer.coriolis})
      inward_.transform_to_parent(j, *column);
  }

  const model::Robot& robot_;
  dag::Graph& graph_;
  Suggestions suggest_;
  Parametrisation p_;
  InwardRecursion inward_;
  std::vector<Vector3> rotation_rates_;
  Entries entries_;
};

}  // namespace

Formulation coriolis_matrix(const model::Robot& robot, const FormulationOptions& choices) {
  Formulation result;
  ChristoffelSymbols(robot, choices, result).run(result.function);
  return in_rates_of_leaders(robot, std::move(result));
}

}  // namespace qvgen::derive::dynamics
