// SPDX-License-Identifier: MIT
#include "derive/inverse/divisors.h"

#include <algorithm>

#include "symbolic/model.h"

namespace qvgen::derive::inverse {
namespace {

bool is_circle(const Step& step) {
  return step.is<kind::Circle>() || step.is<kind::FreeCircle>() || step.is<kind::FactoredCircle>();
}

/// cos φ = (high - low) / (high + low).
bool divides_by(const Step& step, const GiNaC::symbol& symbol) {
  if (!is_circle(step)) return false;
  const GiNaC::ex divisor = step.input("low") + step.input("high");
  return divisor.has(symbol) && divisor.subs(symbol == 0).expand().is_zero();
}

}  // namespace

bool divides_by(const Plan& plan, const std::string& symbol) {
  return std::any_of(plan.steps.begin(), plan.steps.end(),
                     [&](const Step& step) { return divides_by(step, symbolic::symbol(symbol)); });
}

}  // namespace qvgen::derive::inverse
