// SPDX-License-Identifier: MIT
// Bounds on the committed operation counts: what common subexpression elimination on the thesis's corrected
// formulas gives (multiplications + additions, symbolic constants), sympy's counts of the matrix form, and
// the rule that a function never computes more sines and cosines than there are revolute joints left after
// merging parallel neighbours.
#include <fstream>

#include <gtest/gtest.h>

#include "cli/commands.h"
#include "derive/kinematics/turns.h"
#include "description/reader.h"
#include "verify/counts_json.h"

namespace {

using namespace qvgen;

nlohmann::ordered_json committed() {
  std::ifstream file(std::string(QVGEN_SOURCE_DIR) + "/generated/operation_counts.json");
  return nlohmann::ordered_json::parse(file);
}

int operations(const nlohmann::ordered_json& counts) {
  const dag::OperationCounts c = verify::counts_from_json(counts);
  return c.multiplications + c.additions;
}

TEST(Targets, FewestOperationsOfThePose) {
  const std::map<std::string, int> most{
      {"ss", 4},  {"sc", 21}, {"sn", 28}, {"cs", 23}, {"cc", 23}, {"cr", 22}, {"ns", 27}, {"nn", 64},
      {"nr", 33}, {"rc", 52}, {"rn", 30}, {"rr", 43}, {"rs", 11}, {"sr", 24}, {"cn", 26}, {"nc", 35}};
  const auto counts = committed();
  for (const auto& [robot, bound] : most)
    EXPECT_LE(operations(counts.at(robot).at("forward_kinematics").at("fewest_operations")), bound) << robot;
}

TEST(Targets, MatrixFormIsBelowSympy) {
  const std::map<std::string, int> sympy{
      {"puma560", 71 + 36}, {"stanford", 50 + 25}, {"ur5", 84 + 42}, {"iiwa14", 77 + 41}};
  const auto counts = committed();
  for (const auto& [robot, bound] : sympy)
    EXPECT_LT(operations(counts.at(robot).at("homogeneous_transform").at("emitted")), bound) << robot;
}

TEST(Targets, JacobianIsBelowItsThreeMethodsAndSympy) {
  const std::map<std::string, int> sympy{
      {"puma560", 91 + 46}, {"stanford", 76 + 36}, {"ur5", 114 + 57}, {"iiwa14", 113 + 57}};
  const auto counts = committed();
  for (const auto& [robot, bound] : sympy)
    EXPECT_LT(operations(counts.at(robot).at("forward_kinematics_and_jacobian").at("emitted")), bound)
        << robot;
  for (const auto& [robot, functions] : counts.items()) {
    const int jacobian = operations(functions.at("jacobian").at("emitted"));
    const int transform = operations(functions.at("homogeneous_transform").at("emitted"));
    EXPECT_LE(operations(functions.at("forward_kinematics_and_jacobian").at("emitted")), jacobian + transform)
        << robot;
    ASSERT_EQ(functions.at("jacobian").at("forms").size(), 3U) << robot;
    for (const auto& [method, method_counts] : functions.at("jacobian").at("forms").items())
      EXPECT_LE(jacobian, operations(method_counts)) << robot << ", " << method;
  }
}

/// Counts of axes and vectors with their derivatives in one frame. Columns differentiated on their way
/// through the frames cost half as much again.
TEST(Targets, DerivativesOfTheJacobian) {
  const std::map<std::string, std::pair<int, int>> most{{"iiwa14", {269, 176}},
                                                        {"general_6r", {483, 303}},
                                                        {"puma560", {93, 90}},
                                                        {"ur5", {103, 100}},
                                                        {"stanford", {78, 74}}};
  const auto counts = committed();
  for (const auto& [robot, bounds] : most) {
    EXPECT_LE(operations(counts.at(robot).at("jacobian_dot").at("emitted")), bounds.first) << robot;
    EXPECT_LE(operations(counts.at(robot).at("jacobian_dot_times_qd").at("emitted")), bounds.second) << robot;
  }
}

TEST(Targets, NoMoreSinesThanMergedJoints) {
  int chains = 0;
  const auto counts = committed();
  for (const auto& path : cli::descriptions_in(std::string(QVGEN_SOURCE_DIR) + "/generator/robots")) {
    const auto read = description::read_file(path);
    const auto chain = derive::zero_reference_chain(*read.robot);
    if (!chain) continue;
    ++chains;
    int revolute = 0;
    for (const auto& joint : chain->joints) revolute += joint.type == model::JointType::revolute ? 1 : 0;
    const int merged = static_cast<int>(derive::turn_sequence(*chain).turns.size());
    for (const char* function : {"forward_kinematics", "homogeneous_transform"}) {
      const int used =
          verify::counts_from_json(counts.at(read.robot->name).at(function).at("emitted")).sine_cosines;
      EXPECT_LE(used, revolute) << read.robot->name << " " << function;
      EXPECT_GE(used, merged) << read.robot->name << " " << function << ": too few to be right";
    }
  }
  EXPECT_GT(chains, 20);
}

}  // namespace
