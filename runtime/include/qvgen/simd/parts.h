// SPDX-License-Identifier: MIT
#pragma once

// Vectors wider than a register: as many registers as they take, each with its own operations. Never passed
// between files in registers, so that files for different instruction sets agree on them.

#include <type_traits>

#include <qvgen/simd/generic.h>

// Part by part, without a function that the linker could keep for another file.
#define QVGEN_EACH(Type, expression)                             \
  Type result;                                                   \
  for (int i = 0; i < parts; ++i) result.part[i] = (expression); \
  return result

namespace qvgen::simd {

template <class T, int bytes>
struct Operations;

/// Operations on vectors of so many bytes, by those on their parts.
template <class T, int bytes, int part_bytes>
struct InParts {
  using Unit = Operations<T, part_bytes>;
  static constexpr int parts = bytes / part_bytes;
  static constexpr int count = parts * Unit::count;
  static constexpr unsigned all_bits = (1U << count) - 1;

  struct Vector {
    typename Unit::Vector part[parts];

    [[gnu::always_inline]] friend inline Vector operator+(const Vector& a, const Vector& b) {
      QVGEN_EACH(Vector, a.part[i] + b.part[i]);
    }
    [[gnu::always_inline]] friend inline Vector operator-(const Vector& a, const Vector& b) {
      QVGEN_EACH(Vector, a.part[i] - b.part[i]);
    }
    [[gnu::always_inline]] friend inline Vector operator*(const Vector& a, const Vector& b) {
      QVGEN_EACH(Vector, a.part[i] * b.part[i]);
    }
    [[gnu::always_inline]] friend inline Vector operator/(const Vector& a, const Vector& b) {
      QVGEN_EACH(Vector, a.part[i] / b.part[i]);
    }
    [[gnu::always_inline]] friend inline Vector operator-(const Vector& a) { QVGEN_EACH(Vector, -a.part[i]); }
  };

  QVGEN_OPERATION Vector load(const T* from) { QVGEN_EACH(Vector, Unit::load(from + i * Unit::count)); }
  QVGEN_OPERATION void store(const Vector& vector, T* to) {
    for (int i = 0; i < parts; ++i) Unit::store(vector.part[i], to + i * Unit::count);
  }
  template <class... Numbers>
  QVGEN_OPERATION Vector of(Numbers... numbers) {
    const T all[] = {numbers...};
    return load(all);
  }
  QVGEN_OPERATION T at(const Vector& vector, int lane) {
    return Unit::at(vector.part[lane / Unit::count], lane % Unit::count);
  }
  QVGEN_OPERATION void set(Vector& vector, int lane, T value) {
    Unit::set(vector.part[lane / Unit::count], lane % Unit::count, value);
  }
  QVGEN_OPERATION Vector spread(T value) { QVGEN_EACH(Vector, Unit::spread(value)); }
  QVGEN_OPERATION Vector root(const Vector& a) { QVGEN_EACH(Vector, Unit::root(a.part[i])); }

#if defined(__GNUC__)
  struct Mask {
    typename Unit::Mask part[parts];
  };
  QVGEN_OPERATION Mask less(const Vector& a, const Vector& b) {
    QVGEN_EACH(Mask, Unit::less(a.part[i], b.part[i]));
  }
  QVGEN_OPERATION Mask at_most(const Vector& a, const Vector& b) {
    QVGEN_EACH(Mask, Unit::at_most(a.part[i], b.part[i]));
  }
  QVGEN_OPERATION Mask equal(const Vector& a, const Vector& b) {
    QVGEN_EACH(Mask, Unit::equal(a.part[i], b.part[i]));
  }
  QVGEN_OPERATION unsigned bits(const Mask& a) {
    unsigned result = 0;
    for (int i = 0; i < parts; ++i) result |= Unit::bits(a.part[i]) << (i * Unit::count);
    return result;
  }
  QVGEN_OPERATION unsigned bits_of_signs(const Vector& a) {
    unsigned result = 0;
    for (int i = 0; i < parts; ++i) result |= Unit::bits_of_signs(a.part[i]) << (i * Unit::count);
    return result;
  }
  QVGEN_OPERATION Vector chosen(const Mask& condition, const Vector& yes, const Vector& no) {
    QVGEN_EACH(Vector, Unit::chosen(condition.part[i], yes.part[i], no.part[i]));
  }
  QVGEN_OPERATION Vector smaller(const Vector& a, const Vector& b) {
    QVGEN_EACH(Vector, Unit::smaller(a.part[i], b.part[i]));
  }
  QVGEN_OPERATION Vector larger(const Vector& a, const Vector& b) {
    QVGEN_EACH(Vector, Unit::larger(a.part[i], b.part[i]));
  }
  QVGEN_OPERATION Vector magnitude(const Vector& a) { QVGEN_EACH(Vector, Unit::magnitude(a.part[i])); }
#endif
};

#if defined(__GNUC__)
template <class T, int bytes>
using OperationsOf =
    std::conditional_t<(bytes > widest_register), InParts<T, bytes, widest_register>, Generic<T, bytes>>;
#else
template <class T, int bytes>
using OperationsOf = std::conditional_t<bytes == sizeof(T), Single<T, bytes>, InParts<T, bytes, sizeof(T)>>;
#endif

/// Operations on vectors of so many bytes: those of one register or of several, and in their place what the
/// instruction set has.
template <class T, int bytes>
struct Operations : OperationsOf<T, bytes> {};

}  // namespace qvgen::simd

#undef QVGEN_EACH
