// SPDX-License-Identifier: MIT
#include "derive/inverse/results.h"

#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::Program;

namespace {

class Turned {
 public:
  Turned(const Step& step, const Scope& scope)
      : scope_(scope),
        cosine_(symbolic::symbol(names::cosine(step.unknown))),
        sine_(symbolic::symbol(names::sine(step.unknown))) {
    for (const Program::Step& value : step.after.steps()) {
      if (value.name.is_equal(cosine_)) in_results_[cosine_] = value.value;
      if (value.name.is_equal(sine_)) in_results_[sine_] = value.value;
    }
  }

  /// As a number, the first result times a number and the second times a number, if it is that.
  [[nodiscard]] ex written(const ex& value) const {
    if (!value.has(cosine_) && !value.has(sine_)) return value;
    const ex expanded = value.subs(in_results_).expand();
    const ex first = symbolic::symbol(names::cosine_result);
    const ex second = symbolic::symbol(names::sine_result);
    const ex a = expanded.coeff(first, 1);
    const ex b = expanded.coeff(second, 1);
    const ex rest = (expanded - a * first - b * second).expand();
    if (!Scope::is_number(a) || !Scope::is_number(b) || rest.has(first) || rest.has(second)) return value;
    return rest + scope_.clean(a) * first + scope_.clean(b) * second;
  }

 private:
  const Scope& scope_;
  GiNaC::symbol cosine_, sine_;
  GiNaC::exmap in_results_;
};

}  // namespace

void read_results(Plan& plan, const Scope& scope) {
  for (Step& step : plan.steps) {
    if (!step.is<kind::Circle>()) continue;
    const Turned turned(step, scope);
    Program program;
    for (const Program::Step& value : step.after.steps())
      program.output(value.name, turned.written(value.value));
    step.after = program;
  }
}

}  // namespace qvgen::derive::inverse
