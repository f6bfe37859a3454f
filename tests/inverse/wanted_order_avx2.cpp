// SPDX-License-Identifier: MIT
// Puts rows in order as lanes do; compiled for AVX2.
#include <cstring>

#include <qvgen/inverse/wanted_rows_avx2.h>

#include "wanted_order.h"

namespace {

using qvgen::inverse::avx2::FourRows;
using qvgen::inverse::avx2::Pack;

constexpr int dof = 6, most = 64;

FourRows<dof> block_of(const RowsInLanes& rows, int block, Pack& end) {
  FourRows<dof> result;
  const double* squares = rows.squares + 4 * block;
  const bool* exist = rows.exist + 4 * block;
  result.square = Pack(squares[0], squares[1], squares[2], squares[3]);
  result.exists = Pack(exist[0], exist[1], exist[2], exist[3]) > Pack(0.5);
  double ends[4];
  for (int lane = 0; lane < 4; ++lane) {
    const long long branch = branch_of(rows, 4 * block + lane);
    std::memcpy(ends + lane, &branch, sizeof branch);
  }
  end = Pack(ends[0], ends[1], ends[2], ends[3]);
  for (Pack& joint : result.q) joint = end;
  return result;
}

}  // namespace

void put_in_order(const RowsInLanes& rows, int* branches) {
  alignas(32) double room[qvgen::inverse::room_of_wanted(dof, most)];
  qvgen::inverse::avx2::WaitingRows<dof> waiting(room);
  for (int block = 0; block < rows.blocks; block += rows.alternate ? 2 : 1) {
    Pack end, twin_end;
    const FourRows<dof> one = block_of(rows, block, end);
    if (rows.alternate)
      waiting.add(one, end, block_of(rows, block + 1, twin_end), twin_end, rows.is_sorted);
    else
      waiting.add(one, end, rows.is_sorted);
  }
  double written[8 * most];
  waiting.write(written, 8);
  for (int row = 0; row < 4 * rows.blocks; ++row)
    std::memcpy(branches + row, written + 8 * row + dof, sizeof *branches);
}
