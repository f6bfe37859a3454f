// SPDX-License-Identifier: MIT
#include "derive/loops/along_side.h"

#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::loops {
namespace {

using GiNaC::ex;
using symbolic::cross;
using symbolic::Matrix3;
using symbolic::Program;
using symbolic::symbol;
using symbolic::Vector;
using symbolic::operator*;
using symbolic::operator+;
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

}  // namespace

AlongSide::AlongSide(const model::Robot& robot, const Side& side, bool moves, Program& program)
    : robot_(robot), moves_(moves), program_(program) {
  for (const std::size_t joint : side.joints) pass(joint);
  go(side.point);
}

Vector AlongSide::seen(const Vector& direction) const { return program_.let(at_.turn * direction); }

void AlongSide::pass(std::size_t index) {
  const model::Joint& joint = robot_.joints[index];
  const bool turns = joint.type == model::JointType::revolute;
  displace(joint.before);
  const Vector own = symbolic::to_symbolic(joint.axis);
  const Vector axis = program_.let(at_.turn * own);
  joints_.push_back({index, turns, axis, at_.point, {}});
  const ex rate = moves_ ? ex(symbol("rate_" + joint.variable)) : ex(0);
  if (turns)
    turn(joint.variable, own, axis, rate);
  else
    slide(joint.variable, axis, rate);
  displace(joint.after);
}

void AlongSide::turn(const std::string& variable, const Vector& own, const Vector& axis, const ex& rate) {
  at_.turn = program_.let(at_.turn *
                          turn_about(own, symbol(names::cosine(variable)), symbol(names::sine(variable))));
  if (!moves_) return;
  const Vector by = program_.let(rate * axis);
  at_.spin_rate = program_.let(at_.spin_rate + cross(at_.spin, by));
  at_.spin = program_.let(at_.spin + by);
}

void AlongSide::slide(const std::string& variable, const Vector& axis, const ex& rate) {
  go_by(program_.let(symbol(variable) * axis));
  if (!moves_) return;
  const Vector by = program_.let(rate * axis);
  at_.acceleration = program_.let(at_.acceleration + ex(2) * cross(at_.spin, by));
  at_.velocity = program_.let(at_.velocity + by);
}

void AlongSide::displace(const model::Displacement& displacement) {
  const symbolic::Pair pair = symbolic::to_symbolic(displacement);
  go(pair.p);
  if (displacement.turns.empty()) return;
  Matrix3 constant = symbolic::to_matrix(pair.q);
  for (auto& row : constant)
    for (ex& entry : row) entry = entry.expand();
  at_.turn = program_.let(at_.turn * constant);
}

void AlongSide::go(const Vector& by) {
  if (by.x.is_zero() && by.y.is_zero() && by.z.is_zero()) return;
  go_by(program_.let(at_.turn * by));
}

void AlongSide::go_by(const Vector& by) {
  at_.point = program_.let(at_.point + by);
  if (!joints_.empty()) joints_.back().to_next = joints_.back().to_next + by;
  if (!moves_) return;
  const Vector velocity = program_.let(cross(at_.spin, by));
  at_.velocity = program_.let(at_.velocity + velocity);
  at_.acceleration = program_.let(at_.acceleration + cross(at_.spin_rate, by) + cross(at_.spin, velocity));
}

}  // namespace qvgen::derive::loops
