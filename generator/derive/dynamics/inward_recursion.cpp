// SPDX-License-Identifier: MIT
#include "derive/dynamics/inward_recursion.h"

#include <tuple>

namespace qvgen::derive::dynamics {
namespace {

/// The moment about a point d further in along z.
Vector3 about(const Vector3& moment, const Vector3& force, const Scalar& d) {
  return {moment[0] - d * force[1], moment[1] + d * force[0], moment[2]};
}

}  // namespace

Scalar entry(const Parametrisation& p, const Way& way, const Column& column) {
  const Scalar value = way.slides ? p.per_unit * column.force[way.axis] : column.moment[way.axis];
  return column.slides ? p.per_unit * value : value;
}

/// Acceleration of a turning body about its origin: f = e x h; of a sliding one: f = m e, e the axis.
Column column_of(const Way& way, const PseudoInertia& p) {
  const std::size_t k = way.axis, i = (k + 1) % 3, j = (k + 2) % 3;
  const Vector3 h = p.first_moments();
  Column column{way.coordinate, way.slides, {}, {}, {}};
  Vector3& across = way.slides ? column.moment : column.force;
  across[i] = way.slides ? h[j] : -h[j];
  across[j] = way.slides ? -h[i] : h[i];
  if (way.slides)
    column.force[k] = p.mass();
  else
    std::tie(column.moment[i], column.moment[j], column.moment[k]) =
        std::make_tuple(-p.at(i, k), -p.at(j, k), p.at(i, i) + p.at(j, j));
  return column;
}

Scalar InwardRecursion::shift_of(const Link& link) const {
  return link.motion == Motion::prismatic ? link.d + p_.per_unit * symbol(link.variable) : link.d;
}

void InwardRecursion::transform_to_parent(std::size_t j, Column& column) {
  const Link& link = p_.chain.links[j];
  const Circle angle = circle(link.angle, graph_), alpha = circle(link.alpha, graph_);
  const Scalar d = shift_of(link);
  const Vector3 at_axis = about(column.moment, column.force, d);
  const Vector3 force = rotate(2, angle, column.force);
  const Vector3 moment = rotate(2, angle, at_axis);
  suggest_(about(rotate(2, angle, column.moment), force, d));
  if (column.outer_moment && is_parallel(column.outer_link)) offer_parallel(j, column, angle);
  column.outer_moment = at_axis;
  column.outer_force = column.force;
  column.outer_link = j;
  column.force = rotate(0, alpha, force);
  column.moment = rotate(0, alpha, moment) + cross(Vector3{link.a, link.b, Scalar()}, column.force);
}

bool InwardRecursion::is_parallel(std::size_t j) const {
  const Link& link = p_.chain.links[j];
  return link.alpha.terms.empty() && link.alpha.pi == 0 && link.b.is_zero() &&
         link.motion == Motion::revolute && p_.chain.links[link.parent].motion == Motion::revolute;
}

/// Offers what lies behind two parallel axes, turned by the sum of both angles.
void InwardRecursion::offer_parallel(std::size_t j, const Column& column, const Circle& first) {
  const Link& link = p_.chain.links[j];
  const Link& next = p_.chain.links[column.outer_link];
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

PseudoInertia InwardRecursion::transform_to_parent(std::size_t j, const PseudoInertia& inertia) {
  const Link& link = p_.chain.links[j];
  const Circle angle = circle(link.angle, graph_);
  const Scalar d = shift_of(link);
  offer(shifted(turned_about_z(inertia, angle), 2, d));
  const PseudoInertia turned = turned_about_z(shifted(inertia, 2, d), angle);
  return shifted(rotated(turned, 0, circle(link.alpha, graph_)), {link.a, link.b, Scalar()});
}

PseudoInertia InwardRecursion::turned_about_z(const PseudoInertia& inertia, const Circle& by) {
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

void InwardRecursion::offer(const PseudoInertia& inertia) {
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = row; column < 4; ++column) suggest_({inertia.at(row, column)});
}

}  // namespace qvgen::derive::dynamics
