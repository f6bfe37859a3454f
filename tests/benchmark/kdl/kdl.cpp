// SPDX-License-Identifier: MIT
#include "kdl.h"

#include <algorithm>
#include <cstddef>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/chainjnttojacsolver.hpp>

#include "chain.h"
#include "reference/load.h"

namespace comparison {

/// KDL's solvers keep a reference to their chain: it comes before them, and nothing is copied or moved.
struct KdlArm::Solvers {
  explicit Solvers(const reference::Chain& robot)
      : chain(to_kdl(robot)),
        n(chain.getNrOfJoints()),
        pose(chain),
        tangent(chain),
        inverse(chain, gravity),
        forward(chain, gravity),
        parameters(chain, gravity),
        wrenches(chain.getNrOfSegments(), KDL::Wrench::Zero()) {}

  static void copy(const double* from, KDL::JntArray& to) { std::copy_n(from, to.rows(), to.data.data()); }

  KDL::Vector gravity{0, 0, -9.81};
  KDL::Chain chain;
  unsigned n;
  KDL::ChainFkSolverPos_recursive pose;
  KDL::ChainJntToJacSolver tangent;
  KDL::ChainIdSolver_RNE inverse;
  KDL::ChainFdSolver_RNE forward;
  KDL::ChainDynParam parameters;
  KDL::JntArray q{n}, qd{n}, qdd{n}, torque{n};
  KDL::Frame frame;
  KDL::Jacobian jacobian{n};
  KDL::JntSpaceInertiaMatrix mass{static_cast<int>(n)};
  KDL::Wrenches wrenches;
};

KdlArm::KdlArm(const std::string& description)
    : solvers_(std::make_unique<Solvers>(reference::load(description))) {}

KdlArm::~KdlArm() = default;

const double* KdlArm::forward_kinematics(const double* q) {
  // One array of twelve numbers: the position, then the rotation by rows.
  static_assert(sizeof(KDL::Frame) == 12 * sizeof(double) && offsetof(KDL::Frame, p) == 0);
  Solvers::copy(q, solvers_->q);
  solvers_->pose.JntToCart(solvers_->q, solvers_->frame);
  return solvers_->frame.p.data;
}

const double* KdlArm::jacobian(const double* q) {
  Solvers::copy(q, solvers_->q);
  solvers_->tangent.JntToJac(solvers_->q, solvers_->jacobian);
  return solvers_->jacobian.data.data();
}

const double* KdlArm::forward_kinematics_and_jacobian(const double* q) {
  Solvers::copy(q, solvers_->q);
  solvers_->pose.JntToCart(solvers_->q, solvers_->frame);
  solvers_->tangent.JntToJac(solvers_->q, solvers_->jacobian);
  return solvers_->jacobian.data.data();
}

const double* KdlArm::inverse_dynamics(const double* q, const double* qd, const double* qdd) {
  Solvers::copy(q, solvers_->q);
  Solvers::copy(qd, solvers_->qd);
  Solvers::copy(qdd, solvers_->qdd);
  solvers_->inverse.CartToJnt(solvers_->q, solvers_->qd, solvers_->qdd, solvers_->wrenches, solvers_->torque);
  return solvers_->torque.data.data();
}

const double* KdlArm::mass_matrix(const double* q) {
  Solvers::copy(q, solvers_->q);
  solvers_->parameters.JntToMass(solvers_->q, solvers_->mass);
  return solvers_->mass.data.data();
}

const double* KdlArm::forward_dynamics(const double* q, const double* qd, const double* torque) {
  Solvers::copy(q, solvers_->q);
  Solvers::copy(qd, solvers_->qd);
  Solvers::copy(torque, solvers_->torque);
  solvers_->forward.CartToJnt(solvers_->q, solvers_->qd, solvers_->torque, solvers_->wrenches, solvers_->qdd);
  return solvers_->qdd.data.data();
}

}  // namespace comparison
