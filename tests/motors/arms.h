// SPDX-License-Identifier: MIT
// The arms under test, each with its functions by one name, and its description as the reference reads it.
#pragma once

#include <limits>
#include <random>
#include <string>

#include <qvgen/robots/belt_scara.h>
#include <qvgen/robots/bevel_arm.h>
#include <qvgen/robots/geared_seven.h>

#include "reference/load.h"

namespace qvgen::test {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Common part of the arms; each adds its functions.
template <int dof_>
struct MotorArm {
  static constexpr int dof = dof_;
  using Vector = Eigen::Matrix<double, dof, 1>;
  reference::Chain chain;
  MatrixXd coupling;

  explicit MotorArm(const std::string& name)
      : chain(reference::load(std::string(QVGEN_MOTOR_ARMS) + "/" + name + ".toml", {})),
        coupling(chain.coupling()) {}

  Vector joints(const Vector& motors) const { return coupling * motors; }
  Vector random_motors(std::mt19937& random, double size) const {
    std::uniform_real_distribution<double> between(-size, size);
    return Vector::NullaryExpr([&] { return between(random); });
  }
  /// How far a row's tool is from a pose, by the reference.
  double error_of(const Vector& motors, const qvgen::Pose<double>& pose) const {
    const Eigen::Isometry3d tool = reference::forward_kinematics(chain, motors);
    return (tool.linear() - pose.orientation.toRotationMatrix()).norm() +
           (tool.translation() - pose.position).norm();
  }
  /// True if joints differ by whole turns.
  bool is_same(const Vector& a, const Vector& b) const {
    const Vector difference = joints(a) - joints(b);
    for (int i = 0; i < dof; ++i) {
      const bool turns = chain.joints[static_cast<std::size_t>(i)].revolute;
      const double off = turns ? std::remainder(difference[i], 2 * M_PI) : difference[i];
      if (std::abs(off) > 1e-7) return false;
    }
    return true;
  }
};

struct BevelArm : MotorArm<6> {
  BevelArm() : MotorArm("bevel_arm") {}
  using Limits = robots::bevel_arm::Limits;
  static constexpr auto& names = robots::bevel_arm::joint_names;
  static auto pose(const Vector& q) { return robots::bevel_arm::forward_kinematics(q); }
  template <class... More>
  static auto solve(const Vector& /*at*/, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::bevel_arm::inverse_kinematics(pose, more...);
  }
  template <class... More>
  static auto near(const Vector& /*at*/, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::bevel_arm::inverse_kinematics_near(pose, more...);
  }
};

struct BeltScara : MotorArm<4> {
  BeltScara() : MotorArm("belt_scara") {}
  using Limits = robots::belt_scara::Limits;
  static constexpr auto& names = robots::belt_scara::joint_names;
  static auto pose(const Vector& q) { return robots::belt_scara::forward_kinematics(q); }
  static auto jacobian(const Vector& q) { return robots::belt_scara::jacobian(q); }
  template <class... More>
  static auto solve(const Vector& /*at*/, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::belt_scara::inverse_kinematics(pose, more...);
  }
  template <class... More>
  static auto near(const Vector& /*at*/, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::belt_scara::inverse_kinematics_near(pose, more...);
  }
};

/// The rail's value is given: that of the motors `at`.
struct GearedSeven : MotorArm<7> {
  GearedSeven() : MotorArm("geared_seven") {}
  using Limits = robots::geared_seven::Limits;
  static constexpr auto& names = robots::geared_seven::joint_names;
  static auto pose(const Vector& q) { return robots::geared_seven::forward_kinematics(q); }
  static auto jacobian(const Vector& q) { return robots::geared_seven::jacobian(q); }
  template <class... More>
  static auto solve(const Vector& at, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::geared_seven::inverse_kinematics_given_rail(pose, at[0], more...);
  }
  template <class... More>
  static auto near(const Vector& at, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::geared_seven::inverse_kinematics_near_given_rail(pose, at[0], more...);
  }
};

using MotorArms = testing::Types<BevelArm, BeltScara, GearedSeven>;

}  // namespace qvgen::test
