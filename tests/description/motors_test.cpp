// SPDX-License-Identifier: MIT
// Joints that follow sums of joints and motors: what is read, written again, and refused.
#include <gtest/gtest.h>

#include "description/reader.h"
#include "description/write.h"
#include "model/followers.h"
#include "model/motor_turns.h"

namespace qvgen::description {
namespace {

using cln::cl_RA;

std::string joint(const std::string& variable, const std::string& more = "") {
  return "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"" + variable + "\"\n" + more;
}
std::string follows(const std::string& sum) { return "follows = \"" + sum + "\"\n"; }
std::string motor(const std::string& variable, const std::string& more = "") {
  return "[[motor]]\nvariable = \"" + variable + "\"\n" + more;
}

ReadResult read(const std::string& tables) {
  return read_text("name = \"arm\"\ntitle = \"t\"\n" + tables, "arm.toml");
}

/// Tilt and roll by two motors, behind a joint of its own.
std::string wrist(const std::string& tilt = "(ml + mr)/2",
                  const std::string& roll = "1/2 ml - 1/2 mr + 10 deg",
                  const std::string& motors = motor("ml") + motor("mr")) {
  return joint("theta1") + joint("tilt", follows(tilt)) + joint("roll", follows(roll)) + motors;
}

std::string first_error(const std::string& tables) {
  const ReadResult result = read(tables);
  EXPECT_FALSE(result.robot);
  return result.diagnostics.empty() ? "" : to_string(result.diagnostics.front());
}

std::string all_errors(const std::string& tables) {
  std::string all;
  for (const Diagnostic& each : read(tables).diagnostics) all += to_string(each) + "\n";
  return all;
}

TEST(Motors, StandWhereTheirFirstJointDoes) {
  const ReadResult result = read(joint("a", follows("m2 - b")) + joint("b") + joint("c", follows("3 m1")) +
                                 motor("m1") + motor("m2"));
  ASSERT_TRUE(result.robot);
  EXPECT_EQ(model::variables(*result.robot), (std::vector<std::string>{"m2", "b", "m1"}));
  const auto shares = model::shares(*result.robot);
  ASSERT_EQ(shares[0].size(), 2U);
  EXPECT_EQ(shares[0][0].driven, 0U);
  EXPECT_EQ(shares[0][1].ratio, -1);
  EXPECT_EQ(shares[2][0].ratio, 3);
}

TEST(Motors, FactorsAreExactInEveryNotation) {
  for (const char* sum : {"1/2 ml - 0.25 mr", "0.5*ml - mr/4", "(2 ml - mr)/4", "-(mr - 2*ml)/4",
                          "ml/2 - 1/4*mr", "1/4 (2 ml - mr)"}) {
    const ReadResult result = read(wrist(sum, "ml + mr"));
    ASSERT_TRUE(result.robot) << sum << to_string(result.diagnostics.front());
    const auto shares = model::shares(*result.robot);
    EXPECT_EQ(shares[1][0].ratio, cl_RA(1) / 2) << sum;
    EXPECT_EQ(shares[1][1].ratio, cl_RA(-1) / 4) << sum;
  }
}

TEST(Motors, ConstantsGoIntoTheFrameAndLimitsStay) {
  const ReadResult result =
      read(joint("a", follows("ml + mr + 90 deg") + "limits = [0, 1]\n") + joint("b", follows("ml - mr")) +
           motor("ml") + motor("mr", "limits = [-2, 2]\n"));
  ASSERT_TRUE(result.robot);
  const model::Robot& robot = *result.robot;
  EXPECT_EQ(to_string(robot.joints[0].before.turns.at(0).angle), "1/2*pi");
  ASSERT_TRUE(robot.joints[0].limits);
  EXPECT_EQ(to_string(robot.joints[0].limits->upper), "1 - 1/2*pi");
  EXPECT_FALSE(robot.motors[0].limits);
  EXPECT_TRUE(robot.motors[1].limits);
  const ReadResult again = read_text(write_text(robot), "arm.toml");
  ASSERT_TRUE(again.robot);
  EXPECT_EQ(write_text(*again.robot), write_text(robot));
  EXPECT_EQ(model::relation_text(again.robot->joints[1].follows), "ml - mr");
}

TEST(Motors, LimitsOfAJointWithOneMotorBecomeTheMotors) {
  const ReadResult result =
      read(joint("a", follows("m/100") + "limits = [-1, 2]\n") + motor("m", "limits = [-1000, 50]\n"));
  ASSERT_TRUE(result.robot);
  EXPECT_EQ(to_string(result.robot->motors[0].limits->lower), "-100");
  EXPECT_EQ(to_string(result.robot->motors[0].limits->upper), "50");
  EXPECT_FALSE(result.robot->joints[0].limits);
}

TEST(Motors, TheInverseIsExact) {
  const ReadResult result = read(wrist("1/3 ml + 2/7 mr", "ml - 5 mr"));
  ASSERT_TRUE(result.robot);
  const auto inverse = model::inverse_shares(*result.robot);
  ASSERT_TRUE(inverse);
  const auto shares = model::shares(*result.robot);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      cl_RA sum = 0;
      for (const model::Share& share : shares[i]) sum = sum + share.ratio * (*inverse)[share.driven][k];
      EXPECT_EQ(sum, i == k ? 1 : 0);
    }
}

TEST(Motors, OfMoreJointsHaveALeftInverse) {
  const ReadResult result = read(joint("a") + joint("b", follows("a")));
  const auto inverse = model::inverse_shares(*result.robot);
  ASSERT_TRUE(inverse);
  ASSERT_EQ(inverse->size(), 1U);
  EXPECT_EQ((*inverse)[0], (std::vector<cl_RA>{1, 0}));
}

/// The basis makes the lattice that turns of single joints make, and is in echelon form.
TEST(Motors, WholeTurnsHaveABasisInEchelonForm) {
  const ReadResult result = read(wrist("(ml + mr)/2", "(ml - mr)/2"));
  ASSERT_TRUE(result.robot);
  const auto turns = model::motor_turns(*result.robot, *model::inverse_shares(*result.robot));
  ASSERT_EQ(turns.values.size(), 3U);
  ASSERT_EQ(turns.turns.size(), 3U);
  const std::vector<std::vector<cl_RA>> expected{{1, 0, 0}, {0, 1, 1}, {0, 0, 2}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(turns.turns[i].pivot, i);
    EXPECT_EQ(turns.turns[i].ends_block, i != 1);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(cln::abs(turns.turns[i].motion[k]), expected[i][k]) << i << k;
  }
}

TEST(Motors, MistakesAreReportedWithTheirPlace) {
  const std::string two = motor("ml") + motor("mr");
  EXPECT_EQ(first_error(wrist("ml + ml")),
            "arm.toml:11:17: error: 'follows' names 'ml' twice; write it once, with the sum of its factors");
  EXPECT_EQ(first_error(wrist("sqrt(2) ml + mr")),
            "arm.toml:11:20: error: the factor of 'ml' is not rational; write a number or a quotient, e.g. "
            "\"3/2 ml\"");
  EXPECT_EQ(first_error(wrist("0 ml + mr")), "arm.toml:11:14: error: the factor of 'ml' is 0; leave it out");
  EXPECT_EQ(first_error(wrist("ml*mr")),
            "arm.toml:11:11: error: 'follows' is not a sum of multiples of joints and motors; write a sum of "
            "joints "
            "and motors, e.g. \"1/2 ml - 1/2 mr + 10 deg\"");
  EXPECT_EQ(first_error(wrist("10 deg + 1")).substr(0, 60),
            "arm.toml:11:11: error: 'follows' names no joint and no motor");
  EXPECT_EQ(first_error(wrist("ml + mx")),
            "arm.toml:11:11: error: 'tilt' follows 'mx', which is neither a joint of the chain nor a motor; "
            "did you "
            "mean 'ml'?");
  EXPECT_EQ(
      first_error(wrist("ml + roll")),
      "arm.toml:11:11: error: 'tilt' follows 'roll', which follows another itself; name joints that follow "
      "none, or motors");
  EXPECT_EQ(
      first_error(wrist("ml + tilt")),
      "arm.toml:11:11: error: 'tilt' follows 'tilt': no joint leads itself; name joints that follow none, or "
      "motors");
  EXPECT_EQ(first_error(wrist("ml +")).substr(0, 22), "arm.toml:11:16: error:");
  EXPECT_EQ(first_error(wrist("ml + mr", "2 ml + 2 mr")),
            "arm.toml:17:1: error: the relations of the joints do not tell the motors apart: some motion of "
            "the motors "
            "moves no joint; correct the factors of 'follows'; there are at most as many motors as joints");
  EXPECT_EQ(first_error(wrist("ml", "mr", two + motor("mx"))),
            "arm.toml:21:1: error: no joint follows the motor 'mx'; write follows = \"mx\" in the joint that "
            "it moves");
  EXPECT_NE(
      all_errors(wrist("ml", "theta1", motor("ml") + motor("theta1")))
          .find(
              "arm.toml:20:12: error: the variable 'theta1' is used twice: joint 1 has it already; give each "
              "joint and each motor a variable of its own"),
      std::string::npos);
  EXPECT_EQ(first_error(joint("a", follows("ml + mr") + "ratio = 2\n") + joint("b", follows("ml")) + two),
            "arm.toml:8:1: error: 'ratio' beside a sum in 'follows'; write it in the sum, e.g. follows = "
            "\"1/2 ml + "
            "1/2 mr + 10 deg\"");
  EXPECT_EQ(first_error(joint("a", follows("ml + mr") + "coulomb_friction = 2\n") +
                        joint("b", follows("ml")) + two),
            "arm.toml:7:11: error: 'a' follows several and has Coulomb friction, whose direction is no sum "
            "of theirs; "
            "give the friction to the motors");
  EXPECT_EQ(first_error(wrist("ml", "mr", motor("ml", "axis = \"+z\"\n") + motor("mr"))).substr(0, 58),
            "arm.toml:19:1: error: unknown key 'axis' in [[motor]]; the");
}

}  // namespace
}  // namespace qvgen::description
