// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace qvgen::passes::search_detail {

/// splitmix64 (Steele, Lea, Flood 2014): one step of the mixing function.
inline std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

/// FNV-1a, finished by mix: the same on every platform, unlike std::hash.
inline std::uint64_t hash(std::string_view text, std::uint64_t seed) {
  std::uint64_t h = 0xcbf29ce484222325U ^ seed;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return mix(h);
}

/// Integer generator whose stream depends on the seed alone; the distributions of <random> differ between
/// libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() { return mix(state_ += 0x9e3779b97f4a7c15U); }
  /// Uniform in [0, bound), bound > 0 (multiply and shift; its bias of 2^-32 is of no concern here).
  std::uint32_t below(std::uint32_t bound) {
    return static_cast<std::uint32_t>(((next() >> 32U) * bound) >> 32U);
  }
  /// True with probability numerator/256.
  bool chance(std::uint32_t numerator) { return (next() >> 56U) < numerator; }
  /// About exponentially distributed, mean near 1.5, in units of 1/65536: -log2 of a uniform number, linear
  /// between powers of two, so that only integers are involved.
  std::int64_t exponential() {
    const std::uint64_t x = next() | 1U;
    const int zeros = std::countl_zero(x);
    const auto fraction = static_cast<std::int64_t>(((x << zeros) >> 47U) & 0xffffU);
    return (static_cast<std::int64_t>(zeros) << 16U) + 0x10000 - fraction;
  }

 private:
  std::uint64_t state_;
};

}  // namespace qvgen::passes::search_detail
