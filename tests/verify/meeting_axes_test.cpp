// SPDX-License-Identifier: MIT
// Random arms with three axes through a point, where four joints are all that there are, or where the three
// come together only in another order of the joints. What is derived is right to fifty digits.
#include <array>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "derive/inverse/inverse.h"
#include "description/reader.h"
#include "verify/inverse/certify.h"

namespace {

using namespace qvgen;

class RandomArm {
 public:
  explicit RandomArm(unsigned seed) : random_(seed) {}

  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  /// Directions of which no neighbours are parallel; a third of them oblique.
  std::string axis() {
    constexpr std::array<const char*, 9> axes{"1, 0, 0",
                                              "0, 1, 0",
                                              "0, 0, 1",
                                              "-1, 0, 0",
                                              "0, -1, 0",
                                              "0, 0, -1",
                                              R"("3/5", 0, "4/5")",
                                              R"("2/7", "-3/7", "6/7")",
                                              R"(0, "5/13", "-12/13")"};
    int next = last_;
    while (next % 3 == last_ % 3 && (next < 6) == (last_ < 6)) next = below(below(3) == 0 ? 9 : 6);
    last_ = next;
    return axes[static_cast<std::size_t>(next)];
  }
  /// The direction of the latest axis, or against it.
  std::string along_latest() {
    constexpr std::array<const char*, 9> against{"-1, 0, 0",
                                                 "0, -1, 0",
                                                 "0, 0, -1",
                                                 "1, 0, 0",
                                                 "0, 1, 0",
                                                 "0, 0, 1",
                                                 R"("-3/5", 0, "-4/5")",
                                                 R"("-2/7", "3/7", "-6/7")",
                                                 R"(0, "-5/13", "12/13")"};
    return below(2) == 0 ? against[static_cast<std::size_t>(last_)] : "";
  }
  std::string offset() {
    const auto length = [this] {
      return "\"" + std::to_string(1 + below(9)) + "/" + std::to_string(11 + below(7)) + "\"";
    };
    const std::string x = length(), y = length();
    return x + ", " + y + ", " + length();
  }
  void add(bool turns, const std::string& axis, const std::string& origin = "0, 0, 0") {
    text_ += "[[joint]]\ntype = \"" + std::string(turns ? "revolute" : "prismatic") + "\"\naxis = [" + axis +
             "]\nvariable = \"q" + std::to_string(++joints_) + "\"\norigin = [" + origin + "]\n";
  }
  /// Three turns about one point.
  void add_triple(const std::string& origin) {
    add(true, axis(), origin);
    for (int i = 0; i < 2; ++i) add(true, axis());
  }
  /// A turn and a slide along its axis, in either order, elsewhere.
  void add_cylinder(const std::string& origin, bool turn_first) {
    const std::string first = axis(), other = along_latest();
    add(turn_first, first, origin);
    add(!turn_first, other.empty() ? first : other);
  }

  [[nodiscard]] model::Robot robot(const std::string& tool) const {
    const std::string text =
        "name = \"arm\"\ntitle = \"random\"\n[tool]\ntranslation = [" + tool + "]\n" + text_;
    const auto read = description::read_text(text, "arm.toml");
    EXPECT_TRUE(read.robot) << text;
    return *read.robot;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::mt19937 random_;
  int last_ = 0;
  int joints_ = 0;
  std::string text_;
};

void expect_closed_form(RandomArm& arm, const char* part_of_structure) {
  const auto derivation = derive::inverse::derive(arm.robot(arm.offset()));
  ASSERT_TRUE(derivation.found) << arm.text() << derivation.reasons.at(0);
  EXPECT_EQ(derivation.problem.task, model::Task::pose);
  EXPECT_NE(derivation.plan.structure.find(part_of_structure), std::string::npos)
      << derivation.plan.structure;
  EXPECT_NO_THROW(verify::certify_inverse(derivation.problem, lower(derivation.plan), 1)) << arm.text();
}

/// Lengths as they are measured: the product of two links is a root of twenty digits and more.
TEST(MeetingAxes, ArmsWithMeasuredLengths) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    RandomArm arm(300 + seed);
    const auto measured = [&arm] {
      const auto length = [&arm] { return std::to_string(arm.below(2000000) - 1000000) + "e-6"; };
      const std::string x = length(), y = length();
      return x + ", " + y + ", " + length();
    };
    arm.add(true, "0, 0, 1", measured());
    arm.add(true, "0, 1, 0", measured());
    arm.add(true, "0, 1, 0", measured());
    arm.add(true, "1, 0, 0", measured());
    arm.add(true, "0, 1, 0", std::to_string(1 + arm.below(1000000)) + "e-6, 0, 0");
    arm.add(true, "1, 0, 0");
    expect_closed_form(arm, "joints 4, 5 and 6 meet in one point");
  }
}

/// Shoulder and elbow, shoulder and slide, turn and wrist, slide and wrist.
TEST(MeetingAxes, FourJointsWithThreeThroughAPoint) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    RandomArm arm(seed);
    const bool triple_first = seed % 2 == 0, turns = seed / 2 % 2 == 0;
    if (triple_first) arm.add_triple(arm.offset());
    arm.add(turns, arm.axis(), arm.offset());
    if (!triple_first) arm.add_triple(arm.offset());
    expect_closed_form(arm, "meet in one point");
  }
}

/// Refuses arms whose fourth axis goes through the point, too: no pose has finitely many solutions.
TEST(MeetingAxes, FourAxesThroughAPointAreRefused) {
  RandomArm arm(3);
  arm.add_triple("0, 0, 0");
  arm.add(true, arm.axis());
  EXPECT_FALSE(derive::inverse::derive(arm.robot("0, 0, \"1/3\"")).found);
}

/// The forearm rolls, then extends: the roll is an axis of the wrist behind the slide.
TEST(MeetingAxes, WristBehindASlideAlongItsFirstAxis) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    RandomArm arm(100 + seed);
    arm.add(true, arm.axis(), arm.offset());
    arm.add(true, arm.axis(), arm.offset());
    arm.add_cylinder(arm.offset(), true);
    arm.add(true, arm.axis());
    arm.add(true, arm.axis());
    expect_closed_form(arm, "in the order q1, q2, q4, q3, q5, q6");
  }
}

/// The shoulder's last axis stands behind the slide along it.
TEST(MeetingAxes, ShoulderBeforeASlideAlongItsLastAxis) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    RandomArm arm(200 + seed);
    arm.add(true, arm.axis(), arm.offset());
    arm.add(true, arm.axis());
    arm.add_cylinder("0, 0, 0", false);
    arm.add(true, arm.axis(), arm.offset());
    arm.add(true, arm.axis(), arm.offset());
    expect_closed_form(arm, "in the order q1, q2, q4, q3, q5, q6");
  }
}

}  // namespace
