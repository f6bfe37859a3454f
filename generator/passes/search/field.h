// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <optional>

#include "passes/search/random.h"

namespace qvgen::passes::search_detail {

/// Element of the field in which expressions are fingerprinted: a + b w over a prime field, w^2 = 82
/// (Montgomery representation).
///
/// The prime is 12932 * order + 1 with order = 2^4 3^2 5 7 11 13 17 19 23 29 31 37, so the field has the
/// roots of unity exp(i pi r) of every angle r pi that a description is likely to hold, hence i = sqrt(-1)
/// and the square roots of the small primes (Gauss sums of those same roots of unity), all of them consistent
/// with one another. Every other integer has a square root as well, because 82 has none among the integers: a
/// or b w. Without such roots b is zero.
class Field {
 public:
  static constexpr std::uint64_t prime = 2303159653424710081U;
  static constexpr std::uint64_t order = 178097715235440U;

  constexpr Field() = default;
  static Field from(std::uint64_t value);
  /// Primitive root of unity standing for exp(2 pi i / order).
  static Field root_of_unity();

  [[nodiscard]] bool is_zero() const { return (bits_ | along_) == 0; }
  [[nodiscard]] Field power(std::uint64_t exponent) const;
  /// Returns the reciprocal, and zero for zero.
  [[nodiscard]] Field inverse() const;
  /// Returns a square root. All integers have one, of the other elements every second.
  [[nodiscard]] std::optional<Field> square_root() const;
  /// Hash of the value; of integers a bijective one.
  [[nodiscard]] std::uint64_t bits() const { return along_ == 0 ? bits_ : mix(bits_ ^ mix(along_)); }

  friend Field operator+(Field a, Field b) { return raw(add(a.bits_, b.bits_), add(a.along_, b.along_)); }
  friend Field operator-(Field a, Field b) {
    return raw(subtract(a.bits_, b.bits_), subtract(a.along_, b.along_));
  }
  Field operator-() const { return Field() - *this; }
  friend Field operator*(Field a, Field b) {
    const std::uint64_t product = multiply(a.bits_, b.bits_);
    if ((a.along_ | b.along_) == 0) return raw(product);
    return raw(add(product, multiply(square_of_w, multiply(a.along_, b.along_))),
               add(multiply(a.bits_, b.along_), multiply(a.along_, b.bits_)));
  }
  friend bool operator==(Field, Field) = default;
  /// Any order, the same on every platform.
  friend auto operator<=>(Field, Field) = default;

 private:
  [[nodiscard]] Field root_of_integer() const;
  __extension__ using Wide = unsigned __int128;
  static constexpr std::uint64_t negative_inverse() {
    std::uint64_t inverse = prime;  // Newton's iteration modulo 2^64
    for (int i = 0; i < 6; ++i) inverse *= 2 - prime * inverse;
    return ~inverse + 1;
  }
  static Field raw(std::uint64_t bits, std::uint64_t along = 0) {
    Field result;
    result.bits_ = bits;
    result.along_ = along;
    return result;
  }
  static std::uint64_t add(std::uint64_t a, std::uint64_t b) {
    return a + b >= prime ? a + b - prime : a + b;
  }
  static std::uint64_t subtract(std::uint64_t a, std::uint64_t b) { return a >= b ? a - b : a + prime - b; }
  static std::uint64_t multiply(std::uint64_t a, std::uint64_t b) { return reduce(static_cast<Wide>(a) * b); }
  static std::uint64_t reduce(Wide value) {
    const std::uint64_t factor = static_cast<std::uint64_t>(value) * negative_inverse();
    const auto high = static_cast<std::uint64_t>((value + static_cast<Wide>(factor) * prime) >> 64U);
    return high >= prime ? high - prime : high;
  }
  /// Generates the whole multiplicative group of the integers, so it is the square of none.
  static constexpr std::uint64_t generator = 82;
  static constexpr auto square_of_w =
      static_cast<std::uint64_t>((static_cast<Wide>(generator) << 64U) % prime);

  std::uint64_t bits_ = 0, along_ = 0;  ///< a and b
};

}  // namespace qvgen::passes::search_detail
