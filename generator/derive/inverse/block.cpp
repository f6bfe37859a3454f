// SPDX-License-Identifier: MIT
#include "derive/inverse/block.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::dot;
using symbolic::Vector;

Block block_of(const Screw& screw, int sign, const Vector& point, const Scope& scope) {
  Block block{screw, sign, point, {}};
  if (!screw.revolute) return block;
  const Vector arm = scope.clean(point - screw.point);
  block.x0 = {scope.clean(dot(screw.first, arm)), scope.clean(dot(screw.second, arm))};
  block.base = scope.clean(screw.point + dot(screw.axis, arm) * screw.axis);
  return block;
}

Block::Form Block::form(const Vector& n, const Scope& scope) const {
  Form form{scope.clean(dot(n, base)), {}};
  if (!screw.revolute) {
    form.coefficients.x = scope.clean(sign * dot(n, screw.axis));
    return form;
  }
  const ex k1 = scope.clean(dot(n, screw.first));
  const ex k2 = scope.clean(dot(n, screw.second));
  form.coefficients = {scope.clean(k1 * x0.x + k2 * x0.y), scope.clean(sign * (k2 * x0.x - k1 * x0.y))};
  return form;
}

ex Block::at_value(const Vector& n, Builder& builder) const {
  const Form f = form(n, builder.scope());
  const Scope::Turn value = builder.value(screw);
  return f.constant + f.coefficients.x * value.cosine + f.coefficients.y * value.sine;
}

bool Block::depends(const Vector& n, const Scope& scope) const {
  const Form f = form(n, scope);
  return !scope.is_zero(f.coefficients.x) || !scope.is_zero(f.coefficients.y);
}

bool Block::comes_onto(const Screw& line, const Scope& scope) const {
  if (!screw.revolute) return false;
  const Form x = form(line.first, scope), y = form(line.second, scope);
  const Flat &a = x.coefficients, &b = y.coefficients;
  const ex off_x = scope.clean(x.constant - dot(line.first, line.point));
  const ex off_y = scope.clean(y.constant - dot(line.second, line.point));
  // off + (a, b) (cos, sin) = 0
  const ex determinant = scope.clean(a.x * b.y - a.y * b.x);
  const ex cosine = scope.clean(off_y * a.y - off_x * b.y);
  const ex sine = scope.clean(off_x * b.x - off_y * a.x);
  if (!scope.is_zero(determinant))
    return scope.is_zero(cosine * cosine + sine * sine - determinant * determinant);
  // Seen from along the line the point moves to and fro.
  const double reach = scope.sample(a.x * a.x + a.y * a.y + b.x * b.x + b.y * b.y);
  const double way = scope.sample(off_x * off_x + off_y * off_y);
  return scope.is_zero(cosine) && scope.is_zero(sine) && way <= reach * (1 + 1e-9);
}

}  // namespace qvgen::derive::inverse
