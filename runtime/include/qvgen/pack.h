// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <qvgen/sine_cosine.h>

namespace qvgen {

// The compiler's options decide if a pack is one vector register or four doubles: two types to the linker.
#if defined(__AVX__)
#define QVGEN_PACK_ABI vectors
#else
#define QVGEN_PACK_ABI arrays
#endif
inline namespace QVGEN_PACK_ABI {

/// Four doubles side by side: a scalar for the functions of generated robots, which then treat four
/// configurations in one call. Include the robot's ..._definitions.h, compile with -mavx2 -mfma or
/// -march=native:
///
///     arm::JointVector<qvgen::Pack> q, qd, qdd;                // q[i][k]: joint i of configuration k
///     const auto torque = arm::inverse_dynamics(q, qd, qdd);   // torque[i][k]
///
/// A lane has the value of the same call in double but for rounding. No comparisons: functions with branches,
/// Coulomb friction among them, do not take packs.
class Pack {
 public:
  static constexpr int size = 4;

  Pack() = default;
  Pack(double value) : Pack(value, value, value, value) {}  // NOLINT(google-explicit-constructor)
  Pack(double a, double b, double c, double d) : lanes_{a, b, c, d} {}

  double operator[](int lane) const { return lanes_[lane]; }
  void set(int lane, double value) { lanes_[lane] = value; }

#if defined(__AVX__)
  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.lanes_ + b.lanes_); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.lanes_ - b.lanes_); }
  friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.lanes_ * b.lanes_); }
  friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.lanes_ / b.lanes_); }
  Pack operator-() const { return Pack(-lanes_); }
#else
  friend Pack operator+(const Pack& a, const Pack& b) {
    return each([&](int i) { return a[i] + b[i]; });
  }
  friend Pack operator-(const Pack& a, const Pack& b) {
    return each([&](int i) { return a[i] - b[i]; });
  }
  friend Pack operator*(const Pack& a, const Pack& b) {
    return each([&](int i) { return a[i] * b[i]; });
  }
  friend Pack operator/(const Pack& a, const Pack& b) {
    return each([&](int i) { return a[i] / b[i]; });
  }
  Pack operator-() const {
    return each([&](int i) { return -lanes_[i]; });
  }
#endif
  Pack& operator+=(const Pack& other) { return *this = *this + other; }
  Pack& operator-=(const Pack& other) { return *this = *this - other; }
  Pack& operator*=(const Pack& other) { return *this = *this * other; }
  Pack& operator/=(const Pack& other) { return *this = *this / other; }

  friend Pack sqrt(const Pack& a) {
    return each([&](int i) { return std::sqrt(a[i]); });
  }
  friend Pack sin(const Pack& a) { return from(sines_and_cosines<double>(a[0], a[1], a[2], a[3]).sine); }
  friend Pack cos(const Pack& a) { return from(sines_and_cosines<double>(a[0], a[1], a[2], a[3]).cosine); }

  static Pack from(const double* lanes) { return {lanes[0], lanes[1], lanes[2], lanes[3]}; }

 private:
#if defined(__AVX__)
  using Lanes = double __attribute__((vector_size(32)));
  explicit Pack(Lanes lanes) : lanes_(lanes) {}
  Lanes lanes_;
#else
  double lanes_[size];
#endif
  template <class Function>
  static Pack each(Function function) {
    return {function(0), function(1), function(2), function(3)};
  }
};

}  // namespace QVGEN_PACK_ABI
#undef QVGEN_PACK_ABI

/// One vector pass an angle gives both.
template <>
inline void sines_and_cosines<Pack>(const Pack* angles, Pack* sines, Pack* cosines, int count) {
  for (int i = 0; i < count; ++i) {
    const Pack angle = angles[i];
    const auto both = sines_and_cosines<double>(angle[0], angle[1], angle[2], angle[3]);
    sines[i] = Pack::from(both.sine);
    cosines[i] = Pack::from(both.cosine);
  }
}

}  // namespace qvgen

template <>
struct Eigen::NumTraits<qvgen::Pack> : Eigen::GenericNumTraits<qvgen::Pack> {
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
