// SPDX-License-Identifier: MIT
#include "chain.h"

#include <cmath>
#include <string>

namespace comparison {
namespace {

KDL::Vector to_kdl(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

KDL::Frame to_kdl(const Eigen::Isometry3d& t) {
  const Eigen::Matrix3d r = t.linear();
  return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
          to_kdl(Eigen::Vector3d(t.translation()))};
}

/// KDL's special type for a joint about or along a coordinate axis through the frame's origin, else the
/// general.
KDL::Joint to_kdl(const reference::Joint& joint, const Eigen::Vector3d& axis, const Eigen::Vector3d& point) {
  using Type = KDL::Joint::JointType;
  const Type turning[] = {Type::RotX, Type::RotY, Type::RotZ};
  const Type sliding[] = {Type::TransX, Type::TransY, Type::TransZ};
  for (int i = 0; i < 3; ++i) {
    if (point.isZero() && std::abs(axis[i]) == 1) {
      return KDL::Joint(joint.variable, joint.revolute ? turning[i] : sliding[i], axis[i]);
    }
  }
  const Type general = joint.revolute ? Type::RotAxis : Type::TransAxis;
  return KDL::Joint(joint.variable, to_kdl(point), to_kdl(axis), general);
}

/// The inertia of a link seen from a frame that is fixed to it.
KDL::RigidBodyInertia to_kdl(const reference::Joint& link, const Eigen::Isometry3d& frame) {
  const Eigen::Vector3d centre = frame.inverse() * link.centre_of_mass;
  const Eigen::Matrix3d i = frame.linear().transpose() * link.inertia * frame.linear();
  return KDL::RigidBodyInertia(link.mass, to_kdl(centre),
                               KDL::RotationalInertia(i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)));
}

}  // namespace

/// A KDL segment is a joint, then a constant frame. So the constant parts before a joint go to the segment
/// before it; what stands before the first joint goes into that joint's axis and its constant frame.
KDL::Chain to_kdl(const reference::Chain& chain) {
  KDL::Chain result;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const reference::Joint& joint = chain.joints[i];
    const bool last = i + 1 == chain.joints.size();
    const Eigen::Isometry3d behind = last ? chain.tool : chain.joints[i + 1].before;
    Eigen::Isometry3d after = joint.after * behind;
    Eigen::Vector3d axis = joint.axis;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    if (i == 0) {
      const Eigen::Isometry3d before = chain.base * joint.before;
      point = before.translation();
      axis = before.linear() * axis;
      after =
          before * after;  // KDL takes the segment's end at zero, and subtracts the joint's point by itself
    }
    const std::string name = "link" + std::to_string(i + 1);
    result.addSegment(KDL::Segment(name, to_kdl(joint, axis, point), to_kdl(after), to_kdl(joint, behind)));
  }
  return result;
}

}  // namespace comparison
