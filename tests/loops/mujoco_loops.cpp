// SPDX-License-Identifier: MIT
#include "mujoco_loops.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace qvgen::test::loops {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using reference::Chain;

template <class Vector>
std::string list(const Vector& v) {
  std::ostringstream text;
  text.precision(17);
  for (Eigen::Index i = 0; i < v.size(); ++i) text << (i == 0 ? "" : " ") << v[i];
  return text.str();
}

/// Least mass and inertia: MuJoCo has no bodies without.
constexpr double least = 1e-9;

std::string inertial(const reference::Joint& joint) {
  const Matrix3d turn = joint.after.linear();
  const Matrix3d inertia = turn * joint.inertia * turn.transpose() + least * Matrix3d::Identity();
  Eigen::Matrix<double, 6, 1> numbers;
  numbers << inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2), inertia(1, 2);
  return "<inertial pos='" + list(Vector3d(joint.after * joint.centre_of_mass)) + "' mass='" +
         list(Eigen::Matrix<double, 1, 1>(joint.mass + least)) + "' fullinertia='" + list(numbers) + "'/>";
}

/// The bodies on a link; each one's frame is that of its joint, where the joint has moved it.
std::string bodies_on(const Chain& chain, Eigen::Index link) {
  std::string text;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    if (chain.parent_of(i) != link) continue;
    const reference::Joint& joint = chain.joints[i];
    const Isometry3d below = link < 0 ? chain.base : chain.joints[static_cast<std::size_t>(link)].after;
    const Isometry3d frame = below * joint.before;
    const Eigen::Quaterniond turn(frame.linear());
    text += "<body name='b" + std::to_string(i) + "' pos='" + list(Vector3d(frame.translation())) +
            "' quat='" + list(Eigen::Vector4d(turn.w(), turn.x(), turn.y(), turn.z())) + "'><joint type='" +
            (joint.revolute ? "hinge" : "slide") + "' axis='" + list(joint.axis) + "' armature='" +
            list(Eigen::Matrix<double, 1, 1>(joint.rotor_inertia)) + "' damping='" +
            list(Eigen::Matrix<double, 1, 1>(joint.viscous_friction)) + "'/>" + inertial(joint) +
            bodies_on(chain, static_cast<Eigen::Index>(i)) + "</body>";
  }
  return text;
}

std::string model_text(const reference::LoopMechanism& mechanism) {
  std::string equalities;
  for (const reference::Closure& closure : mechanism.closures)
    equalities += "<connect body1='b" + std::to_string(closure.links[0]) + "' body2='b" +
                  std::to_string(closure.links[1]) + "' anchor='0 0 0' solimp='0.9999 0.9999 0.001'/>";
  return "<mujoco><compiler angle='radian'/><option gravity='0 0 -9.81'><flag contact='disable'/></option>"
         "<worldbody>" +
         bodies_on(mechanism.chain, -1) + "</worldbody><equality>" + equalities + "</equality></mujoco>";
}

}  // namespace

MujocoLoops::MujocoLoops(const reference::LoopMechanism& mechanism)
    : model_(mujoco_model(model_text(mechanism))), data_(mj_makeData(model_.get()), &mj_deleteData) {
  for (std::size_t i = 0; i < mechanism.chain.joints.size(); ++i) {
    const int body = mj_name2id(model_.get(), mjOBJ_BODY, ("b" + std::to_string(i)).c_str());
    places_.push_back(model_->jnt_dofadr[model_->body_jntadr[body]]);
  }
  // The second anchor is where the first one is in the model's first pose, in which loops are open.
  for (std::size_t i = 0; i < mechanism.closures.size(); ++i)
    for (std::size_t end = 0; end < 2; ++end) {
      const reference::Closure& closure = mechanism.closures[i];
      const auto link = static_cast<std::size_t>(closure.links[end]);
      const Vector3d at = mechanism.chain.joints[link].after * closure.points[end];
      std::copy(at.data(), at.data() + 3, model_->eq_data + mjNEQDATA * static_cast<int>(i) + 3 * end);
    }
}

Eigen::VectorXd MujocoLoops::forward(const Eigen::VectorXd& q, const Eigen::VectorXd& forces) {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    data_->qpos[places_[i]] = q[static_cast<Eigen::Index>(i)];
    data_->qfrc_applied[places_[i]] = forces[static_cast<Eigen::Index>(i)];
  }
  mj_forward(model_.get(), data_.get());
  Eigen::VectorXd result(q.size());
  for (std::size_t i = 0; i < places_.size(); ++i)
    result[static_cast<Eigen::Index>(i)] = data_->qacc[places_[i]];
  return result;
}

}  // namespace qvgen::test::loops
