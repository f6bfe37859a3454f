// SPDX-License-Identifier: MIT
// The functions in C of the arms under test, behind one name each, and their answers as the C++ library's
// types.
#pragma once

#include <array>
#include <cstring>
#include <tuple>
#include <vector>

#include <qvgen/robots/nested_wrist.h>
#include <qvgen_belt_scara_inverse.h>
#include <qvgen_bevel_arm_inverse.h>
#include <qvgen_gantry_inverse.h>
#include <qvgen_geared_seven_inverse.h>
#include <qvgen_nested_wrist_metrics.h>
#include <qvgen_rail_seven_inverse.h>

#include "outer_arms.h"

namespace qvgen::test {

/// Bevel gears and a bar: six turns.
struct BevelInC : BevelArm {
  using Set = bevel_arm_solutions;
  using Representatives = bevel_arm_representatives;
  using Map = robots::bevel_arm::detail::MotorMap;
  static constexpr auto all = bevel_arm_inverse_kinematics;
  static constexpr auto within = bevel_arm_inverse_kinematics_within_limits;
  static constexpr auto next_to = bevel_arm_inverse_kinematics_near;
  static constexpr auto next_to_within = bevel_arm_inverse_kinematics_near_within_limits;
  static constexpr auto start = bevel_arm_start_representatives;
  static constexpr auto next = bevel_arm_next_representative;
  static auto given(const Vector& /*q*/) { return std::tuple<>(); }
};

/// Six turns; whole turns of the fourth move three motors.
struct NestedInC : MotorArm<6> {
  using Set = nested_wrist_solutions;
  using Representatives = nested_wrist_representatives;
  using Map = robots::nested_wrist::detail::MotorMap;
  static constexpr auto all = nested_wrist_inverse_kinematics;
  static constexpr auto within = nested_wrist_inverse_kinematics_within_limits;
  static constexpr auto next_to = nested_wrist_inverse_kinematics_near;
  static constexpr auto next_to_within = nested_wrist_inverse_kinematics_near_within_limits;
  static constexpr auto start = nested_wrist_start_representatives;
  static constexpr auto next = nested_wrist_next_representative;
  static auto pose(const Vector& q) { return robots::nested_wrist::forward_kinematics(q); }
  static auto given(const Vector& /*q*/) { return std::tuple<>(); }
  NestedInC() : MotorArm("nested_wrist") {}
  template <class... More>
  static auto solve(const Vector& /*at*/, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::nested_wrist::inverse_kinematics(pose, more...);
  }
  template <class... More>
  static auto near(const Vector& /*at*/, const qvgen::Pose<double>& pose, const More&... more) {
    return robots::nested_wrist::inverse_kinematics_near(pose, more...);
  }
};

/// Four joints, a slide among them, asked for by poses.
struct BeltInC : BeltScara {
  using Set = belt_scara_solutions;
  using Representatives = belt_scara_representatives;
  using Map = robots::belt_scara::detail::MotorMap;
  static constexpr auto all = belt_scara_inverse_kinematics;
  static constexpr auto within = belt_scara_inverse_kinematics_within_limits;
  static constexpr auto next_to = belt_scara_inverse_kinematics_near;
  static constexpr auto next_to_within = belt_scara_inverse_kinematics_near_within_limits;
  static constexpr auto start = belt_scara_start_representatives;
  static constexpr auto next = belt_scara_next_representative;
  static auto given(const Vector& /*q*/) { return std::tuple<>(); }
};

/// Seven joints, of which one that is a motor is given.
struct GearedInC : GearedSeven {
  using Set = geared_seven_solutions;
  using Representatives = geared_seven_representatives;
  using Map = robots::geared_seven::detail::MotorMap;
  static constexpr auto all = geared_seven_inverse_kinematics_given_rail;
  static constexpr auto within = geared_seven_inverse_kinematics_given_rail_within_limits;
  static constexpr auto next_to = geared_seven_inverse_kinematics_near_given_rail;
  static constexpr auto next_to_within = geared_seven_inverse_kinematics_near_given_rail_within_limits;
  static constexpr auto start = geared_seven_start_representatives;
  static constexpr auto next = geared_seven_next_representative;
  static auto given(const Vector& q) { return std::tuple(q[0]); }
};

struct RailInC : RailSeven {
  using Set = rail_seven_solutions;
  using Representatives = rail_seven_representatives;
  static constexpr auto all = rail_seven_inverse_kinematics_given_rail_theta3;
  static constexpr auto within = rail_seven_inverse_kinematics_given_rail_theta3_within_limits;
  static constexpr auto next_to = rail_seven_inverse_kinematics_near_given_rail_theta3;
  static constexpr auto next_to_within = rail_seven_inverse_kinematics_near_given_rail_theta3_within_limits;
  static constexpr auto start = rail_seven_start_representatives;
  static constexpr auto next = rail_seven_next_representative;
  static constexpr auto& kinds = robots::rail_seven::is_revolute;
  static auto given(const Vector& q) { return std::tuple(q[0], q[3]); }
};

struct GantryInC : Gantry {
  using Set = gantry_solutions;
  using Representatives = gantry_representatives;
  static constexpr auto all = gantry_inverse_kinematics_given_gx_gz_flange;
  static constexpr auto within = gantry_inverse_kinematics_given_gx_gz_flange_within_limits;
  static constexpr auto next_to = gantry_inverse_kinematics_near_given_gx_gz_flange;
  static constexpr auto next_to_within = gantry_inverse_kinematics_near_given_gx_gz_flange_within_limits;
  static constexpr auto start = gantry_start_representatives;
  static constexpr auto next = gantry_next_representative;
  static constexpr auto& kinds = robots::gantry::is_revolute;
  static auto given(const Vector& q) { return std::tuple(q[0], q[1], q[8]); }
};

/// Calls a function in C with a pose, the given values of `q`, and more arguments.
template <class Arm, class Function, class... More>
typename Arm::Set ask(Function function, const typename Arm::Vector& q, const qvgen::Pose<double>& pose,
                      More... more) {
  typename Arm::Set set;
  std::memset(static_cast<void*>(&set), 0x7f, sizeof set);
  const std::array<double, 4> turn{pose.orientation.w(), pose.orientation.x(), pose.orientation.y(),
                                   pose.orientation.z()};
  const int count = std::apply(
      [&](auto... given) {
        return function(turn.data(), pose.position.data(), given..., more..., nullptr,
                        inverse::default_tolerance, &set);
      },
      Arm::given(q));
  EXPECT_EQ(count, set.count);
  return set;
}

/// The capacity of a set in C.
template <class Set>
constexpr int capacity_of = static_cast<int>(std::extent_v<decltype(Set::rows)>);

/// A set in C as the C++ library's type.
template <class Arm>
Solutions<Arm::dof, capacity_of<typename Arm::Set>> in_cxx(const typename Arm::Set& set) {
  Solutions<Arm::dof, capacity_of<typename Arm::Set>> found;
  for (int k = 0; k < set.count; ++k)
    inverse::append(found, Joints<Arm::dof>(set.rows[k].q), set.rows[k].branch, set.rows[k].continuum != 0);
  found.status = static_cast<Status>(set.status);
  found.effort = {set.effort.passes, set.effort.steps, set.effort.used_up != 0};
  return found;
}

}  // namespace qvgen::test
