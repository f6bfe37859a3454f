// SPDX-License-Identifier: MIT
#include <map>

#include "derive/dynamics/formulation.h"
#include "derive/dynamics/suggestions.h"

namespace qvgen::derive::dynamics {
namespace {

/// Force and moment on the composite body for unit acceleration of one joint, carried inward.
struct Column {
  std::size_t joint;
  bool slides;
  Vector3 force, moment;
  std::optional<Vector3> outer_moment, outer_force;  ///< before the joint behind, for parallel neighbours
};

class CompositeBodies {
 public:
  CompositeBodies(const model::Robot& robot, const Choices& choices, Formulation& out)
      : graph_(out.function.graph), suggest_(out.function), p_(parametrise(robot, choices.gauge, graph_)) {
    out.constants = p_.constants;
  }

  void run(dag::Function& out) {
    PseudoInertia composite;
    for (std::size_t j = p_.chain.links.size(); j-- > 0;) {
      const Link& link = p_.chain.links[j];
      composite = link.inertia + composite;
      if (link.motion != Motion::none) open_column(link, composite);
      for (Column& column : columns_) {
        if (link.motion != Motion::none) entries_[{link.joint, column.joint}] = entry(link, column);
        if (j > 0) carry(j, column);
      }
      if (j > 0) composite = seen_from_before(link, composite);
    }
    for (const auto& [place, value] : entries_)
      out.outputs.push_back(
          {"m" + std::to_string(place.first + 1) + "_" + std::to_string(place.second + 1), value.in(graph_)});
  }

 private:
  /// Acceleration of a turning body about its origin: f = e_z x h; of a sliding one: f = m e_z.
  void open_column(const Link& link, const PseudoInertia& p) {
    const Vector3 h = p.first_moments();
    if (link.motion == Motion::revolute)
      columns_.push_back({link.joint,
                          false,
                          {-h[1], h[0], Scalar()},
                          {-p.at(0, 2), -p.at(1, 2), p.at(0, 0) + p.at(1, 1)},
                          {},
                          {}});
    else
      columns_.push_back({link.joint, true, {Scalar(), Scalar(), p.mass()}, {h[1], -h[0], Scalar()}, {}, {}});
  }

  /// In units of length, forces come out too large by one: once for each sliding joint of the pair.
  Scalar entry(const Link& link, const Column& column) {
    const bool slides = link.motion == Motion::prismatic;
    Scalar value = slides ? p_.per_unit * column.force[2] : column.moment[2];
    if (column.slides) value = p_.per_unit * value;
    return link.joint == column.joint ? value + link.rotor : value;
  }

  Scalar shift_of(const Link& link) {
    if (link.motion != Motion::prismatic) return link.d;
    return link.d + p_.per_unit * Scalar(graph_, graph_.symbol(link.variable));
  }

  static Vector3 about(const Vector3& moment, const Vector3& force, const Scalar& d) {
    return {moment[0] - d * force[1], moment[1] + d * force[0], moment[2]};
  }

  void carry(std::size_t j, Column& column) {
    const Link& link = p_.chain.links[j];
    const Circle angle = circle(link.angle, graph_), alpha = circle(link.alpha, graph_);
    const Scalar d = shift_of(link);
    const Vector3 at_axis = about(column.moment, column.force, d);
    const Vector3 force = rotate(2, angle, column.force);
    const Vector3 moment = rotate(2, angle, at_axis);
    suggest_(about(rotate(2, angle, column.moment), force, d));
    if (is_parallel(j + 1) && column.outer_moment) offer_parallel(j, column, angle);
    column.outer_moment = at_axis;
    column.outer_force = column.force;
    column.force = rotate(0, alpha, force);
    column.moment = rotate(0, alpha, moment) + cross(Vector3{link.a, link.b, Scalar()}, column.force);
  }

  bool is_parallel(std::size_t j) const {
    if (j >= p_.chain.links.size()) return false;
    const Link& link = p_.chain.links[j];
    return link.alpha.terms.empty() && link.alpha.pi == 0 && link.b.is_zero() &&
           link.motion == Motion::revolute && p_.chain.links[j - 1].motion == Motion::revolute;
  }

  /// What lies behind two parallel axes turned by the sum of both angles.
  void offer_parallel(std::size_t j, const Column& column, const Circle& first) {
    const Link& link = p_.chain.links[j];
    const Link& next = p_.chain.links[j + 1];
    const Circle second = circle(next.angle, graph_);
    const Circle both{first.cosine * second.cosine - first.sine * second.sine,
                      first.sine * second.cosine + first.cosine * second.sine};
    const Vector3 direct = rotate(2, both, *column.outer_moment);
    const Vector3 force = rotate(2, both, *column.outer_force);
    suggest_(force);
    const Scalar z = (*column.outer_force)[2];
    const Scalar lever_x = next.a * first.sine * z, lever_y = -(next.a * first.cosine * z);
    const Vector3 turned = rotate(2, first, {Scalar(), -(next.a * z), Scalar()});
    for (const Vector3& lever :
         {Vector3{lever_x, lever_y, Scalar()}, Vector3{turned[0], turned[1], Scalar()}}) {
      const Vector3 moment = Vector3{direct[0], direct[1], Scalar()} + lever;
      suggest_(moment);
      suggest_(about(moment, force, shift_of(link)));
    }
  }

  PseudoInertia seen_from_before(const Link& link, const PseudoInertia& inertia) {
    const Circle angle = circle(link.angle, graph_);
    const Scalar d = shift_of(link);
    offer(shifted(turned_about_z(inertia, angle), 2, d));
    const PseudoInertia turned = turned_about_z(shifted(inertia, 2, d), angle);
    return shifted(rotated(turned, 0, circle(link.alpha, graph_)), {link.a, link.b, Scalar()});
  }

  PseudoInertia turned_about_z(const PseudoInertia& inertia, const Circle& by) {
    const auto& [c, s] = by;
    if (!c.is_zero() && !s.is_zero()) {
      const Scalar difference = inertia.at(0, 0) - inertia.at(1, 1),
                   twice = inertia.at(0, 1) + inertia.at(0, 1);
      const Scalar ss = s * s, sc = s * c, c2 = Scalar(graph_, graph_.constant(1)) - (ss + ss);
      const Scalar u = ss * difference + sc * twice;
      suggest_({inertia.at(0, 0) - u, inertia.at(1, 1) + u, sc * difference + c2 * inertia.at(0, 1)});
    }
    return rotated(inertia, 2, by);
  }

  void offer(const PseudoInertia& inertia) {
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = row; column < 4; ++column) suggest_({inertia.at(row, column)});
  }

  dag::Graph& graph_;
  Suggestions suggest_;
  Parametrisation p_;
  std::vector<Column> columns_;
  std::map<std::pair<std::size_t, std::size_t>, Scalar> entries_;
};

}  // namespace

Formulation mass_matrix(const model::Robot& robot, const Choices& choices) {
  Formulation result;
  CompositeBodies(robot, choices, result).run(result.function);
  return result;
}

}  // namespace qvgen::derive::dynamics
