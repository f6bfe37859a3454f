// SPDX-License-Identifier: MIT
#include "frame_values.h"

#include <vector>

namespace qvgen::test::sources {
namespace {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Base, links, tool.
std::vector<Isometry3d> all_frames(const reference::Chain& chain, const VectorXd& q) {
  std::vector<Isometry3d> frames{Isometry3d::Identity()};
  for (const Isometry3d& frame : reference::frames(chain, q)) frames.push_back(frame);
  return frames;
}

void add_transforms(const std::vector<Isometry3d>& frames, Known& known) {
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t j = 0; j < frames.size(); ++j) {
      if (i == j) continue;
      const Isometry3d transform = frames[i].inverse() * frames[j];
      const std::string name = std::to_string(i) + std::to_string(j);
      known["T" + name] = MatrixXd(transform.matrix());
      known["R" + name] = MatrixXd(transform.linear());
      known["P" + name] = Vector3d(transform.translation());
    }
}

/// The Jacobian at a frame's origin: joints behind it do not move it.
MatrixXd jacobian_at(const reference::Chain& chain, const VectorXd& q, const Vector3d& origin,
                     std::size_t joints) {
  const std::vector<reference::JointPlace> places = reference::joint_places(chain, q);
  MatrixXd jacobian = MatrixXd::Zero(6, q.size());
  for (std::size_t i = 0; i < std::min(joints, chain.joints.size()); ++i) {
    const Vector3d& axis = places[i].axis;
    const auto column = static_cast<Eigen::Index>(i);
    const bool turns = chain.joints[i].revolute;
    jacobian.col(column).head<3>() = turns ? Vector3d(axis.cross(origin - places[i].point)) : axis;
    if (turns) jacobian.col(column).tail<3>() = axis;
  }
  return jacobian;
}

void add_velocities(const std::vector<Isometry3d>& frames, std::size_t j, const VectorXd& velocity,
                    Known& known) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string name = std::to_string(i) + std::to_string(j);
    known["v" + name] = Vector3d(frames[i].linear().transpose() * velocity.head<3>());
    known["omega" + name] = Vector3d(frames[i].linear().transpose() * velocity.tail<3>());
  }
}

/// The Jacobian as each frame but the base sees it: J3, and J3v without the rows of the angular velocity.
void add_turned_jacobians(const std::vector<Isometry3d>& frames, const MatrixXd& jacobian, Known& known) {
  for (std::size_t i = 1; i < frames.size(); ++i) {
    MatrixXd turned(6, jacobian.cols());
    turned << frames[i].linear().transpose() * jacobian.topRows(3),
        frames[i].linear().transpose() * jacobian.bottomRows(3);
    known["J" + std::to_string(i)] = turned;
    known["J" + std::to_string(i) + "v"] = MatrixXd(turned.topRows(3));
  }
}

void add_jacobian(const MatrixXd& jacobian, const VectorXd& qd, Known& known) {
  known["J0"] = jacobian;
  known["J0v"] = MatrixXd(jacobian.topRows(3));
  known["J0w"] = known["J0omega"] = MatrixXd(jacobian.bottomRows(3));
  known["J0xy"] = MatrixXd(jacobian.topRows(2));
  known["J0wz"] = MatrixXd(jacobian.bottomRows(1));
  MatrixXd planar(3, jacobian.cols());
  planar << jacobian.topRows(2), jacobian.bottomRows(1);
  known["J0p"] = planar;
  known["v0xy"] = MatrixXd(jacobian.topRows(2) * qd);
}

}  // namespace

Known frame_values(const reference::Chain& chain, const reference::Values& lengths, const VectorXd& q,
                   const VectorXd& qd) {
  Known known;
  for (const auto& [name, value] : lengths) known[name] = value;
  const std::vector<reference::JointPlace> places = reference::joint_places(chain, q);
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    known[chain.joints[i].variable] = q[static_cast<Eigen::Index>(i)];
    known[chain.joints[i].variable + "'"] = qd[static_cast<Eigen::Index>(i)];
    known["Z0" + std::to_string(i + 1)] = places[i].axis;
  }
  const std::vector<Isometry3d> frames = all_frames(chain, q);
  add_transforms(frames, known);
  for (std::size_t j = 0; j < frames.size(); ++j) {
    known["Z" + std::to_string(j) + std::to_string(j)] = Vector3d(Vector3d::UnitZ());
    add_velocities(frames, j, jacobian_at(chain, q, frames[j].translation(), j) * qd, known);
  }
  const MatrixXd jacobian = reference::jacobian(chain, q);
  add_jacobian(jacobian, qd, known);
  add_turned_jacobians(frames, jacobian, known);
  const std::string tool = std::to_string(frames.size() - 1);
  const MatrixXd turned = frames.back().linear().transpose() * jacobian.topRows(3);
  known["J" + tool + "xy"] = MatrixXd(turned.topRows(2));
  known["theta" + tool + "'"] = 0.0;  // the tool does not turn against the last link
  return known;
}

}  // namespace qvgen::test::sources
