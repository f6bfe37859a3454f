// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/form.h"
#include "derive/jacobian/singular_causes.h"
#include "model/robot.h"

namespace qvgen::derive {

/// A factor of the Jacobian's determinant: the arm is singular where it vanishes.
struct SingularFactor {
  SingularCause cause;
  GiNaC::ex value;
  int multiplicity = 1;
};

/// determinant of the chosen rows of the Jacobian = constant * product of the factors' powers.
struct Singularities {
  std::vector<int> rows;   ///< of the Jacobian: 0 to 2 linear, 3 to 5 angular
  bool decoupled = false;  ///< spherical wrist: arm and wrist factors
  GiNaC::ex constant = 1;
  std::vector<SingularFactor> factors;
  std::string not_factored;  ///< why there are none
};

/// The factored determinant of the square part of the Jacobian: all of it for six joints, else the first rows
/// in which it is not singular everywhere (for three joints the linear ones, if they can be). No factors for
/// arms with more than six joints, with twists that are symbols or no right angles, and where the polynomials
/// would have too many terms.
Singularities singularities(const model::Robot& robot);

/// The determinant by minors of the plain Jacobian, output "determinant": what the factors' product must
/// equal.
symbolic::Program determinant_definition(const model::Robot& robot, const std::vector<int>& rows);

/// The determinant of a six-joint arm by minors of the Jacobian in a frame in the middle: for arms whose
/// determinant is not factored. Output "determinant".
symbolic::Program determinant_by_frames(const model::Robot& robot);

}  // namespace qvgen::derive
