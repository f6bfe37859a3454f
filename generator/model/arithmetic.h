// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/robot.h"

/// Building expressions for a reader that must combine entries (a table row into displacements).
///
/// Only what can be folded without any algebra is folded: numbers with numbers, zeros and ones, and terms
/// that cancel literally. So an entry that a table leaves at 0 stays a literal zero in the model.
namespace qvgen::model {

Expression add(const Expression& a, const Expression& b);
Expression negate(const Expression& a);
Expression subtract(const Expression& a, const Expression& b);
Expression multiply(const Expression& a, const Expression& b);
Expression divide(const Expression& a, const Expression& b);  ///< b is not a literal zero
Expression raise(const Expression& base, long exponent);
Expression sine(const Expression& angle);    ///< a number where the angle is a multiple of pi/2
Expression cosine(const Expression& angle);  ///< likewise

Vector3 add(const Vector3& a, const Vector3& b);
Vector3 subtract(const Vector3& a, const Vector3& b);
/// True only if all three entries are the number 0.
bool is_literal_zero(const Vector3& v);
/// +x, +y, +z (index 0, 1, 2) times the sign.
Vector3 unit_vector(std::size_t index, long sign = 1);

/// Same tree, operand by operand.
bool same(const Expression& a, const Expression& b);

/// A sum taken apart: `positive` or negated term each; a single term if the expression is no sum.
struct Term {
  bool negative = false;
  Expression value;
};
std::vector<Term> terms(const Expression& expression);
Expression sum_of(const std::vector<Term>& terms);

/// a + b*pi with rational a, b, where the expression is of this form; the exact look at an angle.
struct AngleForm {
  cln::cl_RA radians = 0;
  cln::cl_RA half_turns = 0;  ///< multiples of pi
};
std::optional<AngleForm> angle_form(const Expression& angle);

/// Rodrigues' formula; exact permutation for right angles about coordinate axes.
Vector3 rotate(const Turn& turn, const Vector3& v);
Vector3 rotate(const std::vector<Turn>& turns, const Vector3& v);
/// x -> first(second(x)).
Displacement compose(const Displacement& first, const Displacement& second);

}  // namespace qvgen::model
