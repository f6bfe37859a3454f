// SPDX-License-Identifier: MIT
#include "exact/constant_angle.h"

#include <cctype>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/integer_io.h>
#include <cln/real.h>

#include "exact/named_constant.h"
#include "exact/trigonometry.h"

namespace qvgen::exact {
namespace {

const std::string opening = "atan2(";
constexpr unsigned long digits = 70;

cln::cl_I integer(const std::string& text, std::size_t& at) {
  const std::size_t begin = at;
  while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0) ++at;
  return begin == at ? cln::cl_I(1) : cln::cl_I(text.substr(begin, at - begin).c_str());
}

bool skip(const std::string& text, std::size_t& at, const std::string& what) {
  if (text.compare(at, what.size(), what) != 0) return false;
  at += what.size();
  return true;
}

/// The inverse of to_string: terms like -1/2*sqrt(3), -sqrt(2), 3/5.
Number parse(const std::string& text) {
  Number sum;
  for (std::size_t at = 0; at < text.size();) {
    const bool negative = skip(text, at, "-");
    skip(text, at, "+");
    cln::cl_RA coefficient = integer(text, at);
    if (skip(text, at, "/")) coefficient = coefficient / integer(text, at);
    skip(text, at, "*");
    Number term = coefficient;
    if (skip(text, at, "sqrt(")) {
      term = term * Number::root(integer(text, at));
      skip(text, at, ")");
    }
    sum = negative ? sum - term : sum + term;
  }
  return sum;
}

cln::cl_R decimal(const Number& number) {
  const cln::float_format_t format = cln::float_format(digits);
  cln::cl_R sum = 0;
  for (const auto& [radicand, coefficient] : number.terms())
    sum = sum + coefficient * cln::sqrt(cln::cl_float(radicand, format));
  return sum;
}

}  // namespace

CosineSine then(const CosineSine& a, const CosineSine& b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

CosineSine times(CosineSine base, long count) {
  if (count < 0) return times({base.cosine, -base.sine}, -count);
  CosineSine result;
  for (; count > 0; count /= 2) {
    if (count % 2 == 1) result = then(result, base);
    base = then(base, base);
  }
  return result;
}

std::optional<CosineSine> value_of(const Angle& angle) {
  const auto sine = exact_sine(angle.pi), cosine = exact_sine(angle.pi + cln::cl_RA(1) / 2);
  if (!sine || !cosine) return std::nullopt;
  CosineSine result{*cosine, *sine};
  for (const auto& [name, coefficient] : angle.terms) {
    const auto known = constant_angle(name);
    if (!known || cln::denominator(coefficient) != 1) return std::nullopt;
    result = then(result, times(*known, cln::cl_I_to_long(cln::numerator(coefficient))));
  }
  return result;
}

std::string constant_angle(const CosineSine& value) {
  return opening + to_string(value.sine) + "," + to_string(value.cosine) + ")";
}

std::optional<CosineSine> constant_angle(const std::string& name) {
  if (name.compare(0, opening.size(), opening) != 0) return std::nullopt;
  const std::size_t comma = name.find(',');
  return CosineSine{parse(name.substr(comma + 1, name.size() - comma - 2)),
                    parse(name.substr(opening.size(), comma - opening.size()))};
}

cln::cl_RA radians(const CosineSine& value) {
  return cln::rational(
      cln::cl_float(cln::atan(decimal(value.cosine), decimal(value.sine)), cln::float_format(digits)));
}

std::optional<cln::cl_RA> radians(const Angle& angle) {
  cln::cl_RA sum = angle.pi * cln::rational(cln::pi(cln::float_format(digits)));
  for (const auto& [name, coefficient] : angle.terms) {
    if (const auto named = named_value(name)) {
      sum = sum + coefficient * *named;
      continue;
    }
    const auto known = constant_angle(name);
    if (!known) return std::nullopt;
    sum = sum + coefficient * radians(*known);
  }
  return sum;
}

}  // namespace qvgen::exact
