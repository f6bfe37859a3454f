// SPDX-License-Identifier: MIT
// What each pass is for, on the smallest case that shows it.
#include <gtest/gtest.h>

#include "dag/counts.h"
#include "passes/pass.h"

namespace {

using namespace qvgen;
using dag::Edge;

class PassTest : public testing::Test {
 protected:
  dag::Function f;
  dag::Graph& g = f.graph;
  Edge a = g.symbol("a"), b = g.symbol("b"), c = g.symbol("c"), d = g.symbol("d");
  dag::Angle theta{{{"theta", 1}}, 0};
  Edge s = g.sine(theta), k = g.cosine(theta);

  void output(Edge edge) { f.outputs.push_back({"o" + std::to_string(f.outputs.size()), edge}); }
  static std::pair<int, int> operations(const dag::Function& function) {
    const dag::OperationCounts counts = dag::count(function);
    return {counts.multiplications, counts.additions};
  }
};

TEST_F(PassTest, FoldDropsDeadCode) {
  g.product({a, b, c, d});
  output(g.sum({a, b}));
  EXPECT_EQ(passes::fold(f).graph.size(), 3U);
}

TEST_F(PassTest, FlattenOpensSumsThatNobodyElseUses) {
  output(g.sum({a, -g.sum({b, -a})}));  // a - (b - a) = 2a - b
  EXPECT_EQ(operations(passes::flatten(f)), (std::pair{1, 1}));
  const dag::Function flat = passes::flatten(f);
  EXPECT_EQ(flat.graph.node(flat.outputs[0].value).operands.size(), 2U);
}

TEST_F(PassTest, FlattenKeepsSharedSums) {
  const Edge shared = g.sum({a, b});
  output(g.sum({shared, c}));
  output(g.product({shared, d}));
  EXPECT_EQ(operations(passes::flatten(f)), (std::pair{1, 2}));
}

TEST_F(PassTest, TrigJoinsSquares) {
  output(g.sum({g.product({a, s, s}), b, g.product({a, k, k})}));
  EXPECT_EQ(operations(passes::trig(f)), (std::pair{0, 1}));
}

TEST_F(PassTest, TrigTurnsOneMinusSquareIntoTheOtherSquare) {
  output(g.sum({g.constant(1), -g.product({s, s})}));
  EXPECT_EQ(operations(passes::trig(f)), (std::pair{1, 0}));
}

TEST_F(PassTest, FactorTakesOutTheMostFrequentFactor) {
  output(g.sum({g.product({a, b}), g.product({a, c}), g.product({a, d}), g.product({b, c})}));
  EXPECT_EQ(operations(passes::factor(f)), (std::pair{2, 3}));
}

TEST_F(PassTest, ShareFindsCommonPairs) {
  output(g.sum({a, b, c}));
  output(g.sum({a, b, d}));
  output(g.product({a, b, c}));
  output(g.product({a, b, d}));
  EXPECT_EQ(operations(passes::share(f)), (std::pair{3, 3}));
}

TEST_F(PassTest, ShareReciprocalsDividesOnceByADivisor) {
  output(g.quotient(a, c));
  output(g.quotient(-b, c));
  output(g.quotient(a, d));
  EXPECT_EQ(dag::count(f).divisions, 3);
  EXPECT_EQ(dag::count(passes::share_reciprocals(f)).divisions, 2);
}

TEST_F(PassTest, ShareSeesOppositeSigns) {
  output(g.sum({a, -b, c}));
  output(g.sum({b, -a, d}));
  EXPECT_EQ(operations(passes::share(f)), (std::pair{0, 3}));
}

TEST_F(PassTest, ShareLeavesSumAndDifferenceApart) {
  output(g.sum({a, b, c}));
  output(g.sum({a, -b, d}));
  const dag::Function shared = passes::share(f);
  for (const dag::Output& result : shared.outputs)
    EXPECT_EQ(shared.graph.node(result.value).operands.size(), 3U);
}

TEST_F(PassTest, SimplifyReachesAFixedPoint) {
  output(g.sum({g.product({a, b}), g.product({a, c}), g.product({d, s, s}), g.product({d, k, k})}));
  const dag::Function once = passes::simplify(f);
  EXPECT_EQ(operations(once), (std::pair{1, 2}));
  EXPECT_EQ(operations(passes::simplify(once)), operations(once));
}

}  // namespace
