// SPDX-License-Identifier: MIT
// Steps that turn a joint: by a line, a distance, a direction, or one equation with another joint.
#include "derive/inverse/builder.h"
#include "derive/inverse/names.h"
#include "derive/inverse/step_values.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;

std::optional<Flat> Builder::without_root(const Flat& k, const ex& rhs) const {
  const GiNaC::symbol root("root");
  for (const Root& solved : roots_) {
    const ex written = rhs.subs(named_).subs(solved.value == solved.foot + root).expand();
    if (!written.has(root)) continue;
    ex gap = (k.x * k.x + k.y * k.y - written * written).expand();
    gap = (gap + gap.coeff(root, 2) * (solved.square.subs(named_) - root * root)).expand();
    if (gap.has(root) || !gap.info(GiNaC::info_flags::rational_polynomial)) continue;
    const ex factors = GiNaC::factor(gap);
    if (!GiNaC::is_a<GiNaC::mul>(factors)) continue;
    // Two factors, and a number perhaps, in an order and with signs that no run of GiNaC changes.
    std::vector<ex> parts;
    ex number = 1;
    for (const ex& factor : factors) {
      if (GiNaC::is_a<GiNaC::numeric>(factor))
        number *= factor;
      else
        parts.push_back(factor);
    }
    if (parts.size() != 2 || GiNaC::is_a<GiNaC::power>(parts[0]) || GiNaC::is_a<GiNaC::power>(parts[1]))
      continue;
    for (ex& part : parts) {
      if (scope_.sample(part) >= 0) continue;
      part = -part;
      number = -number;
    }
    if (scope_.sample(parts[0] - parts[1]) > 0) std::swap(parts[0], parts[1]);
    return Flat{number * parts[0], parts[1]};
  }
  return std::nullopt;
}

void Builder::turn_by_line(const Screw& screw, const Flat& k, const ex& rhs, const std::string& equation,
                           int degree) {
  if (scope_.is_zero(rhs)) {
    kind::Opposite opposite;
    opposite.degree = degree;
    Step& step = add(opposite, &screw, 2, equation);
    give(step, "", {-k.y, k.x});
    step.degenerate = "the point lies on the axis: " + screw.variable + " is free";
    set_turn(step, screw, result_turn());
    return;
  }
  if (is_constant(k.x) && is_constant(k.y)) {
    const Polar amplitude = polar(k, scope_);
    Step& step = add(kind::Circle{}, &screw, 2, equation);
    step.before.output("low", amplitude.length - rhs);
    step.before.output("high", amplitude.length + rhs);
    step.before.output("scale", 1 / (2 * amplitude.length));
    step.degenerate = "boundary of reach: the two solutions coincide";
    set_turn(step, screw, result_turn() * amplitude.direction);
    return;
  }
  if (const auto factors = without_root(k, rhs)) {
    Step& step = add(kind::FactoredCircle{degree}, &screw, 2, equation);
    give(step, "", k);
    step.before.output("rhs", rhs);
    step.before.output("low", factors->x);
    step.before.output("high", factors->y);
    step.degenerate =
        "boundary of reach: the two solutions coincide; the point on the axis: " + screw.variable +
        " is free";
    set_turn(step, screw, result_turn());
    return;
  }
  Step& step = add(kind::FreeCircle{degree}, &screw, 2, equation);
  const ex amplitude = GiNaC::sqrt(k.x * k.x + k.y * k.y);
  give(step, "", k);
  step.before.output("low", amplitude - rhs);
  step.before.output("high", amplitude + rhs);
  step.degenerate =
      "boundary of reach: the two solutions coincide; the point on the axis: " + screw.variable + " is free";
  set_turn(step, screw, result_turn());
}

Ring Builder::ring(const Flat& v, const Flat& x0) const {
  const bool v_fixed = is_constant(v.x) && is_constant(v.y);
  const bool x_fixed = is_constant(x0.x) && is_constant(x0.y);
  const auto varying = [](const Flat& w) { return Polar{GiNaC::sqrt(w.x * w.x + w.y * w.y), w}; };
  const Polar base = v_fixed ? polar(v, scope_) : varying(v);
  const Polar arm = x_fixed ? polar(x0, scope_) : varying(x0);
  const ex inner =
      scope_.is_zero(base.length - arm.length) ? ex(0) : ex(GiNaC::pow(base.length - arm.length, 2));
  const ex outer =
      scope_.is_zero(base.length + arm.length) ? ex(0) : ex(GiNaC::pow(base.length + arm.length, 2));
  return {base, arm, v_fixed, x_fixed, inner, outer};
}

std::optional<Flat> Builder::straight(const Flat& v, const Flat& x0, const ex& square) const {
  const ex radius = x0.x * x0.x + x0.y * x0.y;
  // v is a constant side and one that known joints turn: without their sines and cosines the first is left.
  const auto constant_part = [&](const ex& value) {
    const ex expanded = value.expand();
    GiNaC::exmap none;
    for (auto part = expanded.preorder_begin(); part != expanded.preorder_end(); ++part)
      if (GiNaC::is_a<GiNaC::symbol>(*part) && !is_constant(*part)) none[*part] = 0;
    return expanded.subs(none);
  };
  const Flat full{v.x.subs(named_).subs(named_), v.y.subs(named_).subs(named_)};
  if (!full.x.info(GiNaC::info_flags::polynomial) || !full.y.info(GiNaC::info_flags::polynomial))
    return std::nullopt;
  const Flat side{constant_part(full.x), constant_part(full.y)}, turned{v.x - side.x, v.y - side.y};
  const ex side_square = side.x * side.x + side.y * side.y,
           turned_square = turned.x * turned.x + turned.y * turned.y;
  const auto along = [&](const Flat& x) {
    const Flat turn = x * conjugate(x0);
    return Flat{scope_.clean(-turn.x / radius), scope_.clean(-turn.y / radius)};
  };
  if (scope_.is_zero(turned_square - radius) && scope_.is_zero(side_square - square)) return along(turned);
  if (scope_.is_zero(side_square - radius) && scope_.is_zero(turned_square - square)) return along(side);
  return std::nullopt;
}

void Builder::turn_by_distance(const Screw& screw, int sign, const Flat& v, const Flat& x0, const ex& square,
                               const std::string& equation) {
  const auto [base, arm, v_fixed, x_fixed, inner, outer] = ring(v, x0);
  const ex low = outer - square;
  const ex high = square - inner;
  if (v_fixed && x_fixed) {
    Step& step = add(kind::Circle{}, &screw, 2, equation);
    step.before.output("low", low);
    step.before.output("high", high);
    step.before.output("scale", 1 / (4 * base.length * arm.length));
    step.degenerate = "stretched or folded: the two solutions coincide";
    const Flat turned = result_turn() * base.direction * conjugate(arm.direction);
    set_turn(step, screw, {turned.x, sign * turned.y});
    return;
  }
  // Unnormalised: v conj(x0), mirrored for a joint that is read backwards.
  const Flat direction = base.direction * conjugate(arm.direction);
  const auto folding = x_fixed ? straight(v, x0, square) : std::nullopt;
  if (folding) {
    Step& step = add(kind::FoldingCircle{}, &screw, 2, equation);
    give(step, "straight_", {folding->x, sign * folding->y});
    give(step, "", {direction.x, sign * direction.y});
    step.before.output("arm_square", arm.length * arm.length);
    step.degenerate =
        "a side on the other: the two solutions coincide; the point on the axis: " + screw.variable +
        " is free";
    set_turn(step, screw, result_turn());
    return;
  }
  Step& step = add(kind::FreeCircle{(v_fixed ? 0 : 1) + (x_fixed ? 0 : 1)}, &screw, 2, equation);
  give(step, "", {direction.x, sign * direction.y});
  step.before.output("low", low);
  step.before.output("high", high);
  step.degenerate =
      "stretched or folded: the two solutions coincide; the point on the axis: " + screw.variable +
      " is free";
  set_turn(step, screw, result_turn());
}

void Builder::turn_by_pair(const Screw& screw, const Flat& direction, const std::string& equation,
                           const ex& length, bool at_double_root) {
  kind::Pair pair;
  pair.length = length;
  pair.at_double_root = at_double_root;
  pair.degree = 4;
  Step& step = add(pair, &screw, 1, equation);
  give(step, "", direction);
  step.degenerate = "the point lies on the axis: " + screw.variable + " is free";
  set_turn(step, screw, result_turn());
}

Scope::Turn Builder::turn_by_pair(const std::string& name, const Flat& direction, const Scope::Turn& choice,
                                  const std::string& equation) {
  Step& step = add(kind::ChosenPair{}, nullptr, 1, equation);
  step.unknown = name;
  give(step, "", direction);
  give(step, "choice_", {choice.cosine, choice.sine});
  step.degenerate = "the directions lie along the axis: " + name + " is free";
  step.after.output(symbolic::symbol(names::cosine(name)), result_turn().x);
  step.after.output(symbolic::symbol(names::sine(name)), result_turn().y);
  return scope_.turn(name);
}

void Builder::turn_by_conic(const Screw& screw, const std::array<ex, 6>& conic, const std::string& equation) {
  Step& step = add(kind::Conic{}, &screw, 4, equation);
  const std::array<const char*, 6> names = {"xx", "xy", "yy", "x", "y", "one"};
  for (std::size_t i = 0; i < 6; ++i) step.before.output(names[i], conic[i]);
  step.degenerate = "boundary of reach: solutions coincide";
  set_turn(step, screw, result_turn());
}

Scope::Turn Builder::two_turns(const Screw& first, const std::string& second, const TwoTurns& equations,
                               bool at_most_six, const std::string& equation) {
  Step& step = add(kind::TwoTurns{at_most_six}, &first, at_most_six ? 6 : 8, equation);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 9; ++k)
      step.before.output(std::string(i == 0 ? "a_" : "b_") + std::to_string(k / 3) + std::to_string(k % 3),
                         equations[i][k]);
  step.degenerate = "dead centre: solutions coincide; both equations the same: nothing is found";
  set_turn(step, first, result_turn());
  step.after.output(symbolic::symbol(names::cosine(second)), symbolic::symbol(names::result_1));
  step.after.output(symbolic::symbol(names::sine(second)), symbolic::symbol(names::result_2));
  return scope_.turn(second);
}

}  // namespace qvgen::derive::inverse
