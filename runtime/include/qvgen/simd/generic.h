// SPDX-License-Identifier: MIT
#pragma once

// Operations on vectors that every machine has, in the vector types of GCC and Clang: the compiler knows more
// of these than of intrinsics, and joins comparisons and selections better. Headers of instruction sets
// replace what it does not translate well. Other compilers take numbers one by one, with arithmetic alone.

#include <cmath>
#include <cstdint>
#include <cstring>

#include <qvgen/simd/instruction_sets.h>

#define QVGEN_OPERATION [[gnu::always_inline]] static inline

namespace qvgen::simd {

#if defined(__GNUC__)

template <class T, int bytes>
struct Generic {
  using Vector __attribute__((vector_size(bytes))) = T;
  static constexpr int count = bytes / static_cast<int>(sizeof(T));
  static constexpr unsigned all_bits = (1U << count) - 1;

  template <class... Numbers>
  QVGEN_OPERATION Vector of(Numbers... numbers) {
    return Vector{numbers...};
  }
  QVGEN_OPERATION Vector load(const T* from) {
    Vector result;
    std::memcpy(&result, from, sizeof result);
    return result;
  }
  QVGEN_OPERATION void store(const Vector& vector, T* to) { std::memcpy(to, &vector, sizeof vector); }
  QVGEN_OPERATION T at(const Vector& vector, int lane) { return vector[lane]; }
  QVGEN_OPERATION void set(Vector& vector, int lane, T value) { vector[lane] = value; }
  // The zero is subtracted: added it would make a zero of -0.
  QVGEN_OPERATION Vector spread(T value) { return value - Vector{}; }
  QVGEN_OPERATION Vector sign_bit() { return spread(T(-0.0)); }

  /// All bits of a lane, or none.
  using Mask = decltype(Vector() < Vector());
  QVGEN_OPERATION Mask mask_of(bool value) { return Mask{} - (value ? 1 : 0); }
  QVGEN_OPERATION Mask less(Vector a, Vector b) { return a < b; }
  QVGEN_OPERATION Mask at_most(Vector a, Vector b) { return a <= b; }
  QVGEN_OPERATION Mask equal(Vector a, Vector b) { return a == b; }
  QVGEN_OPERATION Mask both(Mask a, Mask b) { return a & b; }
  QVGEN_OPERATION Mask either(Mask a, Mask b) { return a | b; }
  QVGEN_OPERATION Mask one_of(Mask a, Mask b) { return a ^ b; }
  QVGEN_OPERATION Mask opposite(Mask a) { return ~a; }
  /// One bit for each lane, the first one lowest.
  QVGEN_OPERATION unsigned bits(Mask a) {
    unsigned result = 0;
    for (int i = 0; i < count; ++i) result |= (a[i] != 0 ? 1U : 0U) << i;
    return result;
  }
  QVGEN_OPERATION unsigned bits_of_signs(Vector a) {
    unsigned result = 0;
    for (int i = 0; i < count; ++i) result |= (std::signbit(a[i]) ? 1U : 0U) << i;
    return result;
  }

  QVGEN_OPERATION Vector chosen(Mask condition, Vector yes, Vector no) { return condition ? yes : no; }
  QVGEN_OPERATION Vector chosen_by_sign(Vector sign, Vector negative, Vector otherwise) {
    return reinterpret_cast<Mask>(sign) < 0 ? negative : otherwise;
  }
  // Beside a NaN `b`, as x86 has it.
  QVGEN_OPERATION Vector smaller(Vector a, Vector b) { return a < b ? a : b; }
  QVGEN_OPERATION Vector larger(Vector a, Vector b) { return a > b ? a : b; }
  QVGEN_OPERATION Vector common(Vector a, Vector b) {
    return reinterpret_cast<Vector>(reinterpret_cast<Mask>(a) & reinterpret_cast<Mask>(b));
  }
  QVGEN_OPERATION Vector flipped(Vector a, Vector b) {
    return reinterpret_cast<Vector>(reinterpret_cast<Mask>(a) ^ reinterpret_cast<Mask>(b));
  }
  QVGEN_OPERATION Vector magnitude(Vector a) {
    return reinterpret_cast<Vector>(reinterpret_cast<Mask>(a) & ~reinterpret_cast<Mask>(sign_bit()));
  }
  QVGEN_OPERATION Vector negated(Mask condition, Vector a) { return condition ? -a : a; }
  QVGEN_OPERATION Vector root(Vector a) {
    Vector result;
    for (int i = 0; i < count; ++i) result[i] = std::sqrt(a[i]);
    return result;
  }

  static constexpr bool stores_chosen_lanes = false;  ///< true: by one instruction
  /// Replaces the chosen lanes of the numbers at `to`.
  QVGEN_OPERATION void put(Mask chosen_lanes, Vector value, T* to) {
    for (int i = 0; i < count; ++i)
      if (chosen_lanes[i]) to[i] = value[i];
  }
  /// Writes the lanes as whole numbers of 32 bits.
  QVGEN_OPERATION void put_rounded(Vector value, void* to) {
    for (int i = 0; i < count; ++i) {
      const auto number = static_cast<std::int32_t>(std::nearbyint(value[i]));
      std::memcpy(static_cast<char*>(to) + sizeof number * static_cast<unsigned>(i), &number, sizeof number);
    }
  }
};

#else

/// One number, in place of a register.
template <class T, int bytes>
struct Single {
  using Vector = T;
  static constexpr int count = 1;
  static T load(const T* from) { return *from; }
  static void store(T vector, T* to) { *to = vector; }
  static T spread(T value) { return value; }
  static T at(T vector, int) { return vector; }
  static void set(T& vector, int, T value) { vector = value; }
  static T root(T a) { return std::sqrt(a); }
};

#endif

}  // namespace qvgen::simd
