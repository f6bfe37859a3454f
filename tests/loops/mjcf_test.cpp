// SPDX-License-Identifier: MIT
// Loops that <equality> of an MJCF closes: at joints where the reader's closures are closed, MuJoCo's own
// constraints of the same file are, and each mechanism has its closed form. Mistakes come with their places.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "derive/inverse/lower.h"
#include "derive/loops/assembly_plan.h"
#include "description/reader.h"
#include "description/write.h"
#include "mujoco_model.h"
#include "verify/loops/certify_loops.h"
#include "verify/loops/driven.h"
#include "verify/loops/mobility.h"

namespace qvgen::test::mjcf_loops {
namespace {

using loops::mujoco_model;
using loops::MujocoData;
using loops::MujocoModel;
using testing::HasSubstr;

std::string body(const std::string& name, const std::string& at, const std::string& joint,
                 const std::string& content = "") {
  return "<body name='" + name + "' " + at +
         "><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/><joint name='" + name + "' " + joint + "/>\n" +
         content + "</body>\n";
}

std::string mjcf(const std::string& bodies, const std::string& equality, const std::string& actuator = "") {
  return "<mujoco model='m'><compiler angle='radian'/><worldbody>\n" + bodies + "</worldbody>\n<equality>\n" +
         equality + "</equality>\n" +
         (actuator.empty() ? "" : "<actuator><motor joint='" + actuator + "'/></actuator>\n") + "</mujoco>\n";
}

const std::string hinge = "axis='0 0 1'", slide = "type='slide' axis='1 0 0'";

/// A four-bar in the plane x, z: closed in the file's pose, at a reference that is not zero.
const std::string crank = body("crank", "pos='0 0 1' euler='1.5707963267948966 0 0'",
                               "axis='0 0 1' ref='0.3'", body("coupler", "pos='0.5 0 0'", hinge));
const std::string connected =
    mjcf(crank + body("rocker", "pos='1 0 1' euler='1.5707963267948966 0 0'", hinge),
         "<connect body1='coupler' body2='rocker' anchor='0.5 0.75 0'/>", "crank");
/// The four-bar with a weld in place of the coupler's other pin.
const std::string welded = mjcf(crank + body("rocker", "pos='1 0 1' euler='1.5707963267948966 0 0'", hinge,
                                             body("end", "pos='0.2 0.7 0'", hinge)),
                                "<weld body1='coupler' body2='end'/>", "crank");
const std::string welded_by_pose =
    mjcf(crank + body("rocker", "pos='1 0 1' euler='1.5707963267948966 0 0'", hinge,
                      body("end", "pos='0.2 0.7 0'", hinge)),
         "<weld body1='coupler' body2='end' relpose='0.6 0.2 0 0.8 0 0 0.6'/>", "crank");
/// A slider-crank whose slide is welded to the coupler behind two pins.
const std::string slider =
    mjcf(body("crank", "", hinge, body("coupler", "pos='0.3 0 0'", hinge)) +
             body("slider", "pos='1 0.1 0'", slide, body("pin", "pos='0.1 0.05 0'", hinge)),
         "<weld body1='coupler' body2='pin'/>", "crank");
/// A piston that slides behind a pin, welded to the slide's rod.
const std::string piston =
    mjcf(body("crank", "", hinge, body("rod", "pos='0.4 0 0'", hinge)) +
             body("barrel", "pos='1 -0.5 0'", hinge, body("stroke", "pos='0.1 0.2 0'", slide)),
         "<weld body1='stroke' body2='rod'/>", "crank");

/// Seven turns in space, closed by a weld in the file's pose, which is no zero of its frames.
const std::string in_space =
    mjcf(body("crank", "", "axis='0 0 1'",
              body("b", "pos='0.3 0 0' euler='0.3 0 0'", "axis='0 1 0'",
                   body("c", "pos='0.1 0.3 0'", "axis='1 0 0' ref='0.2'",
                        body("d", "pos='0 0.3 0.1' euler='0 0.2 0'", "axis='0 0 1'")))) +
             body("k", "pos='0.5 0 0.2'", "axis='0 1 0'",
                  body("m", "pos='0 0.2 0' euler='0 0 0.4'", "axis='1 0 0'",
                       body("n", "pos='0.1 0.3 0'", "axis='0 0 1'"))),
         "<weld body1='d' body2='n'/>", "crank");

/// A five-bar whose cranks <joint> ties, with references that are not zero.
const std::string geared =
    mjcf(crank + body("other", "pos='1 0 1' euler='1.5707963267948966 0 0'", "axis='0 0 1' ref='-0.2'",
                      body("rod", "pos='0.3 0.1 0'", hinge)),
         "<connect body1='coupler' body2='rod' anchor='0.4 0.6 0'/><joint joint1='other' joint2='crank' "
         "polycoef='0.1 -0.5 0 0 0'/>",
         "crank");

description::ReadResult read(const std::string& text) {
  const auto result = description::read_text(text, "m.xml");
  for (const auto& diagnostic : result.diagnostics)
    if (diagnostic.severity == description::Diagnostic::error)
      ADD_FAILURE() << description::to_string(diagnostic);
  return result;
}

model::Mechanism mechanism_of(const std::string& text) {
  const auto result = read(text);
  return {result.robot.value(), result.tips, result.loops};
}

/// The greatest violation of MuJoCo's equality constraints at joint values by their names.
double violation(const std::string& text, const model::Robot& robot, const Eigen::VectorXd& q) {
  const MujocoModel mujoco = mujoco_model(text);
  const MujocoData data(mj_makeData(mujoco.get()), &mj_deleteData);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const int joint = mj_name2id(mujoco.get(), mjOBJ_JOINT, robot.joints[i].variable.c_str());
    data->qpos[mujoco->jnt_qposadr[joint]] = q[static_cast<Eigen::Index>(i)];
  }
  mj_forward(mujoco.get(), data.get());
  EXPECT_GT(data->ne, 0);
  double worst = 0;
  for (int row = 0; row < data->ne; ++row) worst = std::max(worst, std::abs(data->efc_pos[row]));
  return worst;
}

void expect_same_loops(const std::string& text) {
  SCOPED_TRACE(text);
  const model::Mechanism mechanism = mechanism_of(text);
  const verify::LoopNumbers numbers(mechanism);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto q = numbers.assembled(seed);
    ASSERT_TRUE(q.has_value());
    EXPECT_LT(violation(text, mechanism.robot, *q), 1e-10);
    Eigen::VectorXd off = *q;
    off[0] += 1e-3;
    EXPECT_GT(violation(text, mechanism.robot, off), 1e-5);
  }
}

void expect_closed_form(const model::Mechanism& mechanism, int assemblies) {
  const auto plan = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
  ASSERT_TRUE(plan.found) << testing::PrintToString(plan.reasons);
  EXPECT_EQ(plan.plan.capacity, assemblies);
  const auto certificate = verify::certify_loops(mechanism, plan, derive::inverse::lower(plan.plan), 4);
  EXPECT_EQ(certificate.inputs, 4);
}

TEST(MjcfLoops, AreThoseOfMujoco) {
  for (const std::string& text : {connected, welded, welded_by_pose, slider, piston, geared, in_space})
    expect_same_loops(text);
}

TEST(MjcfLoops, HaveTheirClosedForms) {
  std::vector<std::string> texts{welded_by_pose, slider, piston, geared};
  if (QVGEN_LOOP_RINGS >= 100) texts.insert(texts.end(), {connected, welded});  // long runs
  for (const std::string& text : texts) {
    SCOPED_TRACE(text);
    const model::Mechanism mechanism = mechanism_of(text);
    EXPECT_EQ(verify::mobility_of(mechanism).free, 1);
    expect_closed_form(mechanism, 2);
  }
}

TEST(MjcfLoops, WeldsInSpaceAreChains) {
  const model::Mechanism mechanism = mechanism_of(in_space);
  EXPECT_EQ(verify::mobility_of(mechanism).free, 1);
  const auto plan = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
  ASSERT_TRUE(plan.found) << testing::PrintToString(plan.reasons);
  ASSERT_EQ(plan.chains.size(), 1U);
  EXPECT_EQ(plan.chains[0].chain.joints.size(), 6U);
}

/// A weld is a pin whose joint is one more: both have the same assemblies.
TEST(MjcfLoops, AWeldBehindAPinIsThePin) {
  const model::Mechanism pinned = mechanism_of(connected);
  const model::Mechanism weld = mechanism_of(welded);
  EXPECT_EQ(pinned.loops.closures[0].type, model::LoopType::ball);
  EXPECT_EQ(weld.loops.closures[0].type, model::LoopType::weld);
  EXPECT_EQ(weld.robot.joints.size(), pinned.robot.joints.size() + 1);
}

TEST(MjcfLoops, AreWrittenAsTheyWereRead) {
  for (const std::string& text : {connected, welded_by_pose, geared}) {
    const model::Mechanism mechanism = mechanism_of(text);
    const std::string toml = description::write_text(mechanism);
    const auto again = description::read_text(toml, "m.toml");
    ASSERT_TRUE(again.robot.has_value()) << description::to_string(again.diagnostics.front()) << toml;
    EXPECT_EQ(description::write_text(model::Mechanism{*again.robot, again.tips, again.loops}), toml);
    EXPECT_THAT(toml, HasSubstr("actuated = [\"crank\"]"));
  }
}

TEST(MjcfLoops, BelongToWholeRobots) {
  description::ReadOptions options;
  options.tip = "coupler";
  const auto chain = description::read_text(connected, "m.xml", options);
  ASSERT_TRUE(chain.robot.has_value());
  EXPECT_TRUE(chain.loops.empty());
  EXPECT_THAT(description::to_string(chain.diagnostics.back()),
              HasSubstr("<connect> of <equality> is not read: joints move freely"));
}

/// A body that a program moves carries what is welded to it.
TEST(MjcfLoops, TiesToMocapBodiesAreNone) {
  const auto arm =
      read(mjcf(body("a", "", hinge, body("b", "pos='1 0 0'", hinge)) + "<body name='hand' mocap='true'/>\n",
                "<weld body1='hand' body2='b'/>"));
  EXPECT_TRUE(arm.loops.empty());
  EXPECT_EQ(arm.robot->joints.size(), 2U);
}

std::string first_error(const std::string& text) {
  const auto result = description::read_text(text, "m.xml");
  for (const auto& diagnostic : result.diagnostics)
    if (diagnostic.severity == description::Diagnostic::error) return description::to_string(diagnostic);
  return "";
}

TEST(MjcfLoops, MistakesComeWithTheirPlaces) {
  const std::string two = body("a", "", hinge) + body("b", "pos='1 0 0'", hinge);
  EXPECT_EQ(first_error(mjcf(two, "<connect body1='a' body2='bb' anchor='0 0 0'/>")),
            "m.xml:8:27: error: there is no body 'bb'; did you mean 'b'?");
  EXPECT_EQ(first_error(mjcf(two, "<connect body1='a' body2='b'/>")),
            "m.xml:8:1: error: <connect> without 'anchor'; give the point in the frame of 'body1': "
            "anchor=\"x y z\"");
  EXPECT_EQ(first_error(mjcf(two, "<connect body1='a' body2='b' anchor='0 0'/>")),
            "m.xml:8:38: error: 'anchor' has 2 numbers; give three: anchor=\"x y z\"");
  EXPECT_EQ(first_error(mjcf(two, "<weld body1='a' body2='b' relpose='0 0'/>")),
            "m.xml:8:36: error: 'relpose' has 2 numbers; give seven: a position and a quaternion w x y z");
  EXPECT_EQ(first_error(mjcf(two, "<connect body2='b' anchor='0 0 0'/>")),
            "m.xml:8:1: error: <connect> without 'body1'; name the body that it ties: body1=\"...\"");
}

/// A hostile file is refused before any of its loops is read.
TEST(MjcfLoops, AreNotTooMany) {
  std::string many;
  for (int i = 0; i < 1000; ++i) many += "<connect body1='a' body2='b' anchor='0 0 0'/>\n";
  EXPECT_EQ(
      first_error(mjcf(body("a", "", hinge) + body("b", "pos='1 0 0'", hinge), many)),
      "m.xml:40:1: error: 1000 loops are too many; a robot has at most 32; --tip reads a chain without them");
}

/// A four-bar can be driven at each of its joints; where one moves alone there is no choice.
TEST(DrivenJoints, AreFoundWhereThereIsNoChoice) {
  const auto bar = verify::driven_choices(mechanism_of(connected));
  EXPECT_EQ(bar.free, 1U);
  EXPECT_EQ(bar.choices, (std::vector<std::vector<std::size_t>>{{0}, {1}, {2}}));
  // A triangle with a wheel on it: only the wheel moves.
  const auto triangle = verify::driven_choices(mechanism_of(
      mjcf(body("a", "", hinge, body("wheel", "pos='0.2 0 0'", hinge)) + body("b", "pos='1 0 0'", slide),
           "<weld body1='a' body2='b'/>")));
  EXPECT_TRUE(triangle.assembled);
  EXPECT_EQ(triangle.free, 1U);
  EXPECT_EQ(triangle.choices, (std::vector<std::vector<std::size_t>>{{1}}));
  EXPECT_TRUE(triangle.are_all);
}

}  // namespace
}  // namespace qvgen::test::mjcf_loops
