// SPDX-License-Identifier: MIT
// Loops that give way together only: each keeps the distance of two points, and several hold the same joints.
// Two distances hold two turns, of an ankle for instance; three hold two slides and a turn, a platform in its
// plane. Either way two equations are left that are linear in two unit vectors (kind::TwoTurns). Their
// coefficients are found by sampling (wave.h).
#include <algorithm>

#include "derive/loops/solver.h"
#include "derive/loops/wave.h"
#include "symbolic/model.h"

namespace qvgen::derive::loops {

using GiNaC::ex;
using inverse::Flat;
using inverse::Screw;
using symbolic::cross;
using symbolic::dot;
using symbolic::Vector;
using Turn = inverse::Scope::Turn;

namespace {

template <class Spans>
std::string names_of(const Spans& spans) {
  std::string text = "loops ";
  for (std::size_t i = 0; i < spans.size(); ++i)
    text += (i == 0 ? "" : i + 1 == spans.size() ? " and " : ", ") + std::to_string(spans[i].cycle->number);
  return text;
}

Flat operator-(const Flat& a, const Flat& b) { return {a.x - b.x, a.y - b.y}; }
ex length_square(const Flat& v) { return v.x * v.x + v.y * v.y; }

}  // namespace

std::vector<std::size_t> Solver::held(const Span& span) const {
  std::vector<std::size_t> joints = unknown(*span.cycle);
  if (span.pivot) std::erase(joints, *span.pivot);
  return joints;
}

Carrier Solver::carrier_at(const Values& values) {
  return {robot_, [this, values](std::size_t joint) -> Turn {
            const auto given = values.find(joint);
            return given != values.end() ? given->second : builder_.value(screw_of(joint));
          }};
}

Solver::Ends Solver::ends(const Span& span, const Values& values) {
  const Carrier at = carrier_at(values);
  const Cycle& cycle = *span.cycle;
  if (!span.pivot)
    return {at.end(cycle.sides[0], -1) - at.end(cycle.sides[1], -1), cycle.length * cycle.length};
  const Place pivot = place_of(cycle, *span.pivot);
  const Vector centre = at.lifted(*pivot.side, pivot.index, Vector{0, 0, 0}, -1);
  const Vector way = centre - at.end(*pivot.other, -1);
  const Vector arm = at.end(*pivot.side, pivot.index);
  return {pivot.side == &cycle.sides[0] ? way : -way, dot(arm, arm)};
}

void Solver::turn_pivot(const Span& span) {
  if (!span.pivot) return;
  const Place at = place_of(*span.cycle, *span.pivot);
  pair(at, "loop " + std::to_string(span.cycle->number) + ": the turn about the axis of " +
               robot_.joints[*span.pivot].variable);
}

std::string Solver::two_turns(const std::array<Span, 2>& spans) {
  const std::vector<std::size_t> joints = held(spans[0]);
  const Screw first = screw_of(joints[0]), second = screw_of(joints[1]);
  inverse::Builder::TwoTurns equations;
  for (std::size_t i = 0; i < 2; ++i) {
    std::array<Wave, 3> rows;  // by the first turn's quarter
    for (std::size_t j = 0; j < 3; ++j)
      rows[j] = wave([&](const Turn& turn) {
        const Ends found = ends(spans[i], {{joints[0], quarter_turns()[j]}, {joints[1], turn}});
        return ex(dot(found.way, found.way) - found.square);
      });
    for (std::size_t k = 0; k < 3; ++k) {
      const Wave column = wave_of({rows[0][k], rows[1][k], rows[2][k]});
      for (std::size_t j = 0; j < 3; ++j) equations[i][3 * j + k] = kept(column[j]);
    }
  }
  const std::string name = "loop_angle_" + std::to_string(spans[0].cycle->number);
  const Turn turn = builder_.two_turns(
      first, name, equations, false,
      names_of(spans) + " keep their lengths: " + first.variable + " and " + second.variable + " together");
  know(joints[0]);
  builder_.turn_by_pair(second, {turn.cosine, turn.sine}, "the same two equations");
  know(joints[1]);
  for (const Span& span : spans) turn_pivot(span);
  return "";
}

/// A platform's place in a span: where the point is that it carries, against the other end, if its slides
/// were at zero, in coordinates along both slides; and the square of the distance there.
struct Solver::Leg {
  std::array<Flat, 3> way;  ///< of 1, cos and sin of the turn
  ex square;
};

Flat Solver::at(const Leg& leg, const Turn& turn) const {
  const auto sum = [&](const ex& one, const ex& c, const ex& s) {
    return ex(one + c * turn.cosine + s * turn.sine);
  };
  return {sum(leg.way[0].x, leg.way[1].x, leg.way[2].x), sum(leg.way[0].y, leg.way[1].y, leg.way[2].y)};
}

std::optional<Solver::Leg> Solver::leg_of(const Span& span, const PlatformJoints& joints) {
  const auto& [x, y, turn] = joints;
  const Place of_x = place_of(*span.cycle, x), of_y = place_of(*span.cycle, y),
              of_turn = place_of(*span.cycle, turn);
  if (of_x.side != of_y.side || of_x.side != of_turn.side || std::max(of_x.index, of_y.index) > of_turn.index)
    return std::nullopt;
  const auto direction = [&](const Place& place) {
    const Vector axis = symbolic::to_symbolic(robot_.joints[place.joint].axis);
    return scope_.clean(carrier().lifted_direction(*place.side, place.index, axis, -1));
  };
  const Vector a = direction(of_x), b = direction(of_y), normal = cross(a, b);
  if (!scope_.is_zero(dot(a, b)) || !scope_.is_zero(cross(direction(of_turn), normal))) return std::nullopt;
  const auto ends_at = [&](const Turn& value) {
    return ends(span, {{x, {0, 0}}, {y, {0, 0}}, {turn, value}});
  };
  const ex sign = of_x.side == &span.cycle->sides[0] ? 1 : -1;
  const auto along = [&](const Vector& d) {
    return wave([&](const Turn& value) { return ex(sign * dot(d, ends_at(value).way)); });
  };
  const Wave by_a = along(a), by_b = along(b), height = along(normal);
  const Wave squares = wave([&](const Turn& value) { return ends_at(value).square; });
  if (!scope_.is_zero(squares[1]) || !scope_.is_zero(squares[2])) return std::nullopt;
  Leg leg{{}, kept(squares[0] - height[0] * height[0])};
  for (std::size_t k = 0; k < 3; ++k) leg.way[k] = {kept(by_a[k]), kept(by_b[k])};
  return leg;
}

std::string Solver::planar_platform(const std::array<Span, 3>& spans) {
  std::vector<std::size_t> joints = held(spans[0]);
  std::stable_partition(joints.begin(), joints.end(), [&](std::size_t joint) { return !turns(joint); });
  const PlatformJoints platform{joints[0], joints[1], joints[2]};
  std::vector<Leg> legs;
  for (const Span& span : spans) {
    const auto leg = leg_of(span, platform);
    if (!leg)
      return names_of(spans) +
             " hold a platform whose slides are not at right angles to each other and to "
             "the axis of its turn, or do not come before it";
    legs.push_back(*leg);
  }
  // The first point is on a circle: (x, y) + way_1 = radius (cos, sin) of an angle, which the other two hold.
  const ex radius = kept(GiNaC::sqrt(legs[0].square));
  inverse::Builder::TwoTurns equations;
  for (std::size_t i = 1; i < 3; ++i) {
    Leg off = legs[i];
    for (std::size_t k = 0; k < 3; ++k) off.way[k] = off.way[k] - legs[0].way[k];
    Wave level = wave([&](const Turn& value) { return length_square(at(off, value)); });
    level[0] += legs[0].square - legs[i].square;
    for (std::size_t k = 0; k < 3; ++k) {
      equations[i - 1][3 * k] = kept(level[k]);
      equations[i - 1][3 * k + 1] = kept(2 * radius * off.way[k].x);
      equations[i - 1][3 * k + 2] = kept(2 * radius * off.way[k].y);
    }
  }
  const std::string name = "loop_angle_" + std::to_string(spans[0].cycle->number);
  const std::string text = names_of(spans) + " hold a platform in its plane";
  const Screw turn = screw_of(platform.turn);
  const Turn angle = builder_.two_turns(turn, name, equations, true, text);
  know(platform.turn);
  const Flat first = at(legs[0], builder_.value(turn));
  builder_.slide_by_value(screw_of(platform.x), radius * angle.cosine - first.x, text);
  know(platform.x);
  builder_.slide_by_value(screw_of(platform.y), radius * angle.sine - first.y, text);
  know(platform.y);
  for (const Span& span : spans) turn_pivot(span);
  return "";
}

}  // namespace qvgen::derive::loops
