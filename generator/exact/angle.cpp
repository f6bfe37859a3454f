// SPDX-License-Identifier: MIT
#include "exact/angle.h"

#include <sstream>

#include <cln/integer.h>
#include <cln/rational_io.h>

namespace qvgen::exact {

Angle operator+(const Angle& a, const Angle& b) {
  Angle sum = a;
  for (const auto& [symbol, coefficient] : b.terms) {
    const auto [place, inserted] = sum.terms.try_emplace(symbol, coefficient);
    if (!inserted) place->second = place->second + coefficient;
    if (cln::zerop(place->second)) sum.terms.erase(place);
  }
  sum.pi = sum.pi + b.pi;
  return sum;
}

Angle operator*(const cln::cl_RA& factor, const Angle& angle) {
  Angle scaled;
  if (cln::zerop(factor)) return scaled;
  for (const auto& [symbol, coefficient] : angle.terms) scaled.terms.emplace(symbol, factor * coefficient);
  scaled.pi = factor * angle.pi;
  return scaled;
}

namespace {

void append_term(std::ostringstream& text, const cln::cl_RA& coefficient, const std::string& name) {
  const bool first = text.tellp() == 0;
  const cln::cl_RA size = cln::abs(coefficient);
  text << (cln::minusp(coefficient) ? (first ? "-" : " - ") : (first ? "" : " + "));
  if (cln::numerator(size) != 1) text << cln::numerator(size) << '*';
  text << name;
  if (cln::denominator(size) != 1) text << '/' << cln::denominator(size);
}

cln::cl_I common_denominator(const Angle& angle) {
  cln::cl_I common = cln::denominator(angle.pi);
  for (const auto& [symbol, coefficient] : angle.terms)
    common = cln::lcm(common, cln::denominator(coefficient));
  return common;
}

}  // namespace

std::string to_string(const Angle& angle) {
  const cln::cl_I common = common_denominator(angle);
  const Angle whole = cln::cl_RA(common) * angle;
  std::ostringstream text;
  for (const auto& [symbol, coefficient] : whole.terms) append_term(text, coefficient, symbol);
  if (!cln::zerop(whole.pi)) append_term(text, whole.pi, "pi");
  if (text.tellp() == 0) return "0";
  if (common == 1) return text.str();
  std::ostringstream quotient;
  const bool several = whole.terms.size() + (cln::zerop(whole.pi) ? 0 : 1) > 1;
  quotient << (several ? "(" : "") << text.str() << (several ? ")" : "") << '/' << common;
  return quotient.str();
}

}  // namespace qvgen::exact
