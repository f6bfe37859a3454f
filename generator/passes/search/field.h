// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace qvgen::passes::search_detail {

/// Element of the prime field in which expressions are fingerprinted (Montgomery representation).
///
/// The prime is 12932 * order + 1 with order = 2^4 3^2 5 7 11 13 17 19 23 29 31 37, so the field has the
/// roots of unity exp(i pi r) of every angle r pi that a description is likely to hold, hence i = sqrt(-1)
/// and the square roots of the small primes (Gauss sums of those same roots of unity), all of them consistent
/// with one another.
class Field {
 public:
  static constexpr std::uint64_t prime = 2303159653424710081U;
  static constexpr std::uint64_t order = 178097715235440U;

  constexpr Field() = default;
  static Field from(std::uint64_t value);
  /// Primitive root of unity standing for exp(2 pi i / order).
  static Field root_of_unity();

  [[nodiscard]] bool is_zero() const { return bits_ == 0; }
  [[nodiscard]] Field power(std::uint64_t exponent) const;
  [[nodiscard]] Field inverse() const { return power(prime - 2); }
  /// A bijective image of the value, for hashing and ordering.
  [[nodiscard]] std::uint64_t bits() const { return bits_; }

  friend Field operator+(Field a, Field b) {
    const std::uint64_t sum = a.bits_ + b.bits_;
    return raw(sum >= prime ? sum - prime : sum);
  }
  friend Field operator-(Field a, Field b) {
    return raw(a.bits_ >= b.bits_ ? a.bits_ - b.bits_ : a.bits_ + prime - b.bits_);
  }
  Field operator-() const { return Field() - *this; }
  friend Field operator*(Field a, Field b) { return raw(reduce(static_cast<Wide>(a.bits_) * b.bits_)); }
  friend bool operator==(Field, Field) = default;

 private:
  __extension__ using Wide = unsigned __int128;
  static constexpr std::uint64_t negative_inverse() {
    std::uint64_t inverse = prime;  // Newton's iteration modulo 2^64
    for (int i = 0; i < 6; ++i) inverse *= 2 - prime * inverse;
    return ~inverse + 1;
  }
  static Field raw(std::uint64_t bits) {
    Field result;
    result.bits_ = bits;
    return result;
  }
  static std::uint64_t reduce(Wide value) {
    const std::uint64_t factor = static_cast<std::uint64_t>(value) * negative_inverse();
    const auto high = static_cast<std::uint64_t>((value + static_cast<Wide>(factor) * prime) >> 64U);
    return high >= prime ? high - prime : high;
  }
  std::uint64_t bits_ = 0;
};

}  // namespace qvgen::passes::search_detail
