// SPDX-License-Identifier: MIT
#include "derive/inverse/pair_system.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::dot;
using symbolic::Vector;

namespace {

ex determinant(const PairRows& rows, const Scope& scope) {
  return scope.clean(rows[0].k.x * rows[1].k.y - rows[0].k.y * rows[1].k.x);
}

/// Names the block's values that hold the pose: multiplied out they would fill pages.
Block with_names(Builder& builder, const Block& block) {
  const auto named = [&](const std::string& what, const ex& value) {
    return builder.is_constant(value) ? value : builder.keep(what + "_" + block.screw.variable, value);
  };
  Block result = block;
  result.base = {named("base_x", block.base.x), named("base_y", block.base.y), named("base_z", block.base.z)};
  result.x0 = {named("arm_x", block.x0.x), named("arm_y", block.x0.y)};
  return result;
}

}  // namespace

std::string eliminate(Builder& builder, const Block& a, const Screw& c, const PairRows& rows) {
  const Scope& scope = builder.scope();
  const std::string& name = a.screw.variable;
  const PairRow& r = rows[0];
  const PairRow& s = rows[1];
  const ex divisor = determinant(rows, scope);
  if (scope.is_zero(divisor)) return name + " cannot be eliminated";
  // x = -K^-1 (constant + m·u)
  const auto solve = [&](const ex& e, const ex& f) {
    return Flat{(r.k.y * f - s.k.y * e) / divisor, (s.k.x * e - r.k.x * f) / divisor};
  };
  const auto named = [&](const std::string& what, const Flat& v) {
    return Flat{builder.keep(what + "_x", v.x), builder.keep(what + "_y", v.y)};
  };
  const Flat w0 = named("centre_" + name, solve(r.constant, s.constant));
  const Flat w1 = named("cosine_" + name, solve(r.m.x, s.m.x));
  const Flat w2 = named("sine_" + name, solve(r.m.y, s.m.y));
  const auto product = [](const Flat& p, const Flat& q) { return ex(p.x * q.x + p.y * q.y); };
  builder.turn_by_conic(c,
                        {product(w1, w1), 2 * product(w1, w2), product(w2, w2), 2 * product(w0, w1),
                         2 * product(w0, w2), product(w0, w0) - product(a.x0, a.x0)},
                        name + " eliminated from two equations, its point on the circle about its axis");
  const Scope::Turn u = builder.value(c);
  const Flat x{w0.x + w1.x * u.cosine + w2.x * u.sine, w0.y + w1.y * u.cosine + w2.y * u.sine};
  const Flat turn = x * conjugate(a.x0);
  builder.turn_by_pair(a.screw, {turn.x, a.sign * turn.y}, "the point that the elimination gave");
  return "";
}

PairRow same_height(const Vector& n, const Block& u, const Block& w, const Scope& scope) {
  const Block::Form other = w.form(n, scope);
  return {{scope.clean(dot(n, u.screw.first)), scope.clean(dot(n, u.screw.second))},
          scope.clean(dot(n, u.base) - other.constant),
          {-other.coefficients.x, -other.coefficients.y}};
}

PairRow same_distance(const Vector& from, const Block& u, const Block& w, const Scope& scope) {
  const Vector arm_u = scope.clean(u.base - from);
  const Vector arm_w = scope.clean(w.base - from);
  const auto square = [](const Vector& arm, const Block& of) {
    return ex(dot(arm, arm) + of.x0.x * of.x0.x + of.x0.y * of.x0.y);
  };
  const Block::Form other = w.form(ex(2) * arm_w, scope);
  return {{scope.clean(2 * dot(arm_u, u.screw.first)), scope.clean(2 * dot(arm_u, u.screw.second))},
          square(arm_u, u) - square(arm_w, w),
          {-other.coefficients.x, -other.coefficients.y}};
}

std::string eliminate_one(Builder& builder, const Block& a, const Block& c,
                          const std::function<PairRows(const Block& u, const Block& w)>& rows) {
  const auto may_vanish = [&](const PairRows& of) {
    const ex value = determinant(of, builder.scope());
    return value.is_zero() || !builder.is_constant(value);
  };
  const PairRows of_a = rows(a, c), of_c = rows(c, a);
  if (may_vanish(of_a) && !may_vanish(of_c))
    return eliminate(builder, c, a.screw, rows(c, with_names(builder, a)));
  return eliminate(builder, a, c.screw, of_a);
}

}  // namespace qvgen::derive::inverse
