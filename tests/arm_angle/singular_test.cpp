// SPDX-License-Identifier: MIT
// Poses at and near places where the elbow is straight or folded, the outer axes of shoulder or wrist are in
// line, or the wrist stands where the reference says nothing.
#include <gtest/gtest.h>

#include "random_arms.h"

namespace qvgen::test {
namespace {

using inverse::default_tolerance;
using inverse::arm_angle::arm_angle;
using inverse::arm_angle::solve;
using inverse::arm_angle::solve_within;

/// Singularities of a configuration.
struct Place {
  const char* name;
  bool straight, folded, shoulder, wrist;

  friend void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }
};
constexpr Place places[] = {{"straight", true, false, false, false},
                            {"folded", false, true, false, false},
                            {"shoulder", false, false, true, false},
                            {"wrist", false, false, false, true},
                            {"shoulder_and_wrist", false, false, true, true},
                            {"upright", true, false, true, false},
                            {"all", true, false, true, true},
                            {"all_folded", false, true, true, true}};

/// The angle from one direction to another about an axis across both, rad.
double turn(const Eigen::Vector3d& axis, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return std::atan2(axis.dot(from.cross(to)), from.dot(to));
}

Row placed(const Arm& arm, const Place& place, double off, Random& random) {
  Row q = random.joints();
  const double half_turn = random.between(0, 1) < 0.5 ? 0 : 3.14159265358979323846;
  const auto& a = arm.axes;
  const double straight = turn(a[3], arm.wrist - arm.elbow, arm.elbow - arm.shoulder);
  if (place.straight) q[3] = straight + off;
  if (place.folded) q[3] = straight + 3.14159265358979323846 + off;
  if (place.shoulder) q[1] = turn(a[1], a[2], a[0]) + half_turn + off;
  if (place.wrist) q[5] = turn(a[5], a[6], a[4]) + half_turn - off;
  return q;
}

class ArmAngleSingular : public testing::TestWithParam<std::tuple<NamedBuild, Place>> {
 protected:
  [[nodiscard]] Arm arm() { return random_.arm(std::get<0>(GetParam()).build); }
  [[nodiscard]] const Place& place() const { return std::get<1>(GetParam()); }

  void expect_right(const Arm& arm, const Row& q, double psi, const ArmAngleReference& reference) {
    const Pose<double> pose = pose_at(arm, q);
    const Found found = solve(arm, pose, psi, reference, Row::Zero(), default_tolerance);
    ASSERT_FALSE(found.empty());
    bool marked = false;
    double nearest = 10;
    for (int i = 0; i < found.size(); ++i) {
      EXPECT_LT(miss(arm, found[i].q, pose), 1e-12);
      for (int j = 0; j < i; ++j) EXPECT_GT(apart(found[i].q, found[j].q), 1e-9);
      marked = marked || found[i].continuum;
      nearest = std::min(nearest, apart(found[i].q, q));
    }
    EXPECT_EQ(found.status, marked ? Status::singular : Status::solved);
    ++asked_;
    answered_ += marked || nearest < 1e-2;
    for (const auto& row : solve(arm, pose, psi, reference, q, default_tolerance))
      EXPECT_LT(miss(arm, row.q, pose), 1e-12);
  }

  /// Marked, or the sampled joints are among the rows: but where a joint's angle hangs on the last digits of
  /// the arm angle, or on half the digits of a straight elbow.
  void expect_answered() const {
    const bool at_end = place().straight || place().folded;
    EXPECT_GE(answered_, (at_end && place().shoulder ? 0.5 : 0.9) * asked_);
  }

  Random random_{23};
  int asked_ = 0, answered_ = 0;
};

std::string name_of(const testing::TestParamInfo<std::tuple<NamedBuild, Place>>& info) {
  return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param).name;
}

TEST_P(ArmAngleSingular, ExactlyThere) {
  for (int i = 0; i < 200; ++i) {
    const Arm arm = this->arm();
    const Row q = placed(arm, place(), 0, random_);
    const ArmAngleReference reference = random_.reference();
    expect_right(arm, q, arm_angle(arm, q, reference), reference);
  }
  expect_answered();
}

TEST_P(ArmAngleSingular, NearIt) {
  for (int i = 0; i < 1000; ++i) {
    const Arm arm = this->arm();
    const double off = std::pow(10.0, -random_.between(1, 17)) * (random_.between(-1, 1) < 0 ? -1 : 1);
    const Row q = placed(arm, place(), off, random_);
    const ArmAngleReference reference = random_.reference();
    expect_right(arm, q, arm_angle(arm, q, reference), reference);
  }
  expect_answered();
}

TEST_P(ArmAngleSingular, WithinLimitsThereIsASolution) {
  // With the wrist on the shoulder the arm angle is one of three turns that are free.
  if (std::get<0>(GetParam()).build.equal_lengths && place().folded) GTEST_SKIP() << "see README.md";
  const int count = place().straight + place().folded + place().shoulder + place().wrist;
  int answered = 0;
  for (int i = 0; i < 300; ++i) {
    const Arm arm = this->arm();
    const double off = i % 2 == 0 || count > 1 ? 0 : std::pow(10.0, -random_.between(1, 17));
    const Row q = placed(arm, place(), off, random_);
    JointLimits<7> limits;
    for (int j = 0; j < 7; ++j) {
      limits.lower[j] = q[j] - random_.between(0.1, 2);
      limits.upper[j] = q[j] + random_.between(0.1, 2);
    }
    const Pose<double> pose = pose_at(arm, q);
    const auto found = solve_within(arm, pose, limits, {}, default_tolerance);
    answered += !found.empty();
    for (const auto& row : found) EXPECT_LT(miss(arm, row.q, pose), 1e-12);
  }
  // Places that are singular twice are single arm angles, which rounding may miss.
  EXPECT_GE(answered, count > 1 ? 290 : 300);
}

constexpr NamedBuild right_angled[] = {builds[0], builds[1], builds[2], builds[3]};
INSTANTIATE_TEST_SUITE_P(Places, ArmAngleSingular,
                         testing::Combine(testing::ValuesIn(right_angled), testing::ValuesIn(places)),
                         name_of);

TEST(ArmAngleReferences, WhereTheReferenceSaysNothingRowsAreMarked) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Arm arm = random.arm(builds[0].build);
    const Row q = random.joints();
    const Pose<double> pose = pose_at(arm, q);
    // The line from shoulder to wrist, as the solver is to see it.
    const Pose<double> tool = arm.tool;
    const Eigen::Vector3d line =
        (pose * (tool.orientation.conjugate() * (arm.wrist - tool.position)) - arm.shoulder).normalized();
    for (const auto& reference :
         {ArmAngleReference::conventional(line), ArmAngleReference::conventional(-line),
          ArmAngleReference::stereographic(line)}) {
      const Found found = solve(arm, pose, 0.3, reference, Row::Zero(), default_tolerance);
      EXPECT_EQ(found.status, Status::singular);
      for (const auto& row : found) EXPECT_LT(miss(arm, row.q, pose), 1e-12);
    }
    const auto regular = ArmAngleReference::stereographic(-line);
    const Found found = solve(arm, pose, arm_angle(arm, q, regular), regular, Row::Zero(), default_tolerance);
    EXPECT_EQ(found.status, Status::solved);
    double nearest = 10;
    for (const auto& row : found) nearest = std::min(nearest, apart(row.q, q));
    EXPECT_LT(nearest, 1e-6);
  }
}

}  // namespace
}  // namespace qvgen::test
