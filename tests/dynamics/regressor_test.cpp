// SPDX-License-Identifier: MIT
// The base parameters are as few as possible: over many motions no column of the regressor follows from the
// others.
#include "derive/dynamics/regressor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dag/evaluate.h"
#include "derive/dynamics/drive_regressor.h"
#include "description/reader.h"
#include "random_robot.h"
#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

using derive::dynamics::Regressor;

/// Random values for symbols that have none yet: one geometry stays while motions change.
class Leaves {
 public:
  Leaves(std::map<std::string, double> known, std::mt19937& random)
      : values_(std::move(known)), random_(random) {}

  double constant(const exact::Number& value) const { return value.to_double(); }
  double symbol(const std::string& name) {
    return values_.try_emplace(name, std::uniform_real_distribution(0.5, 2.0)(random_)).first->second;
  }
  double sine(const exact::Angle& angle) { return std::sin(radians(angle)); }
  double cosine(const exact::Angle& angle) { return std::cos(radians(angle)); }
  double root(double value) const { return std::sqrt(value); }
  double arctangent(double y, double x) const { return std::atan2(y, x); }

 private:
  double radians(const exact::Angle& angle) {
    double sum = exact::Number(angle.pi).to_double() * 3.14159265358979323846;
    for (const auto& [name, factor] : angle.terms) sum += exact::Number(factor).to_double() * symbol(name);
    return sum;
  }

  std::map<std::string, double> values_;
  std::mt19937& random_;
};

/// Random values of what does not move: the geometry's symbols, and the constants that are made of them.
std::map<std::string, double> geometry(const Regressor& regressor, const model::Robot& robot,
                                       std::mt19937& random) {
  std::map<std::string, double> result;
  for (const model::Parameter& parameter : robot.geometry)
    result[parameter.name] = std::uniform_real_distribution(0.5, 2.0)(random);
  result[derive::dynamics::gravity_symbol] = std::uniform_real_distribution(0.5, 2.0)(random);
  const auto& constants = regressor.formulation.constants;
  const auto values = dag::evaluate<double>(constants, Leaves(result, random));
  for (std::size_t i = 0; i < values.size(); ++i) result[constants.outputs[i].name] = values[i];
  return result;
}

/// Y at so many random motions, one below the other, all columns of length one.
Eigen::MatrixXd columns_of(const Regressor& regressor, const model::Robot& robot, int motions) {
  const auto joints = static_cast<Eigen::Index>(robot.joints.size());
  std::mt19937 random(5);
  const auto known = geometry(regressor, robot, random);
  const auto& y = regressor.formulation.function;
  const Eigen::Index columns = static_cast<Eigen::Index>(y.outputs.size()) / joints;
  Eigen::MatrixXd all(motions * joints, columns);
  for (int k = 0; k < motions; ++k) {
    const auto values = dag::evaluate<double>(y, Leaves(known, random));
    all.middleRows(k * joints, joints) = Eigen::Map<const Eigen::MatrixXd>(values.data(), joints, columns);
  }
  all.colwise().normalize();
  return all;
}

model::Robot read(const std::string& text) {
  const description::ReadResult result = description::read_text(text, "arm.toml");
  if (!result.robot) throw std::runtime_error("not read:\n" + text);
  return *result.robot;
}

void expect_independent_columns(const Regressor& regressor, const model::Robot& robot,
                                const std::string& text) {
  ASSERT_FALSE(regressor.names.empty()) << text;
  const Eigen::MatrixXd all = columns_of(regressor, robot, 30);
  EXPECT_EQ(reference::rank(all, 1e-9), all.cols()) << text;
}

void expect_independent_columns(const std::string& text) {
  const model::Robot robot = read(text);
  expect_independent_columns(derive::dynamics::regressor(robot), robot, text);
}

TEST(Regressor, OfRandomArmsHasIndependentColumns) {
  const std::uint32_t arms = std::getenv("QVGEN_TREES") == nullptr ? 20 : 120;
  for (std::uint32_t seed = 1; seed <= arms; ++seed) expect_independent_columns(random_description(seed));
}

/// While the arm turns about one direction only, slides at any angle to it leave fewer parameters.
TEST(Regressor, OfTurnsAboutOneDirectionWithSlidesHasIndependentColumns) {
  const std::string turn = "[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nlink = [\"l\", \"m\", \"1/3\"]\n";
  for (const char* slide : {"\"+z\"", "\"+x\"", "[0, \"3/5\", \"4/5\"]", "[\"2/7\", \"-3/7\", \"6/7\"]"})
    for (const char* kinds : {"RP", "PR", "RPP", "RRP", "PRPR", "RPRP", "PRRPP"}) {
      std::string text = "name = \"arm\"\ntitle = \"arm\"\n[defaults]\nl = 0.3\nm = 0.2\n";
      int number = 0;
      for (const char kind : std::string(kinds)) {
        const std::string joint =
            kind == 'R' ? turn : "[[joint]]\ntype = \"prismatic\"\naxis = " + std::string(slide) + "\n";
        text += joint + "variable = \"q" + std::to_string(++number) + "\"\n";
      }
      expect_independent_columns(text);
    }
}

/// Every drive parameter has a column, or it is said which columns show it. Columns are independent but for
/// those that are said to depend on others; these add nothing to the rank.
void expect_columns_with_drives(const std::string& text, std::size_t& dependent) {
  const model::Robot robot = read(text);
  const auto links = derive::dynamics::regressor(robot).names.size();
  const derive::dynamics::DriveRegressor found = derive::dynamics::regressor_with_drives(robot);
  const std::size_t count = found.regressor.names.size();
  EXPECT_EQ(count + found.left_out.size(), links + 4 * robot.joints.size()) << text;
  EXPECT_EQ(found.dependences.size(), found.dependent.size());
  const Eigen::MatrixXd all = columns_of(found.regressor, robot, 30);
  EXPECT_EQ(reference::rank(all, 1e-9), static_cast<Eigen::Index>(count - found.dependent.size())) << text;
  std::vector<Eigen::Index> others;
  for (std::size_t k = 0; k < count; ++k)
    if (std::find(found.dependent.begin(), found.dependent.end(), k) == found.dependent.end())
      others.push_back(static_cast<Eigen::Index>(k));
  const Eigen::MatrixXd independent = all(Eigen::all, others);
  EXPECT_EQ(reference::rank(independent, 1e-9), independent.cols()) << text;
  dependent += found.dependent.size();
}

TEST(RegressorWithDrives, OfRandomArmsHasAsManyIndependentColumnsAsItSays) {
  std::size_t dependent = 0;
  for (std::uint32_t seed = 1; seed <= 12; ++seed)
    expect_columns_with_drives(random_description(seed), dependent);
  EXPECT_GT(dependent, 0U) << "no arm has relations with lengths";
}

std::string arm_of(const std::string& joints) {
  return "name = \"arm\"\ntitle = \"arm\"\ninertia = \"free\"\n" + joints;
}

std::string joint(const std::string& type, const std::string& axis, const std::string& variable) {
  return "[[joint]]\ntype = \"" + type + "\"\naxis = \"" + axis + "\"\nvariable = \"" + variable +
         "\"\norigin = [0.1, 0.2, 0.3]\n";
}

/// Rotors of the first two axes, which are at a right angle, turn with their links (Gautier and Khalil 1990);
/// that of the third, parallel to the second, can be told apart.
TEST(RegressorWithDrives, RotorsOfTheFirstJointsArePartOfTheirLinks) {
  const model::Robot robot = read(
      arm_of(joint("revolute", "+z", "t1") + joint("revolute", "+y", "t2") + joint("revolute", "+y", "t3")));
  const auto found = derive::dynamics::regressor_with_drives(robot);
  ASSERT_EQ(found.left_out.size(), 2U);
  EXPECT_EQ(found.left_out[0].substr(0, 4), "Ia1 ");
  EXPECT_EQ(found.left_out[1].substr(0, 4), "Ia2 ");
}

/// An upright slide weighs what its offset could be: the coefficient is gravity.
TEST(RegressorWithDrives, TheOffsetOfAnUprightSlideIsPartOfItsWeight) {
  const model::Robot robot = read(arm_of(joint("prismatic", "+z", "d1")));
  const auto found = derive::dynamics::regressor_with_drives(robot);
  EXPECT_EQ(found.regressor.names, (std::vector<std::string>{"m1", "fv1", "fc1", "off1"}));
  EXPECT_EQ(found.left_out,
            (std::vector<std::string>{"Ia1 has no column of its own: it is part of m1, off1"}));
}

/// A slide that is oblique to gravity weighs what its offset could be, by a factor with the angle; its rotor
/// adds to the mass alone.
TEST(RegressorWithDrives, TheRotorOfAnObliqueSlideDependsOnItsWeightAndOffset) {
  const model::Robot robot =
      read("name = \"arm\"\ntitle = \"arm\"\ninertia = \"free\"\n[defaults]\ns = 0.6\n" +
           joint("prismatic", "+z", "d1") + "rpy = [\"s\", 0, 0]\n");
  const auto found = derive::dynamics::regressor_with_drives(robot);
  EXPECT_EQ(found.dependences,
            (std::vector<std::string>{"Ia1 depends on others by lengths or angles: on m1, off1"}));
}

}  // namespace
}  // namespace qvgen::test
