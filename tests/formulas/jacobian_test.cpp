// SPDX-License-Identifier: MIT
// What `show --jacobian` prints, read as a reader would, against numeric differentiation of homogeneous
// matrices and against the matrices of the Jacobian lecture (examples 5.1 to 5.4, the wrong entries put
// right).
#include <algorithm>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "description/reader.h"
#include "emit/math/jacobian_lines.h"
#include "printed.h"
#include "reference/linear_algebra.h"
#include "reference/load.h"

namespace qvgen::test {
namespace {

using namespace reference;

/// Derived once.
const std::vector<std::string>& lines_of(const std::string& robot,
                                         emit::Notation notation = emit::Notation::text) {
  static std::map<std::pair<std::string, bool>, std::vector<std::string>> known;
  auto& lines = known[{robot, notation.typeset}];
  if (lines.empty())
    lines = emit::jacobian_lines(description::read_file(file_of(robot)).robot.value(), notation);
  return lines;
}

/// A chain at random joint values and rates, with random symbols.
struct Case {
  explicit Case(const std::string& robot) : chain(load(file_of(robot))) {
    const auto described = description::read_file(file_of(robot)).robot.value();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.2, 1.4);
    Values symbols;
    for (const model::Parameter& parameter : described.geometry) symbols[parameter.name] = uniform(random);
    chain = load(file_of(robot), symbols);
    values = symbols;
    q.resize(chain.size());
    rates.resize(chain.size());
    for (Eigen::Index i = 0; i < chain.size(); ++i) {
      const std::string& name = chain.joints[static_cast<std::size_t>(i)].variable;
      values[name] = q[i] = uniform(random);
      values[name + "_rate"] = rates[i] = uniform(random);
    }
  }
  Chain chain;
  Values values;
  VectorXd q, rates;
};

/// Angular velocity and the origin's velocity of a moving frame in its own axes, by central differences.
std::pair<Vector3d, Vector3d> velocity(const Case& at, std::size_t link) {
  constexpr double h = 1e-6;
  const Isometry3d now = frames(at.chain, at.q)[link];
  const Isometry3d after = frames(at.chain, at.q + h * at.rates)[link];
  const Isometry3d before = frames(at.chain, at.q - h * at.rates)[link];
  const Matrix3d turning = now.linear().transpose() * (after.linear() - before.linear()) / (2 * h);
  const Vector3d moving = now.linear().transpose() * (after.translation() - before.translation()) / (2 * h);
  return {{turning(2, 1), turning(0, 2), turning(1, 0)}, moving};
}

/// Constants that are no fractions (jaco2's) are printed in six digits.
void expect_near(const MatrixXd& a, const MatrixXd& b, const std::string& what, double tolerance = 1e-8) {
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), tolerance) << what << "\n" << a << "\n\n" << b;
}
double tolerance_of(const std::string& robot) { return robot == "jaco2" ? 3e-6 : 1e-8; }

class PrintedJacobian : public testing::TestWithParam<const char*> {};

TEST_P(PrintedJacobian, LinkVelocitiesAreTheDerivativesOfTheFrames) {
  const Case at(GetParam());
  const double close = tolerance_of(GetParam());
  const Printed printed(lines_of(GetParam()), at.values);
  const std::size_t links = static_cast<std::size_t>(at.chain.size());
  for (std::size_t link = 1; link <= links + 1; ++link) {
    const std::string index = std::to_string(link);
    if (link > links && !printed.has("v_" + index + "x")) break;  // no tool
    const auto [omega, v] = velocity(at, link - 1);
    expect_near(printed.vector("omega_" + index), omega, "omega_" + index, close);
    expect_near(printed.vector("v_" + index), v, "v_" + index, close);
  }
}

TEST_P(PrintedJacobian, MatrixAxesAndPointsAreThoseOfTheArm) {
  const Case at(GetParam());
  const double close = tolerance_of(GetParam());
  const Printed printed(lines_of(GetParam()), at.values);
  EXPECT_EQ(printed.has("P_x"), GetParam() != std::string("jaco2")) << "twists of 120 degrees";
  if (!printed.has("P_x")) return;
  const int columns = static_cast<int>(at.chain.size());
  const MatrixXd expected = jacobian(at.chain, at.q);
  expect_near(printed.matrix("J", 6, columns), expected, "J", close);
  const Vector3d tool = printed.vector("P");
  expect_near(tool, forward_kinematics(at.chain, at.q).translation(), "P", close);
  for (int i = 0; i < columns; ++i) {
    const std::string index = std::to_string(i + 1);
    const Vector3d z = printed.vector("z_" + index);
    if (!at.chain.joints[static_cast<std::size_t>(i)].revolute) {
      expect_near(z, expected.col(i).head<3>(), "z_" + index, close);
      continue;
    }
    expect_near(z, expected.col(i).tail<3>(), "z_" + index, close);
    expect_near(z.cross(tool - printed.vector("P_" + index)), expected.col(i).head<3>(), "column " + index,
                close);
  }
}

/// The rows that the text names: "S: the rows vx, vy of J."
std::vector<int> rows_of(const std::vector<std::string>& lines) {
  const std::vector<std::string> names{"vx", "vy", "vz", "wx", "wy", "wz"};
  std::vector<int> rows;
  for (const std::string& line : lines) {
    if (line.rfind("S: ", 0) != 0) continue;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (line.find(names[i]) != std::string::npos) rows.push_back(static_cast<int>(i));
  }
  return rows.empty() ? std::vector<int>{0, 1, 2, 3, 4, 5} : rows;
}

TEST_P(PrintedJacobian, DeterminantAndInverseAreThoseOfTheSquarePart) {
  const Case at(GetParam());
  const double close = tolerance_of(GetParam());
  const auto lines = lines_of(GetParam());
  const Printed printed(lines, at.values);
  EXPECT_EQ(printed.has("D"), at.chain.size() <= 6 && GetParam() != std::string("jaco2"));
  if (!printed.has("D")) return;
  const std::vector<int> rows = rows_of(lines);
  const int n = static_cast<int>(rows.size());
  ASSERT_EQ(n, at.chain.size());
  const MatrixXd whole = jacobian(at.chain, at.q);
  MatrixXd square(n, n);
  for (int i = 0; i < n; ++i) square.row(i) = whole.row(rows[static_cast<std::size_t>(i)]);
  EXPECT_NEAR(printed.at("D"), determinant(square), close);
  if (n > 3) return;
  expect_near(printed.matrix("K", n, n) * square, printed.at("D") * MatrixXd::Identity(n, n), "K", close);
}

INSTANTIATE_TEST_SUITE_P(Arms, PrintedJacobian,
                         testing::Values("rr_planar", "rrp", "rrr", "rpp", "planar_3r", "scara", "stanford",
                                         "puma560", "jaco2", "crx10ia", "iiwa14"),
                         [](const auto& robot) { return std::string(robot.param); });

bool contains(const std::vector<std::string>& lines, const std::string& line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

TEST(PrintedJacobian, HasTheVelocitiesOfTheLecture) {
  const auto planar = lines_of("rr_planar");  // example 5.1
  EXPECT_TRUE(contains(planar, "omega_2 = [ 0, 0, theta1' + theta2' ]"));
  EXPECT_TRUE(contains(planar, "v_2 = [ l1*sin(theta2)*theta1', l1*cos(theta2)*theta1', 0 ]"));
  EXPECT_TRUE(contains(planar, "D = l1*l2*sin(theta2)"));
  const auto spatial = lines_of("rrr");  // example 5.3
  EXPECT_TRUE(contains(
      spatial,
      "omega_3 = [ -sin(theta2 + theta3)*theta1', -cos(theta2 + theta3)*theta1', theta2' + theta3' ]"));
  EXPECT_TRUE(contains(spatial, "v_3z = l2*cos(theta2)*theta1'"));
}

/// Entry by entry, with the lecture's symbols.
void expect_matrix(const std::string& robot, const std::vector<std::vector<std::string>>& lecture) {
  const Case at(robot);
  const Printed printed(lines_of(robot), at.values);
  std::vector<std::string> lines{"L ="};
  for (const auto& row : lecture) {
    lines.emplace_back("  [");
    for (const std::string& entry : row) lines.back() += " " + entry + " ";
    lines.back() += "]";
  }
  const int columns = static_cast<int>(lecture.front().size());
  expect_near(printed.matrix("J", 6, columns), Printed(lines, at.values).matrix("L", 6, columns), robot);
}

TEST(PrintedJacobian, IsTheMatrixOfTheLecture) {
  const std::string s1 = "sin(theta1)", c1 = "cos(theta1)", s2 = "sin(theta2)", c2 = "cos(theta2)";
  const std::string s12 = "sin(theta1 + theta2)", c12 = "cos(theta1 + theta2)";
  const std::string s23 = "sin(theta2 + theta3)", c23 = "cos(theta2 + theta3)";
  expect_matrix("rr_planar", {{"-l1*" + s1 + " - l2*" + s12, "-l2*" + s12},
                              {"l1*" + c1 + " + l2*" + c12, "l2*" + c12},
                              {"0", "0"},
                              {"0", "0"},
                              {"0", "0"},
                              {"1", "1"}});
  const std::string reach = "(l2*" + c2 + " + l3*" + c23 + ")", drop = "(l2*" + s2 + " + l3*" + s23 + ")";
  expect_matrix("rrr",
                {{"-" + s1 + "*" + reach + " - d2*" + c1, "-" + c1 + "*" + drop, "-l3*" + c1 + "*" + s23},
                 {c1 + "*" + reach + " - d2*" + s1, "-" + s1 + "*" + drop, "-l3*" + s1 + "*" + s23},
                 {"0", "-l2*" + c2 + " - l3*" + c23, "-l3*" + c23},
                 {"0", "-" + s1, "-" + s1},  // printed with the other sign at the end, rightly before
                 {"0", c1, c1},
                 {"1", "0", "0"}});
  const std::string r = "(l2 + d3)";  // example 5.2
  expect_matrix(
      "rrp",
      {{s1 + "*" + s2 + "*" + r + " + d2*" + c1, "-" + c1 + "*" + c2 + "*" + r, "-" + c1 + "*" + s2},
       {"-" + c1 + "*" + s2 + "*" + r + " + d2*" + s1, "-" + s1 + "*" + c2 + "*" + r, "-" + s1 + "*" + s2},
       {"0", "-" + s2 + "*" + r, c2},
       {"0", s1, "0"},
       {"0", "-" + c1, "0"},
       {"1", "0", "0"}});
  expect_matrix("rpp", {{"-l1*" + s1 + " + d3*" + c1, "0", s1},  // example 5.4
                        {"l1*" + c1 + " + d3*" + s1, "0", "-" + c1},
                        {"0", "1", "0"},
                        {"0", "0", "0"},
                        {"0", "0", "0"},
                        {"1", "0", "0"}});
}

TEST(PrintedJacobian, SaysWhereTheMatrixIsNotWrittenOut) {
  EXPECT_TRUE(contains(lines_of("general_6r"),
                       "Some neighbouring axes are neither parallel nor perpendicular: not written out."));
}

/// Braces and environments close in the order in which they were opened.
TEST(PrintedJacobian, LatexIsBalanced) {
  for (const char* robot : {"rrr", "puma560", "scara", "general_6r"}) {
    int depth = 0;  // of aligned formulas
    for (const std::string& line : lines_of(robot, emit::Notation::latex)) {
      int braces = 0;
      for (const char c : line) ASSERT_GE(braces += c == '{' ? 1 : c == '}' ? -1 : 0, 0) << line;
      EXPECT_EQ(braces, 0) << line;
      EXPECT_EQ(std::count(line.begin(), line.end(), '$') % 2, 0) << line;
      depth += line.find("\\begin{align*}") == 0 ? 1 : 0;
      depth -= line.find("\\end{align*}") == 0 ? 1 : 0;
      ASSERT_TRUE(depth == 0 || depth == 1) << line;
    }
    EXPECT_EQ(depth, 0) << robot;
  }
}

}  // namespace
}  // namespace qvgen::test
