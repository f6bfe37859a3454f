// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/builder.h"

namespace qvgen::derive::inverse {

/// The point that one outer joint moves: base + first x1 + second x2 with (x1, x2) = Rot(sign q) x0 for a
/// revolute joint, base + sign axis q for a prismatic one. sign is -1 for joint a, which is brought to the
/// other side.
struct Block {
  Screw screw;
  int sign = 1;
  symbolic::Vector base;
  Flat x0;

  /// n·point = constant + coefficients·(cos q, sin q), or + coefficients.x * q.
  struct Form {
    GiNaC::ex constant;
    Flat coefficients;
  };
  [[nodiscard]] Form form(const symbolic::Vector& n, const Scope& scope) const;
  /// n·point at the solved value of the joint.
  [[nodiscard]] GiNaC::ex at_value(const symbolic::Vector& n, Builder& builder) const;
  [[nodiscard]] bool depends(const symbolic::Vector& n, const Scope& scope) const;
  /// True if some angle of a turn brings the point onto the axis of another joint.
  [[nodiscard]] bool comes_onto(const Screw& line, const Scope& scope) const;
};

Block block_of(const Screw& screw, int sign, const symbolic::Vector& point, const Scope& scope);

}  // namespace qvgen::derive::inverse
