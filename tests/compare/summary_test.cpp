// SPDX-License-Identifier: MIT
#include "compare/summary.h"

#include "compare/storage.h"
#include "compare/thesis_times.h"
#include "robots.h"

namespace {

using namespace qvgen;
using namespace qvgen::compare;

Row row(const char* robot, const char* formulation, Level level, double cost) {
  return {robot, formulation, "", level, {}, 0, 0, cost, 0};
}

TEST(Summary, IsTheSpreadOfRatios) {
  const std::vector<Row> rows{row("a", "pairs", Level::textbook, 2),    row("a", "dh", Level::textbook, 4),
                              row("b", "dh", Level::textbook, 2),       row("b", "pairs", Level::textbook, 3),
                              row("c", "pairs", Level::textbook, 1),    row("c", "poe", Level::textbook, 1),
                              row("d", "pairs", Level::textbook, 5),    row("d", "dh", Level::textbook, 5),
                              row("a", "pairs", Level::specialised, 1), row("a", "dh", Level::optimised, 1)};
  const auto ratios = pairs_against_matrices(rows);
  ASSERT_EQ(ratios.size(), 3U) << "c has no matrices";
  EXPECT_EQ(ratios[0].by_level.at(Level::textbook), 0.5);
  EXPECT_EQ(ratios[0].by_level.size(), 1U) << "the levels that both have";
  const auto classes = by_class(ratios, {{"a", "spherical"}, {"b", "spherical"}, {"c", "other"}});
  ASSERT_EQ(classes.size(), 1U);
  EXPECT_EQ(classes[0].robots, 2);
  const Spread spread = classes[0].by_level.at(Level::textbook);
  EXPECT_EQ(spread.least, 0.5);
  EXPECT_EQ(spread.median, 1);
  EXPECT_EQ(spread.most, 1.5);
}

/// The printed differences are those of the printed times, in falling order; one row is out of order in
/// print.
TEST(ThesisTimes, AreTranscribed) {
  ASSERT_EQ(thesis_times().size(), 16U);
  double pairs = 0, matrices = 0;
  for (const ThesisTimes& times : thesis_times()) {
    pairs += times.pairs;
    matrices += times.matrices;
    EXPECT_NO_THROW(test::committed_robot(times.robot)) << times.robot;
  }
  EXPECT_NEAR(matrices - pairs,
              13.75 + 9.094 + 9.031 + 8.969 + 8.609 + 8.546 + 2 * 8.469 + 8.36 + 8.359 + 8.297 + 8.156 +
                  7.922 + 7.547 + 7.484 + 7.078,
              1e-9)
      << "the printed column of differences";
}

TEST(Storage, CountsWhatIsNeededAtTheSameTime) {
  dag::Function f;
  dag::Graph& g = f.graph;
  const auto x = g.symbol("x"), y = g.symbol("y"), k = g.symbol("k");
  const auto a = g.product({x, y}), b = g.product({x, k}), c = g.sum({a, b}),
             d = g.product({c, g.constant(3)});
  f.outputs = {{"d", d}, {"e", g.product({d, g.product({k, k})})}};
  const auto is_free = [](const std::string& name) { return name == "k"; };
  EXPECT_EQ(most_alive(f, is_free), 3) << "a and b while their sum is made";
  EXPECT_EQ(constants_of(f, is_free), 3) << "k, k k and 3";
}

}  // namespace
