// SPDX-License-Identifier: MIT
// Palletisers with four motors and more joints, which keep the tool level: each has the closed form of its
// five joints, certified in sixty digits. What is not balanced is refused with the reason.
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "description/reader.h"
#include "model/followers.h"
#include "model/merged_joints.h"
#include "pipeline/products/inverse_derivation.h"
#include "verify/inverse/certify.h"

namespace qvgen::pipeline {
namespace {

/// How the forearm's and the hand's angles come from motors.
enum class Kind {
  bars,       ///< joints that turn back behind each link: two on one line
  absolute,   ///< the forearm's motor is at the base: the elbow follows both
  relative,   ///< the elbow has its own motor: the hand's joint follows both
  telescope,  ///< a slide in place of the elbow
  number
};

class Palletiser {
 public:
  Palletiser(unsigned seed, Kind kind) : random_(seed) {
    const std::string across = any_of({"0, 1, 0", "0, -1, 0", "'3/5', '4/5', 0", "0, '4/5', '3/5'"});
    text_ = "name = \"palletiser\"\ntitle = \"Keeps its tool level\"\n";
    add("revolute", any_of({"0, 0, 1", "0, 0, -1"}), "j1");
    add("revolute", across, "j2");
    if (kind == Kind::bars) {
      add_on_line(across);
      add("revolute", across, "j3");
      add("revolute", across, "level", "-j3");
    } else if (kind == Kind::absolute) {
      text_ += "[[motor]]\nvariable = \"m3\"\n";
      add("revolute", across, "elbow", "m3 - j2");
      add("revolute", across, "level", "-m3");
    } else if (kind == Kind::relative) {
      add("revolute", across, "j3");
      add("revolute", across, "level", "-j2 - j3");
    } else {
      add("prismatic", across.back() == '0' ? "0, 0, 1" : "1, 0, 0", "j3");  // across the turns
      add("revolute", across, "level", "-j2");
    }
    add("revolute", any_of({"0, 0, 1", "0, 0, -1"}), "j4");
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string any_of(const std::vector<std::string>& all) { return all[random_() % all.size()]; }
  std::string length() { return fmt::format("'{}/20'", 1 + static_cast<int>(random_() % 19)); }

  void add_on_line(const std::string& axis) {
    text_ += fmt::format(
        "[[joint]]\ntype = \"revolute\"\naxis = [{}]\nvariable = \"back2\"\nfollows = \"-j2\"\n", axis);
  }

  void add(const std::string& type, const std::string& axis, const std::string& variable,
           const std::string& follows = "") {
    text_ += "[[joint]]\ntype = \"" + type + "\"\nvariable = \"" + variable + "\"\n";
    text_ += "axis = [" + axis + "]\nlink = [" + length() + ", " + length() + ", " + length() + "]\n";
    if (!follows.empty()) text_ += "follows = \"" + follows + "\"\n";
  }

  std::mt19937 random_;
  std::string text_;
};

model::Robot robot_of(const std::string& text) {
  auto read = description::read_text(text, "palletiser.toml");
  EXPECT_TRUE(read.robot) << text;
  return read.robot ? *read.robot : model::Robot();
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(LevelPalletisers, OfEveryKindHaveACertifiedClosedForm) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Palletiser palletiser(seed, static_cast<Kind>(seed % static_cast<unsigned>(Kind::number)));
    const model::Robot robot = robot_of(palletiser.text());
    const InverseDerivation derivation = derive_inverse(robot);
    ASSERT_EQ(derivation.closed_forms.size(), 1U)
        << palletiser.text() << testing::PrintToString(derivation.reasons);
    const derive::inverse::Derivation& form = derivation.closed_forms.front();
    EXPECT_EQ(form.problem.task, model::Task::position_and_yaw);
    EXPECT_EQ(form.problem.own_joints, 5);
    EXPECT_EQ(model::variables(derivation.coupled), model::variables(robot));
    EXPECT_NO_THROW(verify::certify_inverse(form.problem, lower(form.plan), 2)) << palletiser.text();
  }
}

/// A whole pose may be asked for; its rows are then looked at.
TEST(LevelPalletisers, MayBeAskedForPoses) {
  const Palletiser palletiser(3, Kind::absolute);
  const model::Robot robot = robot_of(replaced(palletiser.text(), "title", "task = \"pose\"\ntitle"));
  const InverseDerivation derivation = derive_inverse(robot);
  ASSERT_EQ(derivation.closed_forms.size(), 1U);
  EXPECT_EQ(derivation.closed_forms.front().problem.task, model::Task::pose);
  EXPECT_EQ(derivation.closed_forms.front().problem.filter, derive::inverse::Filter::pose);
}

TEST(LevelPalletisers, ThatDoNotKeepTheToolLevelAreRefused) {
  const std::string text = Palletiser(1, Kind::relative).text();
  const std::string keeps = "follows = \"-j2 - j3\"";
  for (const std::string follows :
       {"follows = \"-j2 + j3\"", "follows = \"-j2 - 2 j3\"", "follows = \"-j3\""}) {
    const InverseDerivation derivation = derive_inverse(robot_of(replaced(text, keeps, follows)));
    EXPECT_FALSE(derivation.found());
    EXPECT_THAT(derivation.reasons, testing::ElementsAre(testing::HasSubstr("keep the tool level")));
  }
  const InverseDerivation tilted =
      derive_inverse(robot_of(replaced(text, keeps, "follows = \"-j2 - j3 + 10 deg\"")));
  EXPECT_FALSE(tilted.found());
}

TEST(LevelPalletisers, OfOtherTasksAreRefused) {
  const std::string text = Palletiser(1, Kind::absolute).text();
  const auto asked = [&](const std::string& task) {
    return derive_inverse(robot_of(replaced(text, "title", "task = \"" + task + "\"\ntitle"))).found();
  };
  EXPECT_TRUE(asked("position_and_yaw"));
  EXPECT_FALSE(asked("position_and_direction"));
}

/// A bar in front of a forearm that a wrist ends: six motors, and six joints when those on one line are one.
TEST(MergedJoints, LeaveAnArmAsManyJointsAsMotors) {
  std::string text = "name = \"bar_arm\"\ntitle = \"A bar turns the forearm back\"\n";
  const auto joint = [&](const std::string& variable, const std::string& axis, const std::string& link,
                         const std::string& more = "") {
    text += "[[joint]]\ntype = \"revolute\"\nvariable = \"" + variable + "\"\naxis = \"" + axis +
            "\"\nlink = [" + link + "]\n" + more;
  };
  joint("j1", "+z", "0.1, 0, 0.4");
  joint("j2", "+y", "0, 0, 0.5");
  joint("back", "-y", "0, 0, 0", "follows = \"j2\"\n");
  joint("m3", "+y", "0.4, 0, 0");
  joint("j4", "+x", "0, 0, 0");
  joint("j5", "+y", "0, 0, 0");
  joint("j6", "+x", "0.1, 0, 0");
  const model::Robot robot = robot_of(text);
  const InverseDerivation derivation = derive_inverse(robot);
  ASSERT_EQ(derivation.closed_forms.size(), 1U) << testing::PrintToString(derivation.reasons);
  EXPECT_EQ(derivation.coupled.joints.size(), 6U);
  EXPECT_EQ(model::variables(derivation.coupled), model::variables(robot));
  const derive::inverse::Derivation& form = derivation.closed_forms.front();
  EXPECT_EQ(form.plan.capacity, 8);
  EXPECT_NO_THROW(verify::certify_inverse(form.problem, lower(form.plan), 2));
}

/// A joint that another one behind it takes away moves nothing.
TEST(MergedJoints, ThatCancelDisappear) {
  const std::string text =
      "name = \"nothing\"\ntitle = \"Turned and turned back\"\n"
      "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"a\"\nlink = [0.3, 0, 0]\n"
      "[[joint]]\ntype = \"revolute\"\naxis = \"+y\"\nvariable = \"b\"\nfollows = \"a\"\n"
      "[[joint]]\ntype = \"revolute\"\naxis = \"+y\"\nvariable = \"c\"\nfollows = \"-a\"\nlink = [0.2, 0, "
      "0]\n"
      "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"d\"\nlink = [0.3, 0, 0]\n";
  const model::Robot merged = model::with_merged_joints(robot_of(text));
  ASSERT_EQ(merged.joints.size(), 2U);
  EXPECT_EQ(merged.joints[1].variable, "d");
  EXPECT_EQ(to_string(merged.joints[1].before.translation[0]), "1/5");
}

}  // namespace
}  // namespace qvgen::pipeline
