// SPDX-License-Identifier: MIT
#include <stdexcept>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl_parser/kdl_parser.hpp>

#include "peers.h"

namespace arms {
namespace {

class Kdl : public Peer {
 public:
  explicit Kdl(const std::string& urdf) {
    KDL::Tree tree;
    if (!kdl_parser::treeFromString(urdf, tree) || !tree.getChain("base_link", "tool0", chain_))
      throw std::runtime_error("KDL cannot read the URDF");
  }
  Eigen::Isometry3d tool(const VectorXd& q) override {
    KDL::Frame frame;
    KDL::ChainFkSolverPos_recursive(chain_).JntToCart(array(q), frame);
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) result(i, j) = frame(i, j);
    return result;
  }
  MatrixXd jacobian(const VectorXd& q) override {
    KDL::Jacobian result(chain_.getNrOfJoints());
    KDL::ChainJntToJacSolver(chain_).JntToJac(array(q), result);
    return result.data;
  }
  VectorXd inverse_dynamics(const VectorXd& q, const VectorXd& qd, const VectorXd& qdd) override {
    KDL::JntArray torque(chain_.getNrOfJoints());
    const KDL::Wrenches none(chain_.getNrOfSegments(), KDL::Wrench::Zero());
    KDL::ChainIdSolver_RNE(chain_, gravity_).CartToJnt(array(q), array(qd), array(qdd), none, torque);
    return torque.data;
  }
  VectorXd forward_dynamics(const VectorXd& q, const VectorXd& qd, const VectorXd& torque) override {
    KDL::JntSpaceInertiaMatrix mass(chain_.getNrOfJoints());
    KDL::ChainDynParam(chain_, gravity_).JntToMass(array(q), mass);
    return mass.data.ldlt().solve(torque - inverse_dynamics(q, qd, VectorXd::Zero(q.size())));
  }

 private:
  static KDL::JntArray array(const VectorXd& values) {
    KDL::JntArray result(static_cast<unsigned>(values.size()));
    result.data = values;
    return result;
  }
  KDL::Chain chain_;
  KDL::Vector gravity_{0, 0, -9.81};
};

}  // namespace

std::unique_ptr<Peer> kdl(const std::string& urdf) { return std::make_unique<Kdl>(urdf); }

}  // namespace arms
