// SPDX-License-Identifier: MIT
#include "reference/chain.h"

namespace reference {
namespace {

Isometry3d motion(const Joint& joint, double value) {
  Isometry3d result = Isometry3d::Identity();
  if (joint.revolute) {
    result.linear() = Eigen::AngleAxisd(value, joint.axis).toRotationMatrix();
  } else {
    result.translation() = value * joint.axis;
  }
  return result;
}

}  // namespace

std::vector<Isometry3d> frames(const Chain& chain, const VectorXd& q) {
  eigen_assert(q.size() == chain.size());
  std::vector<Isometry3d> result;
  Isometry3d frame = chain.base;
  for (Eigen::Index i = 0; i < chain.size(); ++i) {
    const Joint& joint = chain.joints[static_cast<std::size_t>(i)];
    frame = frame * joint.before * motion(joint, q[i]) * joint.after;
    result.push_back(frame);
  }
  result.push_back(frame * chain.tool);
  return result;
}

std::vector<JointPlace> joint_places(const Chain& chain, const VectorXd& q) {
  const std::vector<Isometry3d> links = frames(chain, q);
  std::vector<JointPlace> places;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const Isometry3d frame = (i == 0 ? chain.base : links[i - 1]) * chain.joints[i].before;
    places.push_back({frame.linear() * chain.joints[i].axis, frame.translation()});
  }
  return places;
}

Isometry3d forward_kinematics(const Chain& chain, const VectorXd& q) { return frames(chain, q).back(); }

MatrixXd jacobian(const Chain& chain, const VectorXd& q) {
  const Vector3d tool = forward_kinematics(chain, q).translation();
  const std::vector<JointPlace> places = joint_places(chain, q);
  MatrixXd result = MatrixXd::Zero(6, chain.size());
  for (Eigen::Index i = 0; i < chain.size(); ++i) {
    const auto& [axis, point] = places[static_cast<std::size_t>(i)];
    if (chain.joints[static_cast<std::size_t>(i)].revolute) {
      result.block<3, 1>(0, i) = axis.cross(tool - point);
      result.block<3, 1>(3, i) = axis;
    } else {
      result.block<3, 1>(0, i) = axis;
    }
  }
  return result;
}

}  // namespace reference
