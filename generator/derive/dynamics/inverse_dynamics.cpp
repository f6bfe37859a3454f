// SPDX-License-Identifier: MIT
#include <map>

#include "derive/dynamics/followers.h"
#include "derive/dynamics/newton_euler.h"
#include "derive/dynamics/suggestions.h"
#include "model/coordinates.h"

namespace qvgen::derive::dynamics {
namespace {

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
      states_.push_back(moved(j, before));
    }
    behind_.resize(joints_.size());
    if (choices_.wrench) behind_.back() = wrench_to_balance(last);
    backward(out);
  }

  NewtonEuler known() && { return {std::move(p_), std::move(states_), std::move(wrenches_)}; }

 private:
  /// A link with its joint's values.
  struct Joint {
    Motion moving;
    Circle alpha, angle;
    Scalar a, b, d;  ///< d with the joint variable of a prismatic joint
    Scalar rate, acceleration;
    Scalar drive;  ///< force that the drive itself takes
    PseudoInertia inertia;
    std::size_t parent;
    std::size_t coordinate = 0;
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
                link.parent};
    joint.coordinate = link.coordinate;
    if (link.motion == Motion::none || link.motion == Motion::free) return joint;
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
      Link& link = p_.chain.links[static_cast<std::size_t>(&last - joints_.data())];
      link.inertia = last.inertia;
      link.angle = {};
    }
  }

  /// U z of the joint axis, in the frame before the joint's rotation.
  Vector3 axis_column(const Joint& joint, const Matrix3& u) {
    Vector3 column;
    for (std::size_t r = 0; r < 3; ++r)
      column[r] = -joint.alpha.sine * u[r][1] + joint.alpha.cosine * u[r][2];
    return unrotate(0, joint.alpha, column);
  }

  State moved(std::size_t j, const State& before) {
    if (joints_[j].moving == Motion::free) return float_freely();
    return joints_[j].moving == Motion::revolute ? turn(j, before) : slide(j, before);
  }

  /// Three components of the floating base's velocity or acceleration, the first of them given.
  Vector3 of_base(std::string (*symbol_of)(const std::string&), std::size_t first) {
    const auto component = [&](std::size_t k) {
      return symbol(symbol_of(model::base_coordinate(first + k)));
    };
    return {component(0), component(1), component(2)};
  }

  /// The base's motion is what the caller says. The derivatives of its velocity are those of the components
  /// in its own frame, which turns.
  State float_freely() {
    const bool moves = effects_ != Effects::gravity, speeds_up = effects_ == Effects::all;
    const Vector3 linear = moves ? of_base(velocity_of, 0) : Vector3{};
    const Vector3 rate = speeds_up ? of_base(acceleration_of, 3) : Vector3{};
    State state;
    state.w = moves ? of_base(velocity_of, 3) : Vector3{};
    state.v = cross(state.w, linear);
    if (speeds_up) state.v = state.v + of_base(acceleration_of, 0);
    if (effects_ != Effects::velocity) state.v = state.v + p_.gravity;
    state.u = u_matrix(state.w, rate[1] + state.w[0] * state.w[2], state.w[1] * state.w[2] - rate[0], rate[2],
                       suggest_);
    return state;
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
    std::vector<Scalar> forces(model::base_motions(robot_) + robot_.joints.size());
    wrenches_.resize(joints_.size());
    for (std::size_t j = joints_.size(); j-- > 0;) {
      const Joint& joint = joints_[j];
      const Wrench own = link_wrench(joint.inertia, states_[j].u, states_[j].v, suggest_);
      const Wrench total = own + behind_[j];
      wrenches_[j] = total;
      for (const Way& way : ways_of(p_.chain.links[j]))
        forces[way.coordinate] =
            (way.slides ? p_.per_unit * total.force[way.axis] : total.moment[way.axis]) + joint.drive;
      if (joint.parent == no_link && joint.moving != Motion::none) continue;
      const Wrench inward = carried_inward(j, own, behind_[j]);
      if (joint.parent != no_link) behind_[joint.parent] = behind_[joint.parent] + inward;
    }
    finish(out, forces);
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

  /// Forces by coordinates; nothing of the base follows.
  void finish(dag::Function& out, const std::vector<Scalar>& of_all) {
    const auto joints = of_all.begin() + static_cast<std::ptrdiff_t>(model::base_motions(robot_));
    std::vector<Scalar> forces(of_all.begin(), joints);
    std::vector<Scalar> torques = gathered(robot_, std::vector<Scalar>(joints, of_all.end()), graph_);
    for (const MotorDrive& motor : p_.chain.motors)
      torques[motor.driven] = torques[motor.driven] + force(motor);
    forces.insert(forces.end(), torques.begin(), torques.end());
    for (std::size_t i = 0; i < forces.size(); ++i)
      out.outputs.push_back({"tau" + std::to_string(i + 1), forces[i].in(graph_)});
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
  std::vector<Wrench> wrenches_;
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

NewtonEuler newton_euler(const model::Robot& robot, const FormulationOptions& choices, Formulation& out) {
  Recursion recursion(robot, choices, Effects::all, out);
  recursion.run(out.function);
  return std::move(recursion).known();
}

}  // namespace qvgen::derive::dynamics
