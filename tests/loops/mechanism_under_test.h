// SPDX-License-Identifier: MIT
// Generated functions of a mechanism with loops behind one interface of dynamic sizes, for tests of all of
// them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <qvgen/inverse/solutions.h>

namespace qvgen::test::loops {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Row {
  VectorXd q;
  int branch;
  bool is_free, meets;
};

struct Set {
  Status status;
  std::vector<Row> rows;
};

struct Tip {
  std::string name;
  std::function<Eigen::Matrix4d(const VectorXd& q)> pose;
  std::function<MatrixXd(const VectorXd& q)> jacobian;
  std::function<VectorXd(const VectorXd&q, const VectorXd&wrench)> motor_forces = {}, loop_forces = {};
  // Inverse kinematics, from a pose as a matrix; empty where it is not generated.
  std::function<Set(const Eigen::Matrix4d& pose)> inverse = {};
  std::function<Set(const Eigen::Matrix4d&pose, const VectorXd&seed)> inverse_next_to = {}, inverse_near = {};
  std::function<Set(const Eigen::Matrix4d& pose)> within_limits = {};
  int capacity = 0;
};

struct MechanismUnderTest {
  std::string name;
  std::string description;  ///< path
  int dof = 0, driven = 0, capacity = 0;
  std::vector<int> driven_joints, passive_joints, output_joints;
  std::function<Set(const VectorXd& a)> assemble;
  std::function<Set(const VectorXd& a, const VectorXd& seed)> assemble_near;
  std::function<Set(const VectorXd& outputs)> from_outputs;  ///< empty without a platform
  std::function<VectorXd(const VectorXd& a, const VectorXd& seed)>
      follow;  ///< gives nothing where it does not close
  std::function<bool(const VectorXd& a, const VectorXd& seed)> crosses;
  std::function<VectorXd(const VectorXd& q)> gaps;
  std::function<MatrixXd(const VectorXd& q)> rates;
  std::function<VectorXd(const VectorXd& q, const VectorXd& qd, const VectorXd& add)> accelerations;
  std::function<double(const VectorXd&q)> drive_measure, platform_measure;
  std::function<VectorXd(const VectorXd& q, const VectorXd& ad, const VectorXd& add)> inverse_dynamics;
  std::function<VectorXd(const VectorXd& q, const VectorXd& ad, const VectorXd& forces)> forward_dynamics;
  std::function<MatrixXd(const VectorXd&q)> mass_matrix, loop_jacobian;
  std::function<VectorXd(const VectorXd& q, const VectorXd& ad, const VectorXd& add)> loop_forces;
  std::vector<Tip> tips;
};

/// All that the build has generated.
const std::vector<MechanismUnderTest>& mechanisms();
bool add_mechanism(MechanismUnderTest mechanism);

}  // namespace qvgen::test::loops
