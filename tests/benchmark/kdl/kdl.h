// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

namespace comparison {

/// An arm in Orocos KDL. Numbers go in and out; KDL's and Eigen's types stay inside (CMakeLists.txt says
/// why).
///
/// Measured calls: joints are copied in, KDL computes in its own types, made once. A result is a pointer to
/// KDL's own numbers, valid until the next call; matrices are stored by columns.
class __attribute__((visibility("default"))) KdlArm {
 public:
  /// Reads a robot description (generator/robots/README.md).
  explicit KdlArm(const std::string& description);
  ~KdlArm();
  KdlArm(const KdlArm&) = delete;
  KdlArm& operator=(const KdlArm&) = delete;

  const double* forward_kinematics(const double* q);  ///< 4 x 3: position, then the rows of the rotation
  const double* jacobian(const double* q);            ///< 6 x n, at the tool, linear rows first
  /// Both at one configuration: KDL has no function for it, so this is the sum of the two.
  const double* forward_kinematics_and_jacobian(const double* q);
  const double* inverse_dynamics(const double* q, const double* qd, const double* qdd);     ///< n
  const double* mass_matrix(const double* q);                                               ///< n x n
  const double* forward_dynamics(const double* q, const double* qd, const double* torque);  ///< n

 private:
  struct Solvers;
  std::unique_ptr<Solvers> solvers_;
};

}  // namespace comparison
