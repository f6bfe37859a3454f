// SPDX-License-Identifier: MIT
#include <random>

#include "xml.h"

// End of a chain that nobody names: one limb is taken, several are listed, arms first, with a command to
// copy.
namespace qvgen::description {
namespace {

/// A URDF written link by link; the first link is the base.
class Tree {
 public:
  explicit Tree(const std::string& base) { add_link(base); }
  Tree& fixed(const std::string& parent, const std::string& link) {
    return joint("to_" + link, "fixed", parent, link);
  }
  Tree& moving(const std::string& parent, const std::string& link, const std::string& name) {
    return joint(name, "continuous", parent, link);
  }
  Tree& floating(const std::string& parent, const std::string& link) {
    return joint("to_" + link, "floating", parent, link);
  }
  /// `count` joints in a row: PREFIX1, PREFIX2, ... by the joints PREFIX1_joint, ...
  Tree& row(const std::string& parent, const std::string& prefix, int count) {
    std::string before = parent;
    for (int i = 1; i <= count; ++i) {
      const std::string link = prefix + std::to_string(i);
      moving(before, link, link + "_joint");
      before = link;
    }
    return *this;
  }
  [[nodiscard]] std::string text() const { return "<robot name=\"r\">" + links_ + joints_ + "</robot>"; }

 private:
  void add_link(const std::string& name) { links_ += "<link name=\"" + name + "\"/>\n"; }
  Tree& joint(const std::string& name, const std::string& type, const std::string& parent,
              const std::string& child) {
    add_link(child);
    joints_ += "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
               "\"/><child link=\"" + child + "\"/></joint>\n";
    return *this;
  }
  std::string links_, joints_;
};

std::string title(const Tree& tree, const ReadOptions& options = {}) {
  return read(tree.text(), options).title;
}

/// A gripper whose bars are called as in many a model: two that the motor turns, two behind them, two that
/// guide.
TEST(Tips, BarsOfAGripperInPairsAreItsFingers) {
  Tree robot("base");
  robot.row("base", "link", 7).fixed("link7", "gripper_base");
  for (const std::string side : {"left", "right"})
    robot.moving("gripper_base", side + "_driver", side + "_driver_joint")
        .moving(side + "_driver", side + "_coupler", side + "_coupler_joint")
        .moving("gripper_base", side + "_spring_link", side + "_spring_link_joint");
  EXPECT_NE(
      report(robot.text()).find("the chain may end at gripper_base (arm, 7 joints, without its fingers "),
      std::string::npos)
      << report(robot.text());
}

TEST(Tips, AChainOfMoreJointsThanADescriptionMayHaveIsOfferedFromItsOwn) {
  Tree robot("base");
  robot.row("base", "spine", 10).row("spine10", "left", 9).row("spine10", "right", 9);
  EXPECT_NE(report(robot.text()).find("say where: qvgen check r.xml --base spine10 --tip left9\n"),
            std::string::npos)
      << report(robot.text());
  EXPECT_EQ(read(robot.text(), {.base = "spine10", .tip = "left9"}).joints.size(), 9U);
}

TEST(Tips, FixedFramesBehindOneMovingChain) {
  Tree arm("base");
  arm.row("base", "link", 6).fixed("link6", "end_effector_link").fixed("link6", "camera_link");
  arm.fixed("camera_link", "camera_depth_frame").fixed("camera_link", "camera_color_frame");
  EXPECT_EQ(title(arm), "r, base to end_effector_link");
  EXPECT_EQ(report(arm.text()),
            "8:1: note: the chain ends at 'end_effector_link'; fixed to the same link: camera_depth_frame, "
            "camera_color_frame; --tip names another\n");
  Tree flange("base");
  flange.row("base", "link", 6)
      .fixed("link6", "flange")
      .fixed("link6", "tool0_1")
      .fixed("link6", "left_tool0");
  EXPECT_EQ(title(flange), "r, base to flange");  // the whole name before the end of one
  Tree plain("base");
  plain.row("base", "link", 3)
      .fixed("link3", "plate")
      .fixed("plate", "left_bolt")
      .fixed("plate", "right_bolt");
  plain.fixed("link3", "imu");
  EXPECT_EQ(title(plain), "r, base to plate");  // what the ends that are no sensors have in common
  Tree beside("base");
  beside.row("base", "link", 3).fixed("link1", "cover");
  EXPECT_EQ(title(beside), "r, base to link3");
  EXPECT_EQ(report(beside.text()), "");
}

TEST(Tips, AJawCountsAndTheNoteSaysSo) {
  Tree arm("base");
  arm.row("base", "link", 5).fixed("link5", "gripper_frame").moving("link5", "moving_jaw", "gripper");
  EXPECT_EQ(read(arm.text()).joints.size(), 6U);
  EXPECT_EQ(report(arm.text()),
            "8:1: note: the last joint 'gripper' moves a finger, by its name; it counts as a joint of the "
            "arm; leave "
            "it out: qvgen check r.xml --tip gripper_frame\n");
  EXPECT_EQ(read(arm.text(), {.tip = "gripper_frame"}).joints.size(), 5U);
  Tree roll("base");
  roll.row("base", "link", 5).moving("link5", "gripper_link", "wrist_roll");
  EXPECT_EQ(report(roll.text()), "");
}

TEST(Tips, FingersAreFolded) {
  Tree panda("base");
  panda.row("base", "panda_link", 7).fixed("panda_link7", "panda_hand");
  panda.moving("panda_hand", "left_f", "finger_joint1").moving("panda_hand", "right_f", "finger_joint2");
  EXPECT_EQ(
      report(panda.text()),
      "1:1: error: the chain may end at panda_hand (arm, 7 joints, without its fingers left_f, right_f); say "
      "where: qvgen check r.xml --tip panda_hand\n");
}

TEST(Tips, AHandOfManyJointsIsFolded) {
  Tree robot("base");
  robot.row("base", "arm", 7).fixed("arm7", "palm");
  for (const std::string finger : {"thumb", "index_finger", "ring_finger"}) robot.row("palm", finger, 6);
  EXPECT_EQ(
      report(robot.text()),
      "1:1: error: the chain may end at palm (arm, 7 joints, without its fingers thumb6, index_finger6 and 1 "
      "more); say where: qvgen check r.xml --tip palm\n");
}

TEST(Tips, ArmsBeforeLegsBeforeWheels) {
  Tree robot("base");
  robot.row("base", "wheel_l", 1).row("base", "wheel_r", 1).row("base", "head", 2).row("base", "left_leg", 3);
  robot.row("base", "arm", 7).fixed("arm7", "gripper_link");
  EXPECT_EQ(report(robot.text()),
            "1:1: error: the chain may end at gripper_link (arm, 7 joints), left_leg3 (leg, 3 joints), head2 "
            "(head, 2 "
            "joints); besides 2 wheels or rotors (wheel_l1, wheel_r1); say where: qvgen check r.xml --tip "
            "gripper_link\n");
}

TEST(Tips, ANameDoesNotChooseBetweenTwoArms) {
  Tree two("base");
  two.row("base", "left", 6).fixed("left6", "tool0").row("base", "right", 6).fixed("right6", "right_tool0");
  EXPECT_EQ(
      report(two.text()),
      "1:1: error: the chain may end at tool0 (arm, 6 joints), right_tool0 (arm, 6 joints); say where: qvgen "
      "check r.xml --tip tool0\n");
  Tree with_legs("base");
  with_legs.row("base", "arm", 6).fixed("arm6", "tool0");
  for (const std::string leg : {"lf_leg", "rf_leg", "lh_leg", "rh_leg"}) with_legs.row("base", leg, 3);
  EXPECT_EQ(title(with_legs), "r, base to tool0");
}

TEST(Tips, ChainsBeginBehindWhatFloats) {
  Tree robot("world");
  robot.floating("world", "trunk").row("trunk", "arm", 6).row("trunk", "left_leg", 3);
  EXPECT_EQ(report(robot.text()),
            "1:1: error: the chain may end at arm6 (arm, 6 joints), left_leg3 (leg, 3 joints); say where: "
            "qvgen check "
            "r.xml --base trunk --tip arm6\n");
  EXPECT_EQ(title(robot, {.base = "trunk", .tip = "arm6"}), "r, trunk to arm6");
}

TEST(Tips, ATorsoIsNoPartOfTheArmThatIsProposed) {
  Tree robot("base");
  robot.row("base", "torso", 2).row("torso2", "left", 7).row("torso2", "right", 7);
  EXPECT_EQ(report(robot.text()),
            "1:1: error: the chain may end at left7 (arm, 9 joints, 7 of them behind torso2), right7 (arm, 9 "
            "joints, 7 "
            "of them behind torso2); say where: qvgen check r.xml --base torso2 --tip left7\n");
  EXPECT_EQ(read(robot.text(), {.base = "torso2", .tip = "left7"}).joints.size(), 7U);
}

TEST(Tips, ManyNamesAreCut) {
  Tree many("base");
  for (int i = 0; i < 60; ++i) many.row("base", "limb" + std::to_string(i) + "_", 2);
  const std::string text = report(many.text());
  EXPECT_NE(text.find(" and 52 more; say where: "), std::string::npos) << text;
  EXPECT_LT(text.size(), 400U);
}

/// Random trees: there is a chain or one error, and the command of the error names a tip that is taken.
TEST(Tips, TheCommandOfTheErrorWorks) {
  std::mt19937 random(1);
  static const std::vector<std::string> words{"link", "finger", "tool0", "camera",
                                              "leg",  "wheel",  "a/b'c", "hand"};
  for (int i = 0; i < 300; ++i) {
    Tree tree("base");
    std::vector<std::string> links{"base"};
    for (std::size_t size = 1 + random() % 15; size-- > 0;) {
      const std::string parent = links[links.size() - 1 - random() % std::min<std::size_t>(links.size(), 4)];
      links.push_back(words[random() % words.size()] + "_" + std::to_string(links.size()));
      if (random() % 3 == 0)
        tree.fixed(parent, links.back());
      else
        tree.moving(parent, links.back(), "j" + links.back());
    }
    const ReadResult result = read_text(tree.text(), "r.xml");
    if (result.robot) continue;
    ASSERT_EQ(result.diagnostics.size(), 1U) << tree.text();
    const std::string hint = result.diagnostics.front().hint;
    const std::size_t at = hint.find("--tip ");
    if (at == std::string::npos) {
      ASSERT_NE(hint.find("at least one revolute"), std::string::npos) << hint;
      continue;
    }
    std::string tip = hint.substr(at + 6);
    if (tip.front() == '\'') {  // as a shell reads it
      tip = tip.substr(1, tip.size() - 2);
      for (std::size_t quote; (quote = tip.find("'\\''")) != std::string::npos;) tip.replace(quote, 4, "'");
    }
    ASSERT_TRUE(read_text(tree.text(), "r.xml", {.tip = tip}).robot.has_value()) << tip << "\n"
                                                                                 << tree.text();
  }
}

}  // namespace
}  // namespace qvgen::description
