// SPDX-License-Identifier: MIT
#include "derive/inverse/sample_point.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

/// A symbol without a value.
struct Unknown {};

}  // namespace

void SamplePoint::set(const ex& symbol, const ex& value) {
  const bool is_new = symbols_.insert({symbol, value}).second;
  if (is_new) return;
  symbols_[symbol] = value;
  functions_.clear();
}

std::optional<numeric> SamplePoint::value(const ex& expression) const {
  try {
    return compute(expression);
  } catch (const Unknown&) {
    return std::nullopt;
  }
}

/// Term by term, without expressions in between: GiNaC's own substitution makes a new one at every level.
numeric SamplePoint::compute(const ex& expression) const {
  if (GiNaC::is_a<numeric>(expression)) return GiNaC::ex_to<numeric>(expression);
  if (GiNaC::is_a<GiNaC::symbol>(expression)) {
    const auto known = symbols_.find(expression);
    if (known == symbols_.end()) throw Unknown();
    return GiNaC::ex_to<numeric>(known->second);
  }
  if (GiNaC::is_a<GiNaC::add>(expression)) {
    numeric sum = 0;
    for (const ex& term : expression) sum = sum.add(compute(term));
    return sum;
  }
  if (GiNaC::is_a<GiNaC::mul>(expression)) {
    numeric product = 1;
    for (const ex& factor : expression) product = product.mul(compute(factor));
    return product;
  }
  if (GiNaC::is_a<GiNaC::power>(expression) && expression.op(1).info(GiNaC::info_flags::integer))
    return compute(expression.op(0)).power(GiNaC::ex_to<numeric>(expression.op(1)));
  return compute_once(expression);
}

/// Roots, functions and constants.
numeric SamplePoint::compute_once(const ex& expression) const {
  const auto known = functions_.find(expression);
  if (known != functions_.end()) return GiNaC::ex_to<numeric>(known->second);
  GiNaC::exmap operands;
  for (const ex& operand : expression) operands[operand] = compute(operand);
  const ex result = expression.subs(operands, GiNaC::subs_options::no_pattern).evalf();
  if (!GiNaC::is_a<numeric>(result)) throw Unknown();
  functions_[expression] = result;
  return GiNaC::ex_to<numeric>(result);
}

}  // namespace qvgen::derive::inverse
