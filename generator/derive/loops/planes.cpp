// SPDX-License-Identifier: MIT
// A platform in space whose legs each swing in a plane: 3-RPS, 3-PRS, 3-RRS. The ball at a leg's end stays in
// the leg's plane, whatever its two joints are. Three such planes hold two slides and a turn of the platform,
// with its other coordinates given: linear in the slides and in the turn's cosine and sine. The legs follow.
#include <algorithm>

#include "derive/inverse/attempt.h"
#include "derive/loops/solver.h"
#include "derive/loops/wave.h"
#include "symbolic/model.h"

namespace qvgen::derive::loops {

using GiNaC::ex;
using inverse::Screw;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;
using Turn = inverse::Scope::Turn;

/// The plane of a leg: a x + b y + a wave of the platform's turn = 0.
struct Solver::Plane {
  ex a, b;
  Wave rest;
};

std::optional<Solver::Swing> Solver::swing_of(const Cycle& cycle) const {
  if (cycle.type != model::LoopType::ball || cycle.normal) return std::nullopt;
  for (const Side& side : cycle.sides) {
    Swing swing{&cycle, {}, {}};
    for (const std::size_t joint : unknown(cycle)) {
      const Place at = place_of(cycle, joint);
      (at.side == &side ? swing.leg : swing.held).push_back(joint);
    }
    if (swing.leg.size() == 2 && holds_platform(swing) && swings_in_plane(swing)) return swing;
  }
  return std::nullopt;
}

/// True if the open joints behind a leg are two slides in front of a turn.
bool Solver::holds_platform(const Swing& swing) const {
  if (swing.held.size() != 3) return false;
  std::vector<Place> places;
  for (const std::size_t joint : swing.held) places.push_back(place_of(*swing.cycle, joint));
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.index < b.index; });
  return !turns(places[0].joint) && !turns(places[1].joint) && turns(places[2].joint);
}

/// True if the two joints of a leg move its end in a plane across the axis of one of them.
bool Solver::swings_in_plane(const Swing& swing) const {
  const Place a = place_of(*swing.cycle, swing.leg[0]), b = place_of(*swing.cycle, swing.leg[1]);
  const Place& first = a.index < b.index ? a : b;
  const Place& second = a.index < b.index ? b : a;
  if (!turns(first.joint) && !turns(second.joint)) return false;
  if (second.index != first.index + 1) return false;
  const Carrier at_zero{robot_, [this](std::size_t joint) { return Turn{turns(joint) ? 1 : 0, 0}; }};
  const Vector own = symbolic::to_symbolic(robot_.joints[first.joint].axis);
  const Vector other = at_zero.lifted_direction(
      *second.side, second.index, symbolic::to_symbolic(robot_.joints[second.joint].axis), first.index);
  const bool both_turn = turns(first.joint) && turns(second.joint);
  return both_turn ? scope_.is_zero(cross(own, other)) : scope_.is_zero(dot(own, other));
}

Solver::Plane Solver::plane_of(const Swing& swing, const PlatformJoints& platform) {
  const Cycle& cycle = *swing.cycle;
  const std::size_t turning = turns(swing.leg[0]) ? swing.leg[0] : swing.leg[1];
  const Place leg = place_of(cycle, turning);
  Values zero{{platform.x, {0, 0}}, {platform.y, {0, 0}}};
  for (const std::size_t joint : swing.leg) zero[joint] = {turns(joint) ? 1 : 0, 0};
  const auto direction = [&](std::size_t joint) {
    const Place at = place_of(cycle, joint);
    const Vector axis = symbolic::to_symbolic(robot_.joints[joint].axis);
    return carrier_at(zero).lifted_direction(*at.side, at.index, axis, -1);
  };
  const Vector normal = kept(direction(turning));
  const Wave rest = wave([&](const Turn& value) {
    Values values = zero;
    values[platform.turn] = value;
    const Carrier at = carrier_at(values);
    return ex(dot(normal, at.end(*leg.other, -1) - at.end(*leg.side, -1)));
  });
  return {kept(dot(normal, direction(platform.x))),
          kept(dot(normal, direction(platform.y))),
          {kept(rest[0]), kept(rest[1]), kept(rest[2])}};
}

std::string Solver::three_planes(const std::array<Swing, 3>& swings) {
  std::vector<std::size_t> joints = swings[0].held;
  std::stable_partition(joints.begin(), joints.end(), [&](std::size_t joint) { return !turns(joint); });
  const PlatformJoints platform{joints[0], joints[1], joints[2]};
  std::vector<Plane> planes;
  std::string text = "loops ";
  for (const Swing& swing : swings) {
    text += (planes.empty() ? "" : planes.size() == 2 ? " and " : ", ") + std::to_string(swing.cycle->number);
    planes.push_back(plane_of(swing, platform));
  }
  text += ": the legs stay in their planes";
  // Minors of the slides' coefficients; the sum of the planes with them as factors is free of the slides.
  std::array<ex, 3> minors;
  for (std::size_t i = 0; i < 3; ++i) {
    const Plane &next = planes[(i + 1) % 3], &last = planes[(i + 2) % 3];
    minors[i] = kept(next.a * last.b - next.b * last.a);
  }
  Wave sum{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) sum[k] += minors[i] * planes[i].rest[k];
  const Screw turn = screw_of(platform.turn);
  builder_.turn_by_line(turn, {kept(sum[1]), kept(sum[2])}, kept(-sum[0]), text);
  know(platform.turn);
  std::size_t i = 0;
  while (i < 3 && scope_.is_zero(minors[i])) ++i;
  if (i == 3) return text + " that are all parallel";
  const Turn at = builder_.value(turn);
  const auto rest = [&](const Plane& plane) {
    return kept(plane.rest[0] + plane.rest[1] * at.cosine + plane.rest[2] * at.sine);
  };
  const Plane &next = planes[(i + 1) % 3], &last = planes[(i + 2) % 3];
  const ex first = rest(next), second = rest(last);
  builder_.slide_by_value(screw_of(platform.x), (next.b * second - last.b * first) / minors[i], text);
  know(platform.x);
  builder_.slide_by_value(screw_of(platform.y), (last.a * first - next.a * second) / minors[i], text);
  know(platform.y);
  for (const Swing& swing : swings)
    if (const std::string problem = meeting(*swing.cycle); !problem.empty()) return problem;
  return "";
}

}  // namespace qvgen::derive::loops
