// SPDX-License-Identifier: MIT
// Welds and slides in space: a loop is two chains between the same frames, so that at every assembly that
// the reference finds both reach the same pose; rows of equations are counted, and refusals have reasons.
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "derive/loops/assembly_plan.h"
#include "description/reader.h"
#include "description/write.h"
#include "reference/load.h"
#include "reference/loops.h"
#include "verify/loops/mobility.h"

namespace qvgen::test::loops_in_space {
namespace {

using Eigen::VectorXd;
using testing::HasSubstr;

model::Mechanism mechanism_of(const std::string& text) {
  const auto result = description::read_text(text, "m.toml");
  if (!result.robot) throw std::runtime_error(description::to_string(result.diagnostics.front()));
  return {*result.robot, result.tips, result.loops};
}

/// A random single loop in space: joints on both sides, some of which slide, and a weld or a slide. One joint
/// is driven, and one, which may be another, is the output.
class Ring {
 public:
  Ring(unsigned seed, int joints, bool slides) : random_(seed) {
    const int second = static_cast<int>(random_() % static_cast<unsigned>(joints));
    text_ = "name = \"m\"\ntitle = \"m\"\nactuated = [\"j" + among(0, joints - 1) + "\"]\n";
    int slid = slides ? 1 : 0;
    for (int i = 0; i < joints; ++i) {
      const bool turns = slid > 1 || random_() % 5 != 0;
      slid += turns ? 0 : 1;
      text_ += "[[joint]]\ntype = \"" + std::string(turns ? "revolute" : "prismatic") +
               "\"\naxis = " + axis() + "\nvariable = \"j" + std::to_string(i) + "\"\norigin = " + point() +
               "\nlink = " + point() + "\n";
      if (i == second && i > 0) text_ += "parent = \"base\"\n";
      if (random_() % 3 == 0) text_ += "rpy = [" + number() + ", 0, \"90 deg\"]\n";
    }
    const std::string last = "\"j" + std::to_string(joints - 1) + "\"";
    const std::string other = second > 0 ? "\"j" + std::to_string(second - 1) + "\"" : "\"base\"";
    const bool is_first = random_() % 2 == 0;
    text_ += "[[tip]]\nname = \"end\"\n[[loop]]\ntype = \"" + std::string(slides ? "slide" : "weld") +
             "\"\nbetween = [" + (is_first ? last + ", " + other : other + ", " + last) + "]\nat = [" +
             point() + ", " + point() + "]\nrpy = [" + number() + ", " + number() + ", 0]\n";
    if (slides) text_ += "axis = " + axis() + "\n";
    text_.insert(text_.find("[["), "outputs = [\"j" + among(0, joints - 1) + "\"]\n");
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string among(int low, int high) {
    return std::to_string(low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1)));
  }
  std::string number() { return (random_() % 2 == 0 ? "-0." : "0.") + among(10, 99); }
  std::string point() { return "[" + number() + ", " + number() + ", " + number() + "]"; }
  std::string axis() {
    static const std::array<const char*, 7> axes{"\"+x\"",
                                                 "\"-y\"",
                                                 "\"+z\"",
                                                 "[0, \"3/5\", \"4/5\"]",
                                                 "[\"-4/5\", 0, \"3/5\"]",
                                                 "[\"2/3\", \"1/3\", \"-2/3\"]",
                                                 "[\"6/7\", \"2/7\", \"3/7\"]"};
    return axes[random_() % axes.size()];
  }

  std::mt19937 random_;
  std::string text_;
};

VectorXd values_of(const VectorXd& q, const std::vector<std::size_t>& joints) {
  VectorXd values(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = q[static_cast<Eigen::Index>(joints[i])];
  return values;
}

reference::Isometry3d end_of(const model::Robot& robot, const VectorXd& q) {
  return reference::forward_kinematics(reference::load_text(description::write_text(robot)), q);
}

/// The pose of a chain, whose slide, if it has one, is where it brings the end nearest to another one.
reference::Isometry3d end_of(const derive::loops::LoopChain& of, const VectorXd& q,
                             const reference::Isometry3d& goal) {
  VectorXd values(static_cast<Eigen::Index>(of.joints.size()));
  Eigen::Index slide = -1;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const auto& joint = of.joints[static_cast<std::size_t>(i)];
    values[i] = joint ? q[static_cast<Eigen::Index>(*joint)] : 0;
    if (!joint) slide = i;
  }
  reference::Isometry3d end = end_of(of.chain, values);
  if (slide < 0) return end;
  values[slide] = 1;
  const Eigen::Vector3d way = end_of(of.chain, values).translation() - end.translation();
  values[slide] = way.dot(goal.translation() - end.translation());
  return end_of(of.chain, values);
}

TEST(LoopChains, ReachThePoseOfTheRestAtEveryAssembly) {
  int assemblies = 0;
  for (unsigned seed = 1; seed <= QVGEN_LOOP_RINGS; ++seed) {
    const Ring ring(seed, seed % 2 == 0 ? 7 : 6, seed % 2 != 0);
    SCOPED_TRACE(ring.text());
    const model::Mechanism mechanism = mechanism_of(ring.text());
    const auto& loops = mechanism.loops;
    const auto chains = derive::loops::chains_of(mechanism);
    ASSERT_EQ(chains.size(), loops.actuated == loops.outputs ? 1U : 2U);
    const verify::LoopNumbers numbers(mechanism);
    const auto q = numbers.assembled(seed);
    if (!q) continue;
    assemblies += static_cast<int>(chains.size());
    for (const auto& each : chains) {
      ASSERT_EQ(each.chain.joints.size(), 6U);
      const auto goal = end_of(each.rest, values_of(*q, each.rest_joints));
      EXPECT_LT((end_of(each, *q, goal).matrix() - goal.matrix()).norm(), 1e-9);
      VectorXd off = *q;
      off[static_cast<Eigen::Index>(each.held().front())] += 1e-3;
      EXPECT_GT((end_of(each, off, goal).matrix() - goal.matrix()).norm(), 1e-5);
    }
    const auto plan = derive::loops::assembly_plan(mechanism, loops.outputs);
    EXPECT_TRUE(plan.found);
    ASSERT_EQ(plan.chains.size(), 1U);
    EXPECT_EQ(plan.chains[0].chain.name, chains.back().chain.name);
    EXPECT_EQ(plan.chains[0].rest_joints, loops.outputs);
  }
  EXPECT_GE(assemblies, QVGEN_LOOP_RINGS);
}

/// Gaps and their derivatives, also where loops are far from closed.
TEST(LoopChains, HaveTheDerivativesOfTheirGaps) {
  std::mt19937 random(3);
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const Ring ring(seed, seed % 2 == 0 ? 7 : 6, seed % 2 != 0);
    SCOPED_TRACE(ring.text());
    const verify::LoopNumbers numbers(mechanism_of(ring.text()));
    VectorXd q(seed % 2 == 0 ? 7 : 6);
    for (double& value : q) value = std::uniform_real_distribution<double>(-1, 1)(random);
    const Eigen::MatrixXd jacobian = numbers.jacobian(q);
    ASSERT_EQ(jacobian.rows(), q.size() - 1);
    const double step = 1e-6;
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      const VectorXd way = VectorXd::Unit(q.size(), i) * step;
      const VectorXd by = (numbers.gaps(q + way) - numbers.gaps(q - way)) / (2 * step);
      EXPECT_LT((by - jacobian.col(i)).norm(), 1e-6 * (1 + jacobian.norm() * jacobian.norm()));
    }
  }
}

std::string reasons_of(const std::string& text, const std::vector<std::size_t>& given) {
  model::Mechanism mechanism = mechanism_of(text);
  mechanism.loops.actuated = given;
  const auto plan = derive::loops::assembly_plan(mechanism, given);
  EXPECT_FALSE(plan.found);
  return plan.reasons.empty() ? "" : plan.reasons.front();
}

TEST(LoopChains, SayWhyALoopIsNone) {
  const std::string seven = Ring(2, 7, false).text(), eight = Ring(2, 8, false).text();
  EXPECT_THAT(reasons_of(eight, {0}),
              HasSubstr("its weld holds 6 joints in space, and j1, j2, j3, j4, j5, j6, j7 are open; "
                        "drive all but 6 of them"));
  EXPECT_THAT(reasons_of(Ring(2, 7, true).text(), {0}), HasSubstr("its slide holds 5 joints in space"));
  EXPECT_THAT(reasons_of(eight, {0, 4}), HasSubstr("drive joints that follow each other around the loop"));
  EXPECT_THAT(reasons_of(Ring(2, 6, false).text(), {}), HasSubstr("none of its joints has a value"));
  EXPECT_THAT(reasons_of(seven, {}), HasSubstr("are open"));
}

}  // namespace
}  // namespace qvgen::test::loops_in_space
