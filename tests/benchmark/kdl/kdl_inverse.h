// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

namespace comparison {

/// KDL's two iterative inverse kinematics, which look for one solution from a start; types made once,
/// position and orientation sought to 1e-6.
class __attribute__((visibility("default"))) KdlInverse {
 public:
  /// Reads a robot description (generator/robots/README.md).
  explicit KdlInverse(const std::string& description);
  ~KdlInverse();
  KdlInverse(const KdlInverse&) = delete;
  KdlInverse& operator=(const KdlInverse&) = delete;

  /// The pose to be reached, as KdlArm::forward_kinematics gives it: twelve numbers.
  int levenberg_marquardt(const double* start, const double* goal);
  /// Newton and Raphson with the pseudo-inverse of the Jacobian. Both return KDL's error code, 0 for success.
  int newton(const double* start, const double* goal);
  [[nodiscard]] const double* result() const;  ///< the joints

 private:
  struct Solvers;
  std::unique_ptr<Solvers> solvers_;
};

}  // namespace comparison
