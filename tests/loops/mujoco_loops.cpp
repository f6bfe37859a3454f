// SPDX-License-Identifier: MIT
#include "mujoco_loops.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "reference/linear_algebra.h"

namespace qvgen::test::loops {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using reference::Chain;
using reference::LoopMechanism;

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

std::string name_of(Eigen::Index link) { return link < 0 ? "world" : "b" + std::to_string(link); }

/// Point of a closure in the frame of MuJoCo's body, which is the joint's where the joint has moved it.
Vector3d point_of(const LoopMechanism& mechanism, const reference::Closure& closure, std::size_t end) {
  const Eigen::Index link = closure.links[end];
  const Isometry3d& frame =
      link < 0 ? mechanism.chain.base : mechanism.chain.joints[static_cast<std::size_t>(link)].after;
  return frame * closure.points[end];
}

/// The ends of rods on a link.
std::string sites_on(const LoopMechanism& mechanism, Eigen::Index link) {
  std::string text;
  for (std::size_t i = 0; i < mechanism.closures.size(); ++i)
    for (std::size_t end = 0; end < 2; ++end) {
      const reference::Closure& closure = mechanism.closures[i];
      if (closure.links[end] != link || !closure.is_rod()) continue;
      text += "<site name='s" + std::to_string(i) + "_" + std::to_string(end) + "' pos='" +
              list(point_of(mechanism, closure, end)) + "'/>";
    }
  return text;
}

std::string bodies_on(const LoopMechanism& mechanism, Eigen::Index link);

std::string body_of(const LoopMechanism& mechanism, std::size_t i) {
  const Chain& chain = mechanism.chain;
  const Eigen::Index link = chain.parent_of(i);
  const reference::Joint& joint = chain.joints[i];
  const Isometry3d below = link < 0 ? chain.base : chain.joints[static_cast<std::size_t>(link)].after;
  const Isometry3d frame = below * joint.before;
  const Eigen::Quaterniond turn(frame.linear());
  return "<body name='" + name_of(static_cast<Eigen::Index>(i)) + "' pos='" +
         list(Vector3d(frame.translation())) + "' quat='" +
         list(Eigen::Vector4d(turn.w(), turn.x(), turn.y(), turn.z())) + "'><joint name='j" +
         std::to_string(i) + "' type='" + (joint.revolute ? "hinge" : "slide") + "' axis='" +
         list(joint.axis) + "' armature='" + list(Eigen::Matrix<double, 1, 1>(joint.rotor_inertia)) +
         "' damping='" + list(Eigen::Matrix<double, 1, 1>(joint.viscous_friction)) + "'/>" + inertial(joint) +
         sites_on(mechanism, static_cast<Eigen::Index>(i)) +
         bodies_on(mechanism, static_cast<Eigen::Index>(i)) + "</body>";
}

/// The bodies on a link; each one's frame is that of its joint, where the joint has moved it.
std::string bodies_on(const LoopMechanism& mechanism, Eigen::Index link) {
  std::string text;
  for (std::size_t i = 0; i < mechanism.chain.joints.size(); ++i)
    if (mechanism.chain.parent_of(i) == link) text += body_of(mechanism, i);
  return text;
}

constexpr std::size_t base_joints = 6;

/// The base on its free joint, and motors, which are on nothing.
std::string floating_bodies(const LoopMechanism& mechanism) {
  const Eigen::Index base = base_joints - 1;
  std::string text = "<body name='" + name_of(base) + "'><freejoint/>" +
                     inertial(mechanism.chain.joints[base_joints - 1]) + sites_on(mechanism, base) +
                     bodies_on(mechanism, base) + "</body>";
  for (std::size_t i = base_joints; i < mechanism.chain.joints.size(); ++i)
    if (mechanism.chain.parent_of(i) < 0) text += body_of(mechanism, i);
  return text;
}

std::string fixed_tendon(const std::string& name, const std::string& joints) {
  return "<fixed name='" + name + "'>" + joints + "</fixed>";
}
std::string share(Eigen::Index joint, double factor) {
  return "<joint joint='j" + std::to_string(joint) + "' coef='" + list(Eigen::Matrix<double, 1, 1>(factor)) +
         "'/>";
}

/// Constraints in the order of the mechanism's: those of points, then rods and gears.
struct Constraints {
  std::string tendons, equalities;
};

constexpr const char* stiff = "' solimp='0.9999 0.9999 0.001'/>";

/// Adds a rod: the distance of its ends is constant, or the value of a joint.
void add_rod(const reference::Closure& closure, const std::string& number, Constraints& to) {
  to.tendons += "<spatial name='rod" + number + "'><site site='s" + number + "_0'/><site site='s" + number +
                "_1'/></spatial>";
  to.equalities += "<tendon tendon1='rod" + number;
  if (closure.length_joint >= 0) {
    to.tendons += fixed_tendon("length" + number, share(closure.length_joint, 1));
    to.equalities += "' tendon2='length" + number;
  }
  to.equalities += stiff;
}

Constraints constraints_of(const LoopMechanism& mechanism) {
  Constraints result;
  for (std::size_t i = 0; i < mechanism.closures.size(); ++i) {
    const reference::Closure& closure = mechanism.closures[i];
    if (closure.is_rod()) {
      add_rod(closure, std::to_string(i), result);
      continue;
    }
    result.equalities += "<connect name='c" + std::to_string(i) + "' body1='" + name_of(closure.links[0]) +
                         "' body2='" + name_of(closure.links[1]) + "' anchor='0 0 0" + stiff;
  }
  for (const reference::Gear& gear : mechanism.gears) {
    std::string joints = share(gear.joint, -1);
    for (const auto& [leader, ratio] : gear.leaders) joints += share(leader, ratio);
    const std::string name = "gear" + std::to_string(gear.joint);
    result.tendons += fixed_tendon(name, joints);
    result.equalities += "<tendon tendon1='" + name + stiff;
  }
  return result;
}

std::string model_text(const LoopMechanism& mechanism, Base base) {
  const auto [tendons, equalities] = constraints_of(mechanism);
  return "<mujoco><compiler angle='radian'/><option gravity='0 0 -9.81' jacobian='dense'>"
         "<flag contact='disable'/></option><worldbody>" +
         (base == Base::floats ? floating_bodies(mechanism)
                               : sites_on(mechanism, -1) + bodies_on(mechanism, -1)) +
         "</worldbody><tendon>" + tendons + "</tendon><equality>" + equalities + "</equality></mujoco>";
}

}  // namespace

MujocoLoops::MujocoLoops(const LoopMechanism& mechanism, Base base)
    : model_(mujoco_model(model_text(mechanism, base))), data_(mj_makeData(model_.get()), &mj_deleteData) {
  for (std::size_t i = base == Base::floats ? base_joints : 0; i < mechanism.chain.joints.size(); ++i) {
    const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, ("j" + std::to_string(i)).c_str());
    places_.push_back(model_->jnt_dofadr[joint]);
    positions_.push_back(model_->jnt_qposadr[joint]);
  }
  // The second anchor is where the first one is in the model's first pose, in which loops are open.
  for (std::size_t i = 0; i < mechanism.closures.size(); ++i) {
    const int row = mj_name2id(model_.get(), mjOBJ_EQUALITY, ("c" + std::to_string(i)).c_str());
    for (std::size_t end = 0; end < 2 && row >= 0; ++end) {
      const Vector3d at = point_of(mechanism, mechanism.closures[i], end);
      std::copy(at.data(), at.data() + 3, model_->eq_data + mjNEQDATA * row + 3 * end);
    }
  }
}

Eigen::VectorXd MujocoLoops::forward(const Eigen::VectorXd& q, const Eigen::VectorXd& forces) {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    data_->qpos[positions_[i]] = q[static_cast<Eigen::Index>(i)];
    data_->qfrc_applied[places_[i]] = forces[static_cast<Eigen::Index>(i)];
  }
  mj_forward(model_.get(), data_.get());
  Eigen::VectorXd result(q.size());
  for (std::size_t i = 0; i < places_.size(); ++i)
    result[static_cast<Eigen::Index>(i)] = data_->qacc[places_[i]];
  return result;
}

/// Returns the derivatives of all constraints by MuJoCo's velocities, at its positions.
Eigen::MatrixXd MujocoLoops::constraints() {
  mj_fwdPosition(model_.get(), data_.get());
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(data_->efc_J, data_->ne, model_->nv);
}

Eigen::VectorXd MujocoLoops::forward(const Eigen::VectorXd& pose, const Eigen::VectorXd& q,
                                     const Eigen::VectorXd& velocity, const Eigen::VectorXd& forces) {
  const Eigen::Index n = model_->nv;
  const Matrix3d turn = Eigen::Quaterniond(pose[0], pose[1], pose[2], pose[3]).toRotationMatrix();
  Eigen::VectorXd positions(model_->nq), rates(n), given(n);
  positions.head<7>() << pose.tail<3>(), pose.head<4>();
  rates.head<6>() << turn * velocity.head<3>(),
      velocity.segment<3>(3);  // MuJoCo's: in the world, in the body
  given.head<6>() << turn * forces.head<3>(), forces.segment<3>(3);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto joint = static_cast<Eigen::Index>(i);
    positions[positions_[i]] = q[joint];
    rates[places_[i]] = velocity[6 + joint];
    given[places_[i]] = forces[6 + joint];
  }
  const auto constraints_after = [&](double time) {
    Eigen::Map<Eigen::VectorXd>(data_->qpos, positions.size()) = positions;
    mj_integratePos(model_.get(), data_->qpos, rates.data(), time);
    return constraints();
  };
  const double step = 1e-5;
  const Eigen::VectorXd bent = (constraints_after(step) - constraints_after(-step)) * rates / (2 * step);
  const Eigen::MatrixXd equations = constraints_after(0);
  Eigen::Map<Eigen::VectorXd>(data_->qvel, n) = rates;
  mj_fwdVelocity(model_.get(), data_.get());
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n + equations.rows(), n + equations.rows()), masses(n, n);
  mj_fullM(model_.get(), masses.data(), data_->qM);
  whole.topLeftCorner(n, n) = masses;
  whole.topRightCorner(n, equations.rows()) = equations.transpose();
  whole.bottomLeftCorner(equations.rows(), n) = equations;
  Eigen::VectorXd right(whole.rows());
  right << given + Eigen::Map<const Eigen::VectorXd>(data_->qfrc_passive, n) -
               Eigen::Map<const Eigen::VectorXd>(data_->qfrc_bias, n),
      -bent;
  const Eigen::VectorXd found = reference::least_squares(whole, right);
  Eigen::VectorXd result(6 + q.size());
  const Vector3d linear = velocity.head<3>(), angular = velocity.segment<3>(3);
  result.head<6>() << turn.transpose() * found.head<3>() - angular.cross(linear), found.segment<3>(3);
  for (std::size_t i = 0; i < places_.size(); ++i)
    result[6 + static_cast<Eigen::Index>(i)] = found[places_[i]];
  return result;
}

}  // namespace qvgen::test::loops
