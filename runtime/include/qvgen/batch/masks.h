// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/batch/lanes.h>
#include <qvgen/batch/registers.h>

#define QVGEN_LANES [[gnu::always_inline]] inline

namespace qvgen::batch {

/// A truth value for each lane of doubles.
template <class Set>
struct LaneMask {
  using Unit = Register<double, Set>;
  typename Unit::Mask lanes;
  LaneMask() = default;
  [[gnu::always_inline]] LaneMask(bool value) : lanes(Unit::mask_of(value)) {}  // NOLINT
  [[gnu::always_inline]] explicit LaneMask(typename Unit::Mask all) : lanes(all) {}
};

// Operations that blocks of the inverse kinematics use on doubles, here for lanes of doubles. Each lane has
// the bits that a double has (qvgen/inverse/branch.h).

template <class Set>
QVGEN_LANES LaneMask<Set> operator<(const Lanes<double, Set>& a, const Lanes<double, Set>& b) {
  return LaneMask<Set>(Register<double, Set>::less(a.vector(), b.vector()));
}
template <class Set>
QVGEN_LANES LaneMask<Set> operator<=(const Lanes<double, Set>& a, const Lanes<double, Set>& b) {
  return LaneMask<Set>(Register<double, Set>::at_most(a.vector(), b.vector()));
}
template <class Set>
QVGEN_LANES LaneMask<Set> operator>(const Lanes<double, Set>& a, const Lanes<double, Set>& b) {
  return b < a;
}
template <class Set>
QVGEN_LANES LaneMask<Set> operator>=(const Lanes<double, Set>& a, const Lanes<double, Set>& b) {
  return b <= a;
}
template <class Set>
QVGEN_LANES LaneMask<Set> operator==(const Lanes<double, Set>& a, const Lanes<double, Set>& b) {
  return LaneMask<Set>(Register<double, Set>::equal(a.vector(), b.vector()));
}

template <class Set>
QVGEN_LANES LaneMask<Set> operator&(const LaneMask<Set>& a, const LaneMask<Set>& b) {
  return LaneMask<Set>(Register<double, Set>::both(a.lanes, b.lanes));
}
template <class Set>
QVGEN_LANES LaneMask<Set> operator|(const LaneMask<Set>& a, const LaneMask<Set>& b) {
  return LaneMask<Set>(Register<double, Set>::either(a.lanes, b.lanes));
}
template <class Set>
QVGEN_LANES LaneMask<Set> operator^(const LaneMask<Set>& a, const LaneMask<Set>& b) {
  return LaneMask<Set>(Register<double, Set>::one_of(a.lanes, b.lanes));
}
template <class Set>
QVGEN_LANES LaneMask<Set> operator!(const LaneMask<Set>& a) {
  return a ^ LaneMask<Set>(true);
}

/// One bit for each lane, the first one lowest.
template <class Set>
QVGEN_LANES unsigned bits(const LaneMask<Set>& mask) {
  return Register<double, Set>::bits(mask.lanes);
}
template <class Set>
QVGEN_LANES bool any(const LaneMask<Set>& mask) {
  return bits(mask) != 0;
}

template <class Set>
QVGEN_LANES Lanes<double, Set> select(const LaneMask<Set>& condition, const Lanes<double, Set>& yes,
                                      const Lanes<double, Set>& no) {
  return Lanes<double, Set>(Register<double, Set>::chosen(condition.lanes, yes.vector(), no.vector()));
}
template <class Set>
QVGEN_LANES Lanes<double, Set> smaller(const Lanes<double, Set>& a, const Lanes<double, Set>& b) {
  return Lanes<double, Set>(Register<double, Set>::smaller(a.vector(), b.vector()));
}
template <class Set>
QVGEN_LANES Lanes<double, Set> larger(const Lanes<double, Set>& a, const Lanes<double, Set>& b) {
  return Lanes<double, Set>(Register<double, Set>::larger(a.vector(), b.vector()));
}
template <class Set>
QVGEN_LANES Lanes<double, Set> not_negative(const Lanes<double, Set>& a) {
  return larger(a, Lanes<double, Set>(0.0));
}

// Signs.

template <class Set>
QVGEN_LANES Lanes<double, Set> with_flips_of(const Lanes<double, Set>& a, const Lanes<double, Set>& flips) {
  return Lanes<double, Set>(Register<double, Set>::flipped(a.vector(), flips.vector()));
}
/// The sign bit alone, as a number: plus or minus zero.
template <class Set>
QVGEN_LANES Lanes<double, Set> sign_of(const Lanes<double, Set>& a) {
  return Lanes<double, Set>(Register<double, Set>::common(a.vector(), Lanes<double, Set>(-0.0).vector()));
}
template <class Set>
QVGEN_LANES Lanes<double, Set> magnitude(const Lanes<double, Set>& a) {
  return Lanes<double, Set>(Register<double, Set>::magnitude(a.vector()));
}
template <class Set>
QVGEN_LANES Lanes<double, Set> flipped(const Lanes<double, Set>& a, const Lanes<double, Set>& sign) {
  return with_flips_of(a, sign_of(sign));
}
template <class Set>
QVGEN_LANES Lanes<double, Set> negated(const LaneMask<Set>& condition, const Lanes<double, Set>& a) {
  return Lanes<double, Set>(Register<double, Set>::negated(condition.lanes, a.vector()));
}
template <class Set>
QVGEN_LANES Lanes<double, Set> with_sign(const Lanes<double, Set>& magnitude,
                                         const Lanes<double, Set>& sign) {
  return negated(sign < Lanes<double, Set>(0.0), magnitude);
}
/// Gives a number that is not negative the sign bit of another.
template <class Set>
QVGEN_LANES Lanes<double, Set> with_sign_bit(const Lanes<double, Set>& magnitude,
                                             const Lanes<double, Set>& sign) {
  return with_flips_of(magnitude, sign_of(sign));
}
template <class Set>
QVGEN_LANES Lanes<double, Set> select_by_sign(const Lanes<double, Set>& sign,
                                              const Lanes<double, Set>& negative,
                                              const Lanes<double, Set>& otherwise) {
  return Lanes<double, Set>(
      Register<double, Set>::chosen_by_sign(sign.vector(), negative.vector(), otherwise.vector()));
}

}  // namespace qvgen::batch

#undef QVGEN_LANES
