// SPDX-License-Identifier: MIT
// own_arms LENGTH: the length of the first link is that of the description, in libraries and in headers.
#include <cmath>
#include <cstdlib>

#include <qvgen/robots/left_arm.h>
#include <qvgen/robots/my_arm.h>
#include <qvgen/robots/rr_planar.h>
#include <qvgen/robots/urdf_arm.h>

namespace {

namespace arm = qvgen::robots::my_arm;
namespace other = qvgen::robots::rr_planar;

}  // namespace

int main(int count, char** arguments) {
  const double length = count > 1 ? std::atof(arguments[1]) : 0;
  const auto stretched = arm::forward_kinematics(arm::JointVector<double>::Zero().eval());
  if (std::abs(stretched.position.x() - (length + 0.3)) > 1e-15) return 2;
  if (arm::upper_limits[0] != length) return 3;
  const arm::JointVector<double> q = arm::JointVector<double>::Constant(0.3);
  const auto found = arm::inverse_kinematics(arm::forward_kinematics(q), q, arm::Limits());
  const bool same = !found.empty() && found[0].q.isApprox(q, 1e-9);
  const other::JointVector<double> zero = other::JointVector<double>::Zero();
  if (qvgen::robots::urdf_arm::dof != 2) return 4;
  const auto left = qvgen::robots::left_arm::forward_kinematics(zero);
  if (left.position != other::forward_kinematics(zero).position) return 5;
  return same && other::forward_kinematics(zero).position.allFinite() ? 0 : 1;
}
