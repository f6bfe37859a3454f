// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "emit/math/notation.h"
#include "model/robot.h"

namespace qvgen::emit {

using VectorText = std::array<std::string, 3>;

/// The Jacobian in the base frame at the tool point, and what two of the lecture's methods derive it from.
/// Formulas in the description's names.
struct JacobianFormulas {
  struct Joint {
    bool turns = true;
    VectorText axis;   ///< in the base frame
    VectorText point;  ///< on it; of a joint that turns
  };
  std::vector<Joint> joints;
  VectorText tool;
  std::vector<std::array<std::string, 6>> columns;  ///< velocity, angular velocity
};

/// Cross products of axes, and derivatives of the position and of the quaternion, both certified: each is the
/// Jacobian by differentiation of the plain product of the joints' pairs. No columns where a constant
/// rotation is by a symbolic angle.
JacobianFormulas jacobian_formulas(const model::Robot& described, Notation notation);

/// The determinant of the part of the Jacobian that is square, and the inverse of one of up to three rows.
struct SquarePart {
  std::vector<std::string> rows;  ///< "vx", ...; none: `missing` says why
  std::string determinant;
  std::vector<std::vector<std::string>> adjugate;  ///< inverse * determinant; empty for more than three rows
  std::string missing;
};
/// Certified: the determinant against that of the plain Jacobian, the adjugate times the Jacobian against it.
SquarePart square_part(const model::Robot& described, Notation notation);

}  // namespace qvgen::emit
