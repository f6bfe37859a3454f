// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

#include "arm_benchmarks.h"
#include "reference/dynamics.h"

namespace comparison {

/// Inverse and forward dynamics and the mass matrix by KDL, whose types are made once.
class KdlDynamics {
 public:
  explicit KdlDynamics(const KDL::Chain& chain)
      : n_(chain.getNrOfJoints()),
        chain_(chain),
        inverse_(chain_, gravity_),
        forward_(chain_, gravity_),
        parameters_(chain_, gravity_),
        q_(n_),
        qd_(n_),
        qdd_(n_),
        torque_(n_),
        mass_(n_),
        wrenches_(chain.getNrOfSegments(), KDL::Wrench::Zero()) {}

  template <class Joints>
  const Eigen::VectorXd& inverse(const Joints& q, const Joints& qd, const Joints& qdd) {
    q_.data = q, qd_.data = qd, qdd_.data = qdd;
    inverse_.CartToJnt(q_, qd_, qdd_, wrenches_, torque_);
    return torque_.data;
  }
  template <class Joints>
  const Eigen::MatrixXd& mass(const Joints& q) {
    q_.data = q;
    parameters_.JntToMass(q_, mass_);
    return mass_.data;
  }
  template <class Joints>
  const Eigen::VectorXd& forward(const Joints& q, const Joints& qd, const Joints& torque) {
    q_.data = q, qd_.data = qd, torque_.data = torque;
    forward_.CartToJnt(q_, qd_, torque_, wrenches_, qdd_);
    return qdd_.data;
  }

 private:
  unsigned n_;
  KDL::Vector gravity_{0, 0, -9.81};
  KDL::Chain chain_;
  KDL::ChainIdSolver_RNE inverse_;
  KDL::ChainFdSolver_RNE forward_;
  KDL::ChainDynParam parameters_;
  KDL::JntArray q_, qd_, qdd_, torque_;
  KDL::JntSpaceInertiaMatrix mass_;
  KDL::Wrenches wrenches_;
};

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

/// Largest difference of KDL and the generated code from the reference, relative to the largest component;
/// accelerations are compared through the forces that they take, since a wrist's inertia is a thousandth of
/// an arm's.
template <class Arm>
double disagreement_of_dynamics(const reference::Chain& chain, KdlDynamics& kdl,
                                const std::vector<Motion<Arm>>& all) {
  double worst = 0;
  const auto compare = [&](const Eigen::MatrixXd& a, const Eigen::MatrixXd& truth) {
    worst = std::max(worst, (a - truth).cwiseAbs().maxCoeff() / (1 + truth.cwiseAbs().maxCoeff()));
  };
  const auto torque_for = [&](const Motion<Arm>& m, const Eigen::VectorXd& qdd) {
    return reference::inverse_dynamics(chain, m.q, m.qd, qdd);
  };
  for (const Motion<Arm>& m : all) {
    const Eigen::VectorXd torque = torque_for(m, m.qdd);
    const Eigen::MatrixXd mass = reference::mass_matrix(chain, m.q);
    compare(kdl.inverse(m.q, m.qd, m.qdd), torque);
    compare(Arm::inverse(m.q, m.qd, m.qdd), torque);
    compare(Arm::inverse(m.q, m.qd, m.qdd, m.angles), torque);
    compare(kdl.mass(m.q), mass);
    compare(Arm::mass(m.q), mass);
    compare(Arm::mass(m.q, m.angles), mass);
    compare(torque_for(m, kdl.forward(m.q, m.qd, m.torque)), m.torque);
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
    const KdlArm model(chain);
    const auto kdl = std::make_shared<KdlDynamics>(model.chain());
    const auto all = std::make_shared<std::vector<Motion<Arm>>>(motions<Arm>(chain));
    require_agreement(robot + " dynamics", disagreement_of_dynamics<Arm>(chain, *kdl, *all) / 100);  // 1e-10
    const auto at = [all](std::size_t i) -> const Motion<Arm>& { return (*all)[i]; };

    const std::string inverse = "inverse dynamics/" + robot + "/";
    measure(inverse + "KDL",
            [=](std::size_t i) { return kdl->inverse(at(i).q, at(i).qd, at(i).qdd).data(); });
    measure(inverse + "qvgen", [=](std::size_t i) { return Arm::inverse(at(i).q, at(i).qd, at(i).qdd); });
    measure(inverse + "qvgen given",
            [=](std::size_t i) { return Arm::inverse(at(i).q, at(i).qd, at(i).qdd, at(i).angles); });
    const std::string mass = "mass matrix/" + robot + "/";
    measure(mass + "KDL", [=](std::size_t i) { return kdl->mass(at(i).q).data(); });
    measure(mass + "qvgen", [=](std::size_t i) { return Arm::mass(at(i).q); });
    measure(mass + "qvgen given", [=](std::size_t i) { return Arm::mass(at(i).q, at(i).angles); });
    const std::string forward = "forward dynamics/" + robot + "/";
    measure(forward + "KDL",
            [=](std::size_t i) { return kdl->forward(at(i).q, at(i).qd, at(i).torque).data(); });
    measure(forward + "qvgen", [=](std::size_t i) { return Arm::forward(at(i).q, at(i).qd, at(i).torque); });
    measure(forward + "qvgen given",
            [=](std::size_t i) { return Arm::forward(at(i).q, at(i).qd, at(i).torque, at(i).angles); });
  });
  return true;
}

}  // namespace comparison
