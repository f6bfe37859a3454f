// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <qvgen/inverse/certified/tube.h>

/// Proof that no motion but some given ones follows a stretch of the tool's way: all cells of the product of
/// path and joints are accounted for.
///
/// The goal of the loop is the set of all poses of a part of the stretch. Tubes prove that each motion is one
/// there (tube.h). The covering that proves the solutions of one pose complete (proof.h) is done once for all
/// poses of the part: coefficients, derivatives and regions enclose those of every pose. Boxes that stay open
/// because the part is too long are looked at again in both its halves, and only these. So every solution at
/// every place is one of the motions'.
namespace qvgen::inverse::certified {

/// Part of some ways that follow one another: from a place of the first one, u from 0 to 1, to one of the
/// last. A place s of the stretch is the way's number and u.
struct Stretch {
  const Way* ways;
  int count;
  double from, to;
};

/// Motions that are meant to be all. Motion i has joints q[i][0] to q[i][stretch.count], rad or m: where the
/// stretch begins, where each of its ways ends, and where the stretch ends.
struct MotionTable {
  const double (*const* q)[joints];
  int count;
};

/// Finds solutions at a place of the stretch, at most 64; returns how many. Says where a motion is missing;
/// may be null.
struct OtherSolver {
  const void* context = nullptr;
  int (*solve)(const void* context, double s, double (*rows)[joints]) = nullptr;
};

/// How much is done at most.
struct CompleteEffort {
  long boxes = 400000;  ///< some five microseconds each
  long parts = 200;     ///< of the stretch
  double share = 100;   ///< boxes are halved down to that many times the width of a part's poses
};

struct Completeness {
  struct Gap {
    double from, to;
  };
  std::array<Gap, 16> gaps{};  ///< parts that are not proven, places s in rising order
  std::size_t gap_count = 0;
  bool has_other = false;  ///< a solution was found that is on none of the motions: the rest is not looked at
  double other = 0;        ///< its place
  double other_q[joints]{};
  long boxes = 0, parts = 0;

  [[nodiscard]] bool is_proven() const { return gap_count == 0; }
};

/// Proves a stretch, as far as that can be: next to singular poses it cannot. No exceptions but of the heap.
Completeness prove_complete(const Arm& arm, const Stretch& stretch, const MotionTable& motions,
                            const OtherSolver& solver = {}, const CompleteEffort& effort = {});

}  // namespace qvgen::inverse::certified
