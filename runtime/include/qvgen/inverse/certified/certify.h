// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/certified/interval.h>
#include <qvgen/inverse/certified/proof.h>
#include <qvgen/inverse/certified/sine.h>
#include <qvgen/inverse/screw.h>
#include <qvgen/pose.h>

namespace qvgen::inverse::certified {

inline constexpr int joints = 6;

/// An arm at its zero pose: axes of length one, and its tool.
template <int dof>
struct ArmInBounds {
  Screw<Interval> joints[dof];
  Interval turn[4];  ///< w, x, y, z
  Triple<Interval> place;
};
using Arm = ArmInBounds<joints>;

/// An arm of seven joints with one that stays at a value, rad or m.
Arm without_joint(const ArmInBounds<joints + 1>& arm, int still, double value);

/// How much is done at most.
struct Effort {
  /// Boxes that the count looks at.
  int boxes = 200000;
  /// A row is proven if a solution is at most this far from it, rad or m.
  double farthest = 1e-8;
};

/// Proof that rows are all solutions, and how many boxes it took.
struct Count {
  Proof proof = Proof::undecided;
  int boxes = 0;
};

/// Certifies `count` rows, each six joint values, that are meant to solve a pose, and fills in a proof for
/// each. The rows may have any origin; nothing is proven if there are more than 64. No heap, no exceptions,
/// the same bits at every call.
Count certify(const Arm& arm, const Pose<double>& pose, const double (*rows)[joints], int count,
              const Effort& effort, RowProof* proofs);

/// Certifies a solution set. If `given` is not -1, its rows have a seventh joint at that index, which `arm`
/// lacks.
template <int dof, int capacity>
CertifiedSolutions<dof, capacity> certified_rows(const Arm& arm, const Pose<double>& pose,
                                                 const Solutions<dof, capacity>& found, int given,
                                                 const Effort& effort) {
  CertifiedSolutions<dof, capacity> result;
  result.solutions = found;
  double rows[static_cast<std::size_t>(capacity)][joints];
  for (int i = 0; i < found.size(); ++i)
    for (int k = 0, n = 0; k < dof; ++k)
      if (k != given) rows[i][n++] = found[i].q[k];
  const Count count = certify(arm, pose, rows, found.size(), effort, result.rows.data());
  result.count = count.proof;
  result.boxes = count.boxes;
  return result;
}

/// Certifies a solution set of six joints.
template <int capacity>
CertifiedSolutions<joints, capacity> certified(const Arm& arm, const Pose<double>& pose,
                                               const Solutions<joints, capacity>& found,
                                               const Effort& effort = {}) {
  return certified_rows(arm, pose, found, -1, effort);
}

/// Certifies a solution set of seven joints, whose joint with the index `given` has a value: complete means
/// all solutions with that value.
template <int capacity>
CertifiedSolutions<joints + 1, capacity> certified(const ArmInBounds<joints + 1>& arm,
                                                   const Pose<double>& pose, int given, double value,
                                                   const Solutions<joints + 1, capacity>& found,
                                                   const Effort& effort = {}) {
  return certified_rows(without_joint(arm, given, value), pose, found, given, effort);
}

}  // namespace qvgen::inverse::certified
