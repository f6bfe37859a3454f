// SPDX-License-Identifier: MIT
#pragma once

#include "gathered.h"
#include "line.h"
#include "two_slides.h"

namespace qvgen::inverse::general {
namespace {

/// A(theta) = a[0] + cos a[1] + sin a[2], 6 x 9 by rows: the equations in the powers x_u^2, x_u, 1 of joint
/// 5' (slow index) times those of joint 6'.
struct Equations {
  double a[3][6 * 9 + 1];
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

/// Rows of a table times the nine vectors, three side by side.
inline void contract(const double (&table)[18][15], const Quad (&vectors)[3][15], Equations& result) {
  for (int m = 0; m < 3; ++m)
    for (int r = 0; r < 6; ++r) {
      const double* row = table[6 * m + r];
      Quad s0{}, s1{}, s2{};
      for (int k = 0; k < 15; ++k) {
        s0 += row[k] * vectors[0][k];
        s1 += row[k] * vectors[1][k];
        s2 += row[k] * vectors[2][k];
      }
      // Three of four lanes count: each store overwrites what the one before has written too much.
      double* place = result.a[m] + 9 * r;
      store(place, s0);
      store(place + 3, s1);
      store(place + 6, s2);
    }
}

[[gnu::noinline]] void set_pose(const Elimination& e, const Chain& chain, const Goal& goal, PoseSystem& s) {
  for (int i = 0; i < 6; ++i) s.link[i] = e.link[i];
  s.link[5 - e.shift] = closing(chain, goal, e.backwards);
  if (e.pair == Pair::slides) return set_slides(e.slide, s.link, s.slides);
  const Motion& last = s.link[5];
  const double direction[3] = {last.rotation[2], last.rotation[5], last.rotation[8]};
  double line[15], sixth[3][15];
  line_values(last.translation, direction, line);
  powers_of(line, e.slide[5], sixth);
  Quad side_by_side[15], moved[15], fifth[3][15], vectors[3][15];
  for (int k = 0; k < 15; ++k) side_by_side[k] = Quad{sixth[0][k], sixth[1][k], sixth[2][k], 0};
  move_line(s.link[4].rotation, s.link[4].translation, side_by_side, moved);
  powers_of(moved, e.slide[4], fifth);
  for (int m = 0; m < 3; ++m) move_line(s.link[3].rotation, s.link[3].translation, fifth[m], vectors[m]);
  contract(e.equations, vectors, s.equations);
  if (e.pair != Pair::skew) contract(e.derived, vectors, s.derived);
}

}  // namespace
}  // namespace qvgen::inverse::general
