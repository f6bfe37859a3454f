// SPDX-License-Identifier: MIT
// Rows in lanes, put in order by their squares: what wanted_order_test.cpp asks of a file that is compiled
// for AVX2, and so has no headers with functions that others use.
#pragma once

/// Rows as they come, four in a block; row 4 b + lane has its square, and exists or not.
struct RowsInLanes {
  const double* squares;
  const bool* exist;
  int blocks;
  bool alternate;  ///< two blocks have branches in turn: 0 2 4 6, 1 3 5 7; else they ascend
  bool is_sorted;  ///< by squares; else by branch
};

/// Branch of row 4 b + lane.
inline int branch_of(const RowsInLanes& rows, int row) {
  const int block = row / 4, lane = row % 4;
  return rows.alternate ? 8 * (block / 2) + 2 * lane + block % 2 : row;
}

/// Writes the branches in the order of the rows, those of rows that do not exist behind them.
void put_in_order(const RowsInLanes& rows, int* branches);
