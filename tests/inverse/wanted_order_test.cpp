// SPDX-License-Identifier: MIT
// Law: rows that lanes choose stand by their squares, equal ones by branch, those that do not exist behind
// them, for any number of blocks and any ties.
#include "wanted_order.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/inverse/lanes.h>

namespace {

struct Row {
  double key;
  int branch;
};

/// The branches of rows that exist, as a sort has them.
std::vector<int> sorted(const RowsInLanes& rows) {
  std::vector<Row> all;
  for (int row = 0; row < 4 * rows.blocks; ++row)
    if (rows.exist[row]) all.push_back({rows.is_sorted ? rows.squares[row] : 0, branch_of(rows, row)});
  std::sort(all.begin(), all.end(),
            [](const Row& a, const Row& b) { return a.key != b.key ? a.key < b.key : a.branch < b.branch; });
  std::vector<int> branches;
  for (const Row& row : all) branches.push_back(row.branch);
  return branches;
}

TEST(WantedRows, StandByTheirSquares) {
  if (!qvgen::inverse::machine_has_avx2()) GTEST_SKIP() << "no AVX2";
  std::mt19937_64 random(1);
  const auto share = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  for (int trial = 0; trial < 20000; ++trial) {
    double squares[64];
    bool exist[64];
    const bool has_ties = trial % 2 == 0;
    for (int row = 0; row < 64; ++row) {
      squares[row] = has_ties ? std::floor(3 * share()) : share();
      exist[row] = share() < 0.8;
    }
    const bool alternate = trial % 3 == 0;
    const int blocks = (alternate ? 2 : 1) * (1 + trial % 8);
    const RowsInLanes rows{squares, exist, blocks, alternate, trial % 5 != 0};
    std::vector<int> found(64);
    put_in_order(rows, found.data());
    const std::vector<int> expected = sorted(rows);
    found.resize(expected.size());
    ASSERT_EQ(found, expected) << "trial " << trial;
  }
}

}  // namespace
