// SPDX-License-Identifier: MIT
// Points of a plane as complex numbers (builder.h).
#include "derive/inverse/builder.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;

Flat operator*(const Flat& a, const Flat& b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
Flat conjugate(const Flat& a) { return {a.x, -a.y}; }

Polar polar(const Flat& v, const Scope& scope) {
  if (scope.is_zero(v.y)) return {v.x, {1, 0}};
  if (scope.is_zero(v.x)) return {v.y, {0, 1}};
  const ex length = GiNaC::sqrt(scope.clean(v.x * v.x + v.y * v.y));
  return {length, {v.x / length, v.y / length}};
}

}  // namespace qvgen::derive::inverse
