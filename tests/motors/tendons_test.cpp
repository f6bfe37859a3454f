// SPDX-License-Identifier: MIT
// Motors on fixed tendons of an MJCF where joints branch and beside loops, against MuJoCo's reading of the
// same file: lengths of tendons are the motors' values, their rates the motors' speeds, and a motor's force
// does to the joints what it does to the motor.
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "description/reader.h"
#include "loops/mujoco_model.h"
#include "model/followers.h"
#include "verify/loops/mobility.h"

namespace qvgen::test::tendons {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using loops::mujoco_model;
using loops::MujocoData;
using loops::MujocoModel;

struct File {
  std::string text;
  std::vector<std::string> tendons;
};

std::string body(const std::string& name, const std::string& at, const std::string& joint,
                 const std::string& content = "") {
  return fmt::format(
      "<body name='{0}' pos='{1}'><inertial pos='0.1 0 0' mass='1' diaginertia='1 1 1'/><joint name='{0}' "
      "{2}/>\n{3}</body>\n",
      name, at, joint, content);
}

/// Writes a palm on a wrist, with fingers of one to three joints. Tendons pull random joints, of several
/// fingers too; as many joints have none of their own.
class HandWriter {
 public:
  explicit HandWriter(unsigned seed) : random_(seed) {}

  File hand() {
    std::string bodies;
    joints_ = {"wrist"};
    for (int finger = 0, fingers = 2 + below(2); finger < fingers; ++finger)
      bodies += finger_of(finger, 1 + below(3));
    const std::string wrist = body("wrist", "0 0 0.1", "axis='0 0 1' ref='0.2'", bodies);
    std::shuffle(joints_.begin(), joints_.end(), random_);
    File file;
    std::string tendons, actuators;
    const std::size_t pulled = 1 + static_cast<std::size_t>(below(static_cast<int>(joints_.size())));
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const std::string name = fmt::format("t{}", i);
      if (i < pulled) tendons += tendon(name, pulled);
      if (i < pulled) file.tendons.push_back(name);
      actuators += i < pulled ? "<motor tendon='" + name + "'/>" : "<motor joint='" + joints_[i] + "'/>";
    }
    file.text = "<mujoco model='hand'><compiler angle='radian'/><worldbody>\n" + wrist +
                "</worldbody>\n<tendon>" + tendons + "</tendon>\n<actuator>" + actuators +
                "</actuator></mujoco>\n";
    return file;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  double number() { return (below(3999) - 1999.5) / 1000; }
  std::string finger_of(int finger, int links) {
    std::string content;
    for (int link = links; link-- > 0;) {
      const std::string name = fmt::format("f{}{}", finger, link);
      joints_.push_back(name);
      content = body(name, fmt::format("0.1 {} 0", 0.05 * finger),
                     fmt::format("axis='{} 1 {}' ref='{}'", number(), number(), number()), content);
    }
    return content;
  }
  /// Pulls the joints that have no motors of their own, and some that have.
  std::string tendon(const std::string& name, std::size_t pulled) {
    std::string content;
    for (std::size_t i = 0; i < joints_.size(); ++i)
      if (i < pulled || below(3) == 0)
        content += fmt::format("<joint joint='{}' coef='{}'/>", joints_[i], number());
    return "<fixed name='" + name + "'>" + content + "</fixed>\n";
  }

  std::mt19937 random_;
  std::vector<std::string> joints_;
};

/// MuJoCo's numbers of a file at joints, rates and motors' forces by their names.
struct Mujoco {
  explicit Mujoco(const std::string& text)
      : model(mujoco_model(text)), data(mj_makeData(model.get()), &mj_deleteData) {}

  void place(const model::Robot& robot, const VectorXd& q, const VectorXd& qd) {
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      const int joint = mj_name2id(model.get(), mjOBJ_JOINT, robot.joints[i].variable.c_str());
      if (joint < 0) continue;  // a motor among loops
      data->qpos[model->jnt_qposadr[joint]] = q[static_cast<Eigen::Index>(i)];
      data->qvel[model->jnt_dofadr[joint]] = qd[static_cast<Eigen::Index>(i)];
    }
    for (int i = 0; i < model->nu; ++i) data->ctrl[i] = 1 + 0.5 * i;
    mj_forward(model.get(), data.get());
  }
  double length(const std::string& tendon) const {
    return data->ten_length[mj_name2id(model.get(), mjOBJ_TENDON, tendon.c_str())];
  }
  double rate(const std::string& tendon) const {
    return data->ten_velocity[mj_name2id(model.get(), mjOBJ_TENDON, tendon.c_str())];
  }
  /// Force of the actuator on a tendon or a joint.
  double force(const std::string& target) const {
    for (int i = 0; i < model->nu; ++i) {
      const bool on_tendon = model->actuator_trntype[i] == mjTRN_TENDON;
      const int id = mj_name2id(model.get(), on_tendon ? mjOBJ_TENDON : mjOBJ_JOINT, target.c_str());
      if (id >= 0 && model->actuator_trnid[2 * i] == id) return data->ctrl[i];
    }
    return 0;
  }
  double joint_force(const std::string& joint) const {
    return data->qfrc_actuator[model->jnt_dofadr[mj_name2id(model.get(), mjOBJ_JOINT, joint.c_str())]];
  }

  MujocoModel model;
  MujocoData data;
};

MatrixXd coupling(const model::Robot& robot) {
  const auto shares = model::shares(robot);
  MatrixXd matrix = MatrixXd::Zero(static_cast<Eigen::Index>(shares.size()),
                                   static_cast<Eigen::Index>(model::driven_count(robot)));
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (const model::Share& share : shares[i])
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(share.driven)) =
          cln::double_approx(share.ratio);
  return matrix;
}

description::ReadResult read(const std::string& text, const description::ReadOptions& options) {
  auto result = description::read_text(text, "m.xml", options);
  for (const auto& diagnostic : result.diagnostics)
    if (diagnostic.severity != description::Diagnostic::note)
      ADD_FAILURE() << description::to_string(diagnostic) << text;
  return result;
}

TEST(TendonsOfTrees, AreMujocos) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const File file = HandWriter(seed).hand();
    description::ReadOptions options;
    options.tips = {"all"};
    options.floating = seed % 2 == 0;
    options.snap.mode = description::SnapOptions::off;
    const auto result = read(file.text, options);
    ASSERT_TRUE(result.robot.has_value());
    const model::Robot& robot = *result.robot;
    const MatrixXd by_motors = coupling(robot);
    ASSERT_EQ(by_motors.rows(), by_motors.cols());
    const VectorXd motors = VectorXd::Random(by_motors.cols()), rates = VectorXd::Random(by_motors.cols());
    Mujoco mujoco(file.text);
    mujoco.place(robot, by_motors * motors, by_motors * rates);
    VectorXd forces(by_motors.rows());
    for (Eigen::Index i = 0; i < forces.size(); ++i)
      forces[i] = mujoco.joint_force(robot.joints[static_cast<std::size_t>(i)].variable);
    const VectorXd of_motors = by_motors.transpose() * forces;
    const std::vector<std::string> names = model::variables(robot);
    const double allowed = 1e-12 * (1 + by_motors.norm());
    for (Eigen::Index i = 0; i < motors.size(); ++i) {
      const std::string& name = names[static_cast<std::size_t>(i)];
      EXPECT_NEAR(of_motors[i], mujoco.force(name), 10 * allowed) << name << file.text;
      if (std::find(file.tendons.begin(), file.tendons.end(), name) == file.tendons.end()) continue;
      EXPECT_NEAR(mujoco.length(name), motors[i], allowed) << name << file.text;
      EXPECT_NEAR(mujoco.rate(name), rates[i], allowed) << name << file.text;
    }
  }
}

const std::string hinge = "axis='0 1 0'";

/// A five-bar, whose cranks stand at references that are not zero.
std::string five_bar(const std::string& sections) {
  return "<mujoco model='m'><compiler angle='radian'/><worldbody>\n" +
         body("left", "0 0 0", hinge + " ref='0.3'", body("left_elbow", "0.2 0 0", hinge)) +
         body("right", "0.15 0 0", hinge + " ref='-0.1'", body("right_elbow", "0.2 0 0", hinge)) +
         "</worldbody>\n<equality><connect body1='left_elbow' body2='right_elbow' anchor='0.26 0 0'/>"
         "</equality>\n" +
         sections + "</mujoco>\n";
}

std::string on_cranks(const std::string& name, double left, double right) {
  return fmt::format(
      "<fixed name='{}'><joint joint='left' coef='{}'/><joint joint='right' coef='{}'/></fixed>", name, left,
      right);
}

/// Checks that lengths are the motors' values wherever MuJoCo's loops and the reader's are closed.
void expect_lengths(const std::string& text, const std::vector<std::string>& actuated,
                    const std::vector<std::string>& tendons) {
  const auto result = read(text, {});
  ASSERT_TRUE(result.robot.has_value());
  const model::Mechanism mechanism{*result.robot, result.tips, result.loops};
  std::vector<std::string> names;
  for (const model::Joint& joint : mechanism.robot.joints) names.push_back(joint.variable);
  std::vector<std::string> driven;
  for (const std::size_t joint : mechanism.loops.actuated) driven.push_back(names[joint]);
  EXPECT_EQ(driven, actuated);
  EXPECT_EQ(verify::mobility_of(mechanism).free, static_cast<int>(actuated.size()));
  Mujoco mujoco(text);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto q = verify::LoopNumbers(mechanism).assembled(seed);
    ASSERT_TRUE(q.has_value());
    mujoco.place(mechanism.robot, *q, VectorXd::Zero(q->size()));
    ASSERT_GT(mujoco.data->ne, 0);
    for (int row = 0; row < mujoco.data->ne; ++row) EXPECT_LT(std::abs(mujoco.data->efc_pos[row]), 1e-10);
    for (const std::string& tendon : tendons) {
      const auto place = std::find(names.begin(), names.end(), tendon) - names.begin();
      EXPECT_NEAR(mujoco.length(tendon), (*q)[place], 1e-10) << tendon;
    }
  }
}

TEST(TendonsBesideLoops, AreMujocos) {
  const auto tendons = [](const std::string& text) { return "<tendon>" + text + "</tendon>\n"; };
  expect_lengths(five_bar(tendons(on_cranks("ml", 1, 0.5) + on_cranks("mr", 1, -1)) +
                          "<actuator><motor tendon='ml'/><motor tendon='mr'/></actuator>"),
                 {"ml", "mr"}, {"ml", "mr"});
  // A belt from a crank that has a motor, and a length that the loop has to tell joints by.
  expect_lengths(five_bar(tendons(on_cranks("belt", 0.25, 2)) +
                          "<actuator><motor joint='left'/><motor tendon='belt'/></actuator>"),
                 {"left", "belt"}, {"belt"});
  expect_lengths(five_bar(tendons(on_cranks("sum", 0.75, 0.5)) +
                          "<actuator><motor joint='left_elbow'/><motor tendon='sum'/></actuator>"),
                 {"left_elbow", "sum"}, {"sum"});
}

/// Fingers of a gripper that <equality> ties: the tendon's motor is the motor of the joint that leads.
TEST(TendonsBesideLoops, AMotorOfALengthThatIsAJointIsThatJoints) {
  const std::string text =
      five_bar("<tendon>" + on_cranks("split", 0.5, 0.5) +
               "</tendon><equality><joint joint1='left' joint2='right' polycoef='0.1 1 0 0 0'/></equality>"
               "<actuator><motor tendon='split'/></actuator>");
  expect_lengths(text, {"right"}, {});
}

}  // namespace
}  // namespace qvgen::test::tendons
