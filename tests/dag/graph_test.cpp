// SPDX-License-Identifier: MIT
#include "dag/graph.h"

#include <gtest/gtest.h>

#include "dag/counts.h"
#include "dag/rebuild.h"

namespace {

using namespace qvgen::dag;
using qvgen::exact::Number;

class GraphTest : public testing::Test {
 protected:
  Graph g;
  Edge a = g.symbol("a"), b = g.symbol("b"), c = g.symbol("c");
  Edge zero = g.constant(0), one = g.constant(1), two = g.constant(2);
  Angle theta{{{"theta", 1}}, 0};

  OperationCounts counts(std::vector<Edge> values) {
    Function function{g, {}};
    for (std::size_t i = 0; i < values.size(); ++i)
      function.outputs.push_back({"o" + std::to_string(i), values[i]});
    return count(function);
  }
};

TEST_F(GraphTest, EqualStructureIsOneNode) {
  EXPECT_EQ(g.sum({a, b, c}), g.sum({c, a, b}));
  EXPECT_EQ(g.product({a, b}), g.product({b, a}));
  EXPECT_EQ(g.sum({a, -b}), -g.sum({b, -a}));
  EXPECT_EQ(g.product({-a, b}), -g.product({a, b}));
  EXPECT_EQ(g.product({-a, -b}), g.product({a, b}));
  EXPECT_EQ(g.quotient(-a, b), -g.quotient(a, b));
}

TEST_F(GraphTest, FoldsConstantsZeroAndOne) {
  EXPECT_EQ(g.sum({a, zero}), a);
  EXPECT_EQ(g.product({a, one}), a);
  EXPECT_EQ(g.product({a, zero}), zero);
  EXPECT_EQ(g.sum({a, -a}), zero);
  EXPECT_EQ(g.sum({a, a}), g.product({two, a}));
  EXPECT_EQ(g.sum({g.product({two, a}), g.product({g.constant(3), a})}), g.product({g.constant(5), a}));
  EXPECT_EQ(g.quotient(a, two), g.product({a, g.constant(Number(cln::cl_RA(1) / 2))}));
  EXPECT_EQ(g.quotient(a, a), one);
  EXPECT_EQ(g.root(g.constant(Number(9))), g.constant(Number(3)));
  EXPECT_EQ(g.sum({one, two}), g.constant(Number(3)));
}

TEST_F(GraphTest, ConstantsKeepTheirSignOnTheEdge) {
  EXPECT_EQ(g.constant(Number(-2)), -two);
  EXPECT_EQ(g.value_of(-two), Number(-2));
}

TEST_F(GraphTest, AnglesAreCanonical) {
  EXPECT_EQ(g.sine(Angle{{{"theta", -1}}, 0}), -g.sine(theta));
  EXPECT_EQ(g.cosine(Angle{{{"theta", -1}}, 0}), g.cosine(theta));
  EXPECT_EQ(g.sine(Angle{{{"theta", 1}}, cln::cl_RA(1) / 2}), g.cosine(theta));
  EXPECT_EQ(g.cosine(Angle{{}, 1}), -one);
}

TEST_F(GraphTest, CountsByTheRule) {
  const Edge s = g.sine(theta);
  const Edge c0 = g.cosine(theta);
  EXPECT_EQ(counts({g.product({a, b, c})}).multiplications, 2);
  EXPECT_EQ(counts({g.product({a, a})}).multiplications, 1);
  EXPECT_EQ(counts({g.sum({a, -b, c})}).additions, 2);
  EXPECT_EQ(counts({-a}), OperationCounts{});
  EXPECT_EQ(counts({g.product({s, c0})}).sine_cosines, 1);
  EXPECT_EQ(counts({g.sine(Angle{{}, cln::cl_RA(5) / 18})}), OperationCounts{});
  EXPECT_EQ(counts({g.quotient(a, b), g.root(a), g.arctangent(a, b)}), (OperationCounts{0, 0, 1, 1, 0, 1}));
  const Edge shared = g.product({a, b});
  EXPECT_EQ(counts({g.sum({shared, c}), g.sum({shared, -c})}), (OperationCounts{1, 2, 0, 0, 0, 0}));
}

TEST_F(GraphTest, RootsOfNumbersAreExactWhereTheyAreShort) {
  EXPECT_EQ(g.root(g.constant(Number(cln::cl_RA(9) / 4))), g.constant(Number(cln::cl_RA(3) / 2)));
  const cln::cl_RA rounded = cln::cl_I("12345678901234567890123456789") / cln::expt(cln::cl_I(10), 40);
  const Edge root = g.root(g.constant(Number(rounded)));
  EXPECT_EQ(counts({root}).roots, 1);
  EXPECT_EQ(root, g.root(g.constant(Number(rounded))));
}

TEST_F(GraphTest, FreeSymbolsCostNothing) {
  const Edge product = g.product({g.sum({a, b}), c});
  const Function function{g, {{"o", product}}};
  EXPECT_EQ(count(function).additions, 1);
  const OperationCounts counts = count(function, [](const std::string& name) { return name != "c"; });
  EXPECT_EQ(counts, (OperationCounts{1, 0, 0, 0, 0, 0}));
}

TEST_F(GraphTest, RebuildDropsDeadCode) {
  g.product({a, b, c});
  const Edge sum = g.sum({a, b});
  const Function small = rebuild({g, {{"o", sum}}});
  EXPECT_EQ(small.graph.size(), 3U);
  EXPECT_EQ(count(small).additions, 1);
}

}  // namespace
