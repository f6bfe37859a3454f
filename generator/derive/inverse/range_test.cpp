// SPDX-License-Identifier: MIT
#include "derive/inverse/range_test.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "derive/inverse/names.h"
#include "derive/inverse/schedule.h"
#include "derive/inverse/size.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using GiNaC::exmap;
using symbolic::Program;

namespace {

GiNaC::symbol k() { return symbolic::symbol("signed_root"); }

/// Length of an expression beyond which a test takes as long as a branch.
constexpr std::size_t short_enough = 150;

/// A branching step's results by k = ±√square.
struct Signed {
  exmap results;
  ex square;
};

/// Values that earlier steps have left, by k if one of them has branched.
struct Known {
  exmap values;
  std::optional<Signed> sign;

  [[nodiscard]] ex input(const Step& step, const std::string& name) const {
    return step.input(name).subs(values);
  }
};

/// ±(x, y): k is the direction's length.
Signed opposite(const Step& step, const ex& x, const ex& y, const ex& square) {
  if (step.keeps_length()) return {{{symbolic::symbol(names::result), k()}}, square};
  return {{{symbolic::symbol(names::cosine_result), k() * x / square},
           {symbolic::symbol(names::sine_result), k() * y / square}},
          square};
}

/// cos φ = d / |(x, y)|, if low and high are |(x, y)| ∓ d: k is |(x, y)| sin φ.
std::optional<Signed> line_angle(const ex& low, const ex& high, const ex& x, const ex& y, const ex& square,
                                 const Scope& scope) {
  const ex d = scope.clean((high - low) / 2);
  if (!scope.is_zero((high + low) * (high + low) - 4 * square)) return std::nullopt;
  return Signed{{{symbolic::symbol(names::cosine_result), (d * x - k() * y) / square},
                 {symbolic::symbol(names::sine_result), (k() * x + d * y) / square}},
                square - d * d};
}

std::optional<Signed> by_sign(const Step& step, const Known& known, const Scope& scope) {
  if (step.is<kind::Root>())
    return Signed{{{symbolic::symbol(names::result), k()}}, known.input(step, "square")};
  const ex x = known.input(step, "x");
  const ex y = known.input(step, "y");
  const ex square = x * x + y * y;
  if (step.is<kind::Opposite>()) return opposite(step, x, y, square);
  if (step.is<kind::FreeCircle>())
    return line_angle(known.input(step, "low"), known.input(step, "high"), x, y, square, scope);
  return std::nullopt;
}

/// Takes over what a step leaves; whether that can be said by k. What does not depend on the sign is named.
bool take(const Step& step, Known& known, Program& program, const Scope& scope) {
  const bool solves = !step.is<kind::Linear>() && !step.is<kind::Require>();
  if (solves && known.sign) return false;
  if (solves) known.sign = by_sign(step, known, scope);
  if (solves && !known.sign) return false;
  for (const Program::Step& value : step.after.steps()) {
    ex written = value.value.subs(known.values);
    if (solves) written = written.subs(known.sign->results);
    if (written.has(k()) && nodes(written) > short_enough) return false;
    known.values[value.name] = written.has(k()) ? written.normal() : program.let(written);
  }
  return true;
}

/// middle ± √swing of the share low * scale.
void write(const Step& circle, const Known& known, Program& program) {
  const ex low = known.input(circle, "low");
  const ex scale = known.input(circle, "scale");
  const ex expanded = low.expand();
  if (scale.has(k()) || !expanded.is_polynomial(k()) || expanded.degree(k()) > 2) return;
  // Divided by a direction's length it would be as uncertain as the direction is where it is nearly free.
  if (!Scope::is_number(low.denom())) return;
  const ex square = program.let(known.sign ? known.sign->square : ex(0));
  const ex even = program.let(low.subs(k() == 0) + expanded.coeff(k(), 2) * square);
  const ex odd = scale * expanded.coeff(k(), 1);
  program.output("middle", scale * even);
  program.output("swing", odd * odd * square);
}

}  // namespace

RangeTest range_test(const Plan& plan, const Scope& scope) {
  const auto circle = std::find_if(plan.steps.begin(), plan.steps.end(),
                                   [](const Step& step) { return step.is<kind::Circle>(); });
  if (circle == plan.steps.end() || plan.quartic()) return {};
  RangeTest test{{}, circle->unknown, circle->equation};
  Known known;
  for (const Step* step : steps_behind(plan, static_cast<std::size_t>(circle - plan.steps.begin())))
    if (!take(*step, known, test.values, scope)) return {};
  write(*circle, known, test.values);
  return test;
}

}  // namespace qvgen::derive::inverse
