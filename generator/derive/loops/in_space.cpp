// SPDX-License-Identifier: MIT
#include "derive/loops/in_space.h"

#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::loops {
namespace {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Matrix3;
using symbolic::Program;
using symbolic::symbol;
using symbolic::Vector;
using symbolic::operator*;
using symbolic::operator+;
using symbolic::operator-;
namespace names = inverse::names;

/// Rotation about a unit vector by an angle, given by its cosine and sine.
Matrix3 turn_about(const Vector& axis, const ex& cosine, const ex& sine) {
  const std::array<ex, 3> a{axis.x, axis.y, axis.z};
  Matrix3 m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = a[i] * a[j] * (1 - cosine) + (i == j ? cosine : ex(0));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
    m[next][i] += a[last] * sine;
    m[i][next] -= a[last] * sine;
  }
  // Along a coordinate axis nothing turns: 1 - c + c.
  for (auto& row : m)
    for (ex& entry : row) entry = entry.expand();
  return m;
}

/// A joint on the way along a side, in the common link's frame.
struct Place {
  std::size_t joint;
  bool turns;
  Vector axis, point;
};

/// A frame on the way along a side: where it is, and how it moves at the rates of the joints.
struct Frame {
  Matrix3 turn{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vector point;
  Vector spin, spin_rate;         ///< angular velocity, and its derivative without joint accelerations
  Vector velocity, acceleration;  ///< of the point, likewise
};

/// Goes along a side; `moves`: with rates.
class Walk {
 public:
  Walk(const model::Robot& robot, const Side& side, bool moves, Program& program)
      : robot_(robot), moves_(moves), program_(program) {
    for (const std::size_t joint : side.joints) pass(joint);
    go(side.point);
  }

  [[nodiscard]] const std::vector<Place>& places() const { return places_; }
  [[nodiscard]] const Frame& end() const { return at_; }
  /// A direction of the last link in the common link's frame.
  [[nodiscard]] Vector seen(const Vector& direction) const { return program_.let(at_.turn * direction); }

 private:
  void pass(std::size_t index) {
    const model::Joint& joint = robot_.joints[index];
    const bool turns = joint.type == model::JointType::revolute;
    displace(joint.before);
    const Vector own = symbolic::to_symbolic(joint.axis);
    const Vector axis = program_.let(at_.turn * own);
    places_.push_back({index, turns, axis, at_.point});
    const ex rate = moves_ ? ex(symbol("rate_" + joint.variable)) : ex(0);
    if (turns)
      turn(joint.variable, own, axis, rate);
    else
      slide(joint.variable, axis, rate);
    displace(joint.after);
  }

  void turn(const std::string& variable, const Vector& own, const Vector& axis, const ex& rate) {
    at_.turn = program_.let(at_.turn *
                            turn_about(own, symbol(names::cosine(variable)), symbol(names::sine(variable))));
    if (!moves_) return;
    const Vector by = program_.let(rate * axis);
    at_.spin_rate = program_.let(at_.spin_rate + cross(at_.spin, by));
    at_.spin = program_.let(at_.spin + by);
  }

  void slide(const std::string& variable, const Vector& axis, const ex& rate) {
    go_by(program_.let(symbol(variable) * axis));
    if (!moves_) return;
    const Vector by = program_.let(rate * axis);
    at_.acceleration = program_.let(at_.acceleration + ex(2) * cross(at_.spin, by));
    at_.velocity = program_.let(at_.velocity + by);
  }

  void displace(const model::Displacement& displacement) {
    const symbolic::Pair pair = symbolic::to_symbolic(displacement);
    go(pair.p);
    if (displacement.turns.empty()) return;
    Matrix3 constant = symbolic::to_matrix(pair.q);
    for (auto& row : constant)
      for (ex& entry : row) entry = entry.expand();
    at_.turn = program_.let(at_.turn * constant);
  }

  /// Goes on by a vector of the link.
  void go(const Vector& by) {
    if (by.x.is_zero() && by.y.is_zero() && by.z.is_zero()) return;
    go_by(program_.let(at_.turn * by));
  }
  /// Likewise by one in the common link's frame that turns with the link.
  void go_by(const Vector& by) {
    at_.point = program_.let(at_.point + by);
    if (!moves_) return;
    const Vector velocity = program_.let(cross(at_.spin, by));
    at_.velocity = program_.let(at_.velocity + velocity);
    at_.acceleration = program_.let(at_.acceleration + cross(at_.spin_rate, by) + cross(at_.spin, velocity));
  }

  const model::Robot& robot_;
  bool moves_;
  Program& program_;
  Frame at_;
  std::vector<Place> places_;
};

/// Both sides of a closure, and the directions of the first link in which it is written.
class Closed {
 public:
  Closed(const model::Robot& robot, const Cycle& cycle, bool moves, Program& program)
      : program_(program),
        slides_(cycle.type == model::LoopType::slide),
        sides_{Walk(robot, cycle.sides[0], moves, program), Walk(robot, cycle.sides[1], moves, program)},
        way_(program.let(sides_[0].end().point - sides_[1].end().point)) {
    for (std::size_t k = 0; k < 3; ++k) {
      first_[k] = sides_[0].seen(cycle.directions[k][0]);
      second_[k] = sides_[1].seen(cycle.directions[k][1]);
    }
  }

  std::vector<ex> gaps() {
    std::vector<ex> result = slides_ ? std::vector<ex>{dot(first_[1], way_), dot(first_[2], way_)}
                                     : std::vector<ex>{way_.x, way_.y, way_.z};
    const Vector half = half_turn();
    for (const ex& each : {half.x, half.y, half.z}) result.push_back(2 * each);
    return result;
  }

  std::vector<std::vector<ex>> jacobian(std::size_t joints) {
    std::vector<std::vector<ex>> rows(slides_ ? 5 : 6, std::vector<ex>(joints, 0));
    const Vector half = half_turn();
    for (std::size_t side = 0; side < 2; ++side) add_columns(side, half, rows);
    return rows;
  }

  std::vector<ex> bias() {
    const Frame &a = sides_[0].end(), &b = sides_[1].end();
    const Vector rate = program_.let(a.velocity - b.velocity);
    const Vector second = program_.let(a.acceleration - b.acceleration);
    const Vector spin = program_.let(a.spin - b.spin), spin_rate = program_.let(a.spin_rate - b.spin_rate);
    std::vector<ex> result{second.x, second.y, second.z};
    std::vector<ex> turns;
    if (slides_) result.clear();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector turned = program_.let(cross(a.spin, first_[k]));
      turns.push_back(dot(first_[k], spin_rate) + dot(turned, spin));
      if (!slides_ || k == 0) continue;
      const Vector twice = cross(a.spin_rate, first_[k]) + cross(a.spin, turned);
      result.push_back(dot(first_[k], second) + 2 * dot(turned, rate) + dot(twice, way_));
    }
    result.insert(result.end(), turns.begin(), turns.end());
    return result;
  }

 private:
  /// The tangent of half the angle by which the first link is turned against the second, times the axis.
  Vector half_turn() {
    const auto entry = [&](std::size_t i, std::size_t j) { return dot(first_[i], second_[j]); };
    const ex sum = program_.let(1 + entry(0, 0) + entry(1, 1) + entry(2, 2));
    const auto part = [&](std::size_t i, std::size_t j) {
      return program_.let(program_.let(entry(i, j) - entry(j, i)) / sum);
    };
    return {part(1, 2), part(2, 0), part(0, 1)};
  }

  void add_columns(std::size_t side, const Vector& half, std::vector<std::vector<ex>>& rows) {
    const ex sign = side == 0 ? 1 : -1;
    const Vector& end = sides_[side].end().point;
    for (const Place& place : sides_[side].places()) {
      const Vector moved = place.turns ? program_.let(cross(place.axis, end - place.point)) : place.axis;
      std::size_t row = 0;
      const auto put = [&](const ex& value) { rows[row++][place.joint] = sign * value; };
      if (!slides_)
        for (const ex& each : {moved.x, moved.y, moved.z}) put(each);
      for (std::size_t k = 1; slides_ && k < 3; ++k) {
        ex value = dot(first_[k], moved);
        if (place.turns && side == 0) value += dot(program_.let(cross(place.axis, first_[k])), way_);
        put(value);
      }
      if (!place.turns) continue;
      const Vector spin = program_.let(
          Vector{dot(first_[0], place.axis), dot(first_[1], place.axis), dot(first_[2], place.axis)});
      const ex along = program_.let(dot(half, spin));
      const Vector rate = spin + along * half + cross(half, spin);
      for (const ex& each : {rate.x, rate.y, rate.z}) put(each);
    }
  }

  Program& program_;
  bool slides_;
  std::array<Walk, 2> sides_;
  Vector way_;
  std::array<Vector, 3> first_, second_;
};

}  // namespace

bool is_rigid_in_space(const Cycle& cycle) { return !cycle.normal && cycle.directions.size() == 3; }

std::vector<ex> gaps_in_space(const model::Robot& robot, const Cycle& cycle, Program& program) {
  return Closed(robot, cycle, false, program).gaps();
}

std::vector<std::vector<ex>> jacobian_in_space(const model::Robot& robot, const Cycle& cycle,
                                               Program& program) {
  return Closed(robot, cycle, false, program).jacobian(robot.joints.size());
}

std::vector<ex> bias_in_space(const model::Robot& robot, const Cycle& cycle, Program& program) {
  return Closed(robot, cycle, true, program).bias();
}

}  // namespace qvgen::derive::loops
