// SPDX-License-Identifier: MIT
// A mechanism with pins as MuJoCo has it: the joints' tree, and equality constraints as stiff as they can be.
#pragma once

#include <vector>

#include "mujoco_model.h"
#include "reference/loops.h"

namespace qvgen::test::loops {

class MujocoLoops {
 public:
  /// All closures are pins or balls; gravity is 9.81 m/s^2 along -z.
  explicit MujocoLoops(const reference::LoopMechanism& mechanism);

  /// Computes the accelerations of all joints at rest under forces of all joints.
  Eigen::VectorXd forward(const Eigen::VectorXd& q, const Eigen::VectorXd& forces);

 private:
  MujocoModel model_;
  MujocoData data_;
  std::vector<int> places_;  ///< by joint: where MuJoCo, which counts along the bodies, has it
};

}  // namespace qvgen::test::loops
