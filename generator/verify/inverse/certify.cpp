// SPDX-License-Identifier: MIT
#include "verify/inverse/certify.h"

#include "derive/inverse/inverse.h"
#include "exact/named_constant.h"
#include "model/evaluate.h"
#include "verify/certificate.h"
#include "verify/inverse/execute.h"

namespace qvgen::verify {
namespace {

using derive::inverse::LoweredPlan;
using Quaternion = std::array<Real, 4>;
using Vector = std::array<Real, 3>;

struct Pair {
  Quaternion q{1, 0, 0, 0};
  Vector p{0, 0, 0};
};

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Quaternion conjugate(const Quaternion& q) { return {q[0], -q[1], -q[2], -q[3]}; }

Pair operator*(const Pair& a, const Pair& b) {
  const Quaternion turned = product(product(a.q, {0, b.p[0], b.p[1], b.p[2]}), conjugate(a.q));
  return {product(a.q, b.q), {a.p[0] + turned[1], a.p[1] + turned[2], a.p[2] + turned[3]}};
}

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
  [[nodiscard]] Pair pair(const model::Displacement& displacement) const {
    Pair result;
    for (const model::Turn& each : displacement.turns)
      result.q = product(result.q, turn(vector(each.axis), value(each.angle)));
    result.p = vector(displacement.translation);
    return result;
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

/// Differences of two poses and of two joint vectors, orientations up to sign, angles up to whole turns.
double difference(const Pair& a, const Pair& b, bool orientation) {
  Real worst(0);
  for (std::size_t i = 0; i < 3; ++i) worst = abs(a.p[i] - b.p[i]) > worst ? abs(a.p[i] - b.p[i]) : worst;
  const Quaternion between = product(conjugate(a.q), b.q);
  for (std::size_t i = 1; orientation && i < 4; ++i)
    worst = abs(between[i]) > worst ? abs(between[i]) : worst;
  return worst.to_double();
}

double difference(const model::Robot& robot, const std::vector<Real>& a, const std::vector<Real>& b) {
  Real worst(0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Real gap = a[i] - b[i];
    const Real size = robot.joints[i].type == model::JointType::revolute ? abs(sin(gap / Real(2))) : abs(gap);
    worst = size > worst ? size : worst;
  }
  return worst.to_double();
}

Values target(const model::Bindings& geometry, const Pair& pose) {
  Values values;
  for (const auto& [name, value] : geometry) values[name] = Real(value);
  const std::array<const char*, 4> parts = {"_w", "_x", "_y", "_z"};
  for (std::size_t i = 0; i < 4; ++i) {
    values[derive::inverse::pose_quaternion + std::string(parts[i])] = pose.q[i];
    values[derive::inverse::pose_given + std::string(parts[i])] = pose.q[i];
  }
  values[derive::inverse::pose_scale] = Real(1);
  for (std::size_t i = 0; i < 3; ++i)
    values[derive::inverse::pose_position + std::string(parts[i + 1])] = pose.p[i];
  return values;
}

}  // namespace

std::string InverseCertificate::text() const {
  return "Checked in 60 digits at " + std::to_string(poses) + " random poses: the " +
         std::to_string(solutions) +
         " solutions give the pose back to 50 digits,\n/// the sampled joints among them.";
}

InverseCertificate certify_inverse(const model::Robot& robot, const LoweredPlan& plan, int poses) {
  InverseCertificate certificate;
  Numbers numbers;
  for (int k = 0; k < poses; ++k) {
    model::Bindings geometry = model::default_bindings(robot);
    for (const auto& parameter : robot.geometry)
      if (geometry.count(parameter.name) == 0) geometry[parameter.name] = numbers.between(1, 2);
    for (const std::string& name : model::symbols(robot))
      if (const auto constant = exact::named_value(name)) geometry[name] = *constant;
    for (const auto& [name, definition] : robot.definitions)
      geometry[name] = model::evaluate(definition, geometry);
    std::vector<Real> q;
    for (std::size_t i = 0; i < robot.joints.size(); ++i) q.emplace_back(cln::cl_R(numbers.between(-3, 3)));
    const Definition definition(robot, geometry);
    const Pair pose = definition.pose(q);
    Values values = target(geometry, pose);
    if (plan.plan.locked >= 0) {
      const Real locked = q[static_cast<std::size_t>(plan.plan.locked)];
      values[std::string("cos_") + derive::inverse::locked_joint] = cos(locked);
      values[std::string("sin_") + derive::inverse::locked_joint] = sin(locked);
    }
    const std::vector<Row> rows = execute(plan, values);
    bool sampled = false;
    for (const Row& row : rows) {
      if (difference(definition.pose(row.q), pose, !plan.plan.position_only) > fifty_digits)
        throw CertificateError("inverse kinematics: a solution does not give the pose back");
      sampled = sampled || difference(robot, row.q, q) < fifty_digits;
    }
    if (!sampled)
      throw CertificateError("inverse kinematics: the sampled joints are not among the solutions");
    ++certificate.poses;
    certificate.solutions += static_cast<int>(rows.size());
  }
  return certificate;
}

}  // namespace qvgen::verify
