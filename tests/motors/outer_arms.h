// SPDX-License-Identifier: MIT
// Arms of which several joints are given, behind one interface.
#pragma once

#include <qvgen/robots/gantry.h>
#include <qvgen/robots/rail_seven.h>

#include "arms.h"

namespace qvgen::test {

/// Eight joints: the first and one of the inner arm's seven are given.
struct RailSeven : MotorArm<8> {
  RailSeven() : MotorArm("rail_seven") {}
  static constexpr int given[] = {0, 3};
  static constexpr auto& info = robots::rail_seven::inverse_info_given_rail_theta3;
  using Limits = robots::rail_seven::Limits;
  static auto pose(const Vector& q) { return robots::rail_seven::forward_kinematics(q); }
  template <class... More>
  static auto solve(const Vector& at, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::rail_seven::inverse_kinematics_given_rail_theta3(pose, at[0], at[3], more...);
  }
  template <class... More>
  static auto near(const Vector& at, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::rail_seven::inverse_kinematics_near_given_rail_theta3(pose, at[0], at[3], more...);
  }
};

/// Nine joints: two in front and one behind are given.
struct Gantry : MotorArm<9> {
  Gantry() : MotorArm("gantry") {}
  static constexpr int given[] = {0, 1, 8};
  static constexpr auto& info = robots::gantry::inverse_info_given_gx_gz_flange;
  using Limits = robots::gantry::Limits;
  static auto pose(const Vector& q) { return robots::gantry::forward_kinematics(q); }
  template <class... More>
  static auto solve(const Vector& at, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::gantry::inverse_kinematics_given_gx_gz_flange(pose, at[0], at[1], at[8], more...);
  }
  template <class... More>
  static auto near(const Vector& at, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::gantry::inverse_kinematics_near_given_gx_gz_flange(pose, at[0], at[1], at[8], more...);
  }
};

}  // namespace qvgen::test
