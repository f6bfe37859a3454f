// SPDX-License-Identifier: MIT
// Links of an MJCF that are rods: at assembled joints MuJoCo's own points are as far apart as the rod is
// long, weights are those of the file, and links that do more than keep a distance stay links.
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "derive/loops/assembly_plan.h"
#include "description/reader.h"
#include "model/evaluate.h"
#include "mujoco_model.h"
#include "verify/loops/mobility.h"

namespace qvgen::test::mjcf_rods {
namespace {

using loops::mujoco_model;
using loops::MujocoData;
using loops::MujocoModel;
using testing::HasSubstr;

std::string body(const std::string& name, const std::string& at, const std::string& joints,
                 const std::string& content = "", const std::string& mass = "1") {
  return "<body name='" + name + "' " + at + "><inertial pos='0 0 0' mass='" + mass +
         "' diaginertia='1 1 1'/>" + joints + "\n" + content + "</body>\n";
}

std::string hinge(const std::string& name, const std::string& axis, const std::string& more = "") {
  return "<joint name='" + name + "' axis='" + axis + "' " + more + "/>";
}

std::string mjcf(const std::string& bodies, const std::string& equality) {
  return "<mujoco model='m'><compiler angle='radian'/><worldbody>\n" + bodies + "</worldbody>\n<equality>\n" +
         equality +
         "</equality>\n<actuator><motor joint='left'/><motor joint='right'/></actuator>\n</mujoco>\n";
}

/// An ankle as humanoids have them: two cranks, each with a rod to the foot, which pitches and rolls.
struct Ankle {
  std::string ball = "<joint name='BALL' type='ball'/>";  ///< of a rod; BALL: its name
  std::string in_rod;                                     ///< content of the left rod's body
  std::string more;                                       ///< further closures
  std::string mass = "0.5";

  [[nodiscard]] std::string rod(const std::string& side) const {
    std::string joints = ball;
    for (std::size_t at = joints.find("BALL"); at != std::string::npos; at = joints.find("BALL"))
      joints.replace(at, 4, side + "_ball");
    return "<body name='" + side +
           "_rod' pos='0.04 0.01 0' euler='0.1 0.2 0.3'><inertial pos='0 0 -0.06' mass='" + mass +
           "' diaginertia='1e-3 1e-3 1e-3'/>" + joints + (side == "left" ? in_rod : "") + "</body>\n";
  }
  [[nodiscard]] std::string text() const {
    return mjcf(body("left_crank", "pos='0 0.05 0.3'", hinge("left", "0 1 0"), rod("left")) +
                    body("right_crank", "pos='0 -0.05 0.2'", hinge("right", "0 1 0"), rod("right")) +
                    body("yoke", "", hinge("pitch", "0 1 0"), body("foot", "", hinge("roll", "1 0 0"))),
                "<connect body1='left_rod' body2='foot' anchor='0 0 -0.24'/>\n"
                "<connect body1='right_rod' body2='foot' anchor='0 0 -0.16'/>\n" +
                    more);
  }
};

description::ReadResult read(const std::string& text, const description::ReadOptions& options = {}) {
  const auto result = description::read_text(text, "m.xml", options);
  for (const auto& diagnostic : result.diagnostics)
    if (diagnostic.severity == description::Diagnostic::error)
      ADD_FAILURE() << description::to_string(diagnostic) << "\n" << text;
  return result;
}

std::string said(const description::ReadResult& result) {
  std::string text;
  for (const auto& diagnostic : result.diagnostics) text += description::to_string(diagnostic) + "\n";
  return text;
}

std::vector<model::LoopType> types_of(const description::ReadResult& result) {
  std::vector<model::LoopType> types;
  for (const model::Loop& loop : result.loops.closures) types.push_back(loop.type);
  return types;
}

using model::LoopType;
const std::vector<LoopType> rods{LoopType::rod, LoopType::rod}, one_rod{LoopType::ball, LoopType::rod},
    no_rods{LoopType::ball, LoopType::ball};

/// How much farther apart, or closer, MuJoCo's ends of a <connect> are than its rod is long; by joint values.
double gap(const MujocoModel& model, const MujocoData& data, int connect) {
  const int rod = model->eq_obj1id[connect], foot = model->eq_obj2id[connect];
  const mjtNum* anchors = model->eq_data + connect * mjNEQDATA;
  std::array<mjtNum, 3> far{}, between{};
  mju_rotVecMat(far.data(), anchors + 3, data->xmat + 9 * foot);
  mju_addTo3(far.data(), data->xpos + 3 * foot);
  mju_sub3(between.data(), far.data(), data->xpos + 3 * rod);
  return mju_norm3(between.data()) - mju_norm3(anchors);
}

void set(const MujocoModel& model, const MujocoData& data, const model::Robot& robot,
         const Eigen::VectorXd& q) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const int joint = mj_name2id(model.get(), mjOBJ_JOINT, robot.joints[i].variable.c_str());
    data->qpos[model->jnt_qposadr[joint]] = q[static_cast<Eigen::Index>(i)];
  }
  mj_forward(model.get(), data.get());
}

TEST(MjcfRods, KeepTheDistanceThatMujocoHas) {
  Ankle by_hinges;
  by_hinges.ball = hinge("BALL1", "0 1 0", "pos='0 0 0'") + hinge("BALL2", "1 0 0");
  for (const std::string& text : {Ankle().text(), by_hinges.text()}) {
    const auto result = read(text);
    ASSERT_EQ(types_of(result), rods) << said(result);
    ASSERT_EQ(result.robot->joints.size(), 4U);
    const model::Mechanism mechanism{*result.robot, result.tips, result.loops};
    const MujocoModel mujoco = mujoco_model(text);
    const MujocoData data(mj_makeData(mujoco.get()), &mj_deleteData);
    const verify::LoopNumbers numbers(mechanism);
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const auto q = numbers.assembled(seed);
      ASSERT_TRUE(q.has_value());
      set(mujoco, data, mechanism.robot, *q);
      for (int connect = 0; connect < 2; ++connect) EXPECT_LT(std::abs(gap(mujoco, data, connect)), 1e-10);
      Eigen::VectorXd off = *q;
      off[0] += 1e-2;
      set(mujoco, data, mechanism.robot, off);
      EXPECT_GT(std::abs(gap(mujoco, data, 0)), 1e-6);
    }
  }
}

TEST(MjcfRods, MakeAnAnkleOneOfClosedForm) {
  const auto result = read(Ankle().text());
  const model::Mechanism mechanism{*result.robot, result.tips, result.loops};
  EXPECT_EQ(verify::mobility_of(mechanism).free, 2);
  const auto plan = derive::loops::assembly_plan(mechanism, mechanism.loops.actuated);
  ASSERT_TRUE(plan.found) << testing::PrintToString(plan.reasons);
  EXPECT_EQ(plan.plan.capacity, 8);
}

/// The left rod's centre is a quarter along its way, the right one's three eighths.
TEST(MjcfRods, HaveTheirMassAtTheirEnds) {
  const auto with = read(Ankle().text());
  Ankle light;
  light.mass = "0";
  const auto without = read(light.text());
  const auto added = [&](const std::string& joint) {
    for (std::size_t i = 0; i < with.robot->joints.size(); ++i)
      if (with.robot->joints[i].variable == joint)
        return model::to_double(model::evaluate(with.robot->joints[i].inertia.mass)) -
               model::to_double(model::evaluate(without.robot->joints[i].inertia.mass));
    return -1.0;
  };
  EXPECT_DOUBLE_EQ(added("left"), 0.5 * 3 / 4);
  EXPECT_DOUBLE_EQ(added("right"), 0.5 * 5 / 8);
  EXPECT_DOUBLE_EQ(added("roll"), 0.5 * (1.0 / 4 + 3.0 / 8));
  EXPECT_THAT(said(with),
              HasSubstr("the mass of the rod 'left_rod', 0.5 kg, is read as two masses at its ends"));
  EXPECT_THAT(said(without), testing::Not(HasSubstr("two masses")));
}

TEST(MjcfRods, SayWhatTheyAre) {
  EXPECT_THAT(
      said(read(Ankle().text())),
      HasSubstr("m.xml:3:1: note: 'left_rod' only keeps two points at their distance: it is read as a rod "
                "of 0.24 m; its own joints are left out; --tips with its name keeps them"));
  Ankle limited;
  limited.ball = hinge("BALL1", "0 1 0") + hinge("BALL2", "1 0 0", "range='-1 1'");
  EXPECT_THAT(said(read(limited.text())), HasSubstr("of 0.24 m, without the limits of its joints;"));
}

/// Each of them keeps the left link, and the right one is a rod all the same.
TEST(MjcfRods, AreNoLinksThatDoMore) {
  Ankle turned, crossed, moving, tied, apart;
  moving.in_rod = body("wheel", "", hinge("wheel", "0 0 1"));
  tied.more = "<connect body1='left_rod' body2='yoke' anchor='0.1 0 0'/>\n";
  EXPECT_EQ(types_of(read(moving.text())), one_rod);
  EXPECT_EQ(types_of(read(tied.text())), (std::vector{LoopType::ball, LoopType::rod, LoopType::ball}));
  // Two turns lead a rod around a point only if it is across the second, and that across the first.
  turned.ball = hinge("BALL1", "0 1 0") + hinge("BALL2", "0 0 1");
  EXPECT_EQ(types_of(read(turned.text())), no_rods);
  crossed.ball = hinge("BALL1", "0 0.8 0.6") + hinge("BALL2", "0 1 0");
  EXPECT_EQ(types_of(read(crossed.text())), no_rods);
  apart.ball = hinge("BALL1", "0 1 0", "pos='0.01 0 0'") + hinge("BALL2", "1 0.1 0");
  EXPECT_EQ(types_of(read(apart.text())), no_rods);
}

TEST(MjcfRods, AreNoLinksThatOptionsName) {
  description::ReadOptions tips;
  tips.tips = {"left_rod", "foot"};
  EXPECT_EQ(types_of(read(Ankle().text(), tips)), one_rod);
  description::ReadOptions driven;
  driven.actuated = {"left_ball_x", "right"};
  const auto result = read(Ankle().text(), driven);
  EXPECT_EQ(types_of(result), one_rod);
  const std::string text = said(result), note = "the ball joint 'left_ball' is read as three turns";
  EXPECT_NE(text.find(note), std::string::npos) << text;
  EXPECT_EQ(text.find(note), text.rfind(note)) << "said twice:\n" << text;
  EXPECT_THAT(text, testing::Not(HasSubstr("the ball joint 'right_ball'"))) << "a rod has no joints";
}

}  // namespace
}  // namespace qvgen::test::mjcf_rods
