// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/elimination/setup.h>

// Nothing but types: files for different instruction sets exchange them.
namespace qvgen::inverse::elimination {

/// A pose as the solver works with it: in the frame of the arm's first axis.
struct Goal {
  double rotation[9];
  double translation[3];  ///< m
};

/// Joint values: cosine and sine of an angle, or a slide's length (m) and zero.
struct JointPairs {
  double cosine[joints];
  double sine[joints];
};

/// Joints from which steps may lead to a solution, if there is one.
struct Start {
  JointPairs values;
  bool leads;  ///< Newton's steps have led from here to a solution that was found before
  JointPairs solution;
};

/// Rows that eliminations have found.
struct Gathered {
  static constexpr int most_rows = 32;
  int rows = 0;
  int met = 0;                ///< of them, those that the last elimination has come to
  JointPairs row[most_rows];  ///< they reach the pose, and no two are the same
  int starts = 0;
  Start start[most_rows];
  bool has_twins = false;  ///< two candidates that were hardly told apart have led to a row each
  bool doubtful = false;   ///< there may be more
  bool loud = false;       ///< the polynomial drowns in rounding
  bool faint = false;      ///< it does, and what is looked at instead is known to few digits
  int magnified = 0;       ///< stretches that are looked at through a map

  [[gnu::always_inline]] void add_row(const JointPairs& values) {
    if (rows < most_rows)
      row[rows++] = values;
    else
      doubtful = true;
  }
  [[gnu::always_inline]] void add_start(const Start& values) {
    doubtful = true;
    if (starts < most_rows) start[starts++] = values;
  }
};

/// Part of the work that is done in lanes.
struct Pass {
  /// Eliminates once and adds what comes of it. `tolerance`: see `default_tolerance`.
  void (*eliminate)(const Chain&, const Elimination&, const Goal&, double tolerance, Gathered&);
  /// Newton's steps from so many joint values: each takes what it leads to, if that is a solution nearby.
  void (*lead)(const Chain&, const Goal&, int count, JointPairs*);
  /// At most `Gathered::most_rows` rows: angles in (-pi, pi], and lengths of slides.
  void (*put_out)(const Chain&, int rows, const JointPairs*, double (*q)[joints]);
};
/// Four numbers at a time; null if the compiler was not asked for AVX2. To be called only where the machine
/// has it.
extern const Pass* const pass_for_avx2;
/// Eight, likewise with AVX-512 (F, DQ and VL).
extern const Pass* const pass_for_avx512;
/// Two numbers at a time, everywhere.
extern const Pass* const pass_for_all;

}  // namespace qvgen::inverse::elimination
