// SPDX-License-Identifier: MIT
#include "emit/ast/angle.h"

#include <cln/integer.h>

#include "emit/ast/literal.h"

namespace qvgen::emit::ast {
namespace {

cln::cl_I common_denominator(const dag::Angle& angle) {
  cln::cl_I common = 1;
  for (const auto& [name, coefficient] : angle.terms)
    common = cln::lcm(common, cln::denominator(coefficient));
  return common;
}

}  // namespace

Expression radians(const cln::cl_RA& turns) {
  const cln::cl_RA pi = cln::cl_RA(cln::cl_I("3141592653589793238462643383279502884197")) /
                        cln::cl_RA(cln::expt_pos(cln::cl_I(10), 39));
  return real(literal(exact::Number(turns * pi)));
}

Expression angle_value(const dag::Angle& angle, const std::function<Expression(const std::string&)>& symbol) {
  const cln::cl_I common = common_denominator(angle);
  Expressions terms;
  for (const auto& [name, coefficient] : angle.terms) {
    const cln::cl_RA factor = coefficient * common;
    const cln::cl_RA size = cln::abs(factor);
    const Expression value =
        size == 1 ? symbol(name) : product({real(literal(exact::Number(size))), symbol(name)});
    terms.push_back(cln::minusp(factor) ? negative(value) : value);
  }
  if (common != 1) {
    const Expression all = terms.size() > 1 ? sum(terms) : terms.front();
    terms = {product({real(literal(exact::Number(cln::recip(cln::cl_RA(common))))), all})};
  }
  if (!cln::zerop(angle.pi)) {
    if (terms.empty()) return radians(angle.pi);
    const Expression constant = radians(cln::abs(angle.pi));
    terms.push_back(cln::minusp(angle.pi) ? negative(constant) : constant);
  }
  return terms.size() == 1 ? terms.front() : sum(terms);
}

}  // namespace qvgen::emit::ast
