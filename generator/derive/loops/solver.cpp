// SPDX-License-Identifier: MIT
#include "derive/loops/solver.h"

#include <algorithm>
#include <stdexcept>

#include "derive/inverse/attempt.h"
#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::loops {

using GiNaC::ex;
using inverse::Flat;
using inverse::in_frame;
using inverse::Screw;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;

namespace {

ex square(const Flat& v) { return v.x * v.x + v.y * v.y; }
Flat negative(const Flat& v) { return {-v.x, -v.y}; }

std::string loop_name(const Cycle& cycle) { return "loop " + std::to_string(cycle.number); }

}  // namespace

Solver::Solver(const model::Robot& robot, inverse::Scope& scope, inverse::Builder& builder)
    : robot_(robot), scope_(scope), builder_(builder) {}

void Solver::know(std::size_t joint) { known_.insert(joint); }

std::vector<std::size_t> Solver::unknown(const Cycle& cycle) const {
  std::vector<std::size_t> joints = cycle.joints();
  std::erase_if(joints, [&](std::size_t joint) { return known_.count(joint) > 0; });
  return joints;
}

bool Solver::turns(std::size_t joint) const {
  return robot_.joints[joint].type == model::JointType::revolute;
}

Solver::Place Solver::place_of(const Cycle& cycle, std::size_t joint) const {
  for (std::size_t s = 0; s < 2; ++s) {
    const auto& joints = cycle.sides[s].joints;
    const auto found = std::find(joints.begin(), joints.end(), joint);
    if (found != joints.end())
      return {&cycle.sides[s], &cycle.sides[1 - s], static_cast<int>(found - joints.begin()), joint};
  }
  throw std::logic_error("loops: a joint is not in the loop");
}

Screw Solver::screw_of(std::size_t joint) {
  model::Robot alone;
  alone.joints = {robot_.joints[joint]};
  alone.joints[0].before = {};
  alone.joints[0].after = {};
  alone.joints[0].parent.reset();
  Screw screw = inverse::chain_of(alone, scope_, builder_.plan().target).screws.front();
  screw.joint = static_cast<int>(joint);
  return screw;
}

ex Solver::kept(const ex& value) {
  const ex cleaned = scope_.clean(value);
  if (builder_.is_constant(cleaned)) return cleaned;
  return builder_.keep("loop_value_" + std::to_string(++names_), cleaned);
}

Vector Solver::kept(const Vector& v) { return {kept(v.x), kept(v.y), kept(v.z)}; }

Carrier Solver::carrier() {
  const auto value = [this](std::size_t joint) -> inverse::Scope::Turn {
    if (known_.count(joint) > 0) return builder_.value(screw_of(joint));
    if (turns(joint)) throw std::logic_error("loops: a joint in the way is not known");
    return {0, 0};
  };
  return {robot_, value, [this](const Vector& v) { return kept(v); }};
}

Vector Solver::goal(const Place& at) {
  return kept(carrier().lowered(*at.side, -1, carrier().end(*at.other, -1), at.index));
}

Vector Solver::goal_by(const Place& at, const Place& slide) {
  const Vector axis = symbolic::to_symbolic(robot_.joints[slide.joint].axis);
  const Vector d = carrier().lifted_direction(*slide.side, slide.index, axis, -1);
  const Vector seen = kept(carrier().lowered_direction(*at.side, -1, d, at.index));
  return slide.side == at.side ? -seen : seen;
}

void Solver::pair(const Place& at, const std::string& equation) {
  const Screw screw = screw_of(at.joint);
  const Flat to = in_frame(screw, goal(at), scope_);
  const Flat from = in_frame(screw, kept(carrier().end(*at.side, at.index)), scope_);
  builder_.turn_by_pair(screw, to * inverse::conjugate(from), equation);
  know(at.joint);
}

bool Solver::knows_length(const Cycle& cycle) const {
  return !cycle.length_joint || known_.count(*cycle.length_joint) > 0;
}

void Solver::stretch(const Cycle& cycle) {
  const Vector way = kept(carrier().end(cycle.sides[0], -1) - carrier().end(cycle.sides[1], -1));
  builder_.slide_by_value(screw_of(*cycle.length_joint), GiNaC::sqrt(dot(way, way)),
                          loop_name(cycle) + ": the distance of its points");
  know(*cycle.length_joint);
}

std::string Solver::rod(const Cycle& cycle) {
  if (!knows_length(cycle)) {
    stretch(cycle);
    return "";
  }
  const Place at = place_of(cycle, unknown(cycle).front());
  if (!turns(at.joint)) return slide_by_rod(cycle, at);
  const Screw screw = screw_of(at.joint);
  const Vector y = kept(carrier().end(*at.side, at.index)), q = goal(at);
  const Flat arm = in_frame(screw, y, scope_), to = in_frame(screw, q, scope_);
  if (scope_.is_zero(square(arm)))
    return "the rod of " + loop_name(cycle) + " ends on the axis of " + screw.variable;
  if (scope_.is_zero(square(to)))
    return "the rod of " + loop_name(cycle) + " begins on the axis of " + screw.variable +
           ", so that its length does not tell the angle";
  const ex height = scope_.clean(dot(screw.axis, q - y));
  const ex distance = kept(cycle.length * cycle.length - height * height);
  builder_.turn_by_distance(screw, 1, negative(to), arm, distance,
                            loop_name(cycle) + ": the rod keeps its length");
  know(at.joint);
  return "";
}

std::string Solver::slide_by_rod(const Cycle& cycle, const Place& at) {
  const Screw screw = screw_of(at.joint);
  const Vector to = kept(goal(at) - carrier().end(*at.side, at.index));
  const ex foot = kept(dot(screw.axis, to));
  const Vector off = cross(screw.axis, to);
  builder_.slide_by_root(screw, foot, cycle.length * cycle.length, kept(dot(off, off)),
                         loop_name(cycle) + ": the rod keeps its length");
  know(at.joint);
  return "";
}

std::string Solver::meeting(const Cycle& cycle) {
  const std::vector<std::size_t> joints = unknown(cycle);
  const Place a = place_of(cycle, joints[0]), b = place_of(cycle, joints[1]);
  if (turns(a.joint) && turns(b.joint)) return two_turns(cycle, a, b);
  if (turns(a.joint)) return turn_and_slide(cycle, a, b);
  if (turns(b.joint)) return turn_and_slide(cycle, b, a);
  return two_slides(cycle, a, b);
}

std::string Solver::two_turns(const Cycle& cycle, Place u, Place v) {
  const std::string equation = loop_name(cycle) + ": distance from the axis of ";
  const Vector origin{0, 0, 0};
  if (u.side == v.side) {
    if (u.index > v.index) std::swap(u, v);
    const Screw outer = screw_of(v.joint), inner = screw_of(u.joint);
    const Vector centre = kept(carrier().lowered(*v.side, u.index, origin, v.index));
    const Flat arm = in_frame(outer, kept(carrier().end(*v.side, v.index)), scope_);
    const Flat to = in_frame(inner, goal(u), scope_);
    if (scope_.is_zero(square(arm))) return loop_name(cycle) + " closes on the axis of " + outer.variable;
    builder_.turn_by_distance(outer, 1, negative(in_frame(outer, centre, scope_)), arm, kept(square(to)),
                              equation + inner.variable + ": the same on both sides");
    know(v.joint);
    pair(u, loop_name(cycle) + ": the turn about the axis of " + inner.variable);
    return "";
  }
  const Screw first = screw_of(u.joint), second = screw_of(v.joint);
  const Vector centre =
      kept(carrier().lowered(*u.side, -1, carrier().lifted(*v.side, v.index, origin, -1), u.index));
  const Flat arm = in_frame(first, kept(carrier().end(*u.side, u.index)), scope_);
  const Flat other = in_frame(second, kept(carrier().end(*v.side, v.index)), scope_);
  if (scope_.is_zero(square(arm))) return loop_name(cycle) + " closes on the axis of " + first.variable;
  if (scope_.is_zero(square(other))) return loop_name(cycle) + " closes on the axis of " + second.variable;
  builder_.turn_by_distance(first, 1, negative(in_frame(first, centre, scope_)), arm, kept(square(other)),
                            equation + second.variable + ": the same on both sides");
  know(u.joint);
  pair(v, loop_name(cycle) + ": the turn about the axis of " + second.variable);
  return "";
}

std::string Solver::turn_and_slide(const Cycle& cycle, const Place& turn, const Place& slide) {
  const Screw screw = screw_of(turn.joint), along = screw_of(slide.joint);
  const Flat start = in_frame(screw, kept(carrier().end(*turn.side, turn.index)), scope_);
  const std::string closes = loop_name(cycle) + ": ";
  if (turn.side == slide.side && slide.index > turn.index) {
    const Vector carried = carrier().lifted_direction(*turn.side, slide.index, along.axis, turn.index);
    const Flat d = in_frame(screw, kept(carried), scope_);
    const ex across = kept(d.x * start.y - d.y * start.x);
    const Flat to = in_frame(screw, goal(turn), scope_);
    builder_.slide_by_root(along, kept(-(d.x * start.x + d.y * start.y)), kept(square(to)),
                           kept(across * across), closes + "distance from the axis of " + screw.variable);
    know(slide.joint);
    pair(turn, closes + "the turn about the axis of " + screw.variable);
    return "";
  }
  const Flat to = in_frame(screw, goal(turn), scope_);
  const Flat d = in_frame(screw, goal_by(turn, slide), scope_);
  const Flat level{-d.y, d.x};
  if (scope_.is_zero(square(start))) return loop_name(cycle) + " closes on the axis of " + screw.variable;
  builder_.turn_by_line(
      screw, {kept(level.x * start.x + level.y * start.y), kept(level.y * start.x - level.x * start.y)},
      kept(level.x * to.x + level.y * to.y), closes + "the distance from the line of " + along.variable);
  know(turn.joint);
  const inverse::Scope::Turn by = builder_.value(screw);
  const Flat end{by.cosine * start.x - by.sine * start.y, by.sine * start.x + by.cosine * start.y};
  builder_.slide_by_value(along, d.x * (end.x - to.x) + d.y * (end.y - to.y),
                          closes + "the way along " + along.variable);
  know(slide.joint);
  return "";
}

std::string Solver::two_slides(const Cycle& cycle, const Place& s, const Place& t) {
  const Vector n = *cycle.normal;
  const auto direction = [&](const Place& at) {
    const Vector axis = symbolic::to_symbolic(robot_.joints[at.joint].axis);
    const Vector d = carrier().lifted_direction(*at.side, at.index, axis, -1);
    return kept(at.side == &cycle.sides[0] ? d : -d);
  };
  const Vector a = direction(s), b = direction(t);
  const Vector gap = kept(carrier().end(cycle.sides[1], -1) - carrier().end(cycle.sides[0], -1));
  // Coordinates along a and across it.
  const Vector across = cross(n, a);
  const auto flat = [&](const Vector& v) { return Flat{kept(dot(a, v)), kept(dot(across, v))}; };
  const Flat first = flat(a), second = flat(b), to = flat(gap);
  if (scope_.is_zero(second.y)) return loop_name(cycle) + ": its two slides are parallel";
  builder_.slide_by_value(screw_of(t.joint), to.y / second.y, loop_name(cycle) + ": the way across");
  know(t.joint);
  const ex value = builder_.value(screw_of(t.joint)).cosine;
  builder_.slide_by_value(screw_of(s.joint), (to.x - value * second.x) / first.x,
                          loop_name(cycle) + ": the way along");
  know(s.joint);
  return "";
}

std::string Solver::three_spheres(const std::vector<const Cycle*>& cycles) {
  const std::string loops = "loops " + std::to_string(cycles[0]->number) + ", " +
                            std::to_string(cycles[1]->number) + " and " + std::to_string(cycles[2]->number);
  const std::vector<std::size_t> slides = unknown(*cycles.front());
  std::vector<Place> places;
  std::vector<Vector> axes;
  for (const std::size_t joint : slides) {
    places.push_back(place_of(*cycles.front(), joint));
    axes.push_back(scope_.clean(carrier().lifted_direction(
        *places.back().side, places.back().index, symbolic::to_symbolic(robot_.joints[joint].axis), -1)));
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (!scope_.is_zero(dot(axes[i], axes[(i + 1) % 3])))
      return loops +
             " hold slides that are not at right angles, and three rods place a platform on three slides "
             "that are";
  std::vector<Vector> centre;
  for (const Cycle* cycle : cycles) {
    const Place at = place_of(*cycle, slides.front());
    centre.push_back(kept(carrier().end(*at.other, -1) - carrier().end(*at.side, -1)));
  }
  const auto length_square = [&](std::size_t i) { return cycles[i]->length * cycles[i]->length; };
  const Vector a = kept(centre[1] - centre[0]), b = kept(centre[2] - centre[0]);
  const Vector normal = kept(cross(a, b));
  const ex normal_square = kept(dot(normal, normal));
  const ex k = kept((dot(a, a) + length_square(0) - length_square(1)) / 2);
  const ex l = kept((dot(b, b) + length_square(0) - length_square(2)) / 2);
  const Vector foot = kept(ex(1) / normal_square * (k * cross(b, normal) + l * cross(normal, a)));
  const std::string rods = loops + ": three spheres meet";
  const ex height = builder_.root("height_" + std::to_string(cycles[0]->number), length_square(0),
                                  kept(dot(foot, foot)), rods);
  const Vector point = kept(centre[0] + foot + height / GiNaC::sqrt(normal_square) * normal);
  for (std::size_t i = 0; i < 3; ++i) {
    builder_.slide_by_value(screw_of(slides[i]), dot(axes[i], point), rods);
    know(slides[i]);
  }
  return "";
}

}  // namespace qvgen::derive::loops
