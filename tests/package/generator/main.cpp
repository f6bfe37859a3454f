// SPDX-License-Identifier: MIT
#include <qvgen/robots/my_arm.h>
#include <qvgen/robots/rr_planar.h>

namespace {

namespace arm = qvgen::robots::my_arm;
namespace other = qvgen::robots::rr_planar;

}  // namespace

int main() {
  const arm::JointVector<double> q = arm::JointVector<double>::Constant(0.5);
  const auto found = arm::inverse_kinematics(arm::forward_kinematics(q), q, arm::Limits());
  const bool same = !found.empty() && found[0].q.isApprox(q, 1e-9);
  const other::JointVector<double> zero = other::JointVector<double>::Zero();
  return same && other::forward_kinematics(zero).position.allFinite() ? 0 : 1;
}
