// SPDX-License-Identifier: MIT
#include "derive/dynamics/moving_joints.h"

namespace qvgen::derive::dynamics {
namespace {

MovingJoint joint_of(const Recursion& r, const Link& link) {
  MovingJoint joint{link.motion,
                    circle(link.alpha, r.graph),
                    circle(link.angle, r.graph),
                    link.a,
                    link.b,
                    link.d,
                    {},
                    {},
                    {},
                    link.inertia,
                    link.parent};
  joint.coordinate = link.coordinate;
  if (link.motion == Motion::none || link.motion == Motion::free) return joint;
  const Scalar scale = link.motion == Motion::prismatic ? r.p.per_unit : Scalar(r.graph, r.graph.constant(1));
  if (r.effects != Effects::gravity) joint.rate = r.symbol(velocity_of(link.variable)) * scale;
  if (r.effects == Effects::all || r.effects == Effects::bias)
    joint.drive = link.viscous * r.symbol(velocity_of(link.variable)) +
                  link.coulomb * r.symbol(direction_of(link.variable));
  if (r.effects == Effects::all) {
    joint.acceleration = r.symbol(acceleration_of(link.variable)) * scale;
    joint.drive = joint.drive + link.rotor * r.symbol(acceleration_of(link.variable));
  }
  if (link.motion == Motion::prismatic) joint.d = joint.d + r.symbol(link.variable) * scale;
  return joint;
}

void find_neighbours(std::vector<MovingJoint>& joints) {
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].parent == no_link) continue;
    MovingJoint& parent = joints[joints[j].parent];
    parent.next.push_back(j);
    joints[j].depth = parent.depth + 1;
  }
}

void unrotate_ends(Recursion& r) {
  for (std::size_t j = 0; j < r.joints.size(); ++j) {
    MovingJoint& end = r.joints[j];
    if (!end.next.empty() || end.moving != Motion::revolute) continue;
    end.inertia = rotated(end.inertia, 2, end.angle);
    end.angle = {Scalar(r.graph, r.graph.constant(1)), Scalar()};
    r.p.chain.links[j].inertia = end.inertia;
    r.p.chain.links[j].angle = {};
  }
}

}  // namespace

bool Recursion::is_parallel(std::size_t link) const {
  const MovingJoint& joint = joints[link];
  return joint.parent != no_link && joint.alpha.sine.is_zero() && joint.alpha.cosine.is_one() &&
         joints[joint.parent].moving == Motion::revolute;
}

void add_joints(Recursion& recursion) {
  for (const Link& link : recursion.p.chain.links) recursion.joints.push_back(joint_of(recursion, link));
  find_neighbours(recursion.joints);
  recursion.last_angle = recursion.joints.back().angle;
  if (recursion.choices.last_link_unrotated) unrotate_ends(recursion);
}

Circle sum_of(const Circle& a, const Circle& b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

}  // namespace qvgen::derive::dynamics
