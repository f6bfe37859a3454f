// SPDX-License-Identifier: MIT
#pragma once

#include "gathered.h"
#include "line.h"
#include "two_slides.h"

namespace qvgen::inverse::elimination {
namespace {

/// A(theta) = a[0] + cos a[1] + sin a[2], 6 x 9 by rows: the equations in the powers x_u^2, x_u, 1 of joint
/// 5' (slow index) times those of joint 6'.
struct Equations {
  double a[3][6 * 9 + 7];  ///< and room for a register's end
};

struct PoseSystem {
  Motion link[6];  ///< the loop's constants, the pose's among them
  Equations equations;
  Equations derived;   ///< only of pairs that are not skew
  SlideSystem slides;  ///< only of arms with two slides, in place of the equations
};

/// The constant of the loop that closes it: C6 T^-1, or T C6^-1 backwards. Lengths scaled.
inline Motion closing(const Chain& chain, const Goal& goal, bool backwards) {
  Motion g;
  const Motion& c = chain.links[5];
  const double scale = 1 / chain.size;
  const double(&first)[9] = backwards ? goal.rotation : c.rotation;
  const double(&last)[9] = backwards ? c.rotation : goal.rotation;
  multiply(first, last, false, true, g.rotation);
  const double* t = backwards ? c.translation : goal.translation;
  const double* from = backwards ? goal.translation : c.translation;
  double turned[3];
  rotate(g.rotation, t, turned);
  for (int i = 0; i < 3; ++i) g.translation[i] = (from[i] - turned[i]) * scale;
  return g;
}

/// The nine products of powers side by side, in whole registers.
template <int width>
inline constexpr int padded_products = (9 + width - 1) / width* width;

/// Rows of a table times the nine vectors, which stand side by side.
template <int width>
QVGEN_LANES void contract(const double (&table)[18][15],
                          const double (&vectors)[line_functions][padded_products<width>],
                          Equations& result) {
  constexpr int registers = padded_products<width> / width;
  for (int m = 0; m < 3; ++m)
    for (int r = 0; r < 6; ++r) {
      const double* row = table[6 * m + r];
      Lanes<width> sums[registers] = {};
#pragma GCC unroll 15
      for (int k = 0; k < line_functions; ++k)
#pragma GCC unroll 5
        for (int i = 0; i < registers; ++i) sums[i] += row[k] * load<width>(vectors[k] + width * i);
      // The next row overwrites what the last register has too much.
      for (int i = 0; i < registers; ++i) store(result.a[m] + 9 * r + width * i, sums[i]);
    }
}

/// The functions of the line that joints 6' and 5' carry, by the powers of both: functions by rows, the nine
/// products side by side.
template <int width>
QVGEN_LANES void carry_line(const Elimination& e, const Motion (&link)[6],
                            double (&vectors)[line_functions][padded_products<width>]) {
  // The powers of joint 6' in lanes; the last of four counts for nothing.
  using T = Lanes < width<4 ? width : 4>;
  constexpr int lanes = sizeof(T) / sizeof(double);
  const Motion& last = link[5];
  const double direction[3] = {last.rotation[2], last.rotation[5], last.rotation[8]};
  double line[line_functions], sixth[3][line_functions];
  line_values(last.translation, direction, line);
  powers_of(line, e.slide[5], sixth);
  for (auto& row : vectors)
    for (int i = 9; i < padded_products<width>; ++i) row[i] = 0;
  for (int first = 0; first < 3; first += lanes) {
    T side_by_side[line_functions] = {}, moved[line_functions], fifth[3][line_functions];
    for (int k = 0; k < line_functions; ++k)
      for (int i = 0; i < lanes && first + i < 3; ++i) side_by_side[k][i] = sixth[first + i][k];
    move_line(link[4].rotation, link[4].translation, side_by_side, moved);
    powers_of(moved, e.slide[4], fifth);
    for (int m = 0; m < 3; ++m) {
      T carried[line_functions];
      move_line(link[3].rotation, link[3].translation, fifth[m], carried);
      for (int k = 0; k < line_functions; ++k)
        for (int i = 0; i < lanes && first + i < 3; ++i) vectors[k][3 * m + first + i] = carried[k][i];
    }
  }
}

template <int width>
[[gnu::noinline]] void set_pose(const Elimination& e, const Chain& chain, const Goal& goal, PoseSystem& s) {
  for (int i = 0; i < 6; ++i) s.link[i] = e.link[i];
  s.link[5 - e.shift] = closing(chain, goal, e.backwards);
  if (e.pair == Pair::slides) return set_slides(e.slide, s.link, s.slides);
  alignas(64) double vectors[line_functions][padded_products<width>];
  carry_line<width>(e, s.link, vectors);
  contract<width>(e.equations, vectors, s.equations);
  if (e.pair != Pair::skew) contract<width>(e.derived, vectors, s.derived);
}

}  // namespace
}  // namespace qvgen::inverse::elimination
