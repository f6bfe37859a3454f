// SPDX-License-Identifier: MIT
#include "reference/chain.h"

#include <algorithm>

#include "reference/linear_algebra.h"

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

/// The joint's variable; a chain that is written by hand may leave it out.
std::string name_of(const std::vector<Joint>& joints, std::size_t i) {
  return joints[i].variable.empty() ? "joint " + std::to_string(i) : joints[i].variable;
}

/// True if these are values of the joints themselves, as they are unless joints follow others. Most chains
/// are such, and names are then not compared.
bool are_joints(const Chain& chain, Eigen::Index count) {
  return count == static_cast<Eigen::Index>(chain.joints.size()) &&
         std::all_of(chain.joints.begin(), chain.joints.end(),
                     [](const Joint& joint) { return joint.leaders.empty(); });
}

/// The frames of all links in the world frame.
std::vector<Isometry3d> links(const Chain& chain, const VectorXd& values) {
  const bool by_joints = are_joints(chain, values.size());
  eigen_assert(by_joints || values.size() == chain.size());
  const VectorXd q = by_joints ? values : VectorXd(chain.coupling() * values);
  std::vector<Isometry3d> result;
  result.reserve(chain.joints.size() + 1);
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const Joint& joint = chain.joints[i];
    const Eigen::Index parent = chain.parent_of(i);
    const Isometry3d& from = parent < 0 ? chain.base : result[static_cast<std::size_t>(parent)];
    result.push_back(from * joint.before * motion(joint, q[static_cast<Eigen::Index>(i)]) * joint.after);
  }
  return result;
}

std::vector<JointPlace> places_between(const Chain& chain, const std::vector<Isometry3d>& links) {
  std::vector<JointPlace> places;
  places.reserve(chain.joints.size());
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const Eigen::Index parent = chain.parent_of(i);
    const Isometry3d frame =
        (parent < 0 ? chain.base : links[static_cast<std::size_t>(parent)]) * chain.joints[i].before;
    places.push_back({frame.linear() * chain.joints[i].axis, frame.translation()});
  }
  return places;
}

}  // namespace

std::vector<std::string> Chain::driven() const {
  std::vector<std::string> names;
  const auto add = [&](const std::string& variable) {
    if (std::find(names.begin(), names.end(), variable) == names.end()) names.push_back(variable);
  };
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].leaders.empty()) add(name_of(joints, i));
    for (const Motor& motor : motors)
      for (const auto& leader : joints[i].leaders)
        if (leader.first == motor.variable) add(motor.variable);
  }
  return names;
}

MatrixXd Chain::coupling() const {
  const std::vector<std::string> names = driven();
  const auto place = [&](const std::string& variable) {
    return std::find(names.begin(), names.end(), variable) - names.begin();
  };
  MatrixXd all =
      MatrixXd::Zero(static_cast<Eigen::Index>(joints.size()), static_cast<Eigen::Index>(names.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (joints[i].leaders.empty()) all(row, place(name_of(joints, i))) = 1;
    for (const auto& [leader, ratio] : joints[i].leaders) all(row, place(leader)) += ratio;
  }
  return all;
}

Eigen::Index Chain::parent_of(std::size_t i) const {
  return joints[i].parent.value_or(static_cast<Eigen::Index>(i) - 1);
}

bool Chain::moves(std::size_t i, std::size_t k) const {
  auto at = static_cast<Eigen::Index>(k);
  while (at >= 0 && at != static_cast<Eigen::Index>(i)) at = parent_of(static_cast<std::size_t>(at));
  return at >= 0;
}

std::vector<Isometry3d> frames(const Chain& chain, const VectorXd& q) {
  std::vector<Isometry3d> result = links(chain, q);
  result.push_back((result.empty() ? chain.base : result.back()) * chain.tool);
  return result;
}

std::vector<JointPlace> joint_places(const Chain& chain, const VectorXd& q) {
  return places_between(chain, links(chain, q));
}

Isometry3d forward_kinematics(const Chain& chain, const VectorXd& q) { return frames(chain, q).back(); }

Isometry3d pose_of(const Chain& chain, const NamedFrame& frame, const VectorXd& q) {
  return frames(chain, q)[frame.joint] * frame.placement;
}

MatrixXd jacobian(const Chain& chain, const VectorXd& q) {
  return jacobian_of(chain, {"tool", chain.joints.size() - 1, chain.tool}, q);
}

MatrixXd jacobian_of(const Chain& chain, const NamedFrame& frame, const VectorXd& q) {
  const std::vector<Isometry3d> all = links(chain, q);
  const Vector3d at = (all[frame.joint] * frame.placement).translation();
  const std::vector<JointPlace> places = places_between(chain, all);
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
  return are_joints(chain, q.size()) ? result : product(result, chain.coupling());
}

}  // namespace reference
