// SPDX-License-Identifier: MIT
#include "mujoco.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>

#include <Eigen/Eigenvalues>

namespace comparison {
namespace {

using Eigen::Isometry3d;

std::string list(const Eigen::Vector3d& v) {
  std::ostringstream text;
  text.precision(17);
  text << v.x() << ' ' << v.y() << ' ' << v.z();
  return text.str();
}

std::string list(const Eigen::Quaterniond& q) {
  std::ostringstream text;
  text.precision(17);
  text << q.w() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z();
  return text.str();
}

/// Bodies inside each other; each one's frame is that of its joint, where the joint has moved it.
std::string model_text(const reference::Chain& chain) {
  std::string open, close;
  Isometry3d place = chain.base;
  for (const reference::Joint& joint : chain.joints) {
    const Isometry3d frame = place * joint.before;
    open +=
        "<body pos='" + list(Eigen::Vector3d(frame.translation())) + "' quat='" +
        list(Eigen::Quaterniond(frame.linear())) + "'><joint type='" + (joint.revolute ? "hinge" : "slide") +
        "' axis='" + list(joint.axis) +
        // A place holder that is neither diagonal nor at the origin, so that nothing is taken to be simple.
        "'/><inertial pos='0.1 0.2 0.3' mass='1' fullinertia='2 3 4 0.1 0.2 0.3'/>";
    close += "</body>";
    place = joint.after;
  }
  return "<mujoco><compiler angle='radian'/><option gravity='0 0 -9.81'><flag contact='disable' "
         "constraint='disable'/></option><worldbody>" +
         open + close + "</worldbody></mujoco>";
}

mjModel* load(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), "arm.xml", static_cast<int>(text.size())) != 0)
    throw std::runtime_error("MuJoCo: no memory for the model's text");
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), "arm.xml")], text.data(), text.size());
  char error[1000] = "";
  mjModel* model = mj_loadXML("arm.xml", files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(std::string("MuJoCo: ") + error);
  return model;
}

/// The description's inertia as it is: MuJoCo's reader accepts only those that a body can have.
void set_inertia(mjModel& model, int body, const reference::Joint& joint) {
  const Eigen::Matrix3d turned = joint.after.linear() * joint.inertia * joint.after.linear().transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(turned);
  Eigen::Matrix3d axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  const Eigen::Quaterniond q(axes);
  const Eigen::Vector3d centre = joint.after * joint.centre_of_mass;
  const double orientation[] = {q.w(), q.x(), q.y(), q.z()};
  model.body_mass[body] = joint.mass;
  std::copy_n(centre.data(), 3, model.body_ipos + 3 * body);
  std::copy_n(orientation, 4, model.body_iquat + 4 * body);
  std::copy_n(principal.eigenvalues().data(), 3, model.body_inertia + 3 * body);
}

}  // namespace

MujocoArm::MujocoArm(const reference::Chain& chain)
    : n_(chain.joints.size()), model_(load(model_text(chain))), force_(n_), result_(n_ * n_) {
  for (std::size_t i = 0; i < n_; ++i) {
    const reference::Joint& joint = chain.joints[i];
    if (joint.rotor_inertia != 0 || joint.viscous_friction != 0 || joint.coulomb_friction != 0)
      throw std::runtime_error("MuJoCo: drives are not compared");
    set_inertia(*model_, static_cast<int>(i) + 1, joint);
  }
  data_.reset(mj_makeData(model_.get()));
  mj_setConst(model_.get(), data_.get());
}

void MujocoArm::set(const double* q) {
  std::copy_n(q, n_, data_->qpos);
  mj_kinematics(model_.get(), data_.get());
  mj_comPos(model_.get(), data_.get());
}

const double* MujocoArm::inverse_dynamics(const double* q, const double* qd, const double* qdd) {
  set(q);
  std::copy_n(qd, n_, data_->qvel);
  std::copy_n(qdd, n_, data_->qacc);
  mj_comVel(model_.get(), data_.get());
  mj_rne(model_.get(), data_.get(), 1, result_.data());
  return result_.data();
}

const double* MujocoArm::mass_matrix(const double* q) {
  set(q);
  mj_crb(model_.get(), data_.get());
  mj_fullM(model_.get(), result_.data(), data_->qM);
  return result_.data();
}

const double* MujocoArm::forward_dynamics(const double* q, const double* qd, const double* torque) {
  set(q);
  std::copy_n(qd, n_, data_->qvel);
  mj_crb(model_.get(), data_.get());
  mj_factorM(model_.get(), data_.get());
  mj_comVel(model_.get(), data_.get());
  mj_rne(model_.get(), data_.get(), 0, force_.data());
  for (std::size_t i = 0; i < n_; ++i) force_[i] = torque[i] - force_[i];
  mj_solveM(model_.get(), data_.get(), result_.data(), force_.data(), 1);
  return result_.data();
}

}  // namespace comparison
