// SPDX-License-Identifier: MIT
#include "exact/number.h"

#include <iterator>
#include <sstream>
#include <stdexcept>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/integer_io.h>
#include <cln/lfloat.h>
#include <cln/rational_io.h>
#include <cln/real.h>
#include <cln/real_io.h>

namespace qvgen::exact {
namespace {

using Terms = Number::Terms;

struct Square {
  cln::cl_I root;  ///< largest found integer whose square divides the number
  cln::cl_I free;  ///< squarefree rest
};

/// n = root^2 * free for n > 0, by trial division: radicands of robot descriptions are small.
Square split_square(cln::cl_I n) {
  constexpr unsigned long largest_trial = 1UL << 16;
  cln::cl_I root = 1;
  cln::cl_I free = 1;
  for (unsigned long p = 2; p < largest_trial && cln::square(cln::cl_I(p)) <= n; ++p) {
    while (cln::mod(n, p) == 0) {
      n = cln::exquo(n, p);
      if (cln::mod(n, p) == 0) {
        n = cln::exquo(n, p);
        root = root * p;
      } else {
        free = free * p;
      }
    }
  }
  cln::cl_I whole_root;
  if (cln::isqrt(n, &whole_root)) {
    root = root * whole_root;
  } else {
    free = free * n;
  }
  if (cln::integer_length(free) > 62)
    throw std::domain_error("square root of a number with a too large squarefree part");
  return {root, free};
}

void add_to(Terms& terms, const cln::cl_I& radicand, const cln::cl_RA& coefficient) {
  const auto [place, inserted] = terms.try_emplace(radicand, coefficient);
  if (!inserted) place->second = place->second + coefficient;
  if (cln::zerop(place->second)) terms.erase(place);
}

/// Returns a factor of some radicand that divides each of the others or has no prime in common with it: one
/// of its primes would serve as well, but long radicands are not factored.
cln::cl_I splitting_factor(const Terms& terms) {
  cln::cl_I factor = std::prev(terms.end())->first;
  for (const auto& [radicand, coefficient] : terms)
    if (const cln::cl_I common = cln::gcd(factor, radicand); common != 1) factor = common;
  return factor;
}

}  // namespace

Number::Number(const cln::cl_RA& value) {
  if (!cln::zerop(value)) terms_.emplace(1, value);
}

Number Number::root(const cln::cl_RA& radicand) {
  if (cln::minusp(radicand)) throw std::domain_error("square root of a negative number");
  Number result;
  if (cln::zerop(radicand)) return result;
  const cln::cl_I denominator = cln::denominator(radicand);
  const Square square = split_square(cln::numerator(radicand) * denominator);
  result.terms_.emplace(square.free, cln::cl_RA(square.root) / denominator);
  return result;
}

bool Number::is_one() const { return is_rational() && !is_zero() && terms_.begin()->second == 1; }

bool Number::is_rational() const {
  return terms_.empty() || (terms_.size() == 1 && terms_.begin()->first == 1);
}

cln::cl_RA Number::rational() const {
  const auto place = terms_.find(1);
  return place == terms_.end() ? cln::cl_RA(0) : place->second;
}

cln::cl_F to_float(const Number& number, cln::float_format_t digits) {
  cln::cl_F sum = cln::cl_float(0, digits);
  for (const auto& [radicand, coefficient] : number.terms()) {
    const cln::cl_F term = cln::cl_float(coefficient, digits);
    sum = sum + (radicand == 1 ? term : term * cln::sqrt(cln::cl_float(radicand, digits)));
  }
  return sum;
}

namespace {
/// Enough digits that only a true zero looks like one.
cln::cl_F approximate(const Number& number) { return to_float(number, cln::float_format(80)); }
}  // namespace

int Number::sign() const {
  if (is_zero()) return 0;
  if (terms_.size() == 1) return cln::minusp(terms_.begin()->second) ? -1 : 1;
  return cln::minusp(approximate(*this)) ? -1 : 1;
}

double Number::to_double() const {
  if (is_rational()) return cln::double_approx(rational());
  return cln::double_approx(approximate(*this));
}

Number operator+(const Number& a, const Number& b) {
  Number sum = a;
  for (const auto& [radicand, coefficient] : b.terms_) add_to(sum.terms_, radicand, coefficient);
  return sum;
}

Number Number::operator-() const {
  Number negative = *this;
  for (auto& [radicand, coefficient] : negative.terms_) coefficient = -coefficient;
  return negative;
}

Number operator-(const Number& a, const Number& b) { return a + (-b); }

Number operator*(const Number& a, const Number& b) {
  Number product;
  for (const auto& [ra, ca] : a.terms_) {
    for (const auto& [rb, cb] : b.terms_) {
      const cln::cl_I common = cln::gcd(ra, rb);  // sqrt(x g) sqrt(y g) = g sqrt(x y)
      add_to(product.terms_, cln::exquo(ra, common) * cln::exquo(rb, common), ca * cb * common);
    }
  }
  return product;
}

Number Number::inverse() const {
  if (is_zero()) throw std::domain_error("division by zero");
  if (is_rational()) return Number(cln::recip(rational()));
  // Multiply by the conjugate that changes the sign of one square root: that root leaves the norm.
  const cln::cl_I factor = splitting_factor(terms_);
  Number conjugate = *this;
  for (auto& [radicand, coefficient] : conjugate.terms_)
    if (cln::zerop(cln::mod(radicand, factor))) coefficient = -coefficient;
  return conjugate * (*this * conjugate).inverse();
}

bool operator==(const Number& a, const Number& b) { return a.terms_ == b.terms_; }

std::string to_string(const Number& number) {
  if (number.is_zero()) return "0";
  std::ostringstream text;
  bool first = true;
  for (const auto& [radicand, coefficient] : number.terms()) {
    if (!first && !cln::minusp(coefficient)) text << '+';
    first = false;
    if (radicand == 1) {
      text << coefficient;
    } else {
      if (coefficient == -1)
        text << '-';
      else if (coefficient != 1)
        text << coefficient << '*';
      text << "sqrt(" << radicand << ')';
    }
  }
  return text.str();
}

}  // namespace qvgen::exact
