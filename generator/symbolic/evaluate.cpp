// SPDX-License-Identifier: MIT
#include "symbolic/evaluate.h"

#include <sstream>
#include <stdexcept>

#include <cln/complex.h>

namespace qvgen::symbolic {

using exact::Number;
using GiNaC::ex;

namespace {

[[noreturn]] void refuse(const std::string& what, const ex& expression) {
  std::ostringstream text;
  text << what << ": " << expression;
  throw std::domain_error(text.str());
}

/// coefficient * symbol or coefficient * pi, added to the angle.
void add_angle_term(exact::Angle& angle, const ex& term) {
  ex base = 1;
  ex coefficient = 1;
  if (GiNaC::is_a<GiNaC::mul>(term)) {
    for (const ex& factor : term) (GiNaC::is_a<GiNaC::numeric>(factor) ? coefficient : base) *= factor;
  } else {
    base = term;
  }
  const cln::cl_RA factor = to_rational(coefficient);
  if (base.is_equal(GiNaC::Pi))
    angle = angle + exact::Angle{{}, factor};
  else if (GiNaC::is_a<GiNaC::symbol>(base))
    angle = angle + exact::Angle{{{GiNaC::ex_to<GiNaC::symbol>(base).get_name(), factor}}, 0};
  else if (!base.is_zero())
    refuse("angle is not linear in symbols and pi", base);
}

ex to_ex(const Number& number) {
  ex sum = 0;
  for (const auto& [radicand, coefficient] : number.terms())
    sum += GiNaC::numeric(coefficient) * GiNaC::sqrt(ex(GiNaC::numeric(radicand)));
  return sum;
}

/// r * sqrt(d) with rational r and d, as GiNaC writes it.
Number monomial(const ex& term) {
  Number result = 1;
  const auto multiply = [&](const ex& factor) {
    const bool is_root = GiNaC::is_a<GiNaC::power>(factor) && factor.op(1).is_equal(GiNaC::numeric(1, 2));
    result = result * (is_root ? Number::root(to_rational(factor.op(0))) : Number(to_rational(factor)));
  };
  if (GiNaC::is_a<GiNaC::mul>(term)) {
    for (const ex& factor : term) multiply(factor);
  } else {
    multiply(term);
  }
  return result;
}

Number to_number(const ex& value) {
  const ex flat = value.expand();
  if (!GiNaC::is_a<GiNaC::add>(flat)) return monomial(flat);
  Number sum;
  for (const ex& term : flat) sum = sum + monomial(term);
  return sum;
}

/// Replaces every leaf of an expression by its value.
class AtPoint : public GiNaC::map_function {
 public:
  explicit AtPoint(const exact::ExactPoint& point) : point_(point) {}

  void bind(const GiNaC::symbol& name, const ex& value) { known_[name] = value; }

  ex operator()(const ex& e) override {
    if (GiNaC::is_a<GiNaC::numeric>(e)) return e;
    if (GiNaC::is_a<GiNaC::symbol>(e)) {
      const auto place = known_.find(e);
      return place != known_.end() ? place->second
                                   : to_ex(point_.symbol(GiNaC::ex_to<GiNaC::symbol>(e).get_name()));
    }
    if (e.is_equal(GiNaC::Pi)) return to_ex(point_.symbol("pi"));
    if (GiNaC::is_the_function<GiNaC::sin_SERIAL>(e)) return to_ex(point_.sine(to_angle(e.op(0))));
    if (GiNaC::is_the_function<GiNaC::cos_SERIAL>(e)) return to_ex(point_.cosine(to_angle(e.op(0))));
    return e.map(*this);
  }

 private:
  const exact::ExactPoint& point_;
  GiNaC::exmap known_;
};

}  // namespace

cln::cl_RA to_rational(const ex& number) {
  if (!GiNaC::is_a<GiNaC::numeric>(number)) refuse("not a number", number);
  const auto& value = GiNaC::ex_to<GiNaC::numeric>(number);
  if (!value.is_rational()) refuse("not a rational number", number);
  return cln::the<cln::cl_RA>(cln::realpart(value.to_cl_N()));
}

exact::Angle to_angle(const ex& argument) {
  const ex flat = argument.expand();
  exact::Angle angle;
  if (GiNaC::is_a<GiNaC::add>(flat)) {
    for (const ex& term : flat) add_angle_term(angle, term);
  } else {
    add_angle_term(angle, flat);
  }
  return angle;
}

std::vector<Number> evaluate(const Program& program, const exact::ExactPoint& point) {
  AtPoint at(point);
  for (const auto& step : program.steps()) at.bind(step.name, to_ex(to_number(at(step.value))));
  std::vector<Number> values;
  for (const auto& output : program.outputs()) values.push_back(to_number(at(output.value)));
  return values;
}

}  // namespace qvgen::symbolic
