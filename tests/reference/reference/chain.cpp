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

MatrixXd Chain::coupling() const {
  const auto rows = static_cast<Eigen::Index>(joints.size());
  MatrixXd all = MatrixXd::Zero(rows, rows);
  std::vector<Eigen::Index> leaders;
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Joint& joint = joints[static_cast<std::size_t>(i)];
    if (joint.leader < 0) leaders.push_back(i);
    all(i, joint.leader < 0 ? i : joint.leader) = joint.leader < 0 ? 1 : joint.ratio;
  }
  return all(Eigen::all, leaders);
}

Eigen::Index Chain::parent_of(std::size_t i) const {
  return joints[i].parent.value_or(static_cast<Eigen::Index>(i) - 1);
}

bool Chain::moves(std::size_t i, std::size_t k) const {
  auto at = static_cast<Eigen::Index>(k);
  while (at >= 0 && at != static_cast<Eigen::Index>(i)) at = parent_of(static_cast<std::size_t>(at));
  return at >= 0;
}

std::vector<Isometry3d> frames(const Chain& chain, const VectorXd& values) {
  eigen_assert(values.size() == chain.size());
  const VectorXd q = chain.coupling() * values;
  std::vector<Isometry3d> result;
  Isometry3d frame = chain.base;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const Joint& joint = chain.joints[i];
    const Eigen::Index parent = chain.parent_of(i);
    frame = parent < 0 ? chain.base : result[static_cast<std::size_t>(parent)];
    frame = frame * joint.before * motion(joint, q[static_cast<Eigen::Index>(i)]) * joint.after;
    result.push_back(frame);
  }
  result.push_back(frame * chain.tool);
  return result;
}

std::vector<JointPlace> joint_places(const Chain& chain, const VectorXd& q) {
  const std::vector<Isometry3d> links = frames(chain, q);
  std::vector<JointPlace> places;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const Eigen::Index parent = chain.parent_of(i);
    const Isometry3d frame =
        (parent < 0 ? chain.base : links[static_cast<std::size_t>(parent)]) * chain.joints[i].before;
    places.push_back({frame.linear() * chain.joints[i].axis, frame.translation()});
  }
  return places;
}

Isometry3d forward_kinematics(const Chain& chain, const VectorXd& q) { return frames(chain, q).back(); }

Isometry3d pose_of(const Chain& chain, const NamedFrame& frame, const VectorXd& q) {
  return frames(chain, q)[frame.joint] * frame.placement;
}

MatrixXd jacobian(const Chain& chain, const VectorXd& q) {
  return jacobian_of(chain, {"tool", chain.joints.size() - 1, chain.tool}, q);
}

MatrixXd jacobian_of(const Chain& chain, const NamedFrame& frame, const VectorXd& q) {
  const Vector3d at = pose_of(chain, frame, q).translation();
  const std::vector<JointPlace> places = joint_places(chain, q);
  MatrixXd result = MatrixXd::Zero(6, static_cast<Eigen::Index>(chain.joints.size()));
  for (Eigen::Index i = 0; i <= static_cast<Eigen::Index>(frame.joint); ++i) {
    if (!chain.moves(static_cast<std::size_t>(i), frame.joint)) continue;
    const auto& [axis, point] = places[static_cast<std::size_t>(i)];
    if (chain.joints[static_cast<std::size_t>(i)].revolute) {
      result.block<3, 1>(0, i) = axis.cross(at - point);
      result.block<3, 1>(3, i) = axis;
    } else {
      result.block<3, 1>(0, i) = axis;
    }
  }
  return result * chain.coupling();
}

}  // namespace reference
