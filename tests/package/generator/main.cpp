// SPDX-License-Identifier: MIT
// own_arms LENGTH: the length of the first link is that of the description, in libraries and in headers.
#include <cmath>
#include <cstdlib>

#include <qvgen/robots/my_arm.h>
#include <qvgen/robots/rr_planar.h>
#include <qvgen/robots/urdf_arm.h>
#ifdef HAS_OPTIONS
#include <qvgen/robots/forearm.h>
#include <qvgen/robots/left_arm.h>
#endif

namespace {

namespace arm = qvgen::robots::my_arm;
namespace other = qvgen::robots::rr_planar;

#ifdef HAS_OPTIONS
/// The tool of the URDF's second joint, rpy="1.5708 0.3 0", without the first: 1.5708 is no right angle
/// there.
bool is_read_as_it_stands() {
  namespace forearm = qvgen::robots::forearm;
  static_assert(forearm::dof == 1);
  const auto tool = forearm::forward_kinematics(forearm::JointVector<double>::Zero().eval());
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  const Eigen::Quaterniond turn(AngleAxisd(0.3, Vector3d::UnitY()) * AngleAxisd(1.5708, Vector3d::UnitX()));
  return tool.orientation.angularDistance(turn) < 1e-12 &&
         (tool.position - Vector3d(0.0137, 0, 0.2)).norm() < 1e-12;
}

/// The known robot under another name is the same one, with its inverse kinematics.
bool is_the_other_arm() {
  namespace left_arm = qvgen::robots::left_arm;
  const left_arm::JointVector<double> q = left_arm::JointVector<double>::Constant(0.3);
  const auto found = left_arm::inverse_kinematics(left_arm::forward_kinematics(q), q, left_arm::Limits());
  const other::JointVector<double> zero = other::JointVector<double>::Zero();
  return !found.empty() && found[0].q.isApprox(q, 1e-9) &&
         left_arm::forward_kinematics(zero).position == other::forward_kinematics(zero).position;
}
#endif

}  // namespace

int main(int count, char** arguments) {
  const double length = count > 1 ? std::atof(arguments[1]) : 0;
  const auto stretched = arm::forward_kinematics(arm::JointVector<double>::Zero().eval());
  if (std::abs(stretched.position.x() - (length + 0.3)) > 1e-15) return 2;
  if (arm::upper_limits[0] != length) return 3;
#ifdef HAS_OPTIONS
  if (!is_the_other_arm()) return 5;
  if (!is_read_as_it_stands()) return 6;
#endif
  if (qvgen::robots::urdf_arm::dof != 2) return 4;
  const other::JointVector<double> zero = other::JointVector<double>::Zero();
  return other::forward_kinematics(zero).position.allFinite() ? 0 : 1;
}
