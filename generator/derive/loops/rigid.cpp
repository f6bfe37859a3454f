// SPDX-License-Identifier: MIT
// Closures that leave no turn between two links of a plane: a weld, and a slide. A weld is cut at another
// joint of its loop in thought: at a turn, whose axis is a point of both sides then, or at a slide. That
// joint comes last, by the direction, or the way, that is left for it. A slide between two turns gives one
// equation that is linear in the cosine and sine of one of them, since the other turns by as much.
#include <algorithm>

#include "derive/inverse/attempt.h"
#include "derive/loops/solver.h"
#include "derive/loops/wave.h"
#include "symbolic/model.h"

namespace qvgen::derive::loops {

using GiNaC::ex;
using inverse::Flat;
using inverse::in_frame;
using inverse::Screw;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;
using Turn = inverse::Scope::Turn;

namespace {

std::string name_of(const Cycle& cycle) { return "loop " + std::to_string(cycle.number); }

/// Place among both sides of the side that a joint is on.
std::size_t side_index(const Cycle& cycle, const Side* side) { return side == &cycle.sides[0] ? 0 : 1; }

/// A direction of one link as seen from the other.
Vector across_weld(const Cycle& cycle, std::size_t from, const Vector& direction) {
  return symbolic::rotate(from == 0 ? symbolic::inverse(cycle.turn) : cycle.turn, direction);
}

/// The direction of the other side's end in front of a joint's motion, over that of its own behind it.
Flat direction_between(const Carrier& carrier, const Cycle& cycle, std::size_t side, int index,
                       const Screw& screw, const inverse::Scope& scope) {
  const auto& [first, second] = cycle.directions.front();
  const Vector own = carrier.end_direction(cycle.sides[side], side == 0 ? first : second, index);
  const Vector other = carrier.end_direction(cycle.sides[1 - side], side == 0 ? second : first, -1);
  const Flat from = in_frame(screw, own, scope);
  const Flat to = in_frame(screw, carrier.lowered_direction(cycle.sides[side], -1, other, index), scope);
  return to * inverse::conjugate(from);
}

}  // namespace

void Solver::turn_by_direction(const Cycle& cycle, const Place& at) {
  const Screw screw = screw_of(at.joint);
  const Flat direction =
      direction_between(carrier(), cycle, side_index(cycle, at.side), at.index, screw, scope_);
  builder_.turn_by_pair(screw, {kept(direction.x), kept(direction.y)},
                        name_of(cycle) + ": the links do not turn against each other", 1);
  know(at.joint);
}

Vector Solver::line_across(const Carrier& carrier, const Cycle& cycle) const {
  return cross(*cycle.normal, carrier.end_direction(cycle.sides[0], cycle.directions.front()[0], -1));
}

std::string Solver::slide(const Cycle& cycle) {
  const std::vector<std::size_t> joints = unknown(cycle);
  const Place a = place_of(cycle, joints[0]), b = place_of(cycle, joints[1]);
  if (turns(a.joint) && turns(b.joint)) return slide_of_turns(cycle, a, b);
  if (!turns(a.joint) && !turns(b.joint))
    return name_of(cycle) + " holds two slides, which cannot turn its links into line";
  const Place& turn = turns(a.joint) ? a : b;
  const Place& along = turns(a.joint) ? b : a;
  turn_by_direction(cycle, turn);
  const Vector across = kept(line_across(carrier(), cycle));
  const Vector way = kept(carrier().end(cycle.sides[0], -1) - carrier().end(cycle.sides[1], -1));
  const Vector axis = symbolic::to_symbolic(robot_.joints[along.joint].axis);
  const Vector d = carrier().lifted_direction(*along.side, along.index, axis, -1);
  const ex share = kept(side_index(cycle, along.side) == 0 ? dot(across, d) : -dot(across, d));
  if (scope_.is_zero(share)) return name_of(cycle) + ": its two slides are parallel";
  builder_.slide_by_value(screw_of(along.joint), -dot(across, way) / share,
                          name_of(cycle) + ": the way to the line");
  know(along.joint);
  return "";
}

std::string Solver::slide_of_turns(const Cycle& cycle, const Place& u, const Place& v) {
  const Screw first = screw_of(u.joint), second = screw_of(v.joint);
  const Wave gap = wave([&](const Turn& turn) {
    Values values{{u.joint, turn}, {v.joint, {1, 0}}};
    const Flat by =
        direction_between(carrier_at(values), cycle, side_index(cycle, v.side), v.index, second, scope_);
    values[v.joint] = {scope_.clean(by.x), scope_.clean(by.y)};
    const Carrier at = carrier_at(values);
    return scope_.clean(dot(line_across(at, cycle), at.end(cycle.sides[0], -1) - at.end(cycle.sides[1], -1)));
  });
  const Flat wave{kept(gap[1]), kept(gap[2])};
  if (scope_.is_zero(wave.x) && scope_.is_zero(wave.y))
    return name_of(cycle) + ": the axes of " + first.variable + " and " + second.variable +
           " are one, and turn its links without moving them along the line";
  builder_.turn_by_line(first, wave, kept(-gap[0]), name_of(cycle) + ": the distance from the line");
  know(u.joint);
  turn_by_direction(cycle, v);
  return "";
}

/// The loop of a weld cut at a joint, the last one on its side that is open.
Cycle Solver::cut_at(const Cycle& weld, const Place& at) {
  const std::size_t own = side_index(weld, at.side), other = 1 - own;
  const symbolic::Pair before = symbolic::to_symbolic(robot_.joints[at.joint].before);
  const Carrier carrier = this->carrier();
  Cycle cut = weld;
  cut.type = turns(at.joint) ? model::LoopType::pin : model::LoopType::slide;
  cut.sides[own].joints.resize(static_cast<std::size_t>(at.index));
  cut.sides[own].point = before.p;
  const Vector origin = carrier.at_end(*at.side, at.index, Vector{0, 0, 0}, false);
  cut.sides[other].point =
      kept(weld.sides[other].point + across_weld(weld, own, origin - weld.sides[own].point));
  if (turns(at.joint)) return cut;
  const Vector axis = symbolic::to_symbolic(robot_.joints[at.joint].axis);
  auto& direction = cut.directions.front();
  direction[own] = symbolic::rotate(before.q, axis);
  direction[other] = kept(across_weld(weld, own, carrier.at_end(*at.side, at.index, axis, true)));
  return cut;
}

std::string Solver::weld_cut_at(const Cycle& cycle, const Place& at) {
  const Cycle cut = cut_at(cycle, at);
  const std::string problem = turns(at.joint) ? meeting(cut) : slide(cut);
  if (!problem.empty()) return problem;
  if (turns(at.joint)) {
    turn_by_direction(cycle, at);
    return "";
  }
  const Screw screw = screw_of(at.joint);
  const Vector way = kept(goal(at) - carrier().end(*at.side, at.index));
  builder_.slide_by_value(screw, dot(screw.axis, way), name_of(cycle) + ": the way along " + screw.variable);
  know(at.joint);
  return "";
}

std::string Solver::weld(const Cycle& cycle) {
  const std::vector<std::size_t> open = unknown(cycle);
  std::vector<Place> last;  // on each side
  for (const Side& side : cycle.sides)
    for (auto joint = side.joints.rbegin(); joint != side.joints.rend(); ++joint) {
      if (std::find(open.begin(), open.end(), *joint) == open.end()) continue;
      last.push_back(place_of(cycle, *joint));
      break;
    }
  std::stable_partition(last.begin(), last.end(), [&](const Place& at) { return turns(at.joint); });
  std::string problem;
  for (const Place& at : last) {
    const std::string because = weld_cut_at(cycle, at);
    if (because.empty()) return "";
    if (problem.empty()) problem = because;
    if (unknown(cycle).size() != open.size()) break;  // some of it is solved: no other way is left
  }
  return problem;
}

}  // namespace qvgen::derive::loops
