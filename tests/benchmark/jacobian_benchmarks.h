// SPDX-License-Identifier: MIT
#pragma once

#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/jacobian.hpp>

#include "arm_benchmarks.h"

namespace comparison {

/// KDL's Jacobian of an arm: base frame, at the tool, linear rows first, as here.
class KdlJacobian {
 public:
  explicit KdlJacobian(std::shared_ptr<KdlArm> arm)
      : arm_(std::move(arm)),
        solver_(arm_->chain()),
        joints_(arm_->chain().getNrOfJoints()),
        jacobian_(arm_->chain().getNrOfJoints()) {}
  template <class Joints>
  const KDL::Jacobian& operator()(const Joints& q) {
    joints_.data = q;
    solver_.JntToJac(joints_, jacobian_);
    return jacobian_;
  }

 private:
  std::shared_ptr<KdlArm> arm_;  // KDL's solver keeps a reference to the chain
  KDL::ChainJntToJacSolver solver_;
  KDL::JntArray joints_;
  KDL::Jacobian jacobian_;
};

/// Checks and registers the Jacobian's benchmarks of one arm.
template <class Arm>
bool add_jacobian() {
  add_setup([] {
    using Joints = typename Arm::Joints;
    const std::string robot = Arm::name;
    const reference::Chain chain = load_robot(robot);
    const auto joints = std::make_shared<std::vector<Joints>>(configurations<Joints>(chain));
    const auto arm = std::make_shared<KdlArm>(chain);
    const auto kdl = std::make_shared<KdlJacobian>(arm);
    const auto given = std::make_shared<std::vector<typename Arm::Angles>>();
    double worst = 0;
    for (const Joints& q : *joints) {
      const Eigen::MatrixXd truth = reference::jacobian(chain, q);
      given->push_back(Arm::angles(q));
      worst = std::max({worst, (Arm::jacobian(q) - truth).cwiseAbs().maxCoeff(),
                        (Arm::jacobian(q, given->back()) - truth).cwiseAbs().maxCoeff(),
                        (Arm::both(q).jacobian - truth).cwiseAbs().maxCoeff(),
                        ((*kdl)(q).data - truth).cwiseAbs().maxCoeff()});
    }
    require_agreement(robot, worst);

    const std::string name = "jacobian/" + robot + "/";
    measure(name + "KDL", [=](std::size_t i) {
      const KDL::Jacobian* result = &(*kdl)((*joints)[i]);
      benchmark::ClobberMemory();
      return result;
    });
    measure(name + "qvgen", [=](std::size_t i) { return Arm::jacobian((*joints)[i]); });
    measure(name + "qvgen given", [=](std::size_t i) { return Arm::jacobian((*joints)[i], (*given)[i]); });
    measure(name + "qvgen with pose", [=](std::size_t i) { return Arm::both((*joints)[i]); });
    measure(name + "qvgen velocity",
            [=](std::size_t i) { return Arm::velocity((*joints)[i], (*joints)[255 - i]); });
  });
  return true;
}

}  // namespace comparison
