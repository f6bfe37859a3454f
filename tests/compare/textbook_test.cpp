// SPDX-License-Identifier: MIT
// What a library takes is a formula of the number of joints alone.
#include "compare/measure.h"
#include "robots.h"

namespace {

using namespace qvgen;
using namespace qvgen::compare;

/// Joints along z and x in turn, so that there is no base frame in Denavit-Hartenberg's sense, each link one
/// long.
std::string arm(int turns, int slides, bool tool) {
  std::string text = "name = \"arm\"\ntitle = \"turns, then slides\"\nconvention = \"standard\"\n";
  for (int i = 0; i < turns + slides; ++i) {
    const std::string q = "q" + std::to_string(i);
    text += "[[dh]]\nvariable = \"" + q + "\"\n" + (i < turns ? "theta" : "d") + " = \"" + q +
            "\"\na = 1\nalpha = \"90 deg\"\n";
  }
  if (tool)
    text +=
        "[tool]\ntranslation = [0, \"1/2\", 0]\nturns = [{axis = [\"3/5\", 0, \"4/5\"], angle = \"40 "
        "deg\"}]\n";
  return text;
}

struct Count {
  int multiplications, additions;
};
Count operator*(int n, const Count& c) { return {n * c.multiplications, n * c.additions}; }
Count operator+(const Count& a, const Count& b) {
  return {a.multiplications + b.multiplications, a.additions + b.additions};
}

constexpr Count pair{31, 30}, matrix{36, 27}, dual{48, 40}, rodrigues{12, 10}, vector{3, 3};

/// By the definition of the algorithms: how a joint's own motion is made, and how many products there are.
Count expected(const std::string& name, int turns, int slides, bool tool) {
  const int n = turns + slides;
  const int products = n - 1 + (tool ? 1 : 0);
  // frames parallel to the world's always need a last factor here: the tool is one long, and turned
  if (name == "pairs") return turns * Count{3, 0} + slides * vector + n * pair;
  if (name == "zero_reference") return turns * rodrigues + slides * vector + n * matrix;
  if (name == "dh") return turns * Count{6, 0} + slides * Count{6, 1} + products * matrix;
  // its d is along the next axis: what lies along the first one stands alone, a slide or the way to a lone
  // joint's tool
  if (name == "pieper_roth") {
    const int first = turns == 0 || (n == 1 && tool) ? 1 : 0;
    return n * Count{6, 0} + (n - 1) * Count{3, 2} + slides * Count{0, 1} + (products + first) * matrix;
  }
  if (name == "poe") return turns * (rodrigues + Count{9, 9}) + slides * Count{3, 0} + n * matrix;
  if (name == "cpc") return 2 * n * matrix;
  if (name == "dual_quaternions")
    return turns * Count{6, 0} + slides * Count{4, 0} + n * dual + Count{19, 12};
  return {-1, -1};
}

TEST(Textbook, CountsAreTheFormula) {
  for (const auto& [turns, slides] : {std::pair{1, 0}, {2, 0}, {6, 0}, {8, 0}, {3, 2}, {0, 3}, {1, 1}})
    for (const bool tool : {false, true}) {
      const Subject subject(test::robot_of(arm(turns, slides, tool)), What::forward);
      for (const Formulation& formulation : formulations(What::forward)) {
        if (!formulation.run) continue;
        const auto counts = measure(subject, formulation, Level::textbook).counts;
        const Count formula = expected(formulation.name, turns, slides, tool);
        SCOPED_TRACE(formulation.name + " " + std::to_string(turns) + " " + std::to_string(slides) +
                     (tool ? " tool" : ""));
        EXPECT_EQ(counts.multiplications, formula.multiplications);
        EXPECT_EQ(counts.additions, formula.additions);
        EXPECT_EQ(counts.sine_cosines, turns);
        EXPECT_EQ(counts.divisions + counts.roots + counts.arctangents, 0);
      }
    }
}

/// n turns without a slide, the tool away from the last one.
TEST(Textbook, CountsOfTheJacobianAreTheFormula) {
  for (const int n : {1, 2, 3, 6, 7}) {
    const Subject subject(test::robot_of(arm(n, 0, true)), What::jacobian);
    const int before = n * (n - 1) / 2;
    const auto count = [&](const Formulation& formulation) {
      if (formulation.name == "cross_products")
        return n * rodrigues + (n - 1) * (matrix + Count{9, 6}) + Count{9, 9} + n * Count{6, 6};
      // each column: a step through every joint behind it, the way to the tool, two vectors to the base
      if (formulation.name == "propagation")
        return n * rodrigues + (n - 1) * Count{27, 18} + before * Count{24, 18} + n * Count{24, 18};
      // products of pairs before and behind each joint; five to seven quaternion products a column
      return n * Count{3, 0} + (n - 1) * pair + std::max(n - 2, 0) * pair + n * Count{91, 60} +
             (n - 1) * Count{47, 39};
    };
    for (const Formulation& formulation : formulations(What::jacobian)) {
      if (!formulation.run) continue;
      const auto counts = measure(subject, formulation, Level::textbook).counts;
      SCOPED_TRACE(formulation.name + " " + std::to_string(n));
      EXPECT_EQ(counts.multiplications, count(formulation).multiplications);
      EXPECT_EQ(counts.additions, count(formulation).additions);
      EXPECT_EQ(counts.sine_cosines, n);
    }
  }
}

/// 147 n - 66 and 120 n - 63 by matrices (of Luh, Walker and Paul's recursion, in other frames); a quaternion
/// is made with nine fewer multiplications and ten fewer additions, and a vector turned with six and nine
/// more, five a joint.
TEST(Textbook, CountsOfTheDynamicsAreTheFormula) {
  for (const int n : {1, 2, 3, 6, 7}) {
    std::string text = arm(n, 0, false);
    text.insert(text.find("[[dh]]"), "inertia = \"free\"\n");
    const Subject subject(test::robot_of(text), What::dynamics);
    const Count matrices{147 * n - 66, 120 * n - 63};
    const int turned = 1 + 5 * (n - 1);
    const Count quaternions{matrices.multiplications - 9 * n + 6 * turned,
                            matrices.additions - 10 * n + 9 * turned};
    for (const auto& [name, formula] :
         {std::pair{"newton_euler_matrices", matrices}, {"newton_euler_quaternions", quaternions}})
      for (const Formulation& formulation : formulations(What::dynamics)) {
        if (formulation.name != name) continue;
        const auto counts = measure(subject, formulation, Level::textbook).counts;
        SCOPED_TRACE(formulation.name + " " + std::to_string(n));
        EXPECT_EQ(counts.multiplications, formula.multiplications);
        EXPECT_EQ(counts.additions, formula.additions);
      }
  }
}

/// The robot's numbers never enter: any arm with as many joints takes as much.
TEST(Textbook, DoesNotKnowTheRobot) {
  const auto counts = [](const char* robot, const char* name) {
    const Subject subject(test::committed_robot(robot), What::forward);
    for (const Formulation& formulation : formulations(What::forward))
      if (formulation.name == name) return measure(subject, formulation, Level::textbook).counts;
    throw std::logic_error(name);
  };
  for (const char* name : {"poe", "cpc", "dual_quaternions"})
    EXPECT_EQ(counts("puma560", name), counts("general_6r", name)) << name;
}

/// Zeros gone, nothing more: never more than the textbook; the search never more than that.
TEST(Levels, CostLessAndLess) {
  for (const char* robot : {"ss", "puma560", "jaco2"}) {
    const Subject subject(test::committed_robot(robot), What::forward);
    for (const Formulation& formulation : formulations(What::forward)) {
      if (!formulation.run) continue;
      const double textbook = cost(measure(subject, formulation, Level::textbook).counts);
      const double specialised = cost(measure(subject, formulation, Level::specialised).counts);
      const double optimised = cost(measure(subject, formulation, Level::optimised).counts);
      EXPECT_LT(specialised, textbook) << robot << " " << formulation.name;
      EXPECT_LE(optimised, specialised) << robot << " " << formulation.name;
    }
  }
}

}  // namespace
