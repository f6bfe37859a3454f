// SPDX-License-Identifier: MIT
#pragma once

#include "arm_benchmarks.h"

namespace comparison {

/// Largest difference in m and rad of all Jacobians from the reference's, over all configurations.
template <class Arm>
double disagreement_of_jacobians(const reference::Chain& chain, KdlArm& kdl,
                                 const std::vector<typename Arm::Joints>& joints) {
  double worst = 0;
  const auto compare = [&](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    worst = std::max(worst, (a - b).cwiseAbs().maxCoeff());
  };
  const auto matrix = [&](const double* numbers) {
    return Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic>>(numbers, 6, chain.size());
  };
  for (const auto& q : joints) {
    const Eigen::MatrixXd truth = reference::jacobian(chain, q);
    compare(matrix(kdl.jacobian(q.data())), truth);
    compare(matrix(kdl.forward_kinematics_and_jacobian(q.data())), truth);
    compare(Arm::jacobian(q), truth);
    compare(Arm::jacobian(q, Arm::angles(q)), truth);
    compare(Arm::with_pose(q).jacobian, truth);
  }
  return worst;
}

/// Checks and registers the Jacobian's benchmarks of one arm.
template <class Arm>
bool add_arm_jacobian() {
  add_setup([] {
    using Joints = typename Arm::Joints;
    const std::string robot = Arm::name;
    const reference::Chain chain = load_robot(robot);
    const auto joints = std::make_shared<std::vector<Joints>>(configurations<Joints>(chain));
    const auto kdl = std::make_shared<KdlArm>(description_of(robot));
    require_agreement(robot + " Jacobian", disagreement_of_jacobians<Arm>(chain, *kdl, *joints));
    const auto given = std::make_shared<std::vector<typename Arm::Angles>>();
    for (const Joints& q : *joints) given->push_back(Arm::angles(q));

    const std::string jacobian = "Jacobian/" + robot + "/";
    measure(jacobian + "KDL", [=](std::size_t i) { return kdl->jacobian((*joints)[i].data()); });
    measure(jacobian + "qvgen", [=](std::size_t i) { return Arm::jacobian((*joints)[i]); });
    measure(jacobian + "qvgen given",
            [=](std::size_t i) { return Arm::jacobian((*joints)[i], (*given)[i]); });
    const std::string both = "forward kinematics and Jacobian/" + robot + "/";
    measure(both + "KDL",
            [=](std::size_t i) { return kdl->forward_kinematics_and_jacobian((*joints)[i].data()); });
    measure(both + "qvgen", [=](std::size_t i) { return Arm::with_pose((*joints)[i]); });
  });
  return true;
}

}  // namespace comparison
