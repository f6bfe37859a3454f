// SPDX-License-Identifier: MIT
#include "derive/loops/in_space.h"

#include "derive/loops/along_side.h"

namespace qvgen::derive::loops {
namespace {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Program;
using symbolic::Vector;
using symbolic::operator*;
using symbolic::operator+;
using symbolic::operator-;

/// Both sides of a closure, and the directions of the first link in which it is written.
class Closed {
 public:
  Closed(const model::Robot& robot, const Cycle& cycle, bool moves, Program& program)
      : program_(program),
        slides_(cycle.type == model::LoopType::slide),
        sides_{AlongSide(robot, cycle.sides[0], moves, program),
               AlongSide(robot, cycle.sides[1], moves, program)},
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
    const MovingFrame &a = sides_[0].end(), &b = sides_[1].end();
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
    for (const PassedJoint& place : sides_[side].joints()) {
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
  std::array<AlongSide, 2> sides_;
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
