// SPDX-License-Identifier: MIT
#include "derive/jacobian/rates.h"

namespace qvgen::derive {

using GiNaC::ex;
using symbolic::Quaternion;
using symbolic::Vector;

std::string rate_name(const std::string& variable) { return "rate." + variable; }

Rates::Rates(symbolic::Program& program, const GiNaC::exmap& seeds) : rates_(seeds) {
  const auto steps = program.steps();  // a copy: the program grows
  for (const auto& step : steps) {
    const ex rate = program.let((*this)(step.value));
    if (!rate.is_zero()) rates_[step.name] = rate;
  }
}

ex Rates::operator()(const ex& value) const {
  GiNaC::exset symbols;
  for (auto it = value.preorder_begin(); it != value.preorder_end(); ++it)
    if (GiNaC::is_a<GiNaC::symbol>(*it)) symbols.insert(*it);
  ex sum = 0;
  for (const ex& symbol : symbols) {
    const auto rate = rates_.find(symbol);
    if (rate != rates_.end()) sum += value.diff(GiNaC::ex_to<GiNaC::symbol>(symbol)) * rate->second;
  }
  return sum;
}

Vector Rates::operator()(const Vector& v) const { return {(*this)(v.x), (*this)(v.y), (*this)(v.z)}; }

Quaternion Rates::operator()(const Quaternion& q) const {
  return {(*this)(q.w), (*this)(q.x), (*this)(q.y), (*this)(q.z)};
}

}  // namespace qvgen::derive
