// SPDX-License-Identifier: MIT
#include "passes/search/field.h"

#include <utility>

namespace qvgen::passes::search_detail {

Field Field::from(std::uint64_t value) {
  constexpr Wide square = ((((static_cast<Wide>(1) << 64U) % prime) << 64U) % prime);  // R^2
  return raw(reduce(static_cast<Wide>(value % prime) * static_cast<std::uint64_t>(square)));
}

Field Field::root_of_unity() { return from(generator).power((prime - 1) / order); }

/// As Tonelli and Shanks do: the odd part of a square is an even power of a root of unity z of order 2^6. Of
/// what is no square the 82nd part is one.
Field Field::root_of_integer() const {
  constexpr std::uint64_t twos = 64, odd = (prime - 1) / twos;
  static_assert(odd % 2 == 1);
  const Field z = from(generator).power(odd), w = raw(0, from(1).bits_);
  for (const auto& [square, factor] :
       {std::pair(*this, from(1)), std::pair(*this * from(generator).inverse(), w)}) {
    const Field part = square.power(odd);
    for (std::uint64_t k = 0; k < twos / 2; ++k)
      if (z.power(2 * k) == part) return factor * square.power((odd + 1) / 2) * z.power(twos - k);
  }
  return {};
}

/// The square of x + b w / (2 x) is a + b w if x^2 is half of a + n, n^2 the norm of a + b w.
std::optional<Field> Field::square_root() const {
  if (along_ == 0) return root_of_integer();
  const Field norm = (*this * raw(bits_, subtract(0, along_))).root_of_integer();
  if (norm.along_ != 0) return std::nullopt;
  const Field half = from(2).inverse(), x = ((raw(bits_) + norm) * half).root_of_integer();
  return x + raw(0, along_) * half * x.inverse();
}

Field Field::inverse() const {
  if (along_ == 0) return power(prime - 2);
  const Field norm = *this * raw(bits_, subtract(0, along_));
  return raw(bits_, subtract(0, along_)) * norm.inverse();
}

Field Field::power(std::uint64_t exponent) const {
  Field result = from(1);
  for (Field base = *this; exponent != 0; exponent >>= 1U, base = base * base)
    if ((exponent & 1U) != 0) result = result * base;
  return result;
}

}  // namespace qvgen::passes::search_detail
