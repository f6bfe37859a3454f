// SPDX-License-Identifier: MIT
#include "passes/search/fingerprint.h"

#include <cln/integer.h>
#include <cln/rational.h>

#include "passes/search/random.h"

namespace qvgen::passes::search_detail {
namespace {

std::uint64_t modulo(const cln::cl_I& value, std::uint64_t modulus) {
  return cln::cl_I_to_ulong(cln::mod(value, cln::cl_I(static_cast<unsigned long>(modulus))));
}

Field rational(const cln::cl_RA& value) {
  const Field numerator = Field::from(modulo(cln::numerator(value), Field::prime));
  return numerator * Field::from(modulo(cln::denominator(value), Field::prime)).inverse();
}

/// Legendre symbol by Euler's criterion; p is small.
int legendre(unsigned long a, unsigned long p) {
  unsigned long result = 1;
  for (unsigned long i = 0; i < (p - 1) / 2; ++i) result = result * (a % p) % p;
  return result == 0 ? 0 : result == 1 ? 1 : -1;
}

}  // namespace

Fingerprint::Fingerprint(std::uint64_t seed)
    : seed_(seed),
      unity_(Field::root_of_unity()),
      imaginary_(unity_.power(Field::order / 4)),
      half_(Field::from(2).inverse()) {}

Field Fingerprint::symbol(const std::string& name) const { return Field::from(hash(name, seed_)); }

Field Fingerprint::number(const exact::Number& value) {
  Field result;
  for (const auto& [radicand, coefficient] : value.terms())
    result = result + rational(coefficient) * root(radicand);
  return result;
}

/// Returns a root in the field. The rest of a long radicand, without its small factors, counts as a prime.
Field Fingerprint::root(const cln::cl_I& radicand) {
  const auto known = roots_.find(radicand);
  if (known != roots_.end()) return known->second;
  constexpr unsigned long largest_trial = 1UL << 16;
  Field result = Field::from(1);
  cln::cl_I rest = radicand;
  for (unsigned long p = 2; p < largest_trial && cln::square(cln::cl_I(p)) <= rest; ++p)
    for (; cln::zerop(cln::mod(rest, p)); rest = cln::exquo(rest, p)) result = result * prime_root(p);
  if (rest > 1) {
    const bool is_short = cln::integer_length(rest) <= 63;
    result = result * (is_short ? prime_root(cln::cl_I_to_ulong(rest))
                                : opaque("root", Field::from(modulo(rest, Field::prime)), {}));
  }
  return roots_[radicand] = result;
}

/// sqrt(2) = 2 cos(pi/4); for odd p dividing the order the Gauss sum of the p-th roots of unity is sqrt(p),
/// or i sqrt(p) for p = 3 mod 4. Other primes get a value without the law sqrt(p)^2 = p: equalities may be
/// missed, never invented.
Field Fingerprint::prime_root(unsigned long prime) const {
  if (prime == 2) return unity_.power(Field::order / 8) + unity_.power(Field::order / 8).inverse();
  if (Field::order % prime != 0) return opaque("root", Field::from(prime), {});
  const Field step = unity_.power(Field::order / prime);
  Field sum;
  Field power = step;
  for (unsigned long n = 1; n < prime; ++n, power = power * step)
    sum = legendre(n, prime) == 1 ? sum + power : sum - power;
  return prime % 4 == 1 ? sum : -(imaginary_ * sum);
}

CosineSine Fingerprint::circular(const dag::Angle& angle) const {
  constexpr unsigned long parts = 720720;  // N above: coefficients of angles have denominators that divide it
  Field u = Field::from(1);
  for (const auto& [name, coefficient] : angle.terms) {
    const cln::cl_RA exponent = coefficient * cln::cl_I(parts);
    const Field unit = Field::from(hash(name, ~seed_));
    const bool whole = cln::denominator(exponent) == 1;
    u = u * (whole ? unit.power(modulo(cln::numerator(exponent), Field::prime - 1))
                   : opaque("unit", unit, rational(exponent)));
  }
  const cln::cl_RA turns = angle.pi * cln::cl_I(static_cast<unsigned long>(Field::order / 2));
  u = u * (cln::denominator(turns) == 1 ? unity_.power(modulo(cln::numerator(turns), Field::order))
                                        : opaque("turn", rational(turns), {}));
  const Field inverse = u.inverse();
  return {(u + inverse) * half_, -((u - inverse) * half_ * imaginary_)};
}

Field Fingerprint::opaque(const char* operation, Field a, Field b) const {
  return Field::from(mix(hash(operation, seed_) ^ mix(a.bits() ^ mix(b.bits()))));
}

}  // namespace qvgen::passes::search_detail
