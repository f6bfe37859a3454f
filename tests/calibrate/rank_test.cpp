// SPDX-License-Identifier: MIT
// What cannot be told: the exact rank of random arms is that of differences of the tests' own chain with
// every error there is, and data in which a joint stood still are found out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../identify/random_arm.h"
#include "reference/linear_algebra.h"
#include "simulate.h"

namespace calibrate_test {
namespace {

/// Returns the number of singular values that are not rounding.
Eigen::Index rank_of(const Scene& scene, const DataSet& set, bool tracker_known, bool target_known) {
  MatrixXd all;
  for (const Measurement& row : set.rows) {
    const MatrixXd rows = derivative(scene, row, tracker_known, target_known);
    all.conservativeResize(all.rows() + rows.rows(), rows.cols());
    all.bottomRows(rows.rows()) = rows;
  }
  const VectorXd values = reference::spectrum(all);
  return (values.array() > 1e-6 * values[0]).count();
}

/// Returns a description of an arm with axes at right angles or not, offsets or none, turns and slides.
std::string random_arm(std::mt19937& random) {
  const auto one_of = [&](const std::vector<std::string>& texts) { return texts[random() % texts.size()]; };
  std::string text = "name = \"arm\"\ntitle = \"random\"\n";
  const auto count = 2 + random() % 6;
  for (std::size_t i = 0; i < count; ++i) {
    text += "[[joint]]\ntype = \"" + one_of({"revolute", "revolute", "revolute", "prismatic"}) +
            "\"\naxis = \"" + one_of({"+x", "+y", "-y", "+z", "+z", "-z"}) + "\"\nvariable = \"t" +
            std::to_string(i) + "\"\n";
    if (random() % 2 == 0)
      text += "origin = [" + one_of({"0", "0.2"}) + ", 0, " + one_of({"0", "-0.15"}) + "]\n";
    if (random() % 4 == 0)
      text += "turns = [{ axis = \"+x\", angle = \"" + one_of({"30 deg", "90 deg", "0.3"}) + "\" }]\n";
    if (random() % 2 == 0)
      text += "link = [" + one_of({"0", "0.3"}) + ", " + one_of({"0", "0.1"}) + ", 0.05]\n";
  }
  return text;
}

TEST(Rank, OfRandomArmsIsThatOfDifferences) {
  std::mt19937 random(2);
  int compared = 0;
  const int trials = trial_count(30);
  for (int trial = 0; trial < trials; ++trial) {
    const std::string arm = random_arm(random);
    Scene scene = scene_of_text(arm, 1, 0);
    scene.data = static_cast<Data>(random() % 6);
    stand_anywhere(scene, 1 + random() % 2);
    const bool tracker_known = random() % 3 == 0,
               target_known = random() % 3 == 0 && scene.targets.size() == 1;
    if (tracker_known) scene.tracker.setIdentity();
    if (target_known) scene.targets = {Isometry3d::Identity()};
    const bool touches = scene.data == Data::plane || scene.data == Data::sphere;
    if (touches && arm.find("revolute") == std::string::npos) continue;
    if (touches) {  // a surface through points that the arm reaches
      const Vector3d at =
          (reference::forward_kinematics(scene.truth, random_joints(scene)) * scene.targets[0]).translation();
      scene.point = scene.data == Data::plane ? at : Vector3d(at + Vector3d(0.1, 0.2, -0.05));
      scene.radius = (at - scene.point).norm();
      if (scene.targets.size() > 1 || scene.truth.joints.size() < 4) continue;
    }
    const DataSet set = measure(scene, scene.data == Data::pose || scene.data == Data::camera ? 40 : 120);
    const Identifiable can =
        identifiable(scene.robot, setup_of(set, {Errors::all, false, tracker_known, target_known}));
    EXPECT_EQ(static_cast<Eigen::Index>(can.candidates.size()),
              rank_of(scene, set, tracker_known, target_known))
        << "data " << static_cast<int>(scene.data) << " known " << tracker_known << target_known << "\n"
        << arm;
    ++compared;
  }
  EXPECT_GE(compared, trials / 2);
}

/// Values are those of motors: errors of joints are told as if each joint had been read.
TEST(Rank, OfArmsWithMotorsIsThatOfDifferences) {
  std::mt19937 random(5);
  const auto trials = static_cast<unsigned>(trial_count(12));
  for (unsigned seed = 1; seed <= trials; ++seed) {
    const std::string kind = std::vector<std::string>{"RRR", "RRRR", "RPR", "RRRRR"}[seed % 4];
    const std::string arm = qvgen::test::ArmWriter(seed).with_motors(kind, false);
    Scene scene = scene_of_text(arm, 1, 0);
    scene.data = static_cast<Data>(random() % 3);
    stand_anywhere(scene);
    const DataSet set = measure(scene, scene.data == Data::pose ? 40 : 120);
    const Identifiable can = identifiable(scene.robot, setup_of(set, {Errors::all, false, false, false}));
    EXPECT_EQ(static_cast<Eigen::Index>(can.candidates.size()), rank_of(scene, set, false, false))
        << "data " << static_cast<int>(scene.data) << "\n"
        << arm;
  }
}

TEST(Rank, OfWholePosesIsTheKnownCount) {
  for (const auto& [robot, count] :
       {std::pair{"ur5", 30}, {"puma560", 30}, {"iiwa14", 34}, {"stanford", 28}, {"scara", 20}}) {
    const Scene scene = scene_of(robot, 1, 0);
    const Identifiable can = identifiable(scene.robot, setup_of(measure(scene, 1), {}));
    EXPECT_EQ(can.candidates.size(), static_cast<std::size_t>(count))
        << robot << ": 4 for a turn, 2 for a slide, and 6";
  }
}

TEST(Rank, AJointThatStoodStillIsFoundOut) {
  int found = 0;
  std::mt19937 random(3);
  const std::vector<std::string> robots{"ur5", "puma560", "scara", "stanford", "iiwa14"};
  const int trials = trial_count(15);
  for (int trial = 0; trial < trials; ++trial) {
    Scene scene =
        scene_of(robots[static_cast<std::size_t>(trial) % robots.size()], static_cast<unsigned>(trial));
    stand_anywhere(scene);
    scene.noise = 5e-5;
    scene.data = trial % 2 == 0 ? Data::pose : Data::position;
    const int held = static_cast<int>(random() % scene.truth.joints.size());
    const DataSet set = measure(scene, 80, held);
    DataError error;
    const auto result = calibrate(scene.robot, set, {}, error);
    ASSERT_TRUE(result) << error.message;
    EXPECT_EQ(static_cast<Eigen::Index>(result->active.size()), rank_of(scene, set, false, false))
        << scene.robot.name << " " << held;
    // Whatever cannot be told is told apart by the gaps on both sides of the joint.
    const auto touches = [&](std::size_t index) {
      const std::size_t gap = result->identifiable.model.parameters[index].gap;
      return gap == static_cast<std::size_t>(held) + 1 || gap == static_cast<std::size_t>(held) + 2;
    };
    bool named = false;
    for (const Dependence& each : result->dependent)
      named = named || touches(each.parameter) || std::any_of(each.on.begin(), each.on.end(), touches);
    found += named && !result->untold.empty() ? 1 : 0;
  }
  EXPECT_EQ(found, trials);
}

TEST(Rank, IsSaidInWords) {
  using testing::Contains;
  using testing::HasSubstr;
  const Scene ur5 = scene_of("ur5", 1, 0), scara = scene_of("scara", 1, 0);
  const DataSet poses = measure(ur5, 1);
  const auto never = [](const Scene& scene, const DataSet& set) {
    return identifiable(scene.robot, setup_of(set, {})).never;
  };
  EXPECT_THAT(
      never(ur5, poses),
      Contains("the offset of link 2 and the offset of link 3 only together with the offset of link 1"));
  EXPECT_THAT(never(ur5, poses),
              Contains(testing::AllOf(HasSubstr("the zero of joint 1, "),
                                      HasSubstr("only together with the tracker's frame"))));
  EXPECT_THAT(never(scara, measure(scara, 1)),
              Contains("the length of link 3 only together with the length of link 2"));
}

}  // namespace
}  // namespace calibrate_test
