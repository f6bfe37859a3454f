// SPDX-License-Identifier: MIT
#include "derive/dynamics/link_motions.h"

#include "model/coordinates.h"

namespace qvgen::derive::dynamics {
namespace {

class Outward {
 public:
  explicit Outward(const Recursion& recursion) : r_(recursion) {}

  LinkMotions run() && {
    State base;
    if (r_.effects != Effects::velocity) base.v = r_.p.gravity;
    for (std::size_t j = 0; j < r_.joints.size(); ++j) {
      const std::size_t parent = r_.joints[j].parent;
      motions_.states.push_back(moved(j, parent == no_link ? base : motions_.states[parent]));
    }
    return std::move(motions_);
  }

 private:
  /// Motion as the frame before the joint's rotation sees it; kept for parallel neighbours.
  struct Arriving {
    Vector3 w, v, column;
  };

  /// U z of the joint axis, in the frame before the joint's rotation.
  Vector3 axis_column(const MovingJoint& joint, const Matrix3& u) {
    Vector3 column;
    for (std::size_t r = 0; r < 3; ++r)
      column[r] = -joint.alpha.sine * u[r][1] + joint.alpha.cosine * u[r][2];
    return unrotate(0, joint.alpha, column);
  }

  State moved(std::size_t j, const State& before) {
    if (r_.joints[j].moving == Motion::free) return float_freely();
    return r_.joints[j].moving == Motion::revolute ? turn(j, before) : slide(j, before);
  }

  /// Three components of the floating base's velocity or acceleration, the first of them given.
  Vector3 of_base(std::string (*symbol_of)(const std::string&), std::size_t first) {
    const auto component = [&](std::size_t k) {
      return r_.symbol(symbol_of(model::base_coordinate(first + k)));
    };
    return {component(0), component(1), component(2)};
  }

  /// The base's motion is what the caller says. The derivatives of its velocity are those of the components
  /// in its own frame, which turns.
  State float_freely() {
    const bool moves = r_.effects != Effects::gravity, speeds_up = r_.effects == Effects::all;
    const Vector3 linear = moves ? of_base(velocity_of, 0) : Vector3{};
    const Vector3 rate = speeds_up ? of_base(acceleration_of, 3) : Vector3{};
    State state;
    state.w = moves ? of_base(velocity_of, 3) : Vector3{};
    state.v = cross(state.w, linear);
    if (speeds_up) state.v = state.v + of_base(acceleration_of, 0);
    if (r_.effects != Effects::velocity) state.v = state.v + r_.p.gravity;
    state.u = u_matrix(state.w, rate[1] + state.w[0] * state.w[2], state.w[1] * state.w[2] - rate[0], rate[2],
                       r_.suggest);
    return state;
  }

  Vector3 offset_acceleration(const MovingJoint& joint, const Matrix3& u) {
    return joint.a * column(u, 0) + joint.b * column(u, 1);
  }

  State turn(std::size_t j, const State& before) {
    const MovingJoint& joint = r_.joints[j];
    Arriving in{unrotate(0, joint.alpha, before.w),
                unrotate(0, joint.alpha, before.v + offset_acceleration(joint, before.u)),
                axis_column(joint, before.u)};
    const Vector3 rate_in = angular_acceleration(joint, before);
    State state;
    state.w = unrotate(2, joint.angle, in.w);
    const Vector3 column = unrotate(2, joint.angle, in.column);
    state.w[2] = state.w[2] + joint.rate;
    const Scalar wz_rate = rate_in[2] + joint.acceleration;
    state.u = u_matrix(state.w, column[0], column[1], wz_rate, r_.suggest);
    state.v = unrotate(2, joint.angle, in.v) + joint.d * Vector3{column[0], column[1], state.u[2][2]};
    r_.suggest(unrotate(2, joint.angle, in.v + joint.d * in.column));
    offer_twisted(in, before);
    if (r_.choices.unrotated.contains(joint.depth)) offer_unrotated(j, in, wz_rate);
    if (r_.is_parallel(j)) offer_parallel(j, before.u);
    arriving_[j] = in;
    return state;
  }

  /// A turn about x leaves w'_x alone: U23 = w_y w_z - w'_x before it and behind it.
  void offer_twisted(const Arriving& in, const State& before) {
    r_.suggest({before.u[1][2] + (in.w[1] * in.w[2] - before.w[1] * before.w[2])});
  }

  /// w' of the link before, as that link's U has it, in the frame before the joint's rotation.
  Vector3 angular_acceleration(const MovingJoint& joint, const State& before) {
    const auto& u = before.u;
    const auto half_difference = [&](std::size_t i, std::size_t k) {
      return u[i][k] - before.w[i] * before.w[k];
    };
    const Vector3 rate = {half_difference(2, 1), half_difference(0, 2), half_difference(1, 0)};
    return unrotate(0, joint.alpha, rate);
  }

  State slide(std::size_t j, const State& before) {
    const MovingJoint& joint = r_.joints[j];
    const auto turned = [&](const Vector3& v) {
      return unrotate(2, joint.angle, unrotate(0, joint.alpha, v));
    };
    Matrix3 columns;
    for (std::size_t k = 0; k < 3; ++k) columns[k] = turned(column(before.u, k));
    State state;
    for (std::size_t r = 0; r < 3; ++r) state.u[r] = turned(column(columns, r));
    state.w = turned(before.w);
    const Scalar twice = joint.rate + joint.rate;
    state.v = turned(before.v + offset_acceleration(joint, before.u)) + joint.d * column(state.u, 2);
    state.v = state.v + Vector3{twice * state.w[1], -(twice * state.w[0]), joint.acceleration};
    return state;
  }

  /// Two parallel axes in a row: what arrives at the first turned by the sum of both angles.
  void offer_parallel(std::size_t j, const Matrix3& u_before) {
    const MovingJoint& joint = r_.joints[j];
    const MovingJoint& first = r_.joints[joint.parent];
    const Arriving& in = arriving_.at(joint.parent);
    const Circle both = sum_of(first.angle, joint.angle);
    r_.suggest(unrotate(2, both, in.w));
    const Vector3 column = unrotate(2, both, in.column);
    r_.suggest(column);
    // d of the first link moves along the common axis, so that it may be added before or after.
    const Vector3 direct =
        unrotate(2, both, in.v) + (first.d + joint.d) * Vector3{column[0], column[1], in.column[2]};
    const Vector3 offset = unrotate(2, joint.angle, offset_acceleration(joint, u_before));
    r_.suggest(direct + offset);
    r_.suggest(unrotate(2, both, in.v + (first.d + joint.d) * in.column) + offset);
  }

  /// The wrench of link j in the frame before its joint's rotation: its parameters are rotated, not the
  /// vectors.
  void offer_unrotated(std::size_t j, const Arriving& in, const Scalar& wz_rate) {
    const MovingJoint& joint = r_.joints[j];
    Vector3 w = in.w;
    w[2] = w[2] + joint.rate;
    const Matrix3 u = u_matrix(w, in.column[0], in.column[1], wz_rate, r_.suggest);
    const Vector3 v = in.v + joint.d * in.column;
    motions_.unrotated[j] = link_wrench(rotated(joint.inertia, 2, joint.angle), u, v, r_.suggest);
  }

  const Recursion& r_;
  LinkMotions motions_;
  std::map<std::size_t, Arriving> arriving_;
};

}  // namespace

LinkMotions link_motions(const Recursion& recursion) { return Outward(recursion).run(); }

}  // namespace qvgen::derive::dynamics
