// SPDX-License-Identifier: MIT
// From logs to numbers: rates and accelerations, regressor, weighted least squares, and the full set of
// parameters that a body can have.
#pragma once

#include <optional>
#include <vector>

#include "identify/consistent.h"
#include "identify/estimate.h"
#include "identify/payload.h"
#include "model/robot.h"

namespace qvgen::identify {

struct Request {
  std::vector<DriveParameter> drives = all_drives();
  double gravity = 9.80665;            ///< m/s^2 along the world's -z
  std::optional<Eigen::Index> window;  ///< samples of the polynomials, an odd number; none: the best of some
  std::optional<double> standstill;    ///< rad/s, m/s; none: a hundredth of the joint's greatest rate
  std::optional<double> mass;          ///< of all links, kg
  bool stribeck = false, temperature = false;  ///< friction beyond the drives' (extra_columns.h)
};

/// Rates and accelerations as they were made.
struct Filter {
  bool rates = false, accelerations = false;  ///< derived, not measured
  Eigen::Index half = 0;                      ///< of the windows
  double band = 0;                            ///< Hz, of the accelerations
};

/// Each joint's side of the result; torques in Nm or N.
struct JointResidual {
  Eigen::Index rows = 0;
  double torque = 0, residual = 0;  ///< root mean squares
  double noise = 0;                 ///< standard deviation by the degrees of freedom
  double correlation = 0;           ///< of a residual with the next one; near 0: white
  std::optional<double> hold_out;   ///< root mean square in logs that were not fitted
};

struct Identification {
  ArmRegressor arm;
  Filter filter;
  Estimate estimate;
  FullSet full;
  std::vector<double> standstill;
  std::vector<JointResidual> joints;
  std::vector<MotionLog> logs;                  ///< with rates and accelerations
  std::optional<PayloadEstimate> payload = {};  ///< of logs with one
  std::vector<std::string> doubts = {};         ///< sentences on what seems to be wrong with the logs
};

/// Identifies an arm. Logs of `hold_out` are predicted, not fitted; those of `payload` were made with one.
/// Throws std::runtime_error where the data are too few, or the description lacks a length.
Identification identify(const model::Robot& robot, std::vector<MotionLog> logs,
                        std::vector<MotionLog> hold_out = {}, const Request& request = {},
                        std::vector<MotionLog> payload = {});

}  // namespace qvgen::identify
