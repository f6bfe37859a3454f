// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "model/evaluate.h"
#include "verify/inverse/real.h"

/// Forward kinematics in sixty digits as the description says it, which shares nothing with derivations.
namespace qvgen::verify {

using Quaternion = std::array<Real, 4>;
using Vector = std::array<Real, 3>;

struct Pair {
  Quaternion q{1, 0, 0, 0};
  Vector p{0, 0, 0};
};

inline Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

inline Quaternion conjugate(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }

inline Pair operator*(const Pair& a, const Pair& b) {
  const Quaternion turned = product(product(a.q, {0, b.p[0], b.p[1], b.p[2]}), conjugate(a.q));
  return {product(a.q, b.q), {a.p[0] + turned[1], a.p[1] + turned[2], a.p[2] + turned[3]}};
}

inline Pair inverse(const Pair& pair) {
  const Pair turned_back{conjugate(pair.q), {}};
  const Pair moved = turned_back * Pair{{1, 0, 0, 0}, pair.p};
  return {turned_back.q, {-moved.p[0], -moved.p[1], -moved.p[2]}};
}

/// The tool's pose by multiplying the description's displacements.
class Definition {
 public:
  Definition(const model::Robot& robot, const model::Bindings& geometry)
      : robot_(robot), geometry_(geometry) {}

  [[nodiscard]] Pair pose(const std::vector<Real>& q) const {
    Pair pose = pair(robot_.base);
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      const model::Joint& joint = robot_.joints[i];
      const Vector axis = vector(joint.axis);
      Pair motion;
      if (joint.type == model::JointType::revolute)
        motion.q = turn(axis, q[i]);
      else
        motion.p = {axis[0] * q[i], axis[1] * q[i], axis[2] * q[i]};
      pose = pose * pair(joint.before) * motion * pair(joint.after);
    }
    return pose * pair(robot_.tool);
  }

  [[nodiscard]] Pair pair(const model::Displacement& displacement) const {
    Pair result;
    for (const model::Turn& each : displacement.turns)
      result.q = product(result.q, turn(vector(each.axis), value(each.angle)));
    result.p = vector(displacement.translation);
    return result;
  }

 private:
  [[nodiscard]] Real value(const model::Expression& e) const { return Real(model::evaluate(e, geometry_)); }
  [[nodiscard]] Vector vector(const model::Vector3& v) const {
    return {value(v[0]), value(v[1]), value(v[2])};
  }
  static Quaternion turn(const Vector& axis, const Real& angle) {
    const Real half = angle / Real(2);
    const Real s = sin(half);
    return {cos(half), s * axis[0], s * axis[1], s * axis[2]};
  }

  const model::Robot& robot_;
  const model::Bindings& geometry_;
};

/// A fixed sequence of rationals with four digits.
class Numbers {
 public:
  cln::cl_RA between(int low, int high) {
    state_ = state_ * 6364136223846793005UL + 1442695040888963407UL;
    const auto draw = static_cast<long>((state_ >> 33) % 10007);
    return cln::cl_I(low) + cln::cl_I(draw) * cln::cl_I(high - low) / cln::cl_RA(10007);
  }

 private:
  unsigned long state_ = 2007;
};

}  // namespace qvgen::verify
