// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <qvgen/inverse_velocity_within.h>

namespace qvgen::test {

struct JointRates {
  VelocityStatus status;
  Eigen::VectorXd qd;
  double residual;
};

/// Joint rates within limits, with the factor of scaled ones, or whether limits were in the way.
struct LimitedRates : JointRates {
  double factor = 1;
  bool limited = false;
};

/// Rates by the runtime's templates; rates.h has the definitions, which are compiled once for each number of
/// joints.
template <int dof>
struct RatesOf {
  using VectorXd = Eigen::VectorXd;
  using Twist = Eigen::Matrix<double, 6, 1>;
  using Jacobian = Eigen::Matrix<double, 6, dof>;
  static JointRates of_the_whole(const Jacobian& jacobian, const VectorXd& twist);
  static LimitedRates scaled(const InverseVelocity<double, dof>& rates, const VectorXd& lower,
                             const VectorXd& upper);
  static LimitedRates within(const Jacobian& jacobian, const VectorXd& twist, const VectorXd& lower,
                             const VectorXd& upper);
};

/// The generated functions of one robot behind one type; geometry is that of the defaults.
struct RobotUnderTest {
  using Vector = Eigen::VectorXd;
  using Matrix = Eigen::MatrixXd;
  std::string name;
  int dof = 0;
  std::function<Matrix(const Vector& q)> jacobian;
  std::function<Matrix(const Vector& q)> jacobian_in_float;
  std::function<Matrix(const Vector& q)> jacobian_with_angles_given;
  std::function<Matrix(const Vector& q)> tool_jacobian;
  std::function<Matrix(const Vector& q, const Eigen::Vector3d& point)> jacobian_at;
  std::function<std::pair<Eigen::Isometry3d, Matrix>(const Vector& q)> both;
  std::function<Vector(const Vector& q, const Vector& qd)> velocity;
  std::function<Matrix(const Vector& q, const Vector& qd)> jacobian_dot;
  std::function<Vector(const Vector& q, const Vector& qd)> jacobian_dot_times_qd;
  std::function<Vector(const Vector& q)> singularity_measures;
  std::function<JointRates(const Vector& q, const Vector& twist)> inverse_velocity;
  std::function<JointRates(const Vector& q, const Vector& twist)> inverse_velocity_of_the_whole;
  using Limited = LimitedRates(const Vector& q, const Vector& twist, const Vector& lower,
                               const Vector& upper);
  std::function<Limited> scaled, within;
  std::vector<std::string> singularity_names;
};

inline std::vector<RobotUnderTest>& robots() {
  static std::vector<RobotUnderTest> all;
  return all;
}

inline bool add_robot(RobotUnderTest robot) {
  robots().push_back(std::move(robot));
  return true;
}

}  // namespace qvgen::test
