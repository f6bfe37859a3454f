// SPDX-License-Identifier: MIT
// What `compare --time` compiles computes what the formulation does. How long it takes is no matter of tests.
#include "compare/timed_code.h"

#include <cmath>
#include <sstream>

#include "compare/comparison.h"
#include "robots.h"
#include "toolchain/build.h"
#include "toolchain/workshop.h"

namespace {

using namespace qvgen;
using namespace qvgen::compare;

/// Compiles and runs a program and reads the numbers that it prints.
std::vector<double> numbers_of(const std::string& source) {
  const toolchain::Workshop workshop;
  workshop.write("program.cpp", source);
  const auto program = workshop.folder() / "program";
  const auto built =
      toolchain::build({toolchain::cxx_compiler(), {"-O0"}, {{workshop.folder() / "program.cpp"}}}, program);
  EXPECT_TRUE(built.done) << built.said;
  std::istringstream said(toolchain::run({program.string()}).said);
  return {std::istream_iterator<double>(said), {}};
}

dag::Function everything() {
  dag::Function f;
  dag::Graph& g = f.graph;
  const auto x = g.symbol("x"), k = g.symbol("k");
  const dag::Angle angle{{{"x", cln::cl_RA(1) / 2}}, cln::cl_RA(1) / 3};
  const auto s = g.sine(angle), c = g.cosine(angle), kk = g.product({k, k, g.sine({{{"k", 1}}, 0})});
  f.outputs = {{"a", g.sum({g.product({x, s}), -g.product({c, kk}), g.constant(cln::cl_RA(-7) / 5)})},
               {"b", -g.quotient(g.root(g.sum({x, kk})), g.arctangent(x, -c))},
               {"c", kk},
               {"d", -x}};
  return f;
}

TEST(TimedCode, ComputesTheFunctionAndKeepsWhatIsFree) {
  const TimedCode code = timed_code(everything(), [](const std::string& name) { return name == "k"; });
  ASSERT_EQ(code.inputs.size(), 2U) << "x, and a number for all that is made of k";
  const double x = 0.7, kk = 2.5;
  const std::string arguments = code.inputs[0] == "x" ? "{0.7, 2.5}" : "{2.5, 0.7}";
  const auto y = numbers_of("#include <cmath>\n#include <cstdio>\n" + cpp_function(code, "f") +
                            "int main() {\n  const double x[] = " + arguments +
                            ";\n  double y[4];\n  f(x, y);\n"
                            "  for (const double v : y) std::printf(\"%.17g\\n\", v);\n}\n");
  const double angle = x / 2 + std::acos(-1.0) / 3, s = std::sin(angle), c = std::cos(angle);
  ASSERT_EQ(y.size(), 4U);
  EXPECT_NEAR(y[0], x * s - c * kk - 1.4, 1e-14);
  EXPECT_NEAR(y[1], -std::sqrt(x + kk) / std::atan2(x, -c), 1e-14);
  EXPECT_EQ(y[2], kk);
  EXPECT_EQ(y[3], -x);
}

TEST(TimedCode, GivesThreeNumbersForEachFormulation) {
  Request request;
  request.formulations = {"pairs", "dh"};
  request.levels = {Level::textbook, Level::specialised};
  request.code = true;
  std::vector<Row> rows = qvgen::compare::compare(test::committed_robot("rr_planar"), request);
  std::vector<TimedCode> codes;
  for (const Row& row : rows) codes.push_back(row.code.value());
  const auto numbers = numbers_of(timing_program(codes, 3));
  ASSERT_EQ(numbers.size(), 3 * codes.size());
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    EXPECT_GT(numbers[i], 0);
    EXPECT_LE(numbers[i + 1], numbers[i]);
    EXPECT_GE(numbers[i + 2], numbers[i]);
  }
}

TEST(TimedCode, RatiosAreToTheFastestOfTheLevel) {
  std::vector<Row> rows(3);
  rows[0].robot = rows[1].robot = rows[2].robot = "a";
  rows[2].level = Level::specialised;
  set_times(rows, {{6, 5, 7, 0}, {4, 4, 4, 0}, {3, 3, 3, 0}});
  EXPECT_EQ(rows[0].time->ratio, 1.5);
  EXPECT_EQ(rows[1].time->ratio, 1);
  EXPECT_EQ(rows[2].time->ratio, 1);
}

}  // namespace
