// SPDX-License-Identifier: MIT
// Proofs of rows in joints as proofs of rows in motors.
//
// joints = A motors. A solution that is near a row in every joint is near it in every motor, by the largest
// sum of entries of a row of the inverse of A. Motors are computed from joints; what rounding moves them is
// counted, too, and the entries of A are the doubles next to the description's.
#pragma once

#include <cmath>
#include <limits>

#include <qvgen/inverse/certified/proof.h>
#include <qvgen/inverse/motors.h>

namespace qvgen::inverse::certified {

/// Bounds of A and its inverse, entry by entry.
template <class Map>
class MotorBounds {
 public:
  static constexpr int dof = Map::dof;

  MotorBounds() {
    for (int i = 0; i < dof; ++i) {
      motors_.col(i) = Map::motors(Joints<dof>(Joints<dof>::Unit(i))).cwiseAbs();
      joints_.col(i) = Map::joints(Joints<dof>::Unit(i)).cwiseAbs();
    }
  }
  /// Returns the proof of a row of motors from that of its joints.
  [[nodiscard]] RowProof in_motors(const RowProof& of_joints, const Joints<dof>& q) const {
    if (!of_joints.proven) return of_joints;
    const double rounding = larger_than(share * (motors_ * q.cwiseAbs()).maxCoeff());
    RowProof proof;
    proof.within = larger_than(largest_sum(motors_) * of_joints.within + rounding);
    proof.alone_within = of_joints.alone_within / larger_than(largest_sum(joints_)) * (1 - share) - rounding;
    proof.proven = proof.alone_within > proof.within;
    return proof.proven ? proof : RowProof();
  }

 private:
  using Matrix = Eigen::Matrix<double, dof, dof>;
  /// Bound of all roundings of a sum of products, whose first factors are rounded themselves.
  static constexpr double share = 4 * (dof + 2) * std::numeric_limits<double>::epsilon();
  static double larger_than(double value) { return value * (1 + share); }
  static double largest_sum(const Matrix& matrix) { return matrix.rowwise().sum().maxCoeff(); }

  Matrix motors_, joints_;
};

/// Returns rows of motors with their proofs. Complete stays complete if every row is still proven.
template <class Map, int capacity>
CertifiedSolutions<Map::dof, capacity> certified_in_motors(
    const CertifiedSolutions<Map::dof, capacity>& of_joints) {
  const MotorBounds<Map> bounds;
  CertifiedSolutions<Map::dof, capacity> result = of_joints;
  result.solutions = inverse::in_motors<Map>(of_joints.solutions);
  for (int i = 0; i < of_joints.solutions.size(); ++i) {
    RowProof& row = result.rows[static_cast<std::size_t>(i)];
    const bool was_proven = row.proven;
    row = bounds.in_motors(row, of_joints.solutions[i].q);
    if (was_proven && !row.proven) result.count = Proof::undecided;
  }
  return result;
}

}  // namespace qvgen::inverse::certified
