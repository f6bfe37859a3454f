// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/builder.h"

namespace qvgen::derive::inverse {

/// The pose and what it means for the arm at its zero pose, T = pose * home^-1, in named values.
class Target {
 public:
  Target(Builder& builder, const symbolic::Pair& home);

  /// T x.
  [[nodiscard]] symbolic::Vector image(const symbolic::Vector& x) const;
  /// T^-1 x.
  [[nodiscard]] symbolic::Vector source(const symbolic::Vector& x) const;
  /// T's quaternion, named on first use.
  const symbolic::Quaternion& orientation() { return orientation(home_.q); }
  /// Returns the orientation for another orientation of the tool at zero, the only one that is asked for.
  const symbolic::Quaternion& orientation(const symbolic::Quaternion& home);
  /// The rotation of T, of T^-1, in the matrix's named entries.
  [[nodiscard]] symbolic::Vector direction_image(const symbolic::Vector& v) const;
  symbolic::Vector direction_source(const symbolic::Vector& v);

  [[nodiscard]] const symbolic::Pair& pose() const { return pose_; }

 private:
  Builder& builder_;
  symbolic::Pair home_;
  symbolic::Pair pose_;
  symbolic::Matrix3 matrix_;
  symbolic::Quaternion orientation_;
  bool named_ = false;
};

/// Writes a target in the unit quaternion alone: where the matrix is multiplied out, as for a quartic, every
/// further factor would be rounded once more.
void read_unit_quaternion(symbolic::Program& program);

}  // namespace qvgen::derive::inverse
