// SPDX-License-Identifier: MIT
#include <map>

#include "derive/dynamics/followers.h"
#include "derive/dynamics/suggestions.h"

namespace qvgen::derive::dynamics {
namespace {

/// Motion of a link, in its own frame; v is the acceleration of its origin, gravity included.
struct State {
  Vector3 w, v;
  Matrix3 u;
};

struct Wrench {
  Vector3 force, moment;
};

Wrench operator+(const Wrench& a, const Wrench& b) { return {a.force + b.force, a.moment + b.moment}; }

/// U from the rotation rate, its axis column (U13, U23) and the rate of change of w_z. What of it is not w'
/// shows how w' is got back: w'_y = U13 - w_x w_z, w'_x = w_y w_z - U23.
Matrix3 u_matrix(const Vector3& w, const Scalar& u13, const Scalar& u23, const Scalar& wz_rate,
                 Suggestions& suggest) {
  const Scalar xx = w[0] * w[0], yy = w[1] * w[1], zz = w[2] * w[2];
  const Scalar xy = w[0] * w[1], xz = w[0] * w[2], yz = w[1] * w[2];
  Matrix3 u;
  u[0] = {-(yy + zz), xy - wz_rate, u13};
  u[1] = {xy + wz_rate, -(xx + zz), u23};
  const Scalar wy_rate = u13 - xz, wx_rate = yz - u23;
  u[2] = {xz - wy_rate, yz + wx_rate, -(xx + yy)};
  // The diagonal follows from U33 as well, which a joint's rotation about z leaves alone; and doubles of
  // products.
  suggest({-u[2][2] - xx, -u[2][2] - yy, u[2][2] + (xx - zz), u[2][2] + (yy - zz)});
  suggest({(xz + xz) - u13, (yz + yz) - u23});
  return u;
}

Wrench link_wrench(const PseudoInertia& p, const Matrix3& u, const Vector3& v, Suggestions& suggest) {
  const Vector3 h = p.first_moments();
  Wrench result;
  for (std::size_t r = 0; r < 3; ++r)
    result.force[r] = (u[r][0] * h[0] + u[r][1] * h[1]) + u[r][2] * h[2] + p.mass() * v[r];
  const auto s = [&](std::size_t i, std::size_t k) { return p.at(i, k); };
  const Scalar n1 = u[2][0] * s(0, 1) + u[2][1] * s(1, 1);
  const Scalar n2 = u[2][0] * s(0, 0) + u[2][1] * s(0, 1);
  const Scalar x = n1 + (u[2][2] - u[1][1]) * s(1, 2) - u[1][0] * s(0, 2) - u[1][2] * s(2, 2);
  const Scalar y = (u[0][0] - u[2][2]) * s(0, 2) + u[0][1] * s(1, 2) - n2 + u[0][2] * s(2, 2);
  const Scalar z = ((u[1][1] - u[0][0]) * s(0, 1) + (u[1][0] * s(0, 0) - u[0][1] * s(1, 1))) +
                   (u[1][2] * s(0, 2) - u[0][2] * s(1, 2));
  result.moment = Vector3{x, y, z} + cross(h, v);
  suggest(result.force);
  return result;
}

class Recursion {
 public:
  Recursion(const model::Robot& robot, const FormulationOptions& choices, Effects effects, Formulation& out)
      : robot_(robot),
        graph_(out.function.graph),
        suggest_(out.function),
        choices_(choices),
        effects_(effects),
        p_(parametrise(robot, choices.convention, graph_)) {
    out.constants = p_.constants;
  }

  void run(dag::Function& out) {
    for (const Link& link : p_.chain.links) joints_.push_back(joint_of(link));
    find_neighbours();
    const Circle last = joints_.back().angle;
    if (choices_.last_link_unrotated) unrotate_last_links();
    State base;
    if (effects_ != Effects::velocity) base.v = p_.gravity;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const State& before = joints_[j].parent == no_link ? base : states_[joints_[j].parent];
      states_.push_back(joints_[j].moving == Motion::revolute ? turn(j, before) : slide(j, before));
    }
    behind_.resize(joints_.size());
    if (choices_.wrench) behind_.back() = wrench_to_balance(last);
    backward(out);
  }

 private:
  /// A link with its joint's values.
  struct Joint {
    Motion moving;
    Circle alpha, angle;
    Scalar a, b, d;  ///< d with the joint variable of a prismatic joint
    Scalar rate, acceleration;
    Scalar drive;  ///< force that the drive itself takes
    PseudoInertia inertia;
    std::size_t index;
    std::size_t parent;
    std::size_t depth = 0;               ///< links between this one and the base
    std::vector<std::size_t> next = {};  ///< links that this one carries
  };
  /// Motion as the frame before the joint's rotation sees it; kept for parallel neighbours.
  struct Arriving {
    Vector3 w, v, column;
  };

  Scalar symbol(const std::string& name) { return {graph_, graph_.symbol(name)}; }

  Joint joint_of(const Link& link) {
    Joint joint{link.motion,
                circle(link.alpha, graph_),
                circle(link.angle, graph_),
                link.a,
                link.b,
                link.d,
                {},
                {},
                {},
                link.inertia,
                link.joint,
                link.parent};
    if (link.motion == Motion::none) return joint;
    const Scalar scale = link.motion == Motion::prismatic ? p_.per_unit : Scalar(graph_, graph_.constant(1));
    if (effects_ != Effects::gravity) joint.rate = symbol(velocity_of(link.variable)) * scale;
    if (effects_ == Effects::all || effects_ == Effects::bias)
      joint.drive = link.viscous * symbol(velocity_of(link.variable)) +
                    link.coulomb * symbol(direction_of(link.variable));
    if (effects_ == Effects::all) {
      joint.acceleration = symbol(acceleration_of(link.variable)) * scale;
      joint.drive = joint.drive + link.rotor * symbol(acceleration_of(link.variable));
    }
    if (link.motion == Motion::prismatic) joint.d = joint.d + symbol(link.variable) * scale;
    return joint;
  }

  /// Force that a motor takes for itself.
  Scalar force(const MotorDrive& motor) {
    Scalar sum;
    if (effects_ == Effects::all || effects_ == Effects::bias)
      sum = motor.viscous * symbol(velocity_of(motor.variable)) +
            motor.coulomb * symbol(direction_of(motor.variable));
    if (effects_ == Effects::all) sum = sum + motor.rotor * symbol(acceleration_of(motor.variable));
    return sum;
  }

  void find_neighbours() {
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (joints_[j].parent == no_link) continue;
      Joint& parent = joints_[joints_[j].parent];
      parent.next.push_back(j);
      joints_[j].depth = parent.depth + 1;
    }
  }

  void unrotate_last_links() {
    for (Joint& last : joints_) {
      if (!last.next.empty() || last.moving != Motion::revolute) continue;
      last.inertia = rotated(last.inertia, 2, last.angle);
      last.angle = {Scalar(graph_, graph_.constant(1)), Scalar()};
    }
  }

  /// U z of the joint axis, in the frame before the joint's rotation.
  Vector3 axis_column(const Joint& joint, const Matrix3& u) {
    Vector3 column;
    for (std::size_t r = 0; r < 3; ++r)
      column[r] = -joint.alpha.sine * u[r][1] + joint.alpha.cosine * u[r][2];
    return unrotate(0, joint.alpha, column);
  }

  Vector3 offset_acceleration(const Joint& joint, const Matrix3& u) {
    return joint.a * column(u, 0) + joint.b * column(u, 1);
  }

  State turn(std::size_t j, const State& before) {
    const Joint& joint = joints_[j];
    Arriving in{unrotate(0, joint.alpha, before.w),
                unrotate(0, joint.alpha, before.v + offset_acceleration(joint, before.u)),
                axis_column(joint, before.u)};
    const Vector3 rate_in = angular_acceleration(joint, before);
    State state;
    state.w = unrotate(2, joint.angle, in.w);
    const Vector3 column = unrotate(2, joint.angle, in.column);
    state.w[2] = state.w[2] + joint.rate;
    const Scalar wz_rate = rate_in[2] + joint.acceleration;
    state.u = u_matrix(state.w, column[0], column[1], wz_rate, suggest_);
    state.v = unrotate(2, joint.angle, in.v) + joint.d * Vector3{column[0], column[1], state.u[2][2]};
    suggest_(unrotate(2, joint.angle, in.v + joint.d * in.column));
    offer_twisted(in, before);
    if (choices_.unrotated.contains(joint.depth)) offer_unrotated(j, in, wz_rate);
    if (is_parallel(j)) offer_parallel(j, before.u);
    arriving_[j] = in;
    return state;
  }

  /// A turn about x leaves w'_x alone: U23 = w_y w_z - w'_x before it and behind it.
  void offer_twisted(const Arriving& in, const State& before) {
    suggest_({before.u[1][2] + (in.w[1] * in.w[2] - before.w[1] * before.w[2])});
  }

  /// w' of the link before, as that link's U has it, in the frame before the joint's rotation.
  Vector3 angular_acceleration(const Joint& joint, const State& before) {
    const auto& u = before.u;
    const auto half_difference = [&](std::size_t i, std::size_t k) {
      return u[i][k] - before.w[i] * before.w[k];
    };
    const Vector3 rate = {half_difference(2, 1), half_difference(0, 2), half_difference(1, 0)};
    return unrotate(0, joint.alpha, rate);
  }

  State slide(std::size_t j, const State& before) {
    const Joint& joint = joints_[j];
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

  bool is_parallel(std::size_t j) const {
    const Joint& joint = joints_[j];
    return joint.parent != no_link && joint.alpha.sine.is_zero() && joint.alpha.cosine.is_one() &&
           joints_[joint.parent].moving == Motion::revolute;
  }

  /// Two parallel axes in a row: what arrives at the first turned by the sum of both angles.
  void offer_parallel(std::size_t j, const Matrix3& u_before) {
    const Joint& joint = joints_[j];
    const Joint& first = joints_[joint.parent];
    const Arriving& in = arriving_.at(joint.parent);
    const Circle both = sum_of(first.angle, joint.angle);
    suggest_(unrotate(2, both, in.w));
    const Vector3 column = unrotate(2, both, in.column);
    suggest_(column);
    // d of the first link moves along the common axis, so that it may be added before or after.
    const Vector3 direct =
        unrotate(2, both, in.v) + (first.d + joint.d) * Vector3{column[0], column[1], axis_entry(in)};
    const Vector3 offset = unrotate(2, joint.angle, offset_acceleration(joint, u_before));
    suggest_(direct + offset);
    suggest_(unrotate(2, both, in.v + (first.d + joint.d) * in.column) + offset);
  }
  static Scalar axis_entry(const Arriving& in) { return in.column[2]; }
  static Circle sum_of(const Circle& a, const Circle& b) {
    return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
  }

  /// The wrench of link j in the frame before its joint's rotation: its parameters are rotated, not the
  /// vectors.
  void offer_unrotated(std::size_t j, const Arriving& in, const Scalar& wz_rate) {
    const Joint& joint = joints_[j];
    Vector3 w = in.w;
    w[2] = w[2] + joint.rate;
    const Matrix3 u = u_matrix(w, in.column[0], in.column[1], wz_rate, suggest_);
    const Vector3 v = in.v + joint.d * in.column;
    unrotated_[j] = link_wrench(rotated(joint.inertia, 2, joint.angle), u, v, suggest_);
  }

  /// Minus the wrench on the tool, about the origin of the last link in that link's frame, which has not
  /// turned by its joint's angle if that is so chosen. Forces are per unit of length.
  Wrench wrench_to_balance(const Circle& last) {
    const auto component = [&](std::size_t k) { return symbol(wrench_component(k)); };
    const Circle yaw = circle(p_.chain.yaw, graph_);
    const Vector3 force = outward(unrotate(2, yaw, {component(0), component(1), component(2)}));
    const Vector3 moment = outward(unrotate(2, yaw, {component(3), component(4), component(5)}));
    const bool turned = choices_.last_link_unrotated && joints_.back().moving == Motion::revolute;
    const Vector3 tool = turned ? rotate(2, last, p_.chain.tool) : p_.chain.tool;
    const Vector3 scaled = p_.unit * force;
    return {-scaled, -(moment + cross(tool, scaled))};
  }

  /// A vector of the frame that link 0 starts from, in the last link's frame.
  Vector3 outward(Vector3 v) {
    Vector3 arriving;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (is_parallel(j)) suggest_(unrotate(2, sum_of(joints_[j - 1].angle, joints_[j].angle), arriving));
      arriving = unrotate(0, joints_[j].alpha, v);
      v = unrotate(2, joints_[j].angle, arriving);
    }
    return v;
  }

  void backward(dag::Function& out) {
    std::vector<Scalar> torques(robot_.joints.size());
    for (std::size_t j = joints_.size(); j-- > 0;) {
      const Joint& joint = joints_[j];
      const Wrench own = link_wrench(joint.inertia, states_[j].u, states_[j].v, suggest_);
      const Wrench total = own + behind_[j];
      if (joint.moving == Motion::revolute) torques[joint.index] = total.moment[2];
      if (joint.moving == Motion::prismatic) torques[joint.index] = p_.per_unit * total.force[2];
      if (joint.moving != Motion::none) torques[joint.index] = torques[joint.index] + joint.drive;
      if (joint.parent == no_link && joint.moving != Motion::none) continue;
      const Wrench inward = carried_inward(j, own, behind_[j]);
      if (joint.parent != no_link) behind_[joint.parent] = behind_[joint.parent] + inward;
    }
    finish(out, torques);
  }

  /// The wrench on link j and all behind it, in the frame of the link before and about its origin.
  Wrench carried_inward(std::size_t j, const Wrench& own, const Wrench& behind) {
    const Joint& joint = joints_[j];
    const Wrench total = own + behind;
    const Wrench at_axis = shifted(total, joint.d);
    const Wrench turned{rotate(2, joint.angle, total.force), rotate(2, joint.angle, at_axis.moment)};
    suggest_(shifted({turned.force, rotate(2, joint.angle, total.moment)}, joint.d).moment);
    if (const auto place = unrotated_.find(j); place != unrotated_.end())
      offer_sum_unrotated(j, place->second, behind);
    if (joint.next.size() == 1 && is_parallel(joint.next.front())) offer_parallel_inward(j, own);
    const Vector3 force = rotate(0, joint.alpha, turned.force);
    Vector3 moment = rotate(0, joint.alpha, turned.moment);
    moment = moment + cross(Vector3{joint.a, joint.b, Scalar()}, force);
    last_shifted_[j] = at_axis;
    return {force, moment};
  }

  /// About a point d further in along z.
  static Wrench shifted(const Wrench& w, const Scalar& d) {
    return {w.force, {w.moment[0] - d * w.force[1], w.moment[1] + d * w.force[0], w.moment[2]}};
  }

  void offer_sum_unrotated(std::size_t j, const Wrench& own, const Wrench& behind) {
    const Joint& joint = joints_[j];
    const Wrench turned{rotate(2, joint.angle, behind.force),
                        rotate(2, joint.angle, shifted(behind, joint.d).moment)};
    suggest_((own + turned).force);
    suggest_(own.moment + turned.moment);
    suggest_({own.moment[2] + behind.moment[2]});
  }

  /// The moment behind joint j + 1 turned by both angles at once, its offset's part by the first alone.
  void offer_parallel_inward(std::size_t j, const Wrench& own) {
    const Joint& joint = joints_[j];
    const Joint& next = joints_[joint.next.front()];
    if (!next.b.is_zero()) return;
    const Circle both = sum_of(joint.angle, next.angle);
    const Wrench& outer = last_shifted_.at(joint.next.front());
    const Vector3 direct = rotate(2, both, outer.moment);
    const Vector3 force = rotate(2, next.angle, outer.force);
    const Scalar z = outer.force[2];
    const Vector3 lever = {next.a * joint.angle.sine * z, -(next.a * joint.angle.cosine * z),
                           next.a * force[1]};
    const Vector3 lever_2 = rotate(2, joint.angle, {Scalar(), -(next.a * z), Scalar()});
    for (const Vector3& offset : {lever, lever_2}) {
      const Vector3 behind =
          Vector3{direct[0], direct[1], Scalar()} + Vector3{offset[0], offset[1], Scalar()};
      suggest_(behind);
      suggest_(rotate(2, joint.angle, own.moment) + behind);
      if (const auto place = unrotated_.find(j); place != unrotated_.end())
        suggest_(place->second.moment + behind);
    }
    suggest_(rotate(2, both, outer.force));
  }

  void finish(dag::Function& out, const std::vector<Scalar>& of_chain) {
    std::vector<Scalar> torques = gathered(robot_, of_chain, graph_);
    for (const MotorDrive& motor : p_.chain.motors)
      torques[motor.driven] = torques[motor.driven] + force(motor);
    for (std::size_t i = 0; i < torques.size(); ++i)
      out.outputs.push_back({"tau" + std::to_string(i + 1), torques[i].in(graph_)});
  }

  const model::Robot& robot_;
  dag::Graph& graph_;
  Suggestions suggest_;
  const FormulationOptions& choices_;
  Effects effects_;
  Parametrisation p_;
  std::vector<Joint> joints_;
  std::vector<State> states_;
  std::vector<Wrench> behind_;  ///< by link, the sum over those that it carries
  std::map<std::size_t, Arriving> arriving_;
  std::map<std::size_t, Wrench> unrotated_, last_shifted_;
};

}  // namespace

std::string velocity_of(const std::string& variable) { return variable + "'"; }
std::string acceleration_of(const std::string& variable) { return variable + "''"; }
std::string force_of(const std::string& variable) { return variable + "!"; }
std::string direction_of(const std::string& variable) { return variable + "~"; }
std::string wrench_component(std::size_t index) { return "&" + std::to_string(index); }

Formulation inverse_dynamics(const model::Robot& robot, const FormulationOptions& choices, Effects effects) {
  Formulation result;
  Recursion(robot, choices, effects, result).run(result.function);
  return in_rates_of_leaders(robot, std::move(result));
}

}  // namespace qvgen::derive::dynamics
