// SPDX-License-Identifier: MIT
// The law of every pass: outputs keep their names and exact values, and nothing depends on the order of
// construction.
#include <algorithm>

#include <gtest/gtest.h>

#include "dag/counts.h"
#include "dag/evaluate.h"
#include "dag/rebuild.h"
#include "exact/point.h"
#include "passes/pass.h"
#include "random_function.h"

namespace {

using namespace qvgen;

class EveryPass : public testing::TestWithParam<passes::Pass> {};

TEST_P(EveryPass, KeepsExactValues) {
  for (std::uint32_t seed = 1; seed <= 150; ++seed) {
    const dag::Function before = test::random_function(seed, 25);
    const dag::Function after = GetParam().run(before);
    const exact::ExactPoint point(seed);
    ASSERT_EQ(after.outputs.size(), before.outputs.size());
    for (std::size_t i = 0; i < after.outputs.size(); ++i)
      EXPECT_EQ(after.outputs[i].name, before.outputs[i].name);
    EXPECT_EQ(dag::evaluate<exact::Number>(after, point), dag::evaluate<exact::Number>(before, point))
        << "seed " << seed;
  }
}

TEST_P(EveryPass, DependsOnStructureAlone) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    const dag::Function before = test::random_function(seed, 25);
    // An equal function in a graph where everything was created in another order.
    dag::Function reordered = before;
    std::reverse(reordered.outputs.begin(), reordered.outputs.end());
    reordered = dag::rebuild(reordered);
    std::reverse(reordered.outputs.begin(), reordered.outputs.end());
    const dag::Function a = GetParam().run(before);
    const dag::Function b = GetParam().run(reordered);
    for (std::size_t i = 0; i < a.outputs.size(); ++i)
      EXPECT_EQ(a.graph.node(a.outputs[i].value).key, b.graph.node(b.outputs[i].value).key)
          << "seed " << seed;
  }
}

std::vector<passes::Pass> passes_and_reciprocals() {
  std::vector<passes::Pass> all = passes::all_passes();
  all.push_back({"share_reciprocals", passes::share_reciprocals});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Passes, EveryPass, testing::ValuesIn(passes_and_reciprocals()),
                         [](const auto& pass) { return std::string(pass.param.name); });

TEST(Simplify, KeepsExactValuesAndNeverAddsOperations) {
  for (std::uint32_t seed = 1; seed <= 150; ++seed) {
    const dag::Function before = test::random_function(seed, 25);
    const dag::Function after = passes::simplify(before);
    const exact::ExactPoint point(seed);
    EXPECT_EQ(dag::evaluate<exact::Number>(after, point), dag::evaluate<exact::Number>(before, point))
        << "seed " << seed;
    const auto total = [](const dag::OperationCounts& c) {
      return c.multiplications + c.additions + c.divisions;
    };
    EXPECT_LE(total(dag::count(after)), total(dag::count(before))) << "seed " << seed;
  }
}

}  // namespace
