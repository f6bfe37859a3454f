// SPDX-License-Identifier: MIT
// The equations of a log, Y p = tau, as one triangle for each joint: Householder's reflections keep all that
// a least-squares solution needs, without the squared condition number of normal equations. Weights may so be
// chosen after the data have been read, and logs are joined by joining triangles.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "identify/arm_regressor.h"
#include "identify/motion_log.h"

namespace qvgen::identify {

/// Equations of one joint; [Y tau] has been turned into a triangle with the same sums of squares.
class JointEquations {
 public:
  /// `columns` of Y are not zero for this joint.
  explicit JointEquations(std::vector<Eigen::Index> columns);

  /// Takes so many rows; `write` fills them, the torque in the last column.
  template <class Write>
  void add(Eigen::Index count, const Write& write) {
    if (filled_ + count > rows_.rows()) reduce();
    write(rows_.middleRows(filled_, count));
    filled_ += count;
  }
  /// Counts rows that hold measurements: those left out are written as zeros.
  void count(Eigen::Index measured) { measured_ += measured; }
  void add(const JointEquations& other);

  [[nodiscard]] const std::vector<Eigen::Index>& columns() const { return columns_; }
  [[nodiscard]] Eigen::Index measured() const { return measured_; }
  /// Returns the triangle, (n+1) x (n+1); the last column is that of the torque.
  [[nodiscard]] Eigen::MatrixXd triangle() const;

 private:
  void reduce();

  std::vector<Eigen::Index> columns_;
  Eigen::MatrixXd rows_;  ///< the triangle, then rows that wait
  Eigen::Index filled_;   ///< rows in use
  Eigen::Index measured_ = 0;
};

using Equations = std::vector<JointEquations>;

/// Bounds on what of a log is used.
struct UseOfLog {
  /// Rows of a joint that is slower (rad/s, m/s) are left out for this joint: friction at rest may be
  /// anything. A joint each; empty: all rows are used.
  std::vector<double> slowest = {};
};

/// Returns the equations of a log whose rates and accelerations are known; rows with any number that is not
/// finite are left out. The same numbers come out for any number of threads.
Equations equations_of(const ArmRegressor& arm, const MotionLog& log, const UseOfLog& use = {});
/// Adds equations of the same arm.
void add(Equations& all, const Equations& others);

/// Returns the torques that parameters predict, samples x joints.
Eigen::MatrixXd predicted(const ArmRegressor& arm, const MotionLog& log, const Eigen::VectorXd& parameters);

}  // namespace qvgen::identify
