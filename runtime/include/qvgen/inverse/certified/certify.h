// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/certified/interval.h>
#include <qvgen/inverse/certified/proof.h>
#include <qvgen/inverse/certified/sine.h>
#include <qvgen/inverse/screw.h>
#include <qvgen/pose.h>

namespace qvgen::inverse::certified {

inline constexpr int joints = 6;

/// An arm with six joints at its zero pose: axes of length one, and its tool.
struct Arm {
  Screw<Interval> joints[certified::joints];
  Interval turn[4];  ///< w, x, y, z
  Triple<Interval> place;
};

/// How much is done at most.
struct Effort {
  /// Boxes that the count looks at.
  int boxes = 200000;
  /// A row is proven if a solution is at most this far from it, rad or m.
  double farthest = 1e-8;
};

/// Of `count` rows, each six joint values, that are meant to solve a pose: fills in what is proven of each of
/// them. The rows may have any origin. No heap, no exceptions, the same bits at every call.
struct Count {
  Proof proof = Proof::undecided;
  int boxes = 0;
};
Count certify(const Arm& arm, const Pose<double>& pose, const double (*rows)[joints], int count,
              const Effort& effort, RowProof* proofs);

/// The same of a solution set.
template <int capacity>
CertifiedSolutions<joints, capacity> certified(const Arm& arm, const Pose<double>& pose,
                                               const Solutions<joints, capacity>& found,
                                               const Effort& effort = {}) {
  CertifiedSolutions<joints, capacity> result;
  result.solutions = found;
  double rows[static_cast<std::size_t>(capacity)][joints];
  for (int i = 0; i < found.size(); ++i)
    for (int k = 0; k < joints; ++k) rows[i][k] = found[i].q[k];
  const Count count = certify(arm, pose, rows, found.size(), effort, result.rows.data());
  result.count = count.proof;
  result.boxes = count.boxes;
  return result;
}

}  // namespace qvgen::inverse::certified
