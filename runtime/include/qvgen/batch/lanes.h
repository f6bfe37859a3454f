// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstring>

#include <Eigen/Core>
#include <qvgen/batch/machine.h>
#include <qvgen/batch/registers.h>

#define QVGEN_LANES [[gnu::always_inline]] friend inline

namespace qvgen::batch {

/// As many numbers as a register of the set holds: a scalar for the functions of generated robots, which then
/// treat one configuration in each lane. The compiler's own vectors: it knows more of them than of
/// intrinsics, and the same text serves every machine.
///
/// Only for sources that are compiled for the set.
template <class T, class Set>
class Lanes {
 public:
  using Number = T;
  static constexpr int size = Set::bytes / static_cast<int>(sizeof(T));
  using Vector __attribute__((vector_size(Set::bytes))) = T;

  Lanes() = default;
  // Minus zero: plus zero would make a zero of -0.
  [[gnu::always_inline]] Lanes(double value)  // NOLINT(google-explicit-constructor)
      : vector_(static_cast<T>(value) - Vector{}) {}
  [[gnu::always_inline]] explicit Lanes(const Vector& vector) : vector_(vector) {}

  [[gnu::always_inline]] static Lanes load(const T* from) {
    Lanes result;
    std::memcpy(&result.vector_, from, sizeof(Vector));
    return result;
  }
  [[gnu::always_inline]] void store(T* to) const { std::memcpy(to, &vector_, sizeof(Vector)); }
  [[gnu::always_inline]] const Vector& vector() const { return vector_; }
  [[gnu::always_inline]] T operator[](int lane) const { return vector_[lane]; }

  QVGEN_LANES Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.vector_ + b.vector_); }
  QVGEN_LANES Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.vector_ - b.vector_); }
  QVGEN_LANES Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.vector_ * b.vector_); }
  QVGEN_LANES Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.vector_ / b.vector_); }
  QVGEN_LANES Lanes operator-(const Lanes& a) { return Lanes(-a.vector_); }
  [[gnu::always_inline]] Lanes& operator+=(const Lanes& other) { return *this = *this + other; }
  [[gnu::always_inline]] Lanes& operator-=(const Lanes& other) { return *this = *this - other; }
  [[gnu::always_inline]] Lanes& operator*=(const Lanes& other) { return *this = *this * other; }
  [[gnu::always_inline]] Lanes& operator/=(const Lanes& other) { return *this = *this / other; }

  /// 1, -1, or 0 of zero and NaN: qvgen::direction.
  QVGEN_LANES Lanes direction(const Lanes& a) {
    const Vector zero{};
    const Vector one = zero + T(1);
    return Lanes(a.vector_ > zero ? one : a.vector_ < zero ? -one : zero);
  }
  QVGEN_LANES Lanes sqrt(const Lanes& a) { return Lanes(Register<T, Set>::root(a.vector_)); }
  // Generated functions ask for the sine of a single angle only if it is a constant of the arm, equal in all
  // lanes.
  QVGEN_LANES Lanes sin(const Lanes& a) {
    return of_constant(a, [](T x) { return std::sin(x); });
  }
  QVGEN_LANES Lanes cos(const Lanes& a) {
    return of_constant(a, [](T x) { return std::cos(x); });
  }

 private:
  template <class Function>
  [[gnu::always_inline]] static Lanes each(const Lanes& a, Function function) {
    Lanes result;
    for (int i = 0; i < size; ++i) result.vector_[i] = function(a.vector_[i]);
    return result;
  }
  template <class Function>
  [[gnu::always_inline]] static Lanes of_constant(const Lanes& a, Function function) {
    const T first = a.vector_[0];
    bool all_same = true;
    for (int i = 1; i < size; ++i) all_same = all_same && a.vector_[i] == first;
    return all_same ? Lanes(function(first) - Vector{}) : each(a, function);
  }

  Vector vector_;
};

}  // namespace qvgen::batch

#undef QVGEN_LANES

template <class T, class Set>
struct Eigen::NumTraits<qvgen::batch::Lanes<T, Set>> : Eigen::GenericNumTraits<qvgen::batch::Lanes<T, Set>> {
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};
