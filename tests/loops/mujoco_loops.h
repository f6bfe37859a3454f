// SPDX-License-Identifier: MIT
// A mechanism with loops as MuJoCo has it: the joints' tree, on a free joint if its base floats, and equality
// constraints. Points that are one are <connect>, as stiff as can be; rods and gears are tendons of constant
// length.
#pragma once

#include <vector>

#include "mujoco_model.h"
#include "reference/loops.h"

namespace qvgen::test::loops {

/// Six joints in place of a base that floats are left out: the sixth one's link is on a free joint.
enum class Base { stands, floats };

class MujocoLoops {
 public:
  /// All closures are pins, balls or rods; gravity is 9.81 m/s^2 along -z.
  explicit MujocoLoops(const reference::LoopMechanism& mechanism, Base base = Base::stands);

  /// Computes the accelerations of all joints at rest under forces of all joints. Constraints are as stiff as
  /// can be, so joints without mass are off.
  Eigen::VectorXd forward(const Eigen::VectorXd& q, const Eigen::VectorXd& forces);

  /// Computes the accelerations of a base that floats and of all joints with exact constraints: MuJoCo's mass
  /// matrix, bias and constraint Jacobian, its rate by differences, and multipliers. `pose` is w x y z and
  /// metres; other vectors begin with the base's six, in its own frame, linear before angular.
  Eigen::VectorXd forward(const Eigen::VectorXd& pose, const Eigen::VectorXd& q,
                          const Eigen::VectorXd& velocity, const Eigen::VectorXd& forces);

 private:
  Eigen::MatrixXd constraints();

  MujocoModel model_;
  MujocoData data_;
  std::vector<int> places_, positions_;  ///< by joint: where MuJoCo, which counts along the bodies, has it
};

}  // namespace qvgen::test::loops
