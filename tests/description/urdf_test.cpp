// SPDX-License-Identifier: MIT
#include "description/write.h"
#include "xml.h"

namespace qvgen::description {
namespace {

std::string link(const std::string& name, const std::string& inertial = "") {
  return "<link name=\"" + name + "\">" + inertial + "</link>\n";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& more = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + more + "</joint>\n";
}

std::string robot(const std::string& content) {
  return "<robot name=\"my_arm_2\">\n" + content + "</robot>\n";
}

/// One continuous joint with the given frame and axis.
model::Joint single(const std::string& more, const ReadOptions& options = {}) {
  const model::Robot result =
      read(robot(link("a") + link("b") + joint("j", "continuous", "a", "b", more)), options);
  return result.joints.empty() ? model::Joint{} : result.joints.front();
}

TEST(Urdf, ReadsAChain) {
  const model::Robot arm = read(robot(
      link("a") + link("b") + link("c") + link("d") +
      joint("turn-1", "revolute", "a", "b",
            "<origin xyz=\"0 0 0.25\"/><axis xyz=\"0 0 1\"/><limit lower=\"-1.5\" upper=\"2\"/>"
            "<dynamics damping=\"0.5\" friction=\"0.25\"/>") +
      joint("2nd", "continuous", "b", "c",
            "<origin xyz=\"1 2 3\" rpy=\"0.1 0 -0.2\"/><axis xyz=\"0 -1 0\"/>") +
      joint("turn-1 ", "prismatic", "c", "d", "<axis xyz=\"3 0 4\"/><limit lower=\"0\" upper=\"0.5\"/>")));
  EXPECT_EQ(arm.name, "my_arm_2");
  EXPECT_EQ(arm.title, "my_arm_2, a to d");
  ASSERT_EQ(arm.joints.size(), 3U);
  EXPECT_EQ(arm.joints[0].variable, "turn_1");
  EXPECT_EQ(arm.joints[0].type, model::JointType::revolute);
  EXPECT_EQ(texts(arm.joints[0].before), "0, 0, 1/4");
  EXPECT_EQ(texts(arm.joints[0].axis), "0, 0, 1");
  EXPECT_EQ(to_string(arm.joints[0].limits->lower), "-3/2");
  EXPECT_EQ(to_string(arm.joints[0].limits->upper), "2");
  EXPECT_EQ(to_string(arm.joints[0].drive.viscous_friction), "1/2");
  EXPECT_EQ(to_string(arm.joints[0].drive.coulomb_friction), "1/4");
  EXPECT_EQ(arm.joints[1].variable, "joint_2nd");
  EXPECT_EQ(texts(arm.joints[1].before), "0, 0, 1 by -1/5; 1, 0, 0 by 1/10; 1, 2, 3");
  EXPECT_EQ(texts(arm.joints[1].axis), "0, -1, 0");
  EXPECT_FALSE(arm.joints[1].limits);
  EXPECT_EQ(arm.joints[2].variable, "turn_1_1");
  EXPECT_EQ(arm.joints[2].type, model::JointType::prismatic);
  EXPECT_EQ(texts(arm.joints[2].axis), "3/5, 0, 4/5");
}

TEST(Urdf, AxesAreNormalisedExactly) {
  EXPECT_EQ(texts(single("").axis), "1, 0, 0");
  EXPECT_EQ(texts(single("<axis xyz=\"0.57735 0.57735 -0.57735\"/>").axis),
            "1/sqrt(3), 1/sqrt(3), (-1)/sqrt(3)");
  EXPECT_EQ(texts(single("<axis xyz=\"0 2 0\"/>").axis), "0, 1, 0");
  EXPECT_EQ(texts(single("<axis xyz=\"0.2 0 0.1\"/>").axis), "1/sqrt(5/4), 0, 1/2/sqrt(5/4)");
}

TEST(Urdf, RoundedAnglesAndAxesAreWhatTheyWere) {
  const auto roll = [](const std::string& angle, const ReadOptions& options = {}) {
    return texts(single("<origin rpy=\"" + angle + " 0 0\"/>", options).before);
  };
  for (const std::string text :
       {"1.5707963267948966", "1.570796", "1.5708", "1.5707", "1.57", "+1.571", "157.08e-2"})
    EXPECT_EQ(roll(text), "1, 0, 0 by 1/2*pi; 0, 0, 0") << text;
  EXPECT_EQ(roll("3.141"), "1, 0, 0 by pi; 0, 0, 0");
  EXPECT_EQ(roll("-3.14159"), "1, 0, 0 by -pi; 0, 0, 0");
  EXPECT_EQ(roll("0.785398"), "1, 0, 0 by 1/4*pi; 0, 0, 0");
  EXPECT_EQ(roll("0.262"), "1, 0, 0 by 1/12*pi; 0, 0, 0");
  EXPECT_EQ(roll("1e-17"), "0, 0, 0");
  // Angles that were measured, or are too coarse to tell, stay.
  EXPECT_EQ(roll("1.5702"), "1, 0, 0 by 7851/5000; 0, 0, 0");
  EXPECT_EQ(roll("1.570659"), "1, 0, 0 by 1570659/1000000; 0, 0, 0");
  EXPECT_EQ(roll("0.26"), "1, 0, 0 by 13/50; 0, 0, 0");
  EXPECT_EQ(roll("0.0001"), "1, 0, 0 by 1/10000; 0, 0, 0");
  EXPECT_EQ(roll("1.6"), "1, 0, 0 by 8/5; 0, 0, 0");

  ReadOptions off;
  off.snap.mode = SnapOptions::off;
  EXPECT_EQ(roll("1.5708", off), "1, 0, 0 by 3927/2500; 0, 0, 0");
  ReadOptions within;
  within.snap = parse_snap("1e-2").value();
  EXPECT_EQ(roll("1.5650", within), "1, 0, 0 by 1/2*pi; 0, 0, 0");
  EXPECT_EQ(roll("1.56", within), "1, 0, 0 by 39/25; 0, 0, 0");
  EXPECT_FALSE(parse_snap("never"));
  EXPECT_FALSE(parse_snap("-1"));

  EXPECT_EQ(texts(single("<axis xyz=\"0.866 0 -0.5\"/>").axis), "sqrt(3)/2, 0, -1/2");
  EXPECT_EQ(texts(single("<axis xyz=\"0.7071 0 0.70711\"/>").axis), "sqrt(2)/2, 0, sqrt(2)/2");
  EXPECT_EQ(texts(single("<axis xyz=\"0.9659 0.2588 0\"/>").axis),
            "(sqrt(6) + sqrt(2))/4, (sqrt(6) - sqrt(2))/4, 0");
  EXPECT_EQ(texts(single("<axis xyz=\"4.9e-12 1 -6e-17\"/>").axis), "0, 1, 0");
  EXPECT_EQ(texts(single("<origin xyz=\"-1.75e-18 0.001 2e-6\"/>").before), "0, 1/1000, 1/500000");
  // The wrist of a published arm is spherical but for a quarter of a micrometre.
  EXPECT_EQ(texts(single("<origin xyz=\"0.0356 -0.000000239858 -0.0404996\"/>").before),
            "89/2500, 0, -101249/2500000");
  EXPECT_EQ(texts(single("<origin xyz=\"0.000001 -0.0000010001 0\"/>").before), "0, -10001/10000000000, 0");
  EXPECT_EQ(texts(single("<origin xyz=\"1e-9 0 0\"/>", off).before), "1/1000000000, 0, 0");
}

TEST(Urdf, EveryChangeIsNoted) {
  EXPECT_EQ(
      report(robot(
          link("a") + link("b") +
          joint("j", "continuous", "a", "b",
                "\n<origin xyz=\"1e-17 0 0\" rpy=\"0 1.5708 0\"/>\n<axis xyz=\"0 0.7071 -0.70711\"/>"))),
      "5:14: note: 1e-17 is read as 0, -1.0e-17 more; --snap off keeps it\n"
      "5:32: note: 1.5708 is read as 90 deg, -3.7e-06 more; --snap off keeps it\n"
      "6:14: note: 0.7071 is read as sqrt(2)/2, 6.8e-06 more; --snap off keeps it\n"
      "6:21: note: -0.70711 is read as -sqrt(2)/2, 3.2e-06 more; --snap off keeps it\n");
}

TEST(Urdf, JointsThatAreCalledOtherwiseInTheCodeAreNoted) {
  EXPECT_EQ(
      report(robot(link("a") + link("b") + joint("left/elbow-1", "continuous", "a", "b"))),
      "4:1: note: the joint 'left/elbow-1' is 'left_elbow_1' in the code; names have letters, digits and "
      "'_' there, at most 64, and are no macros\n");
  EXPECT_EQ(report(robot(link("a") + link("b") + joint("elbow_1", "continuous", "a", "b"))), "");
}

TEST(Urdf, FixedJointsAreFolded) {
  const model::Robot arm =
      read(robot(link("world") + link("a") + link("b") + link("flange") + link("tool0") +
                 joint("f0", "fixed", "world", "a", "<origin xyz=\"0 0 1\" rpy=\"0 0 1.5708\"/>") +
                 joint("j", "continuous", "a", "b",
                       "<origin xyz=\"0.5 0 0\" rpy=\"0 0 -1.5708\"/><axis xyz=\"0 0 1\"/>") +
                 joint("f1", "fixed", "b", "flange", "<origin xyz=\"0 0.25 0\" rpy=\"0 0 0.785398\"/>") +
                 joint("f2", "fixed", "flange", "tool0", "<origin xyz=\"2 0 0\" rpy=\"0 0.3 0\"/>")));
  ASSERT_EQ(arm.joints.size(), 1U);
  EXPECT_EQ(texts(arm.joints[0].before), "0, 1/2, 1");
  EXPECT_EQ(texts(arm.tool), "0, 0, 1 by 1/4*pi; 0, 1, 0 by 3/10; sqrt(2), 1/4 + sqrt(2), 0");
}

TEST(Urdf, MassesOfFixedLinksAreLumped) {
  const std::string block =
      "<inertial><origin xyz=\"0 0 0.5\"/><mass value=\"2\"/>"
      "<inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.2\" iyz=\"0\" izz=\"0.25\"/></inertial>";
  const model::Robot arm =
      read(robot(link("base", block) + link("a", block) + link("b", block) + link("camera", block) +
                 link("finger", block) + joint("j", "continuous", "base", "a", "<axis xyz=\"0 0 1\"/>") +
                 joint("f", "fixed", "a", "b") +
                 joint("g", "fixed", "a", "camera", "<origin xyz=\"0 3 0\" rpy=\"0 0 1.5708\"/>") +
                 joint("h", "prismatic", "b", "finger", "<mimic joint=\"j\"/>")),
           {.tip = "b"});
  ASSERT_EQ(arm.joints.size(), 1U);
  const model::Inertia& inertia = arm.joints[0].inertia;
  EXPECT_EQ(to_string(inertia.mass), "6");
  EXPECT_EQ(texts(inertia.centre_of_mass), "0, 1, 1/2");
  std::string tensor;
  for (const auto& entry : inertia.inertia) tensor += to_string(entry) + " ";
  // 2 * 0.1 + 0.2 + 2 * 2 * 1 + 2 * 4, 2 * 0.2 + 0.1, 3 * 0.25 + the same twelve.
  EXPECT_EQ(tensor, "62/5 1/2 51/4 0 0 0 ");
}

TEST(Urdf, BaseAndTip) {
  const std::string arm = robot(link("a") + link("b") + link("c") + link("d") + link("e") +
                                joint("j1", "continuous", "a", "b") + joint("j2", "continuous", "b", "c") +
                                joint("j3", "continuous", "c", "d") + joint("j4", "continuous", "c", "e"));
  EXPECT_EQ(
      report(arm),
      "1:1: error: the chain may end at d (3 joints), e (3 joints); say where: qvgen check r.xml --tip d\n");
  EXPECT_EQ(read(arm, {.tip = "e"}).joints.size(), 3U);
  EXPECT_EQ(read(arm, {.base = "b", .tip = "d"}).joints.size(), 2U);
  EXPECT_EQ(read(arm, {.name = "other", .tip = "d"}).name, "other");
  EXPECT_EQ(report(arm, {.tip = "ee"}),
            "1:1: error: --tip ee: there is no link of that name; did you mean 'e'?\n");
  EXPECT_EQ(report(arm, {.base = "c", .tip = "a"}),
            "1:1: error: a does not hang on c; swap --base and --tip\n");
  EXPECT_EQ(report(arm, {.base = "d", .tip = "e"}),
            "1:1: error: e does not hang on d; choose a --tip that joints connect with the --base\n");
  EXPECT_EQ(
      report(arm, {.base = "d"}),
      "5:1: error: no joint between d and the tips moves; an arm has at least one revolute, continuous or "
      "prismatic joint\n");
  EXPECT_EQ(report(arm, {.base = "b", .tip = "b"}),
            "3:1: error: no joint from b to b moves; choose another --base or --tip\n");
  const std::string named =
      robot(link("a") + link("tool0") + link("camera") + joint("j1", "continuous", "a", "tool0") +
            joint("j2", "continuous", "tool0", "camera"));
  EXPECT_EQ(read(named).title, "my_arm_2, a to tool0");
}

TEST(Urdf, MistakesInTheTree) {
  EXPECT_EQ(report(robot("")), "1:1: error: no links; a URDF has <link> and <joint> elements\n");
  EXPECT_EQ(report(robot(link("a") + link("a") + link("base_link") + "<joint/>\n" +
                         joint("j", "revolut", "base_lnk", "b") + joint("k", "fixed", "a", "base_link") +
                         joint("k", "fixed", "a", "base_link"))),
            "3:13: error: the link 'a' is there twice; give each link a name of its own\n"
            "5:1: error: <joint> without 'name'; add name=\"...\"\n"
            "5:1: error: <joint> without 'type'; add type=\"...\"\n"
            "5:1: error: a joint without <parent>; add <parent link=\"...\"/>\n"
            "5:1: error: a joint without <child>; add <child link=\"...\"/>\n"
            "6:23: error: unknown joint type 'revolut'; did you mean 'revolute'?\n"
            "6:46: error: there is no link 'base_lnk'; did you mean 'base_link'?\n"
            "6:70: error: there is no link 'b'; did you mean 'a'?\n"
            "8:14: error: the joint 'k' is there twice; give each joint a name of its own\n");
  const std::string two = link("a") + link("b") + link("c");
  EXPECT_EQ(report(robot(two + joint("j", "fixed", "a", "c") + joint("k", "fixed", "b", "c"))),
            "6:1: error: two joints hold the link 'c'; a link has one parent: cut the loop\n");
  EXPECT_EQ(
      report(robot(two + joint("j", "fixed", "b", "c") + joint("k", "fixed", "c", "b"))),
      "3:1: error: the link 'b' hangs on itself, through other links; a URDF is a tree: cut the loop\n");
  EXPECT_EQ(report(robot(two + joint("j", "continuous", "a", "b"))),
            "4:1: warning: nothing moves behind c, apart from the other links: left out; join them to a, or "
            "choose with --base\n");
  EXPECT_EQ(report(robot(two + link("d") + joint("j", "continuous", "a", "b") +
                         joint("k", "continuous", "c", "d"))),
            "4:1: error: the links hang on more than one root: a, c; join them, or say which with --base\n");
}

std::string report_joint(const std::string& type, const std::string& more, const std::string& inertial = "") {
  return report(robot(link("a") + link("b", inertial) + joint("j", type, "a", "b", "\n" + more)));
}

TEST(Urdf, MistakesInNumbers) {
  EXPECT_EQ(
      report_joint(
          "revolute",
          "<origin xyz=\"0 nan 0\" rpy=\"1 2\"/><axis xyz=\"0 0 0\"/><limit lower=\"1\" upper=\"-inf\"/>"),
      "5:16: error: 'nan' is not finite; write a finite number\n"
      "5:28: error: 'rpy' of <origin> has 2 numbers; write 3 numbers apart by blanks\n"
      "5:45: error: the axis of 'j' has length zero; give a direction, e.g. xyz=\"0 0 1\"\n"
      "5:77: error: '-inf' is not finite; write a finite number\n");
  EXPECT_EQ(
      report_joint("continuous", "<origin xyz=\"0,1 0 ${h}\" rpy=\"1e99 1e999999999 0\"/>"),
      "5:14: error: '0,1' is no number; write a decimal number such as 0.1 or 1e-3\n"
      "5:20: error: '${h}' is to be filled in by xacro; install xacro, which is run then: pip install xacro\n"
      "5:31: error: '1e99' is beyond every robot; lengths are in metres, angles in radians\n"
      "5:36: error: the exponent of '1e999999999' is out of range; exponents go from -300 to 300\n");
  EXPECT_EQ(report_joint("revolute", "<limit lower=\"2\" upper=\"1\"/>"),
            "5:15: warning: the limits of 'j' are reversed: they are read as 1 to 2; swap lower and upper\n");
  EXPECT_EQ(
      report_joint("floating", ""),
      "4:23: error: the joint 'j' is floating; a chain has revolute, continuous, prismatic and fixed joints: "
      "choose --base behind it, or read the whole robot with --floating\n");
  EXPECT_EQ(report_joint("revolut", ""),
            "4:23: error: unknown joint type 'revolut'; did you mean 'revolute'?\n");
  EXPECT_EQ(
      report_joint("hinge", ""),
      "4:23: error: the joint 'j' is hinge; did you mean 'revolute', or 'continuous' without limits?\n");
}

TEST(Urdf, Warnings) {
  EXPECT_EQ(report_joint("revolute", "<origin xyx=\"0 0 1\" rpy=\"90 0 0\"/><orgin/>"),
            "4:1: warning: the joint 'j' has no <limit>: it is read as unlimited; add <limit lower=\"...\" "
            "upper=\"...\" "
            ".../>, or make it continuous\n"
            "5:14: warning: nobody reads 'xyx' of <origin>; did you mean 'xyz'?\n"
            "5:26: warning: the angle 90 is more than a full turn in radians; URDF has radians: 90 degrees "
            "are 1.5708\n"
            "5:35: warning: nobody reads <orgin> of a joint; did you mean <origin>?\n");
  EXPECT_EQ(report_joint("prismatic", "<limit effort=\"3\"/><dynamics damping=\"-1\"/>"),
            "5:1: warning: the limits of 'j' leave it no way: it is read as unlimited; give lower and upper, "
            "or make it "
            "fixed\n"
            "5:39: warning: the friction of 'j' is negative: it drives the joint; give a positive number\n");
  EXPECT_EQ(
      report_joint("continuous", "",
                   "<inertial><mass value=\"-1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" "
                   "izz=\"-3\"/></inertial>"),
      "4:1: warning: link 1 has the negative mass -1; masses are positive\n"
      "4:1: warning: the inertia of link 1 is not positive definite; principal moments are positive, the "
      "order is "
      "[xx, yy, zz, xy, yz, xz]\n"
      "4:1: warning: the inertia of link 1 breaks the triangle inequality: xx = 1 exceeds yy + zz = -2; give "
      "it "
      "about the centre of mass, each principal moment at most the sum of the others\n");
}

TEST(Urdf, SphericalJointsAreThreeTurnsAsOfABall) {
  const std::string place = R"(<origin xyz="0.1 0.2 0.3" rpy="0 0.5 0"/>)";
  const auto axis = [](const std::string& xyz) { return "<axis xyz=\"" + xyz + "\"/>"; };
  const auto spherical = [](const std::string& more) {
    return robot(link("a") + link("b") + joint("p", "spherical", "a", "b", more));
  };
  const std::string three = robot(link("a") + link("b") + link("i") + link("j") +
                                  joint("p_x", "continuous", "a", "i", place + axis("1 0 0")) +
                                  joint("p_y", "continuous", "i", "j", axis("0 1 0")) +
                                  joint("p_z", "continuous", "j", "b", axis("0 0 1")));
  EXPECT_EQ(write_text(model::Mechanism{read(spherical(place)), {}}),
            write_text(model::Mechanism{read(three), {}}));
  EXPECT_EQ(report(spherical(place)),
            "4:1: note: the spherical joint 'p' is read as three turns, p_x, p_y and p_z, each about an axis "
            "that the one before has turned; they have no limits; with the second at 90 or -90 degrees they "
            "lack one of its motions\n");
  const std::string limited = report(spherical("<limit lower=\"-1\" upper=\"1\"/>"));
  EXPECT_NE(limited.find("warning: <limit> of a spherical joint is not read"), std::string::npos) << limited;
}

}  // namespace
}  // namespace qvgen::description
