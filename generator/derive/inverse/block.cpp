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

}  // namespace qvgen::derive::inverse
