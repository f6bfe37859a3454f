// SPDX-License-Identifier: MIT
#pragma once

// Numbers side by side in a vector register: the one vector type of the library, with one set of operations.
// It is the scalar of generated functions (a configuration a lane), of the blocks of the inverse kinematics
// (a branch or a pose a lane) and of elimination (a root a lane). A lane has the bits that a single number
// has.
//
// Serves code that may not include Eigen; with it also include eigen.h.

#include <qvgen/simd/instruction_sets.h>
#include <qvgen/simd/operations.h>

#define QVGEN_LANES [[gnu::always_inline]] friend inline

namespace qvgen::simd {

/// A truth value for each lane.
template <class T, class Set>
struct Mask {
  using Unit = Operations<T, Set::bytes>;
  typename Unit::Mask lanes;

  Mask() = default;
  [[gnu::always_inline]] Mask(bool value)
      : lanes(Unit::mask_of(value)) {}  // NOLINT(google-explicit-constructor)
  [[gnu::always_inline]] explicit Mask(typename Unit::Mask all) : lanes(all) {}

  QVGEN_LANES Mask operator&(const Mask& a, const Mask& b) { return Mask(Unit::both(a.lanes, b.lanes)); }
  QVGEN_LANES Mask operator|(const Mask& a, const Mask& b) { return Mask(Unit::either(a.lanes, b.lanes)); }
  QVGEN_LANES Mask operator^(const Mask& a, const Mask& b) { return Mask(Unit::one_of(a.lanes, b.lanes)); }
  QVGEN_LANES Mask operator!(const Mask& a) { return Mask(Unit::opposite(a.lanes)); }

  /// One bit for each lane, the first one lowest.
  QVGEN_LANES unsigned bits(const Mask& a) { return Unit::bits(a.lanes); }
  QVGEN_LANES bool any(const Mask& a) { return bits(a) != 0; }
  QVGEN_LANES bool all(const Mask& a) { return bits(a) == Unit::all_bits; }
};

/// As many numbers as `Set` has bytes for. Only for sources that are compiled for the set.
template <class T, class Set>
class Lanes {
 public:
  using Number = T;
  using Unit = Operations<T, Set::bytes>;
  using Vector = typename Unit::Vector;
  using Truth = Mask<T, Set>;
  static constexpr int size = Unit::count;

  Lanes() = default;
  [[gnu::always_inline]] Lanes(double value)  // NOLINT(google-explicit-constructor)
      : vector_(Unit::spread(static_cast<T>(value))) {}
  [[gnu::always_inline]] explicit Lanes(const Vector& vector) : vector_(vector) {}
  template <class... Numbers>
  [[gnu::always_inline]] Lanes(T first, T second, Numbers... others)
      : vector_(Unit::of(first, second, static_cast<T>(others)...)) {
    static_assert(2 + sizeof...(others) == size);
  }

  [[gnu::always_inline]] static Lanes load(const T* from) { return Lanes(Unit::load(from)); }
  [[gnu::always_inline]] void store(T* to) const { Unit::store(vector_, to); }
  [[gnu::always_inline]] const Vector& vector() const { return vector_; }
  [[gnu::always_inline]] T operator[](int lane) const { return Unit::at(vector_, lane); }
  [[gnu::always_inline]] void set(int lane, T value) { Unit::set(vector_, lane, value); }

  QVGEN_LANES Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.vector_ + b.vector_); }
  QVGEN_LANES Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.vector_ - b.vector_); }
  QVGEN_LANES Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.vector_ * b.vector_); }
  QVGEN_LANES Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.vector_ / b.vector_); }
  QVGEN_LANES Lanes operator-(const Lanes& a) { return Lanes(-a.vector_); }
  [[gnu::always_inline]] Lanes& operator+=(const Lanes& other) { return *this = *this + other; }
  [[gnu::always_inline]] Lanes& operator-=(const Lanes& other) { return *this = *this - other; }
  [[gnu::always_inline]] Lanes& operator*=(const Lanes& other) { return *this = *this * other; }
  [[gnu::always_inline]] Lanes& operator/=(const Lanes& other) { return *this = *this / other; }
  QVGEN_LANES Lanes sqrt(const Lanes& a) { return Lanes(Unit::root(a.vector_)); }

  QVGEN_LANES Truth operator<(const Lanes& a, const Lanes& b) {
    return Truth(Unit::less(a.vector_, b.vector_));
  }
  QVGEN_LANES Truth operator<=(const Lanes& a, const Lanes& b) {
    return Truth(Unit::at_most(a.vector_, b.vector_));
  }
  QVGEN_LANES Truth operator==(const Lanes& a, const Lanes& b) {
    return Truth(Unit::equal(a.vector_, b.vector_));
  }
  QVGEN_LANES Truth operator>(const Lanes& a, const Lanes& b) { return b < a; }
  QVGEN_LANES Truth operator>=(const Lanes& a, const Lanes& b) { return b <= a; }

  QVGEN_LANES Lanes select(const Truth& condition, const Lanes& yes, const Lanes& no) {
    return Lanes(Unit::chosen(condition.lanes, yes.vector_, no.vector_));
  }
  QVGEN_LANES Lanes smaller(const Lanes& a, const Lanes& b) {
    return Lanes(Unit::smaller(a.vector_, b.vector_));
  }
  QVGEN_LANES Lanes larger(const Lanes& a, const Lanes& b) {
    return Lanes(Unit::larger(a.vector_, b.vector_));
  }
  QVGEN_LANES Lanes not_negative(const Lanes& a) { return larger(a, Lanes(0.0)); }
  /// 1, -1, or 0 of zero and NaN: qvgen::direction.
  QVGEN_LANES Lanes direction(const Lanes& a) {
    const Vector zero{};
    const Vector one = zero + T(1);
    return Lanes(a.vector_ > zero ? one : a.vector_ < zero ? -one : zero);
  }

  // Signs, in one or two instructions.

  QVGEN_LANES Lanes magnitude(const Lanes& a) { return Lanes(Unit::magnitude(a.vector_)); }
  /// A number of which the sign bit alone counts: that of a product.
  QVGEN_LANES Lanes sign_of_product(const Lanes& a, const Lanes& b) {
    return Lanes(Unit::flipped(a.vector_, b.vector_));
  }
  /// The sign bit alone, as a number: plus or minus zero.
  QVGEN_LANES Lanes sign_of(const Lanes& a) { return Lanes(Unit::common(a.vector_, Unit::sign_bit())); }
  /// Changes the sign of lanes where another number has the sign bit.
  QVGEN_LANES Lanes flipped(const Lanes& a, const Lanes& sign) { return sign_of_product(a, sign_of(sign)); }
  /// Gives a number that is not negative the sign bit of another.
  QVGEN_LANES Lanes with_sign_bit(const Lanes& magnitude, const Lanes& sign) {
    return flipped(magnitude, sign);
  }
  QVGEN_LANES Lanes negated(const Truth& condition, const Lanes& a) {
    return Lanes(Unit::negated(condition.lanes, a.vector_));
  }
  QVGEN_LANES Lanes with_sign(const Lanes& magnitude, const Lanes& sign) {
    return negated(sign < Lanes(0.0), magnitude);
  }
  QVGEN_LANES Lanes select_by_sign(const Lanes& sign, const Lanes& negative, const Lanes& otherwise) {
    return Lanes(Unit::chosen_by_sign(sign.vector_, negative.vector_, otherwise.vector_));
  }
  /// One bit for each lane, set where the number has the sign bit.
  QVGEN_LANES unsigned bits_of_signs(const Lanes& a) { return Unit::bits_of_signs(a.vector_); }

 private:
  Vector vector_;
};

}  // namespace qvgen::simd

#undef QVGEN_LANES
