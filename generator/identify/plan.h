// SPDX-License-Identifier: MIT
// A motion that tells much: each joint follows a short Fourier series about the middle of its range, with a
// smooth begin and end at rest. Of some hundred random ones, and changes of the best, the one with the
// largest determinant of information wins (D-optimal: no choice of units changes it). Where the description
// has inertias and limits of torque, motions that would need more are made smaller. A fixed seed makes the
// search repeatable.
#pragma once

#include <optional>
#include <vector>

#include "identify/estimate.h"
#include "model/robot.h"

namespace qvgen::identify {

struct PlanRequest {
  double seconds = 20;
  double rate = 100;   ///< samples per second of the table
  double speed = 1;    ///< rad/s, m/s of joints whose description has no velocity limit
  double share = 0.8;  ///< of limits of speed, of torque and of ranges that is used
  int trials = 150;    ///< of the search
  std::vector<DriveParameter> drives = all_drives();
};

struct Plan {
  MotionLog motion;      ///< with rates and accelerations, without torques
  double condition = 0;  ///< of the information, columns scaled to length one
  ArmRegressor arm;
  Eigen::VectorXd deviation;  ///< expected, of each parameter, for white noise of 1 Nm (N) in every torque
  /// Greatest share of a joint's limit of torque that the described arm needs; nothing where no inertias or
  /// no limits say it.
  std::optional<double> effort = {};
};

/// Plans a motion. Throws std::runtime_error for a slide without limits, and for limits of torque that do not
/// let the arm be held in the middle of its ranges.
Plan plan(const model::Robot& robot, const PlanRequest& request);

/// Returns the motion as a table: time, q1 ..., qd1 ....
std::string plan_table(const model::Robot& robot, const MotionLog& motion);

/// Returns what a motion would tell, as text.
std::string plan_summary(const Plan& plan);

}  // namespace qvgen::identify
