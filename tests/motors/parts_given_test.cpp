// SPDX-License-Identifier: MIT
// Several given joints beside a part of a pose, some in front of the others, in C++ and C: rows keep the
// given values and reach that part, the joints that it was made from are there. given_anywhere_test.cpp has
// random arms.
#include <map>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/rail_pitch.h>
#include <qvgen/robots/torso_torch.h>
#include <qvgen_rail_pitch_inverse.h>
#include <qvgen_torso_torch_inverse.h>
#ifdef QVGEN_ALL_ARMS
#include <qvgen/robots/turned_level.h>
#include <qvgen_turned_level_inverse.h>
#endif

#include "asked_part.h"
#include "in_c.h"

namespace qvgen::test {
namespace {

using Eigen::Vector3d;

/// Kinds of parts: the arguments of functions in C++ and C.
struct Pitch {
  static PositionAndPitch<double> in_cxx(const Part& part) { return {part.position, part.pitch}; }
  static double in_c(const Part& part) { return part.pitch; }
};
struct Level {
  static PositionAndInclination<double> in_cxx(const Part& part) { return {part.position, part.direction}; }
  static const double* in_c(const Part& part) { return part.direction.data(); }
};
struct Torch {
  static PositionAndDirection<double> in_cxx(const Part& part) { return {part.position, part.direction}; }
  static const double* in_c(const Part& part) { return part.direction.data(); }
};

/// An arm: what its compiled functions say.
struct PartArm {
  int dof;
  std::vector<int> given;
  InverseInfo info;
  std::function<Rows(const VectorXd&at, const Part&part, const Asked&asked)> solve, near, solve_in_c;
  std::function<Rows(const VectorXd& at, const Pose<double>& pose, const VectorXd& seed)> solve_pose;
};

template <class Kind, int dof, class Set, class Solve, class Near, class SolveInC>
PartArm arm_of(const InverseInfo& info, std::vector<int> given, const Solve& solve, const Near& near,
               const SolveInC& solve_in_c) {
  PartArm arm{dof, std::move(given), info, {}, {}, {}, {}};
  arm.solve = [solve](const VectorXd& at, const Part& part, const Asked& asked) {
    const auto& target = Kind::in_cxx(part);
    if (asked.seed == nullptr) return rows_of(solve(at, target));
    if (asked.limits == nullptr) return rows_of(solve(at, target, fixed<dof>(*asked.seed)));
    return rows_of(solve(at, target, fixed<dof>(*asked.seed), fixed<dof>(*asked.limits)));
  };
  arm.near = [near](const VectorXd& at, const Part& part, const Asked& asked) {
    return rows_of(near(at, Kind::in_cxx(part), fixed<dof>(*asked.seed)));
  };
  arm.solve_in_c = [solve_in_c](const VectorXd& at, const Part& part, const Asked& asked) {
    Set set;
    solve_in_c(at, asked.seed->data(), &set, part.position.data(), Kind::in_c(part));
    return rows_of(in_cxx(set));
  };
  arm.solve_pose = [solve](const VectorXd& at, const Pose<double>& pose, const VectorXd& seed) {
    return rows_of(solve(at, pose, fixed<dof>(seed)));
  };
  return arm;
}

// The indices of the given joints of an arm, and what its functions are called after.
#define QVGEN_TEST_PART_ARM(ARM, KIND, SUFFIX, SUFFIX_IN_C, GIVEN, ...)                        \
  arm_of<KIND, robots::ARM::dof, ARM##_solutions>(                                             \
      robots::ARM::inverse_info##SUFFIX, GIVEN,                                                \
      [](const VectorXd& at, const auto& target, const auto&... more) {                        \
        return robots::ARM::inverse_kinematics##SUFFIX(target, __VA_ARGS__, more...);          \
      },                                                                                       \
      [](const VectorXd& at, const auto& target, const auto&... more) {                        \
        return robots::ARM::inverse_kinematics_near##SUFFIX(target, __VA_ARGS__, more...);     \
      },                                                                                       \
      [](const VectorXd& at, const double* seed, ARM##_solutions* set, const auto... target) { \
        ARM##_inverse_kinematics##SUFFIX##SUFFIX_IN_C(target..., __VA_ARGS__, seed, nullptr,   \
                                                      ARM##_default_tolerance, set);           \
      })

std::map<std::string, PartArm> make_part_arms() {
  using List = std::vector<int>;
  std::map<std::string, PartArm> arms;
  arms["rail_pitch"] = QVGEN_TEST_PART_ARM(rail_pitch, Pitch, _given_rail_roll, _of_position_and_pitch,
                                           (List{0, 5}), at[0], at[5]);
  arms["torso_torch"] = QVGEN_TEST_PART_ARM(torso_torch, Torch, _given_torso_q6, _of_position_and_direction,
                                            (List{0, 6}), at[0], at[6]);
#ifdef QVGEN_ALL_ARMS
  arms["turned_level"] = QVGEN_TEST_PART_ARM(turned_level, Level, _given_rail_table,
                                             _of_position_and_inclination, (List{0, 1}), at[0], at[1]);
#endif
  return arms;
}

const PartArm& part_arm(const std::string& name) {
  static const std::map<std::string, PartArm> arms = make_part_arms();
  return arms.at(name);
}

class PartsGiven : public testing::TestWithParam<const char*> {
 protected:
  const PartArm& arm_ = part_arm(GetParam());
  AskedArm reference_{std::string(QVGEN_MOTOR_ARMS) + "/" + GetParam() + ".toml", arm_.info.task,
                      Vector3d(arm_.info.tool_axis), arm_.given};

  VectorXd joints() {
    std::uniform_real_distribution<double> uniform(-3, 3);
    VectorXd q(arm_.dof);
    for (double& joint : q) joint = uniform(random_);
    return q;
  }
  [[nodiscard]] Part part_of(const VectorXd& q) const { return reference_.part(q); }
  [[nodiscard]] double way(const VectorXd& a, const VectorXd& b) const { return reference_.way(a, b); }
  void expect_reached(const VectorXd& row, const VectorXd& q) {
    EXPECT_LT(reference_.gap(row, q), 1e-9);
    for (const int i : arm_.given) EXPECT_EQ(row[i], q[i]);
  }

 private:
  std::mt19937 random_{11};
};
INSTANTIATE_TEST_SUITE_P(Of, PartsGiven, testing::Values("rail_pitch", "torso_torch"), name_of);
#ifdef QVGEN_ALL_ARMS
INSTANTIATE_TEST_SUITE_P(LongRuns, PartsGiven, testing::Values("turned_level"), name_of);
#endif

TEST_P(PartsGiven, AreToldByTheInfo) {
  EXPECT_EQ(arm_.info.given_joint, arm_.given[0]);
  EXPECT_EQ(arm_.info.more_given, static_cast<int>(arm_.given.size()) - 1);
}

TEST_P(PartsGiven, RowsReachThePartThatIsAskedFor) {
  for (int k = 0; k < 300; ++k) {
    const VectorXd q = joints();
    const Part part = part_of(q);
    const Rows found = arm_.solve(q, part, {});
    ASSERT_EQ(found.status, Status::solved);
    bool is_there = false;
    for (const Row& row : found) {
      expect_reached(row.q, q);
      is_there = is_there || way(row.q, q) < 1e-6;
    }
    EXPECT_TRUE(is_there) << q.transpose();
  }
}

TEST_P(PartsGiven, APoseGivesTheSameRows) {
  for (int k = 0; k < 50; ++k) {
    const VectorXd q = joints();
    const auto pose = Pose<double>::from_isometry(reference_.tool(q));
    const Rows found = arm_.solve_pose(q, pose, q);
    ASSERT_FALSE(found.empty());
    EXPECT_LT(way(found[0].q, q), 1e-6);
    if (arm_.info.task == Task::position_and_direction) continue;  // whole poses alone
    EXPECT_EQ(found.size, arm_.solve(q, part_of(q), {}).size);
  }
}

TEST_P(PartsGiven, TakeSeedsAndLimits) {
  for (int k = 0; k < 100; ++k) {
    const VectorXd q = joints(), around = VectorXd::Constant(arm_.dof, 0.05);
    const Part part = part_of(q);
    const Rows seeded = arm_.solve(q, part, {&q, nullptr});
    ASSERT_FALSE(seeded.empty());
    EXPECT_LT(way(seeded[0].q, q), 1e-6);
    const Rows near = arm_.near(q, part, {&q, nullptr});
    ASSERT_EQ(near.size, 1U);
    EXPECT_LT(distance(near[0].q, q), 1e-6);
    Bounds limits{q - around, q + around};
    const Rows inside = arm_.solve(q, part, {&q, &limits});
    ASSERT_GE(inside.size, 1U);
    EXPECT_LT(distance(inside[0].q, q), 1e-6);
    const int given = arm_.given[1];
    limits.lower[given] = q[given] + 0.01;  // the given value is outside
    EXPECT_TRUE(arm_.solve(q, part, {&q, &limits}).empty());
  }
}

TEST_P(PartsGiven, CHasTheRowsOfCpp) {
  for (int k = 0; k < 100; ++k) {
    const VectorXd q = joints();
    const Part part = part_of(q);
    const Rows wanted = arm_.solve(q, part, {&q, nullptr}), found = arm_.solve_in_c(q, part, {&q, nullptr});
    ASSERT_EQ(found.size, wanted.size);
    for (std::size_t i = 0; i < found.size; ++i) EXPECT_LT(way(found[i].q, wanted[i].q), 1e-9);
  }
}

TEST_P(PartsGiven, AreNoneForWhatIsNoNumberOrFar) {
  const VectorXd q = joints();
  Part part = part_of(q);
  for (const int i : arm_.given) {
    VectorXd odd = q;
    odd[i] = nan;
    EXPECT_EQ(arm_.solve(odd, part, {}).status, Status::invalid);
  }
  part.position.x() = 1e4;
  EXPECT_EQ(arm_.solve(q, part, {}).status, Status::unreachable);
  part.position.x() = nan;
  EXPECT_EQ(arm_.solve(q, part, {}).status, Status::invalid);
}

}  // namespace
}  // namespace qvgen::test
