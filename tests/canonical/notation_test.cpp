// SPDX-License-Identifier: MIT
// Where a joint has its zero, which way its axis points and which frames a table has are notation: what is
// derived from a right-angled arm does not depend on them, nor what it costs.
#include <cstdlib>

#include <gtest/gtest.h>

#include "canonical/right_angles.h"
#include "description/reader.h"
#include "model/arithmetic.h"
#include "other_notation.h"
#include "pipeline/pipeline.h"
#include "verify/same_pose.h"

namespace qvgen {
namespace {

/// All that derivations of the kinematics read of a robot.
std::string text_of(const model::Robot& robot) {
  std::string text;
  const auto add = [&](const model::Vector3& v) {
    for (const model::Expression& component : v) text += model::to_string(component) + " ";
  };
  const auto place = [&](const model::Displacement& displacement) {
    add(displacement.translation);
    for (const model::Turn& turn : displacement.turns) {
      add(turn.axis);
      text += model::to_string(turn.angle) + "; ";
    }
  };
  place(robot.base);
  for (const model::Joint& joint : robot.joints) {
    text += joint.variable + (joint.type == model::JointType::revolute ? " turns " : " slides ");
    place(joint.before);
    add(joint.axis);
    place(joint.after);
  }
  place(robot.tool);
  return text;
}

TEST(Notation, DoesNotChangeWhatIsDerivedFrom) {
  std::mt19937 random(1);
  for (int k = 0; k < (test::is_long_run() ? 200 : 25); ++k) {
    const model::Robot robot = test::random_right_angled_robot(random);
    const model::Robot other = test::in_another_notation(robot, random);
    const std::vector<canonical::Arm> own = canonical::right_angled_models(robot);
    const std::vector<canonical::Arm> theirs = canonical::right_angled_models(other);
    ASSERT_FALSE(own.empty()) << text_of(robot);
    ASSERT_EQ(own.size(), theirs.size()) << text_of(robot);
    for (std::size_t i = 0; i < own.size(); ++i)
      ASSERT_EQ(text_of(own[i].robot), text_of(theirs[i].robot)) << text_of(robot);
    // And it is the arm that either describes.
    const std::size_t some = random() % own.size();
    ASSERT_NO_THROW(verify::certify_same_pose(robot, own[some])) << text_of(robot);
    ASSERT_NO_THROW(verify::certify_same_pose(other, theirs[some])) << text_of(other);
  }
}

TEST(Notation, IsNoConcernOfArmsWithObliqueAxes) {
  std::mt19937 random(2);
  model::Robot robot = test::random_right_angled_robot(random);
  robot.joints.front().axis = {
      model::Expression(cln::cl_RA(3) / 5), {}, model::Expression(cln::cl_RA(4) / 5)};
  EXPECT_TRUE(canonical::right_angled_models(robot).empty());
}

/// An arm with a wrist and one that reaches fewer poses stand for the others in usual runs.
class Counts : public ::testing::TestWithParam<const char*> {};

TEST_P(Counts, AreEqual) {
  const std::string robot = GetParam();
  if (robot != "puma560" && robot != "scara" && !test::is_long_run()) GTEST_SKIP() << "long runs have it";
  const std::string file = std::string(QVGEN_SOURCE_DIR) + "/generator/robots/" + robot + ".toml";
  const description::ReadResult described = description::read_file(file);
  ASSERT_TRUE(described.robot);
  std::mt19937 random(3);
  model::Robot other = test::in_another_notation(*described.robot, random);
  other.name += "_written_otherwise";
  const auto output = pipeline::generate({other}, {"kinematics", "jacobian", "inverse"}).front();
  const nlohmann::json committed = test::committed_counts(robot);
  ASSERT_GE(output.counts.size(), 9U);
  for (const auto& [function, entry] : output.counts.items()) {
    if (!entry.contains("emitted")) continue;
    const auto& own = committed.at(function).at("emitted");
    const nlohmann::json theirs = entry.at("emitted");
    if (function != "inverse_kinematics") {
      EXPECT_EQ(own, theirs) << function;
      continue;
    }
    // A tool that is turned at the described zero pose costs one product of the pose with a constant.
    for (const auto& [operation, count] : own.items()) {
      const int most = operation == "mul" ? 4 : operation == "add" ? 8 : 0;
      EXPECT_LE(std::abs(count.get<int>() - theirs.at(operation).get<int>()), most) << operation;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Counts, ::testing::Values("puma560", "irb6640", "stanford", "scara"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace qvgen
