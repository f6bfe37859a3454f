// SPDX-License-Identifier: MIT
#include "verify/inverse/certify.h"

#include "derive/inverse/inverse.h"
#include "derive/inverse/names.h"
#include "exact/named_constant.h"
#include "model/evaluate.h"
#include "verify/certificate.h"
#include "verify/inverse/definition.h"
#include "verify/inverse/execute.h"

namespace qvgen::verify {

namespace names = derive::inverse::names;
namespace {

using derive::inverse::LoweredPlan;

/// That a row is right its pose says, to fifty digits. Which of the rows it is, joints next to a singular
/// structure, axes nearly in line, tell with fewer.
constexpr double forty_digits = 1e-40;

/// Differences of two poses and of two joint vectors, orientations up to sign, angles up to whole turns.
double difference(const Pair& a, const Pair& b, model::Task task) {
  Real worst(0);
  const bool position = task != model::Task::direction && task != model::Task::orientation;
  const bool orientation = task != model::Task::position;
  for (std::size_t i = 0; position && i < 3; ++i)
    worst = abs(a.p[i] - b.p[i]) > worst ? abs(a.p[i] - b.p[i]) : worst;
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
    values[names::pose_quaternion + std::string(parts[i])] = pose.q[i];
    values[names::pose_given + std::string(parts[i])] = pose.q[i];
  }
  values[names::pose_scale] = Real(1);
  for (std::size_t i = 0; i < 3; ++i) values[names::pose_position + std::string(parts[i + 1])] = pose.p[i];
  return values;
}

}  // namespace

std::string InverseCertificate::text() const {
  return "Checked in 60 digits at " + std::to_string(poses) + " random poses: the " +
         std::to_string(solutions) +
         " solutions give the pose back to 50 digits,\n/// the sampled joints among them.";
}

InverseCertificate certify_inverse(const model::Robot& robot, const LoweredPlan& plan, int poses,
                                   model::Task task) {
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
    const std::vector<Row> rows = execute(plan, values);
    bool sampled = false;
    for (const Row& row : rows) {
      if (difference(definition.pose(row.q), pose, task) > fifty_digits) {
        if (plan.plan.candidates) continue;
        throw CertificateError("inverse kinematics: a solution does not give the pose back");
      }
      ++certificate.solutions;
      sampled = sampled || difference(robot, row.q, q) < forty_digits;
    }
    if (!sampled)
      throw CertificateError("inverse kinematics: the sampled joints are not among the solutions");
    ++certificate.poses;
  }
  return certificate;
}

}  // namespace qvgen::verify
