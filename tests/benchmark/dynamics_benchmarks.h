// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "arm_benchmarks.h"
#include "mujoco.h"
#include "reference/dynamics.h"

namespace comparison {

/// A motion: position, rate and acceleration, sines and cosines, and the forces that cause it.
template <class Arm>
struct Motion {
  typename Arm::Joints q, qd, qdd, torque;
  typename Arm::Angles angles;
};

template <class Arm>
std::vector<Motion<Arm>> motions(const reference::Chain& chain) {
  const auto q = configurations<typename Arm::Joints>(chain);
  std::vector<Motion<Arm>> result;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const auto &qd = q[(i + 85) % q.size()], &qdd = q[(i + 170) % q.size()];
    result.push_back({q[i], qd, qdd, Arm::inverse(q[i], qd, qdd), Arm::angles(q[i])});
  }
  return result;
}

/// Largest difference of KDL, MuJoCo and the generated code from the reference, relative to the largest
/// component; accelerations are compared through the forces that they take, since a wrist's inertia is a
/// thousandth of an arm's.
template <class Arm>
double disagreement_of_dynamics(const reference::Chain& chain, KdlArm& kdl, MujocoArm& mujoco,
                                const std::vector<Motion<Arm>>& all) {
  double worst = 0;
  const auto compare = [&](const Eigen::MatrixXd& a, const Eigen::MatrixXd& truth) {
    worst = std::max(worst, (a - truth).cwiseAbs().maxCoeff() / (1 + truth.cwiseAbs().maxCoeff()));
  };
  const auto torque_for = [&](const Motion<Arm>& m, const Eigen::VectorXd& qdd) {
    return reference::inverse_dynamics(chain, m.q, m.qd, qdd);
  };
  const auto vector = [&](const double* numbers) {
    return Eigen::Map<const Eigen::VectorXd>(numbers, chain.size());
  };
  const auto compare_library = [&](auto& library, const Motion<Arm>& m) {
    compare(vector(library.inverse_dynamics(m.q.data(), m.qd.data(), m.qdd.data())), torque_for(m, m.qdd));
    compare(Eigen::Map<const Eigen::MatrixXd>(library.mass_matrix(m.q.data()), chain.size(), chain.size()),
            reference::mass_matrix(chain, m.q));
    const auto qdd = vector(library.forward_dynamics(m.q.data(), m.qd.data(), m.torque.data()));
    compare(torque_for(m, qdd), m.torque);
  };
  for (const Motion<Arm>& m : all) {
    const Eigen::VectorXd torque = torque_for(m, m.qdd);
    const Eigen::MatrixXd mass = reference::mass_matrix(chain, m.q);
    compare_library(kdl, m);
    compare_library(mujoco, m);
    compare(Arm::inverse(m.q, m.qd, m.qdd), torque);
    compare(Arm::inverse(m.q, m.qd, m.qdd, m.angles), torque);
    compare(Arm::mass(m.q), mass);
    compare(Arm::mass(m.q, m.angles), mass);
    compare(torque_for(m, Arm::forward(m.q, m.qd, m.torque)), m.torque);
    compare(torque_for(m, Arm::forward(m.q, m.qd, m.torque, m.angles)), m.torque);
  }
  return worst;
}

template <class Arm>
bool add_arm_dynamics() {
  add_setup([] {
    const std::string robot = Arm::name;
    const reference::Chain chain = load_robot(robot);
    const auto kdl = std::make_shared<KdlArm>(description_of(robot));
    const auto mujoco = std::make_shared<MujocoArm>(chain);
    const auto all = std::make_shared<std::vector<Motion<Arm>>>(motions<Arm>(chain));
    require_agreement(robot + " dynamics",
                      disagreement_of_dynamics<Arm>(chain, *kdl, *mujoco, *all) / 100);  // 1e-10
    const auto at = [all](std::size_t i) -> const Motion<Arm>& { return (*all)[i]; };

    const std::string inverse = "inverse dynamics/" + robot + "/";
    measure(inverse + "KDL", [=](std::size_t i) {
      return kdl->inverse_dynamics(at(i).q.data(), at(i).qd.data(), at(i).qdd.data());
    });
    measure(inverse + "MuJoCo", [=](std::size_t i) {
      return mujoco->inverse_dynamics(at(i).q.data(), at(i).qd.data(), at(i).qdd.data());
    });
    measure(inverse + "qvgen", [=](std::size_t i) { return Arm::inverse(at(i).q, at(i).qd, at(i).qdd); });
    measure(inverse + "qvgen given",
            [=](std::size_t i) { return Arm::inverse(at(i).q, at(i).qd, at(i).qdd, at(i).angles); });
    const std::string mass = "mass matrix/" + robot + "/";
    measure(mass + "KDL", [=](std::size_t i) { return kdl->mass_matrix(at(i).q.data()); });
    measure(mass + "MuJoCo", [=](std::size_t i) { return mujoco->mass_matrix(at(i).q.data()); });
    measure(mass + "qvgen", [=](std::size_t i) { return Arm::mass(at(i).q); });
    measure(mass + "qvgen given", [=](std::size_t i) { return Arm::mass(at(i).q, at(i).angles); });
    const std::string forward = "forward dynamics/" + robot + "/";
    measure(forward + "KDL", [=](std::size_t i) {
      return kdl->forward_dynamics(at(i).q.data(), at(i).qd.data(), at(i).torque.data());
    });
    measure(forward + "MuJoCo", [=](std::size_t i) {
      return mujoco->forward_dynamics(at(i).q.data(), at(i).qd.data(), at(i).torque.data());
    });
    measure(forward + "qvgen", [=](std::size_t i) { return Arm::forward(at(i).q, at(i).qd, at(i).torque); });
    measure(forward + "qvgen given",
            [=](std::size_t i) { return Arm::forward(at(i).q, at(i).qd, at(i).torque, at(i).angles); });
  });
  return true;
}

}  // namespace comparison
