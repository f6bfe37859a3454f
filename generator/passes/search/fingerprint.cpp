// SPDX-License-Identifier: MIT
#include "passes/search/fingerprint.h"

#include <optional>

#include <cln/integer.h>
#include <cln/numtheory.h>
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

/// Returns a factor of a number that is no prime (Pollard's rho), or nothing if its factors are long.
std::optional<cln::cl_I> factor_of(const cln::cl_I& number) {
  constexpr int most_steps = 1 << 14;
  const auto next = [&](const cln::cl_I& x) { return cln::mod(cln::square(x) + 1, number); };
  cln::cl_I slow = 2, fast = 2;
  for (int step = 0; step < most_steps; ++step) {
    slow = next(slow);
    fast = next(next(fast));
    const cln::cl_I common = cln::gcd(fast - slow, number);
    if (common == number) break;
    if (common != 1) return common;
  }
  return std::nullopt;
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

/// Returns a root in the field: the product of those of the radicand's primes.
Field Fingerprint::root(const cln::cl_I& radicand) {
  const auto known = roots_.find(radicand);
  if (known != roots_.end()) return known->second;
  constexpr unsigned long largest_trial = 1UL << 16;
  Field result = Field::from(1);
  cln::cl_I rest = radicand;
  for (unsigned long p = 2; p < largest_trial && cln::square(cln::cl_I(p)) <= rest; ++p)
    for (; cln::zerop(cln::mod(rest, p)); rest = cln::exquo(rest, p)) result = result * prime_root(p);
  return roots_[radicand] = result * root_without_small_factors(rest);
}

/// A product of primes that are too long to be found gets a value without the law root^2 = radicand:
/// equalities may be missed, never invented.
Field Fingerprint::root_without_small_factors(const cln::cl_I& radicand) const {
  if (radicand == 1) return Field::from(1);
  if (cln::isprobprime(radicand)) return prime_root(radicand);
  if (const auto factor = factor_of(radicand))
    return root_without_small_factors(*factor) * root_without_small_factors(cln::exquo(radicand, *factor));
  return opaque("root", Field::from(modulo(radicand, Field::prime)), {});
}

/// sqrt(2) = 2 cos(pi/4); for odd p dividing the order the Gauss sum of the p-th roots of unity is sqrt(p),
/// or i sqrt(p) for p = 3 mod 4. No angle says the sign of other primes' roots: any will do.
Field Fingerprint::prime_root(const cln::cl_I& number) const {
  if (number > static_cast<unsigned long>(Field::order) || Field::order % cln::cl_I_to_ulong(number) != 0)
    return *Field::from(modulo(number, Field::prime)).square_root();
  const unsigned long prime = cln::cl_I_to_ulong(number);
  if (prime == 2) return unity_.power(Field::order / 8) + unity_.power(Field::order / 8).inverse();
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
