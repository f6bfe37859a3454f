// SPDX-License-Identifier: MIT
#include "verify/inverse/certify_rows.h"

#include <algorithm>
#include <cmath>

#include "exact/named_constant.h"
#include "verify/certificate.h"
#include "verify/inverse/but_heading.h"
#include "verify/inverse/definition.h"

namespace qvgen::verify {
namespace {

/// Largest difference of positions, as a share of a size, and of orientations up to sign.
double difference(const Pair& a, const Pair& b, double size) {
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) worst = std::max(worst, std::abs((a.p[i] - b.p[i]).to_double()) / size);
  const Quaternion between = product(conjugate(a.q), b.q);
  for (std::size_t i = 1; i < 4; ++i) worst = std::max(worst, std::abs(between[i].to_double()));
  return worst;
}

double difference(const model::Robot& robot, const std::vector<double>& a, const std::vector<Real>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double way = a[i] - b[i].to_double();
    const bool revolute = robot.joints[i].type == model::JointType::revolute;
    worst = std::max(worst, std::abs(revolute ? 2 * std::sin(way / 2) : way));
  }
  return worst;
}

PoseInDoubles in_doubles(const Pair& pose) {
  PoseInDoubles result{};
  for (std::size_t i = 0; i < 4; ++i) result[i] = pose.q[i].to_double();
  for (std::size_t i = 0; i < 3; ++i) result[4 + i] = pose.p[i].to_double();
  return result;
}

}  // namespace

std::string RowCertificate::text() const {
  return "Checked at " + std::to_string(poses) + " random poses: the " + std::to_string(solutions) +
         " solutions give the pose back to 1e-12 (by sixty digits),\n/// the sampled joints among them.";
}

RowCertificate certify_rows(const model::Robot& robot, const model::Bindings& geometry, double size,
                            const RowSolver& solver, int poses, int heading) {
  RowCertificate certificate;
  Numbers numbers;
  model::Bindings constants = geometry;
  for (const std::string& name : model::symbols(robot))
    if (const auto constant = exact::named_value(name)) constants[name] = *constant;
  const Definition definition(robot, constants);
  for (int k = 0; k < poses; ++k) {
    std::vector<Real> q;
    for (std::size_t i = 0; i < robot.joints.size(); ++i) q.emplace_back(cln::cl_R(numbers.between(-3, 3)));
    const Pair pose = definition.pose(q);
    std::vector<double> sample;
    for (const Real& value : q) sample.push_back(value.to_double());
    bool sampled = false;
    for (const std::vector<double>& row : solver(in_doubles(pose), sample)) {
      std::vector<Real> values;
      for (const double x : row) values.emplace_back(x);
      const double off = heading < 0 ? difference(definition.pose(values), pose, size)
                                     : difference_but_heading(definition, values, q, heading, size);
      if (!(off < 1e-12))
        throw CertificateError("inverse kinematics: a solution does not give the pose back");
      sampled = sampled || difference(robot, row, q) < 1e-6;
      ++certificate.solutions;
    }
    if (!sampled)
      throw CertificateError("inverse kinematics: the sampled joints are not among the solutions");
    ++certificate.poses;
  }
  return certificate;
}

}  // namespace qvgen::verify
