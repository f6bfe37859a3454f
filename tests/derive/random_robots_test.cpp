// SPDX-License-Identifier: MIT
// Random arms through the pipeline: every form is certified by `optimise`; here the result is compared once
// more, in double, with the independent chain that reads the same description by itself.
#include <cmath>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "../random_arms/leaves.h"
#include "dag/evaluate.h"
#include "derive/jacobian/quantities.h"
#include "derive/kinematics/forward_kinematics.h"
#include "description/reader.h"
#include "emit/math/singularities.h"
#include "model/evaluate.h"
#include "optimise/optimise.h"
#include "random_robot.h"
#include "reference/load.h"

namespace {

using namespace qvgen;

using test::Leaves;

/// Little search: whether a form is right does not depend on how far it is simplified.
optimise::OptimiseOptions quick() {
  optimise::OptimiseOptions options;
  options.search.iterations = 2000;
  return options;
}

class RandomRobots : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomRobots, DeriveToTheReferencePose) {
  const std::string text = test::random_description(GetParam());
  const auto read = description::read_text(text, "random.toml");
  ASSERT_TRUE(read.robot) << text << (read.diagnostics.empty() ? "" : to_string(read.diagnostics.front()));
  const reference::Chain chain = reference::load_text(text);
  const auto pose = optimise::optimise(derive::forward_kinematics(*read.robot), quick());
  const auto transform = optimise::optimise(derive::homogeneous_transform(*read.robot), quick());

  Leaves leaves;
  for (const auto& [name, value] : model::default_bindings(*read.robot))
    leaves.values[name] = model::to_double(value);
  std::mt19937 random(GetParam());
  Eigen::VectorXd q(chain.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    q[i] = std::uniform_real_distribution<double>(-3, 3)(random);
    leaves.values[read.robot->joints[static_cast<std::size_t>(i)].variable] = q[i];
  }
  const Eigen::Isometry3d expected = reference::forward_kinematics(chain, q);
  const auto p = dag::evaluate<double>(pose.function, leaves);
  const Eigen::Quaterniond orientation(p[0], p[1], p[2], p[3]);
  EXPECT_LT((orientation.toRotationMatrix() - expected.linear()).norm(), 1e-13) << text;
  EXPECT_LT((Eigen::Vector3d(p[4], p[5], p[6]) - expected.translation()).norm(), 1e-12) << text;
  const auto m = dag::evaluate<double>(transform.function, leaves);
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_NEAR(m[i], expected.linear()(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)),
                1e-13)
        << text;
}

/// Six joints whose last ones slide: the determinant's point of reference moves with them, its value does
/// not.
TEST(SlidesAtTheEnd, SingularityMeasuresAreTheDeterminant) {
  const std::string revolute = "[[joint]]\ntype = \"revolute\"\norigin = [\"1/3\", 0, \"2/5\"]\naxis = ";
  const std::string slide = "[[joint]]\ntype = \"prismatic\"\naxis = ";
  const std::string axes[] = {"\"z\"\n", "[\"3/5\", 0, \"4/5\"]\n",   "\"x\"\n", "\"y\"\n",
                              "\"z\"\n", "[\"5/13\", 0, \"12/13\"]\n"};
  for (std::size_t slides = 1; slides <= 3; ++slides) {
    std::string text = "name = \"slides_at_the_end\"\ntitle = \"an arm with slides at its end\"\n";
    for (std::size_t i = 0; i < 6; ++i)
      text +=
          (i + slides < 6 ? revolute : slide) + axes[i] + "variable = \"q" + std::to_string(i + 1) + "\"\n";
    const auto read = description::read_text(text, "slides.toml");
    ASSERT_TRUE(read.robot) << text << (read.diagnostics.empty() ? "" : to_string(read.diagnostics.front()));
    const auto measures = emit::singularity_measures(*read.robot);
    EXPECT_NE(measures.names, std::vector<std::string>{"determinant"})
        << "factored, since no twist is a symbol";
    EXPECT_NO_THROW(optimise::optimise(measures.quantity, quick())) << text;
  }
}

/// Twists whose sines are no roots of rational numbers, two of which add up to a right angle.
TEST(AnyTwist, EveryFormIsItsDefinition) {
  std::string text = "name = \"any_twist\"\ntitle = \"twists of any size\"\nconvention = \"standard\"\n";
  const char* twists[] = {"50 deg", "40 deg", "7 deg", "-45 deg", "90 deg", "0"};
  for (std::size_t i = 0; i < 6; ++i)
    text += "[[dh]]\ntype = \"revolute\"\nvariable = \"q" + std::to_string(i + 1) +
            "\"\na = \"1/3\"\nd = \"1/5\"\nalpha = \"" + twists[i] + "\"\n";
  const auto read = description::read_text(text, "any_twist.toml");
  ASSERT_TRUE(read.robot) << text << (read.diagnostics.empty() ? "" : to_string(read.diagnostics.front()));
  const auto jacobian = optimise::optimise(derive::jacobian(*read.robot), quick());
  EXPECT_LE(jacobian.counts.sine_cosines, 6) << "a constant's sine is a number";
}

/// A usual run has twenty arms. Long runs have QVGEN_ARMS, the sixth of which takes as long as all twenty.
auto seeds() {
  const char* arms = std::getenv("QVGEN_ARMS");
  return arms == nullptr ? testing::Range(8U, 28U)
                         : testing::Range(1U, 1U + static_cast<std::uint32_t>(std::atoi(arms)));
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomRobots, seeds());

}  // namespace
