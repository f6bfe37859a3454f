// SPDX-License-Identifier: MIT
// The functions in C of each arm behind vectors of any length, and the C++ library on the rows that they
// find.
#include <array>
#include <cstring>
#include <map>

#include <gtest/gtest.h>
#include <qvgen/robots/belt_scara.h>
#include <qvgen/robots/bevel_arm.h>
#include <qvgen/robots/geared_seven.h>
#include <qvgen/robots/nested_wrist.h>
#include <qvgen/robots/palletiser.h>
#include <qvgen/robots/rail_seven.h>
#include <qvgen_belt_scara_inverse.h>
#include <qvgen_bevel_arm_inverse.h>
#include <qvgen_geared_seven_inverse.h>
#include <qvgen_nested_wrist_inverse.h>
#include <qvgen_palletiser_inverse.h>
#include <qvgen_rail_seven_inverse.h>
#ifdef QVGEN_ALL_ARMS
#include <qvgen/robots/gantry.h>
#include <qvgen_gantry_inverse.h>
#endif

#include "in_c.h"

namespace qvgen::test {
namespace {

/// Calls the C++ library of arms whose whole turns move several motors.
template <class Map>
struct LibraryOfMotors {
  static constexpr bool uses_seed = false;
  template <int dof, int capacity>
  static auto nearest(const Solutions<dof, capacity>& rows, const Joints<dof>& seed,
                      const JointLimits<dof>& limits) {
    return inverse::nearest_within_motors<Map>(rows, seed, limits);
  }
  template <int dof, int capacity>
  static auto all(const Solutions<dof, capacity>& rows, const JointLimits<dof>& limits) {
    return AllWithinMotors<Map, capacity>(rows, limits);
  }
};

/// Calls the C++ library of arms in which every joint turns by itself.
template <const auto& kinds>
struct LibraryOfJoints {
  static constexpr bool uses_seed = true;
  template <int dof, int capacity>
  static auto nearest(const Solutions<dof, capacity>& rows, const Joints<dof>& seed,
                      const JointLimits<dof>& limits) {
    return nearest_within_limits(rows, limits, kinds, seed);
  }
  template <int dof, int capacity>
  static auto all(const Solutions<dof, capacity>& rows, const JointLimits<dof>& limits) {
    return within_limits(rows, limits, kinds);
  }
};

/// A set with nothing in it that a function may rely on.
template <class Set>
Set untouched() {
  Set set;
  std::memset(static_cast<void*>(&set), 0x7f, sizeof set);
  return set;
}

const double* data_of(const VectorXd* values) { return values == nullptr ? nullptr : values->data(); }

/// Functions of an arm from those in C: `solve(at, set, turn, position, more...)` and so on.
template <class Library, class Set, class Solve, class Within, class Near, class NearWithin, class First,
          class Next>
FunctionsInC functions_of(const Solve& solve, const Within& within, const Near& near,
                          const NearWithin& near_within, const First& first, const Next& next) {
  constexpr int dof = dof_of<Set>;
  const auto ask = [](const auto& function, const VectorXd& at, const qvgen::Pose<double>& pose,
                      auto... more) {
    auto set = untouched<Set>();
    const std::array<double, 4> turn{pose.orientation.w(), pose.orientation.x(), pose.orientation.y(),
                                     pose.orientation.z()};
    const int count = function(at, &set, turn.data(), pose.position.data(), more...);
    EXPECT_EQ(count, set.count);
    return set;
  };
  const auto choose = [ask](const auto& anywhere, const auto& inside) {
    return [=](const VectorXd& at, const qvgen::Pose<double>& pose, const Asked& asked) {
      const double* seed = data_of(asked.seed);
      if (asked.limits == nullptr) return rows_of(in_cxx(ask(anywhere, at, pose, seed)));
      return rows_of(
          in_cxx(ask(inside, at, pose, seed, asked.limits->lower.data(), asked.limits->upper.data())));
    };
  };
  const double* none = nullptr;
  FunctionsInC all;
  all.solve = choose(solve, within);
  all.near = choose(near, near_within);
  all.representatives = [=](const VectorXd& at, const qvgen::Pose<double>& pose, const Bounds& limits) {
    const Set set = ask(solve, at, pose, none);
    auto each = first(set, limits.lower.data(), limits.upper.data());
    Rows rows;
    while (rows.rows.size() < Rows::most_kept && next(&each) == 1)
      rows.append(each.row.q, dof, each.row.branch, each.row.continuum != 0);
    for (int again = 0; rows.rows.size() < Rows::most_kept && again < 2; ++again) EXPECT_EQ(next(&each), 0);
    return rows;
  };
  all.representatives_of_cxx = [=](const VectorXd& at, const qvgen::Pose<double>& pose,
                                   const Bounds& limits) {
    Rows rows;
    append_all(rows, Library::all(in_cxx(ask(solve, at, pose, none)), fixed<dof>(limits)));
    return rows;
  };
  all.nearest_of_cxx = [=](const VectorXd& at, const qvgen::Pose<double>& pose, const VectorXd& seed,
                           const Bounds& limits) {
    const Set set = ask(solve, at, pose, Library::uses_seed ? seed.data() : none);
    return rows_of(Library::nearest(in_cxx(set), fixed<dof>(seed), fixed<dof>(limits)));
  };
  return all;
}

// A function in C of an arm with the given values of the motors `at`.
#define QVGEN_TEST_CALL(FUNCTION, ...)                                                                       \
  []([[maybe_unused]] const VectorXd& at, auto* set, const double* turn, const double* position,             \
     auto... more) {                                                                                         \
    return FUNCTION(turn, position __VA_OPT__(, ) __VA_ARGS__, more..., nullptr, inverse::default_tolerance, \
                    set);                                                                                    \
  }

// An arm: its name, the C++ library that it takes, what its inverse kinematics is called after, and its given
// values.
#define QVGEN_TEST_ARM_IN_C(ARM, LIBRARY, SUFFIX, ...)                                     \
  functions_of<LIBRARY, ARM##_solutions>(                                                  \
      QVGEN_TEST_CALL(ARM##_inverse_kinematics##SUFFIX, __VA_ARGS__),                      \
      QVGEN_TEST_CALL(ARM##_inverse_kinematics##SUFFIX##_within_limits, __VA_ARGS__),      \
      QVGEN_TEST_CALL(ARM##_inverse_kinematics_near##SUFFIX, __VA_ARGS__),                 \
      QVGEN_TEST_CALL(ARM##_inverse_kinematics_near##SUFFIX##_within_limits, __VA_ARGS__), \
      [](const ARM##_solutions& set, const double* lower, const double* upper) {           \
        ARM##_representatives each;                                                        \
        ARM##_start_representatives(&set, lower, upper, &each);                            \
        return each;                                                                       \
      },                                                                                   \
      ARM##_next_representative)

}  // namespace

void add_functions_in_c(std::map<std::string, Arm>& arms) {
  const auto add = [&](const std::string& name, const FunctionsInC& functions) {
    arms.at(name).in_c = functions;
  };
  add("bevel_arm", QVGEN_TEST_ARM_IN_C(bevel_arm, LibraryOfMotors<robots::bevel_arm::detail::MotorMap>, ));
  add("nested_wrist",
      QVGEN_TEST_ARM_IN_C(nested_wrist, LibraryOfMotors<robots::nested_wrist::detail::MotorMap>, ));
  add("belt_scara", QVGEN_TEST_ARM_IN_C(belt_scara, LibraryOfMotors<robots::belt_scara::detail::MotorMap>, ));
  add("palletiser", QVGEN_TEST_ARM_IN_C(palletiser, LibraryOfMotors<robots::palletiser::detail::MotorMap>, ));
  add("geared_seven",
      QVGEN_TEST_ARM_IN_C(geared_seven, LibraryOfMotors<robots::geared_seven::detail::MotorMap>, _given_rail,
                          at[0]));
  add("rail_seven", QVGEN_TEST_ARM_IN_C(rail_seven, LibraryOfJoints<robots::rail_seven::is_revolute>,
                                        _given_rail_theta3, at[0], at[3]));
#ifdef QVGEN_ALL_ARMS
  add("gantry", QVGEN_TEST_ARM_IN_C(gantry, LibraryOfJoints<robots::gantry::is_revolute>, _given_gx_gz_flange,
                                    at[0], at[1], at[8]));
#endif
}

}  // namespace qvgen::test
