// SPDX-License-Identifier: MIT
#include "derive/kinematics/turns.h"

#include "symbolic/model.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

bool is_identity(const Quaternion& q) {
  return (q.w - 1).expand().is_zero() && q.x.is_zero() && q.y.is_zero() && q.z.is_zero();
}

/// The angle of q as a rotation about that axis, if it is a multiple of 30 degrees.
std::optional<ex> angle_about(const Quaternion& q, const Vector& axis) {
  for (int k = -5; k <= 6; ++k) {
    const ex angle = GiNaC::Pi * k / 6;
    const Quaternion candidate = rotation(axis, angle);
    const ex difference[] = {q.w - candidate.w, q.x - candidate.x, q.y - candidate.y, q.z - candidate.z};
    bool equal = true;
    for (const ex& component : difference) equal = equal && component.expand().is_zero();
    if (equal) return angle;
  }
  return std::nullopt;
}

}  // namespace

TurnSequence turn_sequence(const ZeroReferenceChain& chain) {
  TurnSequence sequence{{}, chain.home};
  for (const auto& joint : chain.joints) {
    if (joint.type != model::JointType::revolute) continue;
    const ex variable = symbol(joint.variable);
    const int sign = sequence.turns.empty() ? 0 : parallel(sequence.turns.back().axis, joint.axis);
    if (sign != 0)
      sequence.turns.back().angle += sign * variable;
    else
      sequence.turns.push_back({joint.axis, variable});
  }
  if (sequence.turns.empty() || is_identity(chain.home)) return sequence;
  if (const auto angle = angle_about(chain.home, sequence.turns.back().axis)) {
    sequence.turns.back().angle += *angle;
    sequence.home = {};
  }
  return sequence;
}

bool is_euler_triple(const std::vector<Turn>& turns, std::size_t i) {
  return i + 2 < turns.size() && parallel(turns[i].axis, turns[i + 2].axis) != 0 &&
         perpendicular(turns[i].axis, turns[i + 1].axis);
}

Quaternion euler_triple(const Turn& first, const Turn& second, const Turn& third) {
  const Vector& a = first.axis;
  const Vector& b = second.axis;
  const ex gamma = parallel(a, third.axis) * third.angle;
  const ex c = GiNaC::cos(second.angle / 2);
  const ex s = GiNaC::sin(second.angle / 2);
  const ex sum = (first.angle + gamma) / 2;
  const ex difference = (gamma - first.angle) / 2;
  const Vector vector = (c * GiNaC::sin(sum)) * a + (s * GiNaC::cos(difference)) * b +
                        (s * GiNaC::sin(difference)) * cross(b, a);
  return {c * GiNaC::cos(sum), vector.x, vector.y, vector.z};
}

namespace {

Quaternion plus(const Quaternion& a, const Quaternion& b) {
  return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z};
}
Quaternion times(const ex& s, const Quaternion& q) { return {s * q.w, s * q.x, s * q.y, s * q.z}; }

/// One choice (bit k of `sines`: the k-th perpendicular turn gives its sine). q_a(x) b = b q_a(-x) carries
/// all rotations about the axis to the end.
Quaternion angle_sum_term(const std::vector<Turn>& turns, const Vector& axis, unsigned sines) {
  ex coefficient = 1;
  ex angle = 0;
  Quaternion units;
  for (const Turn& turn : turns) {
    const int sign = parallel(axis, turn.axis);
    if (sign != 0) {
      angle += sign * turn.angle;
      continue;
    }
    if ((sines & 1U) != 0) {
      coefficient *= GiNaC::sin(turn.angle / 2);
      units = units * Quaternion{0, turn.axis.x, turn.axis.y, turn.axis.z};
      angle = -angle;
    } else {
      coefficient *= GiNaC::cos(turn.angle / 2);
    }
    sines >>= 1U;
  }
  return times(coefficient, units * rotation(axis, angle));
}

}  // namespace

std::optional<Quaternion> angle_sum_product(const std::vector<Turn>& turns, const Vector& axis,
                                            std::size_t most) {
  std::size_t across = 0;
  for (const Turn& turn : turns) {
    if (parallel(axis, turn.axis) != 0) continue;
    if (!perpendicular(axis, turn.axis)) return std::nullopt;
    ++across;
  }
  if (across > most) return std::nullopt;
  Quaternion sum{0, 0, 0, 0};
  for (unsigned choice = 0; choice < (1U << across); ++choice)
    sum = plus(sum, angle_sum_term(turns, axis, choice));
  return sum;
}

Vector turned(const Turn& turn, const Vector& v) {
  const Vector along = dot(turn.axis, v).expand() * turn.axis;
  const Vector across = v - along;
  const Vector flat{across.x.expand(), across.y.expand(), across.z.expand()};
  return along + GiNaC::cos(turn.angle) * flat + GiNaC::sin(turn.angle) * cross(turn.axis, v);
}

}  // namespace qvgen::derive
