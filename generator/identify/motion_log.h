// SPDX-License-Identifier: MIT
// A measured motion in numbers, in SI units and on the joints' side: what every step of an identification
// reads.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace qvgen::identify {

/// Samples are rows, joints that follow none are columns.
struct MotionLog {
  std::string name;          ///< the file, for messages
  std::vector<double> time;  ///< s, ascending; empty if neither rates nor accelerations have to be derived
  Eigen::MatrixXd q;         ///< rad or m
  Eigen::MatrixXd qd, qdd;   ///< per s and s^2; without rows where they were not measured
  Eigen::MatrixXd torque;    ///< Nm or N
  Eigen::MatrixXd temperature =
      {};  ///< degrees Celsius; without rows where it was not measured or is not used

  [[nodiscard]] Eigen::Index samples() const { return q.rows(); }
  [[nodiscard]] Eigen::Index joints() const { return q.cols(); }
};

}  // namespace qvgen::identify
