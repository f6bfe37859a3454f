// SPDX-License-Identifier: MIT
#include "derive/inverse/held_angle.h"

#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;

namespace {

/// Sum of `change(term)` over an expanded expression's terms.
template <class Change>
ex term_by_term(const ex& expanded, const Change& change) {
  if (!GiNaC::is_a<GiNaC::add>(expanded)) return change(expanded).expand();
  ex sum = 0;
  for (const ex& term : expanded) sum += change(term);
  return sum.expand();
}

}  // namespace

HeldAngle::HeldAngle(const std::string& variable)
    : cosine(symbolic::symbol(names::cosine(variable))), sine(symbolic::symbol(names::sine(variable))) {
  const ex angle = symbolic::symbol(variable);
  cosine_value = GiNaC::cos(angle);
  sine_value = GiNaC::sin(angle);
  half_cosine_ = GiNaC::cos(angle / 2);
  half_sine_ = GiNaC::sin(angle / 2);
}

ex HeldAngle::left_out(const ex& value) const {
  return value.subs(
      GiNaC::lst{half_cosine_ == cosine, half_sine_ == sine, cosine_value == cosine, sine_value == sine});
}

ex HeldAngle::at_zero(const ex& value) const {
  return left_out(value).subs(GiNaC::lst{cosine == 1, sine == 0});
}

ex HeldAngle::in_whole_angle(const ex& expanded) const {
  const GiNaC::symbol c("half_cosine"), s("half_sine");
  const ex value =
      expanded
          .subs(GiNaC::lst{half_cosine_ == c, half_sine_ == s, cosine_value == cosine, sine_value == sine})
          .expand();
  if (!value.is_polynomial(GiNaC::lst{c, s, cosine, sine})) return expanded;
  bool even = true;
  const ex whole = term_by_term(value, [&](const ex& term) {
    const int of_cosine = term.degree(c), of_sine = term.degree(s);
    even = even && (of_cosine + of_sine) % 2 == 0;
    const ex mixed = of_sine % 2 == 0 ? ex(1) : ex(sine / 2);
    return term.coeff(c, of_cosine).coeff(s, of_sine) * mixed * GiNaC::pow((1 + cosine) / 2, of_cosine / 2) *
           GiNaC::pow((1 - cosine) / 2, of_sine / 2);
  });
  if (!even) return expanded;
  return term_by_term(whole, [&](const ex& term) {
    const int degree = term.degree(sine);
    return term.coeff(sine, degree) * GiNaC::pow(1 - cosine * cosine, degree / 2) *
           GiNaC::pow(sine, degree % 2);
  });
}

}  // namespace qvgen::derive::inverse
