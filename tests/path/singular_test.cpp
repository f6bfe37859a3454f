// SPDX-License-Identifier: MIT
// Paths through singular poses and around them: straight through a wrist the motion goes on with the other
// branch; past a corner there it stops; next to it joints turn fast and nothing is lost; a cuspidal arm
// changes posture on the way.
#include <gtest/gtest.h>

#include "arms.h"
#include "reference/linear_algebra.h"

namespace path_test {
namespace {

Values wrist_straight() {
  Values q;
  q << 0.3, -0.2, 0.4, 0.5, 0, -0.3;
  return q;
}

bool begins_with(const Track& track, const Values& q, const AnyArm& arm) {
  return track.begin.s == 0 && difference(track.begin.q, q, arm.revolute).norm() < 1e-6;
}

/// The track that begins with some joints.
Track track_from(const Whole& whole, const Values& q, const AnyArm& arm) {
  for (const Track& track : whole.found())
    if (begins_with(track, q, arm)) return track;
  ADD_FAILURE() << "no track begins with " << q.transpose();
  return {};
}

TEST(SingularPath, StraightThroughTheWristTheMotionGoesOn) {
  const AnyArm& arm = arm_called("irb6640").arm;
  Values from = wrist_straight(), to = from;
  from[4] = -0.4;
  to[4] = 0.4;                                                // a turn of the fifth joint alone
  for (const std::size_t count : {2U, 3U, 10U, 11U, 101U}) {  // odd: a sample is singular
    SCOPED_TRACE(count);
    const Whole whole(arm, path_of_joints(arm, from, to, count), no_limits(), Between::screw);
    const Track track = track_from(whole, from, arm);
    EXPECT_EQ(track.end.cause, Cause::path_end);
    EXPECT_LT((track.end.q - to).norm(), 1e-6);
    EXPECT_EQ(track.crossings, 1);
    EXPECT_NE(track.first_branch, track.last_branch);
  }
}

TEST(SingularPath, APathThatBeginsOrEndsSingularIsFollowed) {
  const AnyArm& arm = arm_called("irb6640").arm;
  Values to = wrist_straight();
  to[4] = 0.6;
  for (const bool reversed : {false, true}) {
    auto samples = path_of_joints(arm, wrist_straight(), to, 9);
    if (reversed) std::reverse(samples.begin(), samples.end());
    const Whole whole(arm, samples, no_limits(), Between::screw);
    const auto tracks = whole.found();
    EXPECT_TRUE(std::any_of(tracks.begin(), tracks.end(), [&](const Track& track) {
      const End& far = reversed ? track.begin : track.end;
      const End& near = reversed ? track.end : track.begin;
      return difference(far.q, to, arm.revolute).norm() < 1e-6 &&
             near.s == (reversed ? whole.curve.end() : 0) && std::abs(near.q[4]) < 1e-5;
    }));
  }
}

/// In at one direction and out at another: the fourth joint would have to turn on the spot.
TEST(SingularPath, ACornerAtTheWristStopsTheMotion) {
  const AnyArm& arm = arm_called("irb6640").arm;
  Values from = wrist_straight(), to = from;
  from[4] = 0.4;
  to[3] += 1.0;
  to[5] -= 1.0;  // the same pose at theta5 = 0, another direction out of it
  to[4] = 0.4;
  std::vector<Pose<double>> samples = path_of_joints(arm, from, wrist_straight(), 8);
  for (int i = 1; i < 8; ++i) {
    Values q = to;
    q[4] = 0.4 * i / 7;
    samples.push_back(arm.forward(q));
  }
  const Whole whole(arm, samples, no_limits(), Between::screw);
  const Track track = track_from(whole, from, arm);
  EXPECT_EQ(track.end.cause, Cause::flip);
  EXPECT_NEAR(track.end.s, 7, 1e-9);
  EXPECT_EQ(track.end.free, 0b101000U) << "theta4 and theta6";
}

/// Past the wrist at 1e-3 ... 1e-7 rad the fourth joint makes half a turn; branches keep their numbers.
TEST(SingularPath, NextToTheWristJointsTurnFast) {
  const AnyArm& arm = arm_called("irb6640").arm;
  for (const double off : {1e-3, 1e-5, 1e-7}) {
    SCOPED_TRACE(off);
    Values from = wrist_straight();
    from[4] = 0.3;
    const Pose<double> start = arm.forward(from), straight = arm.forward(wrist_straight());
    const Vector3<double> turn =
        rotation_vector<double>(straight.orientation * start.orientation.conjugate());
    const Vector3<double> aside = turn.cross(Vector3<double>(0.3, 0.5, 0.8)).normalized();
    // The wrist's centre stays where it is only if the tool turns about it: the position follows the turn.
    const Pose<double> centre_to_tool = [&] {
      Values q = from;
      q[4] = 0;
      return arm.forward(q);
    }();
    static_cast<void>(centre_to_tool);
    std::vector<Pose<double>> samples;
    for (int i = 0; i <= 20; ++i) {
      Values q = from;
      q[4] = 0.3 - 0.03 * i;
      Pose<double> pose = arm.forward(q);
      pose.orientation = from_rotation_vector<double>(off * aside) * pose.orientation;
      samples.push_back(pose);
    }
    const Whole whole(arm, samples);
    const Track track = track_from(whole, arm.solve(samples[0])[0].q, arm);
    EXPECT_EQ(track.end.cause, Cause::path_end);
    EXPECT_EQ(track.first_branch, track.last_branch);
    EXPECT_EQ(track.crossings, 0);
    EXPECT_GT(std::abs(track.end.q[3] - track.begin.q[3]), 2.5);
  }
}

/// A loop of the tool from one posture to another with the determinant never zero.
TEST(SingularPath, ACuspidalArmChangesPostureWithoutASingularity) {
  const AnyArm& arm = arm_called("cuspidal").arm;
  std::mt19937 random(5);
  int changes = 0;
  for (int i = 0; i < 3000 && changes < 5; ++i) {
    const Values from = random_joints(arm, random);
    for (const auto& row : arm.solve(arm.forward(from))) {
      const Values way = difference(row.q, from, arm.revolute), to = from + way;
      bool regular = way.head<3>().norm() > 0.5;
      const bool sign = reference::determinant(arm.jacobian(from)) > 0;
      for (int k = 0; k <= 60 && regular; ++k) {
        const double determinant = reference::determinant(arm.jacobian(from + way * k / 60));
        regular = (determinant > 0) == sign && std::abs(determinant) > 1e-3;
      }
      if (!regular) continue;
      ++changes;
      const Whole whole(arm, path_of_joints(arm, from, to, 400));
      const Track track = track_from(whole, from, arm);
      EXPECT_EQ(track.end.cause, Cause::path_end);
      EXPECT_LT((track.end.q - to).norm(), 1e-6) << "another posture at the same pose";
      EXPECT_EQ(track.crossings, 0);
    }
  }
  EXPECT_GE(changes, 5);
}

TEST(SingularPath, OnePoseOrTheSameTwiceIsNoFault) {
  const AnyArm& arm = arm_called("ur5").arm;
  Values q;
  q << 0.1, -1.2, 1.4, -0.5, 0.7, 0.3;
  const Pose<double> pose = arm.forward(q);
  const Whole one(arm, {pose}), two(arm, {pose, pose, pose});
  EXPECT_EQ(one.record.tracks(), arm.solve(pose).size());
  EXPECT_EQ(two.record.tracks(), one.record.tracks());
  for (const Track& track : two.found()) EXPECT_EQ(track.end.cause, Cause::path_end);
}

}  // namespace
}  // namespace path_test
