// SPDX-License-Identifier: MIT
// Whole trees of links: each limb is the chain that --base and --tip read; a held joint is a fixed one; what
// cannot be meant is reported.
#include "model/mechanism.h"

#include <random>

#include "description/write.h"
#include "evaluation.h"
#include "xml.h"

namespace qvgen::description {
namespace {

/// A URDF of random joints, fixed links among them, each on one of the links before it.
struct RandomTree {
  explicit RandomTree(unsigned seed) : random(seed) {
    text = "<robot name=\"r\"><link name=\"l0\"/>\n";
    const int count = 3 + below(9);
    for (int i = 1; i <= count; ++i)
      add(i, i == 1 ? "revolute" : std::vector{"revolute", "prismatic", "fixed"}[below(3)]);
    text += "</robot>";
  }
  unsigned below(int n) { return static_cast<unsigned>(random() % static_cast<unsigned>(n)); }
  std::string number() { return std::to_string(static_cast<int>(below(19)) - 9) + "e-1"; }
  std::string vector() { return number() + " " + number() + " " + number(); }

  void add(int i, const std::string& type) {
    const std::string n = std::to_string(i);
    parents.push_back(below(i));
    types.push_back(type);
    text +=
        "<link name=\"l" + n + "\"><inertial><origin xyz=\"" + vector() + "\"/><mass value=\"" + n +
        "\"/><inertia ixx=\"1\" ixy=\"0.1\" ixz=\"0\" iyy=\"1.5\" iyz=\"0\" izz=\"1.2\"/></inertial></link>"
        "<joint name=\"j" +
        n + "\" type=\"" + type + "\"><parent link=\"l" + std::to_string(parents.back()) +
        "\"/><child link=\"l" + n + "\"/><origin xyz=\"" + vector() + "\" rpy=\"" + vector() +
        "\"/><axis xyz=\"" + std::vector{"1 0 0", "0 1 0", "0 0 -1", "0.6 0 0.8"}[below(4)] +
        "\"/><limit lower=\"-1\" upper=\"2\"/></joint>\n";
  }

  std::mt19937 random;
  std::string text;
  std::vector<unsigned> parents;   ///< of link i + 1
  std::vector<std::string> types;  ///< of joint i + 1
};

ReadResult whole(const std::string& text, std::vector<std::string> tips = {every_tip}) {
  ReadOptions options;
  options.tips = std::move(tips);
  ReadResult result = read_text(text, "r.xml", options);
  for (const auto& diagnostic : result.diagnostics)
    if (diagnostic.severity != Diagnostic::note) ADD_FAILURE() << to_string(diagnostic) << "\n" << text;
  return result;
}

/// All that a model says, but for its name and title.
std::string content(model::Robot robot) {
  robot.name = robot.title = "";
  return write_text(robot);
}

std::string chain(const std::string& text, const std::string& tip) {
  ReadOptions options;
  options.tip = tip;
  return content(read(text, options));
}

TEST(Mechanism, LimbsAreTheChainsThatTipsRead) {
  int limbs = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const RandomTree tree(seed);
    const ReadResult result = whole(tree.text);
    ASSERT_TRUE(result.robot);
    for (const model::Frame& tip : result.tips) {
      EXPECT_EQ(content(model::limb(*result.robot, tip)), chain(tree.text, tip.name)) << tip.name << "\n"
                                                                                      << tree.text;
      ++limbs;
    }
  }
  EXPECT_GT(limbs, 60);
}

constexpr const char* torso = R"(<mujoco model="r"><worldbody>
<body name="torso" pos="0 0 1"><freejoint name="root"/><geom type="sphere" size="0.1" mass="5"/>
 <body name="arm" pos="0 0.2 0" quat="0.5 0.5 -0.5 0.5"><joint name="shoulder" type="ball"/>
  <geom type="capsule" size="0.02 0.1" mass="1"/>
  <body name="hand" pos="0 0 0.3"><joint name="elbow" axis="0 1 0" pos="0 0 -0.1"/><joint name="reach" type="slide"/>
   <geom type="box" size="0.02 0.03 0.04" mass="0.3"/><site name="palm" pos="0 0 0.05"/></body></body>
 <body name="head" pos="0 0 0.4"><joint name="neck" axis="0 0 1"/><geom type="sphere" size="0.05" mass="0.8"/></body>
</body></worldbody></mujoco>)";

TEST(Mechanism, BodiesOfMjcfAreATreeAsWell) {
  ReadOptions options;
  options.tips = {every_tip};
  const ReadResult result = read_text(torso, "r.xml", options);
  ASSERT_TRUE(result.robot);
  EXPECT_EQ(result.robot->joints.size(), 6U);  // the ball joint is three turns, the free joint is held
  ASSERT_EQ(result.tips.size(), 2U);
  EXPECT_EQ(result.tips[0].name, "hand");
  EXPECT_EQ(result.tips[1].name, "head");
  for (const model::Frame& tip : result.tips) {
    ReadOptions one;
    one.tip = tip.name;
    EXPECT_EQ(content(model::limb(*result.robot, tip)),
              content(read_text(torso, "r.xml", one).robot.value()));
  }
  options.fixed = {"reach", "neck"};
  const ReadResult held = read_text(torso, "r.xml", options);
  ASSERT_TRUE(held.robot);
  EXPECT_EQ(held.robot->joints.size(), 4U);
  EXPECT_TRUE(held.tips.empty());
}

TEST(Mechanism, LimbsFromAnyLinkMoveAsTheChainsDo) {
  int chains = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const RandomTree tree(seed);
    const ReadResult result = whole(tree.text);
    ASSERT_TRUE(result.robot);
    for (const model::Frame& tip : result.tips)
      for (const model::Frame& from : result.robot->frames) {
        std::size_t joint = tip.joint;
        while (joint != model::base_link && joint != from.joint)
          joint = model::parent_of(*result.robot, joint);
        if (joint == model::base_link || from.joint == tip.joint) continue;
        const model::Robot limb = model::limb(*result.robot, from, tip);
        ReadOptions options;
        options.base = from.name;
        options.tip = tip.name;
        const ReadResult read = read_text(tree.text, "r.xml", options);
        if (!read.robot) continue;  // the frame is beside the way to the tip
        const std::vector<double> q{0.3, -0.8, 1.1, 0.4, -0.5, 0.9, 0.2, -1.2, 0.7, 0.6, -0.1, 0.5};
        EXPECT_TRUE(test::tool_pose(limb, q, {}).isApprox(test::tool_pose(*read.robot, q, {}), 1e-12))
            << tree.text;
        ++chains;
      }
  }
  EXPECT_GT(chains, 10);
}

TEST(Mechanism, OneTipMakesTheChain) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const RandomTree tree(seed);
    const std::string tip = whole(tree.text).robot ? "l" + std::to_string(tree.parents.size()) : "";
    if (tree.types.back() == "fixed") continue;
    const ReadResult result = whole(tree.text, {tip});
    ASSERT_TRUE(result.robot);
    EXPECT_TRUE(result.tips.empty());
    EXPECT_EQ(result.robot->title, "r, l0 to " + tip);
    EXPECT_EQ(content(*result.robot), chain(tree.text, tip));
  }
}

TEST(Mechanism, AHeldJointIsAFixedOne) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const RandomTree tree(seed);
    if (tree.types.back() == "fixed") continue;
    const std::string last = "j" + std::to_string(tree.types.size());
    std::string fixed = tree.text;
    const std::string as_it_was = "name=\"" + last + "\" type=\"" + tree.types.back() + "\"";
    fixed.replace(fixed.find(as_it_was), as_it_was.size(), "name=\"" + last + "\" type=\"fixed\"");
    ReadOptions options;
    options.tips = {every_tip};
    const ReadResult expected = read_text(fixed, "r.xml", options);
    options.fixed = {last};
    const ReadResult held = read_text(tree.text, "r.xml", options);
    ASSERT_EQ(held.robot.has_value(), expected.robot.has_value());
    if (held.robot) {
      EXPECT_EQ(content(*held.robot), content(*expected.robot));
    }
  }
}

TEST(Mechanism, IsReadBackFromWhatIsWritten) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const ReadResult result = whole(RandomTree(seed).text);
    if (result.tips.empty()) continue;
    const std::string text = write_text(model::Mechanism{*result.robot, result.tips});
    const ReadResult again = read_text(text, "a.toml");
    for (const auto& diagnostic : again.diagnostics) ADD_FAILURE() << to_string(diagnostic) << "\n" << text;
    ASSERT_TRUE(again.robot);
    EXPECT_EQ(write_text(model::Mechanism{*again.robot, again.tips}), text);
    ReadOptions options;
    options.tip = result.tips.front().name;
    const ReadResult limb = read_text(text, "a.toml", options);
    ASSERT_TRUE(limb.robot);
    EXPECT_EQ(content(*limb.robot), content(model::limb(*result.robot, result.tips.front())));
  }
}

std::string link(const std::string& name, const std::string& mass = "1") {
  return "<link name=\"" + name + "\"><inertial><mass value=\"" + mass + "\"/></inertial></link>\n";
}
std::string joint(const std::string& parent, const std::string& child, const std::string& more = "") {
  return "<joint name=\"to_" + child + "\" type=\"continuous\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + more + "</joint>\n";
}
/// Two legs with a foot each.
const std::string legs =
    "<robot name=\"r\">" + link("trunk") + link("a") + link("b") + link("foot") + joint("trunk", "a") +
    joint("trunk", "b") +
    "<joint name=\"f\" type=\"fixed\"><parent link=\"b\"/><child link=\"foot\"/></joint></robot>";

std::string told(const std::string& text, const std::vector<std::string>& tips,
                 const std::vector<std::string>& fixed = {}, const std::string& base = "") {
  ReadOptions options;
  options.tips = tips;
  options.fixed = fixed;
  options.base = base;
  return report(text, options);
}

TEST(Mechanism, TipsAreTheEndsThatPeopleMean) {
  const ReadResult result = whole(legs);
  ASSERT_EQ(result.tips.size(), 2U);
  EXPECT_EQ(result.tips[0].name, "a");
  EXPECT_EQ(result.tips[1].name, "foot");
  EXPECT_EQ(result.robot->title, "r, 2 limbs from trunk");
  EXPECT_EQ(model::parent_of(*result.robot, 1), model::base_link);
  EXPECT_EQ(whole(legs, {"foot", "a"}).tips.front().name, "foot");
}

TEST(Mechanism, WhatCannotBeMeantIsReported) {
  EXPECT_EQ(told(legs, {"fot"}),
            "1:1: error: --tips fot: there is no link of that name; did you mean 'foot'?\n");
  EXPECT_EQ(told(legs, {"trunk"}),
            "1:1: error: --tips trunk: the link does not move against trunk; leave it out\n");
  EXPECT_EQ(told(legs, {"a", "a"}), "1:1: error: --tips names a twice; name each tip once\n");
  EXPECT_EQ(told(legs, {"foot"}, {}, "a"),
            "1:1: error: --tips foot: the link does not hang on a; choose another --base, or other tips\n");
  EXPECT_EQ(told(legs, {"all"}, {"to_c"}),
            "1:1: error: --fixed to_c: no joint of that name moves; did you mean 'to_a'?\n");
  EXPECT_EQ(
      told(legs, {"all"}, {"to_a", "to_b"}),
      "1:17: error: nothing moves behind trunk; a robot has at least one revolute, continuous or prismatic "
      "joint\n");
  const std::string roots = "<robot name=\"r\">" + link("x") + link("y") + link("z") + link("w") +
                            joint("x", "y") + joint("z", "w") + "</robot>";
  EXPECT_EQ(told(roots, {"all"}),
            "3:1: error: the links hang on more than one root: x, z; join them, or say which with --base\n");
  const std::string twice = "<robot name=\"r\">" + link("x") + link("x") + "</robot>";
  EXPECT_EQ(told(twice, {"all"}),
            "2:13: error: the link 'x' is there twice; give each link a name of its own\n");
  const std::string cycle =
      "<robot name=\"r\">" + link("x") + link("y") + joint("x", "y") + joint("y", "x") + "</robot>";
  EXPECT_EQ(
      told(cycle, {"all"}),
      "1:17: error: the link 'x' hangs on itself, through other links; a URDF is a tree: cut the loop\n");
}

TEST(Mechanism, NamesOfLimbsMayBeTooLong) {
  std::string text = legs;
  text.replace(text.find("\"r\""), 3, "\"" + std::string(60, 'r') + "\"");
  EXPECT_EQ(told(text, {"foot"}), "");  // one tip makes a chain, which has the robot's own name
  EXPECT_NE(told(text, {"all"}).find("error: the limb '" + std::string(60, 'r') + "_foot': "),
            std::string::npos);
}

TEST(Mechanism, ATipWithoutMassIsTold) {
  const std::string text = "<robot name=\"r\">" + link("x") + link("y") + link("z", "0") + joint("x", "y") +
                           joint("x", "z") + "</robot>";
  EXPECT_EQ(told(text, {"all"}),
            "5:1: warning: the joint 'to_z' moves no mass: there is no forward dynamics; give its link a "
            "mass, or hold "
            "the joint: --fixed to_z\n");
  EXPECT_EQ(told(text, {"all"}, {"to_z"}), "");
}

TEST(Mechanism, ManyLinksAreRefused) {
  const auto row = [](int count, const std::string& type) {
    std::string text = "<robot name=\"r\"><link name=\"l0\"/>\n";
    for (int i = 1; i <= count; ++i) {
      const std::string n = std::to_string(i),
                        before = std::to_string(i % 2 == 0 ? i - 1 : std::max(0, i - 2));
      text += "<link name=\"l" + n + "\"/><joint name=\"j" + n + "\" type=\"" + type + "\"><parent link=\"l" +
              before + "\"/><child link=\"l" + n + "\"/></joint>\n";
    }
    return text + "</robot>";
  };
  EXPECT_EQ(told(row(64, "continuous"), {"all"}), "");
  EXPECT_EQ(
      told(row(500, "continuous"), {"all"}),
      "1:17: error: 500 joints behind l0 move; a robot has at most 64: hold some with --fixed, or name fewer "
      "--tips\n");
}

TEST(Mechanism, AFollowerMayHaveItsLeaderInAnotherLimb) {
  const std::string text = "<robot name=\"r\">" + link("x") + link("y") + link("z") + joint("x", "y") +
                           joint("x", "z", "<mimic joint=\"to_y\" multiplier=\"-2\"/>") + "</robot>";
  const ReadResult result = whole(text);
  ASSERT_EQ(result.tips.size(), 2U);
  ASSERT_EQ(result.robot->joints[1].follows.size(), 1U);
  EXPECT_EQ(result.robot->joints[1].follows[0].variable, result.robot->joints[0].variable);
  EXPECT_TRUE(model::limb(*result.robot, result.tips[1]).joints[0].follows.empty());
}

constexpr const char* branched = R"(name = "two"
title = "two arms"
[[joint]]
type = "revolute"
axis = "+z"
variable = "waist"
[[joint]]
type = "revolute"
axis = "+x"
variable = "left"
[[joint]]
type = "prismatic"
axis = "+y"
variable = "right"
parent = "waist"
[[joint]]
type = "revolute"
axis = "+y"
variable = "head"
parent = "base"
[[tip]]
name = "left_hand"
joint = "left"
translation = [0.1, 0, 0]
[[tip]]
name = "right_hand"
joint = "right"
[[tip]]
name = "eyes"
)";

std::string with(const std::string& old, const std::string& by) {
  std::string text = branched;
  return text.replace(text.find(old), old.size(), by);
}

std::string mistakes(const std::string& text) {
  std::string all;
  for (const auto& diagnostic : read_text(text, "t.toml").diagnostics)
    all += to_string(diagnostic).substr(7) + "\n";
  return all;
}

TEST(Mechanism, TomlNamesTheParents) {
  const ReadResult result = read_text(branched, "t.toml");
  ASSERT_TRUE(result.robot);
  EXPECT_EQ(result.tips.size(), 3U);
  EXPECT_EQ(model::parent_of(*result.robot, 1), 0U);
  EXPECT_EQ(model::parent_of(*result.robot, 2), 0U);
  EXPECT_EQ(model::parent_of(*result.robot, 3), model::base_link);
  EXPECT_EQ(model::limb(*result.robot, result.tips[1]).joints.size(), 2U);
  EXPECT_EQ(result.tips[2].joint, 3U);
}

TEST(Mechanism, TomlReportsWhatIsWrong) {
  EXPECT_EQ(mistakes(with("parent = \"waist\"", "parent = \"waste\"")),
            "15:10: error: no joint before this one has the variable 'waste'; did you mean 'waist'?\n");
  EXPECT_EQ(
      mistakes(with("parent = \"waist\"", "parent = \"head\"")),
      "15:10: error: no joint before this one has the variable 'head'; name an earlier joint, or \"base\"\n");
  EXPECT_EQ(mistakes(with("title = \"two arms\"\n", "title = \"two arms\"\ntask = \"pose\"\n")),
            "3:1: error: 'task' beside [[tip]]; it belongs to a chain; each [[tip]] has its own translation "
            "and turns\n");
  EXPECT_EQ(mistakes(with("\"eyes\"", "\"left_hand\"")),
            "29:8: error: the tip 'left_hand': another tip has this name; give each tip a name of its own\n");
  std::string without(branched);
  without.erase(without.find("[[tip]]"));
  const std::string ends =
      "tip = [{name = \"tip_left\", joint = \"left\"}, {name = \"tip_right\", joint = \"right\"}, "
      "{name = \"tip_head\", joint = \"head\"}]";
  EXPECT_EQ(mistakes(without),
            "1:1: error: the joints branch, and no [[tip]] says where limbs end; write those that matter "
            "before the first [[joint]]: " +
                ends + "\n");
  EXPECT_EQ(mistakes(ends + "\n" + without), "");
}

}  // namespace
}  // namespace qvgen::description
