// SPDX-License-Identifier: MIT
#include "derive/dynamics/chain.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include <cln/integer.h>

#include "derive/dynamics/rotation_sequence.h"
#include "exact/constant_angle.h"
#include "model/coordinates.h"
#include "model/followers.h"
#include "model/mechanism.h"

namespace qvgen::derive::dynamics {
namespace {

using exact::Angle;

Vector3 rotated(const RotationSequence& sequence, Vector3 v, dag::Graph& graph) {
  for (auto turn = sequence.rbegin(); turn != sequence.rend(); ++turn)
    v = rotate(turn->axis, circle(turn->angle, graph), v);
  return v;
}

PseudoInertia rotated(const RotationSequence& sequence, PseudoInertia inertia, dag::Graph& graph) {
  for (auto turn = sequence.rbegin(); turn != sequence.rend(); ++turn)
    inertia = rotated(inertia, turn->axis, circle(turn->angle, graph));
  return inertia;
}

Vector3 to_vector(const model::Vector3& v, dag::Graph& graph) {
  return {to_scalar(v[0], graph), to_scalar(v[1], graph), to_scalar(v[2], graph)};
}

bool is_multiple_of_half_turn(const Angle& angle) {
  return angle.terms.empty() && cln::denominator(angle.pi) == 1;
}

Angle quarter(long count) { return {{}, cln::cl_RA(count) / 2}; }

/// The constant way from one joint frame (z along its axis) to the next: Rz(phi) T(0,0,d) T(a,b,0) Rx(alpha)
/// T(0,0,d_next) and the rest of the rotation, which begins with a turn about z.
struct Passage {
  Angle phi, alpha;
  RotationSequence rest;
  Scalar a, b, d, next_d;
};

Angle take(RotationSequence& sequence, std::size_t axis) {
  if (sequence.empty() || sequence.front().axis != axis) return {};
  const Angle angle = sequence.front().angle;
  sequence.erase(sequence.begin());
  return angle;
}

/// Moves the origins along the two axes to the feet of their common normal where that needs no division by a
/// variable quantity.
Passage make_passage(RotationSequence sequence, const Vector3& t, dag::Graph& graph) {
  Passage passage;
  sequence = recomposed(reduced(std::move(sequence)));
  passage.phi = take(sequence, 2);
  passage.alpha = take(sequence, 0);
  Vector3 offset = unrotate(2, circle(passage.phi, graph), t);
  if (is_multiple_of_half_turn(passage.alpha)) {
    if (offset[0].is_zero() && !offset[1].is_zero()) {
      passage.phi = passage.phi + quarter(1);
      const bool flipped = cln::oddp(cln::numerator(passage.alpha.pi));
      sequence = reduced(RotationSequence{{2, quarter(flipped ? 1 : -1)}} * sequence);
      offset = {offset[1], -offset[0], offset[2]};
    }
    passage.next_d = circle(passage.alpha, graph).cosine * offset[2];
    offset[2] = Scalar();
  } else if (exact::value_of(passage.alpha)) {
    const auto [cosine, sine] = circle(passage.alpha, graph);
    passage.next_d = -offset[1] / sine;
    offset[2] = offset[2] - passage.next_d * cosine;
    offset[1] = Scalar();
  }
  passage.a = offset[0];
  passage.b = offset[1];
  passage.d = offset[2];
  passage.rest = std::move(sequence);
  return passage;
}

class ChainBuilder {
 public:
  ChainBuilder(const model::Robot& robot, dag::Graph& graph, Inertias inertias)
      : robot_(robot), graph_(graph), inertias_(inertias) {}

  Chain build() {
    if (robot_.joints.empty()) throw std::domain_error("dynamics: no joints");
    stands_.resize(robot_.joints.size());
    if (robot_.floating_base) add_floating_base();
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      const std::size_t parent = model::parent_of(robot_, j);
      if (parent == model::base_link)
        arrive_from_base(j);
      else if (first_behind(parent) == j)
        arrive(j, stands_[parent].link, stands_[parent].next);
      else
        arrive_beside(j, stands_[parent].link, way_from_joint(parent, j), stands_[parent].next);
      const auto next = first_behind(j);
      stands_[j] = {chain_.links.size() - 1, next ? passage_of(way_from_joint(j, *next)) : last_passage()};
      leave(j, stands_[j].next);
    }
    if (inertias_ == Inertias::described) read_motors();
    return std::move(chain_);
  }

 private:
  /// Rotation and translation from one joint frame to another.
  struct Offset {
    RotationSequence turns;
    Vector3 offset;
  };
  /// The link that a joint moves, whose frame is the one from which the next passage starts.
  struct Stand {
    std::size_t link = no_link;
    Passage next;
  };

  /// The joint behind a link for which its frame is chosen: the first one.
  void add_floating_base() {
    Link base;
    base.motion = Motion::free;
    base.inertia = inertias_ == Inertias::described ? from_description(*robot_.floating_base, graph_)
                                                    : from_standard(0, graph_);
    chain_.links.push_back(base);
  }

  [[nodiscard]] std::optional<std::size_t> first_behind(std::size_t link) const {
    for (std::size_t j = 0; j < robot_.joints.size(); ++j)
      if (model::parent_of(robot_, j) == link) return j;
    return std::nullopt;
  }

  Passage passage_of(const Offset& way) { return make_passage(way.turns, way.offset, graph_); }

  Offset way_from_base(std::size_t j) {
    const model::Joint& joint = robot_.joints[j];
    const RotationSequence base = to_sequence(robot_.base.turns);
    return {base * to_sequence(joint.before.turns) * from_z_to(joint.axis),
            to_vector(robot_.base.translation, graph_) +
                rotated(base, to_vector(joint.before.translation, graph_), graph_)};
  }

  Offset way_from_joint(std::size_t j, std::size_t behind) {
    const model::Joint& here = robot_.joints[j];
    const model::Joint& next = robot_.joints[behind];
    const RotationSequence back = inverse(from_z_to(here.axis));
    const RotationSequence after = to_sequence(here.after.turns);
    const Vector3 offset = to_vector(here.after.translation, graph_) +
                           rotated(after, to_vector(next.before.translation, graph_), graph_);
    return {back * after * to_sequence(next.before.turns) * from_z_to(next.axis),
            rotated(back, offset, graph_)};
  }

  /// The frame in which the first joint begins is the one for all others on the base.
  void arrive_from_base(std::size_t j) {
    const Offset way = way_from_base(j);
    if (robot_.floating_base) return arrive_beside(j, 0, way, {});
    if (first_behind(model::base_link) == j) {
      chain_.start = way.offset;
      const Passage passage = passage_of({way.turns, {}});
      chain_.yaw = passage.phi;
      return arrive(j, no_link, passage);
    }
    Passage taken;
    taken.phi = chain_.yaw;
    const Vector3 offset = way.offset - chain_.start;
    arrive_beside(j, no_link, {way.turns, offset}, taken);
  }

  /// Behind the last joint its frame is free along its axis: the remaining offset goes into the inertia.
  Passage last_passage() const {
    Passage passage;
    passage.d = -chain_.links.back().d;
    return passage;
  }

  /// A further joint on a link whose frame was chosen for another one: what that has taken of the way (a turn
  /// about z and a shift along it) is taken back, and what is left of such a turn is a link without motion.
  void arrive_beside(std::size_t j, std::size_t parent, Offset way, const Passage& taken) {
    way.turns = RotationSequence{{2, cln::cl_RA(-1) * taken.phi}} * way.turns;
    way.offset = unrotate(2, circle(taken.phi, graph_), way.offset);
    way.offset[2] = way.offset[2] - taken.d;
    const Passage passage = passage_of(way);
    if (passage.phi != Angle{} || !passage.d.is_zero()) {
      Link between;
      between.joint = j;
      between.parent = parent;
      between.angle = passage.phi;
      between.d = passage.d;
      chain_.links.push_back(between);
      parent = chain_.links.size() - 1;
    }
    arrive(j, parent, passage);
  }

  /// Links up to joint j; more than one if the passage has turns left over.
  void arrive(std::size_t j, std::size_t parent, Passage passage) {
    Link link;
    link.joint = j;
    link.parent = parent;
    link.alpha = passage.alpha;
    link.a = passage.a;
    link.b = passage.b;
    link.d = passage.next_d;
    link.angle = take(passage.rest, 2);
    while (!passage.rest.empty()) {
      chain_.links.push_back(link);
      link = Link();
      link.joint = j;
      link.parent = chain_.links.size() - 1;
      link.alpha = take(passage.rest, 0);
      link.angle = take(passage.rest, 2);
    }
    const model::Joint& joint = robot_.joints[j];
    link.variable = joint.variable;
    link.coordinate = model::base_motions(robot_) + j;
    if (inertias_ == Inertias::described) read_drive(joint, link);
    link.motion = joint.type == model::JointType::revolute ? Motion::revolute : Motion::prismatic;
    if (link.motion == Motion::revolute) link.angle = link.angle + Angle{{{joint.variable, 1}}, 0};
    chain_.links.push_back(link);
  }

  /// Turns the frame of the link by phi about its axis and moves it along by d, and takes the inertia there.
  void leave(std::size_t j, const Passage& passage) {
    const model::Joint& joint = robot_.joints[j];
    Link& link = chain_.links.back();
    link.angle = link.angle + passage.phi;
    link.d = link.d + passage.d;
    const RotationSequence back = inverse(from_z_to(joint.axis));
    const bool described = inertias_ == Inertias::described;
    PseudoInertia inertia = described ? from_description(joint.inertia, graph_)
                                      : from_standard(model::base_bodies(robot_) + j, graph_);
    for (const model::Displacement& step : {joint.inertia.frame, joint.after}) {
      inertia = rotated(to_sequence(step.turns), inertia, graph_);
      inertia = shifted(inertia, to_vector(step.translation, graph_));
    }
    inertia = rotated(RotationSequence{{2, cln::cl_RA(-1) * passage.phi}} * back, inertia, graph_);
    link.inertia = shifted(inertia, 2, -passage.d);
    if (j + 1 == robot_.joints.size() && !model::branches(robot_)) place_tool(joint, back, passage);
  }

  void place_tool(const model::Joint& last, const RotationSequence& back, const Passage& passage) {
    const Vector3 tool =
        to_vector(last.after.translation, graph_) +
        rotated(to_sequence(last.after.turns), to_vector(robot_.tool.translation, graph_), graph_);
    chain_.tool = rotated(back, tool, graph_);
    chain_.tool[2] = chain_.tool[2] - passage.d;
  }

  void read_drive(const model::Joint& joint, Link& link) {
    link.rotor = to_scalar(joint.drive.rotor_inertia, graph_);
    link.viscous = to_scalar(joint.drive.viscous_friction, graph_);
    link.coulomb = to_scalar(joint.drive.coulomb_friction, graph_);
  }

  void read_motors() {
    const std::vector<std::string> variables = model::variables(robot_);
    for (const model::Motor& motor : robot_.motors) {
      const auto place = std::find(variables.begin(), variables.end(), motor.variable);
      chain_.motors.push_back({motor.variable, static_cast<std::size_t>(place - variables.begin()),
                               to_scalar(motor.drive.rotor_inertia, graph_),
                               to_scalar(motor.drive.viscous_friction, graph_),
                               to_scalar(motor.drive.coulomb_friction, graph_)});
    }
  }

  const model::Robot& robot_;
  dag::Graph& graph_;
  Inertias inertias_;
  Chain chain_;
  std::vector<Stand> stands_;  ///< by joint
};

}  // namespace

std::vector<Way> ways_of(const Link& link) {
  if (link.motion == Motion::none) return {};
  if (link.motion != Motion::free) return {{link.motion == Motion::prismatic, 2, link.coordinate}};
  std::vector<Way> ways;
  for (std::size_t k = 0; k < model::motions_of_body; ++k)
    ways.push_back({k < 3, k % 3, link.coordinate + k});
  return ways;
}

Chain make_chain(const model::Robot& robot, dag::Graph& graph, Inertias inertias) {
  return ChainBuilder(robot, graph, inertias).build();
}

/// Constant angles alone become numbers; in the company of a variable they stay inside its sine and cosine.
Circle circle(const Angle& angle, dag::Graph& graph) {
  if (const auto known = exact::value_of(angle))
    return {Scalar(graph, graph.constant(known->cosine)), Scalar(graph, graph.constant(known->sine))};
  return {Scalar(graph, graph.cosine(angle)), Scalar(graph, graph.sine(angle))};
}

Scalar to_scalar(const model::Expression& expression, dag::Graph& graph) {
  using Kind = model::Expression::Kind;
  const auto operand = [&](std::size_t i) { return to_scalar(expression.operands()[i], graph); };
  const auto one = [&] { return Scalar(graph, graph.constant(1)); };
  switch (expression.kind()) {
    case Kind::number:
      return {graph, graph.constant(exact::Number(expression.number()))};
    case Kind::pi:
      return {graph, graph.symbol("pi")};
    case Kind::symbol:
      return {graph, graph.symbol(expression.name())};
    case Kind::negate:
      return -operand(0);
    case Kind::quotient:
      return operand(0) / operand(1);
    case Kind::root:
      return {graph, graph.root(operand(0).in(graph))};
    case Kind::sine:
      return circle(to_angle(expression.operands()[0]), graph).sine;
    case Kind::cosine:
      return circle(to_angle(expression.operands()[0]), graph).cosine;
    default:
      break;
  }
  const std::size_t count = expression.operands().size();
  Scalar result = expression.kind() == Kind::sum ? Scalar() : one();
  if (expression.kind() == Kind::power) {
    const long exponent = expression.exponent();
    for (long i = 0; i < std::abs(exponent); ++i) result = result * operand(0);
    return exponent < 0 ? one() / result : result;
  }
  for (std::size_t i = 0; i < count; ++i)
    result = expression.kind() == Kind::sum ? result + operand(i) : result * operand(i);
  return result;
}

}  // namespace qvgen::derive::dynamics
