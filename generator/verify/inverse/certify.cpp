// SPDX-License-Identifier: MIT
#include "verify/inverse/certify.h"

#include "derive/inverse/inverse.h"
#include "derive/inverse/names.h"
#include "exact/named_constant.h"
#include "model/evaluate.h"
#include "model/tasks.h"
#include "verify/certificate.h"
#include "verify/inverse/but_heading.h"
#include "verify/inverse/described_arm.h"
#include "verify/inverse/execute.h"

namespace qvgen::verify {

namespace names = derive::inverse::names;
namespace {

using derive::inverse::LoweredPlan;
using derive::inverse::Problem;

/// Digits to which a row's joints are compared. Its pose is compared to fifty digits; joints next to a
/// singular structure, axes nearly in line, have fewer.
constexpr double forty_digits = 1e-40;

bool asks_for_position(model::Task task) {
  return task != model::Task::direction && task != model::Task::orientation;
}
bool asks_for_orientation(model::Task task) { return task != model::Task::position; }

/// Returns a pose as the functions for a task see it, with zeros in place of what the task leaves open. The
/// rest of the orientation is a joint of the problem's.
Pair asked(Pair pose, model::Task task) {
  if (!asks_for_position(task)) pose.p = {0, 0, 0};
  if (!asks_for_orientation(task)) pose.q = {1, 0, 0, 0};
  return pose;
}

/// Differences of two poses and of two joint vectors, orientations up to sign, angles up to whole turns.
double difference(const Pair& a, const Pair& b, model::Task task) {
  Real worst(0);
  for (std::size_t i = 0; asks_for_position(task) && i < 3; ++i)
    worst = abs(a.p[i] - b.p[i]) > worst ? abs(a.p[i] - b.p[i]) : worst;
  const Quaternion between = product(conjugate(a.q), b.q);
  for (std::size_t i = 1; asks_for_orientation(task) && i < 4; ++i)
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

/// Random joints. Of those that are balanced the last one keeps the balance.
std::vector<Real> sampled_joints(const Problem& problem, Numbers& numbers) {
  std::vector<Real> q;
  for (int i = 0; i < problem.row_size; ++i) q.emplace_back(cln::cl_R(numbers.between(-3, 3)));
  if (problem.balance.empty()) return q;
  const auto [kept, own_sense] = problem.balance.turns.back();
  Real sum(0);
  for (const auto& [place, sense] : problem.balance.turns)
    if (place != kept) sum = sum + Real(sense) * q[static_cast<std::size_t>(place)];
  q[static_cast<std::size_t>(kept)] = Real(-own_sense) * sum;
  return q;
}

/// Random values of the symbols without default, and those of the names that stand for constants and for what
/// is made of symbols.
model::Bindings sampled_geometry(const Problem& problem, Numbers& numbers) {
  model::Bindings geometry = model::default_bindings(problem.described);
  for (const auto& parameter : problem.described.geometry)
    if (geometry.count(parameter.name) == 0) geometry[parameter.name] = numbers.between(1, 2);
  model::Robot with_frames = problem.moving;
  if (problem.has_frames) {
    with_frames.base = problem.base;
    with_frames.tool = problem.tool;
  }
  for (const model::Robot* robot : {&problem.robot, static_cast<const model::Robot*>(&with_frames)})
    for (const std::string& name : model::symbols(*robot))
      if (const auto constant = exact::named_value(name)) geometry[name] = *constant;
  for (const auto& [name, definition] : problem.robot.definitions)
    geometry[name] = model::evaluate(definition, geometry);
  return geometry;
}

}  // namespace

std::string InverseCertificate::text() const {
  return "Checked in 60 digits at " + std::to_string(poses) + " random poses: the " +
         std::to_string(solutions) +
         " solutions give the pose back to 50 digits,\n/// the sampled joints among them.";
}

InverseCertificate certify_inverse(const Problem& problem, const LoweredPlan& plan, int poses) {
  InverseCertificate certificate;
  Numbers numbers;
  for (int k = 0; k < poses; ++k) {
    const model::Bindings geometry = sampled_geometry(problem, numbers);
    const DescribedArm arm(problem, geometry);
    const std::vector<Real> q = sampled_joints(problem, numbers);
    const Pair pose = arm.pose(q);
    Values values = target(geometry, arm.pose_of_plan(asked(pose, problem.task)));
    if (problem.given >= 0) values[held_parameter(problem)] = arm.value_of_plan(q, problem.given);
    bool sampled = false;
    for (const Row& of_plan : execute(plan, values)) {
      const std::vector<Real> row = arm.row(of_plan, q);
      const double off = model::leaves_heading(problem.task)
                             ? difference_but_heading(arm, row, q, problem.heading_joint())
                             : difference(arm.pose(row), pose, problem.task);
      if (off > fifty_digits) {
        if (plan.plan.candidates) continue;
        throw CertificateError("inverse kinematics: a solution does not give the pose back");
      }
      ++certificate.solutions;
      sampled = sampled || difference(problem.described, row, q) < forty_digits;
    }
    if (!sampled)
      throw CertificateError("inverse kinematics: the sampled joints are not among the solutions");
    ++certificate.poses;
  }
  return certificate;
}

}  // namespace qvgen::verify
