// SPDX-License-Identifier: MIT
#include "derive/inverse/held_angle.h"

#include <optional>
#include <utility>

#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;

namespace {

/// A term as rest * x^first * y^second.
struct Monomial {
  ex rest;
  int first = 0;
  int second = 0;
};

/// Exponent of a factor that is a power of the symbol; 0 if it is none.
int exponent(const ex& factor, const ex& symbol) {
  if (factor.is_equal(symbol)) return 1;
  if (!GiNaC::is_a<GiNaC::power>(factor) || !factor.op(1).info(GiNaC::info_flags::posint)) return 0;
  return factor.op(0).is_equal(symbol) ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 0;
}

/// Splits powers of x and y off terms. Each factor is looked at once: GiNaC's degree and coeff go through the
/// whole term for each symbol and each power.
class Splitter {
 public:
  Splitter(const ex& x, const ex& y) : x_(x), y_(y) {}

  /// Nothing if x or y stands in the term other than as a power.
  std::optional<Monomial> operator()(const ex& term) {
    Monomial result;
    GiNaC::exvector rest;
    const bool product = GiNaC::is_a<GiNaC::mul>(term);
    for (std::size_t i = 0; i < (product ? term.nops() : 1); ++i) {
      const ex factor = product ? term.op(i) : term;
      const int first = exponent(factor, x_), second = exponent(factor, y_);
      result.first += first;
      result.second += second;
      if (first + second > 0) continue;
      if (!is_free(factor)) return std::nullopt;
      rest.push_back(factor);
    }
    result.rest = GiNaC::dynallocate<GiNaC::mul>(std::move(rest));
    return result;
  }

 private:
  /// Terms have the same roots and sums as factors: what one holds is found out once.
  bool is_free(const ex& factor) {
    if (factor.nops() == 0 || free_.count(factor) != 0) return true;
    if (factor.has(x_) || factor.has(y_)) return false;
    free_.insert(factor);
    return true;
  }

  ex x_, y_;
  GiNaC::exset free_;
};

/// Sum of `change(monomial in x and y)` over an expanded expression's terms; nothing if a term is no
/// monomial, or if `change` has nothing for one. All are added at once: one by one they take the square of
/// the time.
template <class Change>
std::optional<ex> term_by_term(const ex& expanded, const ex& x, const ex& y, const Change& change) {
  Splitter split(x, y);
  GiNaC::exvector terms;
  const bool sum = GiNaC::is_a<GiNaC::add>(expanded);
  for (std::size_t i = 0; i < (sum ? expanded.nops() : 1); ++i) {
    const auto monomial = split(sum ? expanded.op(i) : expanded);
    const std::optional<ex> changed = monomial ? change(*monomial) : std::nullopt;
    if (!changed) return std::nullopt;
    terms.push_back(changed->expand());
  }
  return ex(GiNaC::dynallocate<GiNaC::add>(std::move(terms))).expand();
}

ex put(const ex& value, const GiNaC::exmap& values) {
  return value.subs(values, GiNaC::subs_options::no_pattern);
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
  return put(value, {{half_cosine_, cosine}, {half_sine_, sine}, {cosine_value, cosine}, {sine_value, sine}});
}

ex HeldAngle::at_zero(const ex& value) const { return put(left_out(value), {{cosine, 1}, {sine, 0}}); }

ex HeldAngle::in_whole_angle(const ex& expanded) const {
  const GiNaC::symbol c("half_cosine"), s("half_sine");
  const ex value =
      put(expanded, {{half_cosine_, c}, {half_sine_, s}, {cosine_value, cosine}, {sine_value, sine}})
          .expand();
  const auto whole = term_by_term(value, c, s, [&](const Monomial& term) -> std::optional<ex> {
    if ((term.first + term.second) % 2 != 0) return std::nullopt;
    const ex mixed = term.second % 2 == 0 ? ex(1) : ex(sine / 2);
    return term.rest * mixed * GiNaC::pow((1 + cosine) / 2, term.first / 2) *
           GiNaC::pow((1 - cosine) / 2, term.second / 2);
  });
  if (!whole) return expanded;
  const auto reduced = term_by_term(*whole, cosine, sine, [&](const Monomial& term) -> std::optional<ex> {
    return term.rest * GiNaC::pow(cosine, term.first) * GiNaC::pow(1 - cosine * cosine, term.second / 2) *
           GiNaC::pow(sine, term.second % 2);
  });
  return reduced ? *reduced : expanded;
}

}  // namespace qvgen::derive::inverse
