// SPDX-License-Identifier: MIT
#include "derive/inverse/builder.h"

#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;

Builder::Builder(const model::Robot& robot, Scope& scope, Plan& plan, const std::string& held)
    : scope_(scope), plan_(plan) {
  for (const auto& parameter : robot.geometry)
    if (parameter.name != held) constants_.insert(symbolic::symbol(parameter.name));
  for (const auto& step : plan.target.steps())
    if (is_constant(step.value)) constants_.insert(step.name);
  plan_.joints.resize(robot.joints.size());
  scope_.turn(names::result);
  for (const char* name : {names::result, names::result_1, names::result_2}) scope_.length(name);
}

bool Builder::is_constant(const ex& value) const {
  if (GiNaC::is_a<GiNaC::symbol>(value)) return constants_.count(value) > 0;
  for (std::size_t i = 0; i < value.nops(); ++i)
    if (!is_constant(value.op(i))) return false;
  return true;
}

Step& Builder::add(Kind kind, const Screw* screw, int branches, const std::string& equation) {
  Step step;
  step.kind = std::move(kind);
  step.branches = branches;
  step.equation = equation;
  if (screw != nullptr) {
    step.joint = screw->joint;
    step.unknown = screw->variable;
    auto& value = plan_.joints[static_cast<std::size_t>(screw->joint)];
    value.revolute = screw->revolute;
    value.cosine = screw->revolute ? names::cosine(screw->variable) : screw->variable;
    value.sine = screw->revolute ? names::sine(screw->variable) : "";
    if (screw->revolute)
      scope_.turn(screw->variable);
    else
      scope_.length(screw->variable);
  }
  plan_.steps.push_back(std::move(step));
  return plan_.steps.back();
}

Scope::Turn Builder::value(const Screw& screw) {
  if (screw.joint < 0) return {scope_.held()->cosine, scope_.held()->sine};
  const JointValue& value = plan_.joints[static_cast<std::size_t>(screw.joint)];
  return {symbolic::symbol(value.cosine), value.revolute ? ex(symbolic::symbol(value.sine)) : ex(0)};
}

ex Builder::without_foot(const ex& value) const {
  if (roots_.empty() || plan_.steps.empty() ||
      symbolic::symbol(plan_.steps.back().unknown) != roots_.back().value)
    return value;
  if (GiNaC::is_a<GiNaC::symbol>(value) || roots_.back().foot.is_zero()) return value;
  return value.subs(roots_.back().value == roots_.back().foot + symbolic::symbol(names::result)).expand();
}

ex Builder::keep(const std::string& name, const ex& wanted) {
  symbolic::Program& program =
      plan_.steps.empty() || is_constant(wanted) ? plan_.target : plan_.steps.back().after;
  const ex value = without_foot(wanted);
  const ex symbol =
      value.is_equal(wanted) ? scope_.define(program, name, wanted) : scope_.rename(program, name, value);
  if (!symbol.is_equal(wanted)) named_[symbol] = wanted;
  return symbol;
}

void Builder::set_turn(Step& step, const Screw& screw, const Flat& v) {
  step.after.output(symbolic::symbol(names::cosine(screw.variable)), v.x);
  step.after.output(symbolic::symbol(names::sine(screw.variable)), v.y);
}

void Builder::set_length(Step& step, const Screw& screw, const ex& value) {
  step.after.output(symbolic::symbol(screw.variable), value);
}

namespace {

/// A pair among a step's inputs: "point_" names point_x and point_y, "" x and y.
void give(Step& step, const std::string& name, const Flat& v) {
  step.before.output(name + "x", v.x);
  step.before.output(name + "y", v.y);
}

Flat result_turn() { return {symbolic::symbol(names::cosine_result), symbolic::symbol(names::sine_result)}; }
ex result_length() { return symbolic::symbol(names::result); }

}  // namespace

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

void Builder::slide_by_root(const Screw& screw, const ex& foot, const ex& square, const ex& height_square,
                            const std::string& equation) {
  Step& step = add(kind::Root{}, &screw, 2, equation);
  step.before.output("square", square - height_square);
  step.before.output("scale", height_square);
  step.degenerate = "the point at the foot of the perpendicular: the two solutions coincide";
  set_length(step, screw, foot + result_length());
  roots_.push_back({symbolic::symbol(screw.variable), foot, square - height_square});
}

ex Builder::root(const std::string& name, const ex& square, const ex& height_square,
                 const std::string& equation) {
  Step& step = add(kind::Root{}, nullptr, 2, equation);
  step.unknown = name;
  step.before.output("square", square - height_square);
  step.before.output("scale", height_square);
  step.degenerate = "the two solutions coincide";
  const ex length = scope_.length(name);
  step.after.output(symbolic::symbol(name), result_length());
  return length;
}

void Builder::slide_by_value(const Screw& screw, const ex& value, const std::string& equation) {
  set_length(add(kind::Linear{}, &screw, 1, equation), screw, value);
}

void Builder::slide_by_line(const Screw& screw, const Flat& along, const Flat& rhs,
                            const std::optional<Reach>& reach, const std::string& equation) {
  const bool flat = !along.y.is_zero();
  if (!flat && is_constant(along.x)) return slide_by_value(screw, rhs.x / along.x, equation);
  kind::Line line{flat};
  using Reached = kind::Line::Reach;
  if (reach) line.reach = reach->outer ? Reached::between : Reached::beyond;
  Step& step = add(line, &screw, 1, equation);
  if (flat) {
    give(step, "", along);
    give(step, "rhs_", rhs);
  } else {
    step.before.output("divisor", along.x);
    step.before.output("rhs", rhs.x);
  }
  if (reach) {
    give(step, "point_", reach->point);
    give(step, "along_", reach->along);
    step.before.output("inner", reach->inner);
    if (reach->outer) step.before.output("outer", *reach->outer);
  }
  step.degenerate = std::string(flat ? "(x, y)" : "divisor") + " = 0, the equation does not see " +
                    screw.variable + ": it is free" +
                    (reach ? " as far as the joint after it can follow" : "");
  set_length(step, screw, result_length());
}

void Builder::slide_beside(const Screw& screw, const Flat& along, const Flat& other, const Flat& rhs,
                           const std::string& equation) {
  Step& step = add(kind::Beside{}, &screw, 1, equation);
  give(step, "", along);
  give(step, "other_", other);
  give(step, "rhs_", rhs);
  step.degenerate = "(x, y) along (other_x, other_y): " + screw.variable + " is free";
  set_length(step, screw, result_length());
}

void Builder::two_slides(const Screw& s, const Screw& t, const Slides& slides, const std::string& equation) {
  const bool equally_inclined = scope_.is_zero(slides.a * slides.a - slides.b * slides.b);
  Step& step = add(kind::Slides{}, &s, equally_inclined ? 1 : 2, equation);
  step.before.output("a", slides.a);
  step.before.output("b", slides.b);
  step.before.output("k", slides.k);
  step.before.output("g", slides.g);
  step.before.output("f", slides.f);
  step.before.output("gap", slides.gap);
  step.degenerate =
      "boundary of reach: the two solutions coincide; a = b or a = -b: one of them is infinitely far away; a "
      "= b = 0: " +
      s.variable + " is free as far as " + t.variable + " can follow";
  set_length(step, s, symbolic::symbol(names::result_1));
  const ex other = scope_.rename(step.after, "offset_" + t.variable, symbolic::symbol(names::result_2));
  slide_by_value(t, other, "the same two equations");
}

void Builder::turn_by_conic(const Screw& screw, const std::array<ex, 6>& conic, const std::string& equation) {
  Step& step = add(kind::Conic{}, &screw, 4, equation);
  const std::array<const char*, 6> names = {"xx", "xy", "yy", "x", "y", "one"};
  for (std::size_t i = 0; i < 6; ++i) step.before.output(names[i], conic[i]);
  step.degenerate = "boundary of reach: solutions coincide";
  set_turn(step, screw, result_turn());
}

void Builder::slide_and_turn(const Screw& slide, const Screw& turn, const SlideAndTurn& equations,
                             const std::string& equation) {
  Step& step = add(kind::SlideTurn{slide.joint}, &turn, 4, equation);
  step.before.output("divisor", equations.divisor);
  step.before.output("h", equations.h);
  step.before.output("level", equations.level);
  give(step, "l_", equations.l);
  step.before.output("mean", equations.mean);
  give(step, "m_", equations.m);
  step.degenerate =
      "boundary of reach: solutions coincide; divisor = 0 and (l_x, l_y) = 0: " + slide.variable +
      " is free as far as " + turn.variable + " can follow";
  set_turn(step, turn, result_turn());
  const ex offset = scope_.rename(step.after, "offset_" + slide.variable, result_length());
  slide_by_value(slide, offset, "the same two equations");
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

Scope::Turn Builder::reachable(const std::string& name, const std::vector<kind::Reach::Seed>& seeds,
                               const Flat& point, const Flat& offset, const ex& inner, const ex& outer) {
  Step& step = add(kind::Reach{seeds}, nullptr, 1, "the distance that the two links between leave open");
  step.unknown = name;
  give(step, "point_", point);
  give(step, "offset_", offset);
  step.before.output("inner", inner);
  step.before.output("outer", outer);
  step.after.output(symbolic::symbol(names::cosine(name)), symbolic::symbol(names::cosine_result));
  step.after.output(symbolic::symbol(names::sine(name)), symbolic::symbol(names::sine_result));
  return scope_.turn(name);
}

void Builder::require_zero(const ex& residual, const ex& scale, const std::string& equation) {
  Step& step = add(kind::Require{}, nullptr, 1, equation);
  step.before.output("residual", residual);
  step.before.output("scale", scale);
}

void Builder::polish(const std::vector<Screw>& arm, const std::vector<symbolic::Vector>& start,
                     const std::vector<symbolic::Vector>& goal) {
  kind::Newton newton{{}, static_cast<int>(start.size())};
  for (const Screw& screw : arm) newton.variables.push_back(screw.variable);
  Step& step = add(newton, nullptr, 1,
                   "Newton steps: near a singular place, and after a quartic, closed forms lose digits");
  step.unknown = "arm";
  const auto input = [&](const std::string& name, std::size_t i, const symbolic::Vector& v) {
    const std::string full = name + std::to_string(i + 1);
    step.before.output(full + "_x", v.x);
    step.before.output(full + "_y", v.y);
    step.before.output(full + "_z", v.z);
  };
  for (std::size_t i = 0; i < arm.size(); ++i) {
    input("axis", i, arm[i].axis);
    input("point", i, arm[i].revolute ? arm[i].point : symbolic::Vector{0, 0, 0});
  }
  for (std::size_t i = 0; i < start.size(); ++i) {
    input("start", i, start[i]);
    input("goal", i, goal[i]);
  }
}

Scope::Turn Builder::half(const std::string& name, const ex& cosine, const ex& sine) {
  Step& step = add(kind::Half{}, nullptr, 1, "half angle of " + name);
  step.unknown = name;
  step.before.output("cosine", cosine);
  step.before.output("sine", sine);
  step.after.output(symbolic::symbol(names::cosine(names::half(name))),
                    symbolic::symbol(names::cosine_result));
  step.after.output(symbolic::symbol(names::sine(names::half(name))), symbolic::symbol(names::sine_result));
  return scope_.turn(names::half(name));
}

}  // namespace qvgen::derive::inverse
