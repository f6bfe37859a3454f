// SPDX-License-Identifier: MIT
#include "derive/inverse/pair_system.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;

std::string eliminate(Builder& builder, const Block& a, const Screw& c, const std::array<PairRow, 2>& rows) {
  const Scope& scope = builder.scope();
  const std::string& name = a.screw.variable;
  const PairRow& r = rows[0];
  const PairRow& s = rows[1];
  const ex determinant = scope.clean(r.k.x * s.k.y - r.k.y * s.k.x);
  if (scope.is_zero(determinant)) return name + " cannot be eliminated";
  // x = -K^-1 (constant + m·u)
  const auto solve = [&](const ex& e, const ex& f) {
    return Flat{(r.k.y * f - s.k.y * e) / determinant, (s.k.x * e - r.k.x * f) / determinant};
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

}  // namespace qvgen::derive::inverse
