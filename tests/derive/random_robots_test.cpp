// SPDX-License-Identifier: MIT
// Random arms through the pipeline: every form is certified by `optimise`; here the result is compared once more, in
// double, with the independent chain that reads the same description by itself.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "application/optimise.h"
#include "dag/evaluate.h"
#include "derive/forward_kinematics.h"
#include "description/reader.h"
#include "model/evaluate.h"
#include "random_robot.h"
#include "reference/load.h"

namespace {

using namespace qvgen;

/// Values of symbols and joint variables in double.
struct Leaves {
  std::map<std::string, double> values;
  double constant(const exact::Number& number) const { return number.to_double(); }
  double symbol(const std::string& name) const { return values.at(name); }
  double angle(const exact::Angle& angle) const {
    double sum = cln::double_approx(angle.pi) * M_PI;
    for (const auto& [name, coefficient] : angle.terms) sum += cln::double_approx(coefficient) * values.at(name);
    return sum;
  }
  double sine(const exact::Angle& a) const { return std::sin(angle(a)); }
  double cosine(const exact::Angle& a) const { return std::cos(angle(a)); }
  double root(double x) const { return std::sqrt(x); }
  double arctangent(double y, double x) const { return std::atan2(y, x); }
};

class RandomRobots : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomRobots, DeriveToTheReferencePose) {
  const std::string text = test::random_description(GetParam());
  const auto read = description::read_text(text, "random.toml");
  ASSERT_TRUE(read.robot) << text << (read.diagnostics.empty() ? "" : to_string(read.diagnostics.front()));
  const reference::Chain chain = reference::load_text(text);
  application::OptimiseOptions quick;
  quick.search.iterations = 2000;
  const auto pose = application::optimise(derive::forward_kinematics(*read.robot), quick);
  const auto transform = application::optimise(derive::homogeneous_transform(*read.robot), quick);

  Leaves leaves;
  for (const auto& [name, value] : model::default_bindings(*read.robot)) leaves.values[name] = model::to_double(value);
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
    EXPECT_NEAR(m[i], expected.linear()(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)), 1e-13) << text;
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRobots, testing::Range(1U, 41U));

}  // namespace
