// SPDX-License-Identifier: MIT
// Inverse dynamics by the Newton-Euler recursion (thesis 5.1 to 5.15), vectors turned from link to link by
// rotation matrices or by quaternions, q v q^-1. Both over the frames of exact_arm.h that are parallel to the
// world's at zero, so that they differ in nothing else.
#include "optimise/dynamics.h"

#include <stdexcept>

#include "compare/chain.h"
#include "compare/exact_arm.h"
#include "compare/formulation.h"
#include "derive/dynamics/chain.h"
#include "derive/dynamics/formulation.h"

namespace qvgen::compare {
namespace {

using derive::dynamics::to_scalar;

/// By matrices.
struct ByMatrix {
  Matrix r;
  ByMatrix(const Vector& axis, const std::string& joint, Recorder& recorder)
      : r(rotation(axis, recorder.circle(variable(joint)), recorder)) {}
  [[nodiscard]] Vector outward(const Vector& v) const { return r * v; }
  [[nodiscard]] Vector inward(const Vector& v) const { return transpose(r) * v; }
};

/// By quaternions.
struct ByQuaternion {
  Quaternion q;
  ByQuaternion(const Vector& axis, const std::string& joint, Recorder& recorder)
      : q(rotation(axis, recorder.circle(half(joint)))) {}
  [[nodiscard]] Vector outward(const Vector& v) const { return turned(q, v); }
  [[nodiscard]] Vector inward(const Vector& v) const { return turned(conjugate(q), v); }
};

/// A link in its joint's frame: mass, centre of mass, inertia about it.
struct Body {
  Value mass;
  Vector centre;
  Matrix inertia;
};

Body body_of(const model::Inertia& described, const ExactFrame& link, Recorder& recorder) {
  dag::Graph& graph = recorder.graph();
  const ExactMatrix r = matrix_of(link.turns, graph);
  const auto entry = [&](std::size_t k) { return to_scalar(described.inertia[k], graph); };
  const ExactMatrix own{
      {{entry(0), entry(3), entry(5)}, {entry(3), entry(1), entry(4)}, {entry(5), entry(4), entry(2)}}};
  const ExactMatrix turned_inertia = product(product(r, own), transposed(r));
  const auto kept = [&](std::size_t i, std::size_t k) { return recorder.stored(turned_inertia[i][k]); };
  const Value xy = kept(0, 1), yz = kept(1, 2), zx = kept(2, 0);
  const ExactVector centre = link.offset + product(r, exact(described.centre_of_mass, graph));
  return {recorder.stored(to_scalar(described.mass, graph)),
          stored(centre, recorder),
          {{{kept(0, 0), xy, zx}, {xy, kept(1, 1), yz}, {zx, yz, kept(2, 2)}}}};
}

template <class Rotation>
class NewtonEuler {
 public:
  NewtonEuler(Recorder& recorder, const model::Robot& robot)
      : recorder_(recorder), robot_(robot), arm_(parallel_arm(robot, recorder.graph())) {}

  Results run() {
    const Value none = recorder_.entry(0);
    State state{zero(recorder_), zero(recorder_), {none, none, gravity()}};
    for (std::size_t i = 0; i < arm_.joints.size(); ++i) outward(i, state);
    Results results;
    std::optional<Wrench> behind;
    for (std::size_t i = arm_.joints.size(); i-- > 0;) {
      behind = inward(i, behind);
      const Vector& along = links_[i].rotation ? behind->moment : behind->force;
      results.insert(results.begin(),
                     {"tau" + std::to_string(i + 1), with_drive(i, dot(along, links_[i].axis))});
    }
    return results;
  }

 private:
  /// Angular velocity and acceleration, and the acceleration of the frame's origin against free fall, in the
  /// link's frame.
  struct State {
    Vector omega, alpha, acceleration;
  };
  struct Wrench {
    Vector force, moment;
  };
  struct LinkState {
    Vector axis, way;                  ///< the way from the joint before, in the frame of the link before
    std::optional<Rotation> rotation;  ///< none of a slide
    Vector force, moment;              ///< of inertia, about the centre of mass
    Vector centre;
  };

  Value gravity() {
    dag::Graph& graph = recorder_.graph();
    return recorder_.stored({graph, graph.symbol(derive::dynamics::gravity_symbol)});
  }

  Value rate(const std::string& joint) { return recorder_.argument(derive::dynamics::velocity_of(joint)); }
  Value acceleration(const std::string& joint) {
    return recorder_.argument(derive::dynamics::acceleration_of(joint));
  }

  /// Thesis 5.2 to 5.9; the base is at rest but for gravity, and whoever writes the program knows that.
  void outward(std::size_t i, State& s) {
    const auto& joint = arm_.joints[i];
    const Vector axis = stored(joint.axis, recorder_), offset = stored(joint.offset, recorder_);
    const Vector spin = rate(joint.variable) * axis, push = acceleration(joint.variable) * axis;
    const Vector way = joint.revolute ? offset : offset + recorder_.argument(joint.variable) * axis;
    const bool from_base = i == 0;
    if (!from_base)
      s.acceleration = s.acceleration + cross(s.alpha, way) + cross(s.omega, cross(s.omega, way));
    std::optional<Rotation> turn;
    if (joint.revolute) {
      turn.emplace(axis, joint.variable, recorder_);
      s.acceleration = turn->inward(s.acceleration);
      if (from_base) {
        s.omega = spin;
        s.alpha = push;
      } else {
        const Vector carried = turn->inward(s.omega);
        s.omega = carried + spin;
        s.alpha = turn->inward(s.alpha) + push + cross(carried, spin);
      }
    } else if (from_base) {
      s.acceleration = s.acceleration + push;
    } else {
      s.acceleration = s.acceleration + push + recorder_.literal(2) * cross(s.omega, spin);
    }
    const Body body = body_of(robot_.joints[i].inertia, joint.link, recorder_);
    const Vector at_centre =
        s.acceleration + cross(s.alpha, body.centre) + cross(s.omega, cross(s.omega, body.centre));
    links_.push_back({axis, way, turn, body.mass * at_centre,
                      body.inertia * s.alpha + cross(s.omega, body.inertia * s.omega), body.centre});
  }

  /// Thesis 5.10 to 5.13: what the joint bears, in its link's frame.
  Wrench inward(std::size_t i, const std::optional<Wrench>& behind) const {
    const LinkState& link = links_[i];
    Wrench wrench{link.force, link.moment + cross(link.centre, link.force)};
    if (!behind) return wrench;
    const LinkState& next = links_[i + 1];
    const Vector force = next.rotation ? next.rotation->outward(behind->force) : behind->force;
    const Vector moment = next.rotation ? next.rotation->outward(behind->moment) : behind->moment;
    return {wrench.force + force, wrench.moment + moment + cross(next.way, force)};
  }

  /// Rotor inertia and friction, of joints that have any.
  Value with_drive(std::size_t i, Value force) {
    const model::Drive& drive = robot_.joints[i].drive;
    const std::string& joint = robot_.joints[i].variable;
    const auto add = [&](const model::Expression& coefficient, const Value& by) {
      if (!coefficient.is_literal_zero())
        force = force + recorder_.stored(to_scalar(coefficient, recorder_.graph())) * by;
    };
    add(drive.rotor_inertia, acceleration(joint));
    add(drive.viscous_friction, rate(joint));
    add(drive.coulomb_friction, recorder_.argument(derive::dynamics::direction_of(joint)));
    return force;
  }

  Recorder& recorder_;
  const model::Robot& robot_;
  ParallelArm arm_;
  std::vector<LinkState> links_;
};

void check_inertia(const model::Robot& robot) {
  if (!optimise::has_inertia(robot)) throw std::domain_error("it has no inertia, so no dynamics");
}

dag::Function emitted(const model::Robot& robot) {
  check_inertia(robot);
  return optimise::generate_dynamics(optimise::dynamics_model(robot), optimise::dynamics_quantities().front())
      .function;
}

template <class Rotation>
Results newton_euler(Recorder& recorder, const model::Robot& robot) {
  check_inertia(robot);
  return NewtonEuler<Rotation>(recorder, robot).run();
}

}  // namespace

std::vector<Formulation> dynamics_formulations() {
  return {{"newton_euler_matrices", "Newton-Euler, rotation matrices", newton_euler<ByMatrix>},
          {"newton_euler_quaternions", "Newton-Euler, quaternions", newton_euler<ByQuaternion>},
          {"emitted", "as generated", {}, false, emitted}};
}

}  // namespace qvgen::compare
