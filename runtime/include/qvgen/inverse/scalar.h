// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

/// Building blocks of generated inverse kinematics. Every block computes one branch of a solution, chosen by
/// a sign, without jumps, so that the same text serves one number or a pack of numbers, one branch in each
/// lane.
namespace qvgen::inverse {

/// What a scalar type needs beyond arithmetic; packs and multi-precision numbers specialise it.
template <typename Scalar>
struct ScalarTraits {
  using Mask = bool;  ///< a truth value for each lane
  static Scalar epsilon() { return std::numeric_limits<Scalar>::epsilon(); }
};

template <typename Scalar>
using Mask = typename ScalarTraits<Scalar>::Mask;

template <typename Scalar>
Scalar epsilon() {
  return ScalarTraits<Scalar>::epsilon();
}

/// One of two values, for conditions that no processor can predict: a jump would cost more than both values.
template <typename Scalar>
Scalar select(bool condition, const Scalar& yes, const Scalar& no) {
#if defined(__GNUC__)
  return __builtin_expect_with_probability(condition, 1, 0.5) ? yes : no;
#else
  return condition ? yes : no;
#endif
}

inline bool any(bool condition) { return condition; }

/// Whether what is next to a singular pose is left to another solver: such a branch is doubtful then, and
/// regular ones, which are nearly all, need no steps for it.
template <typename Scalar>
inline constexpr bool leaves_singular_poses = false;

/// Two roots closer than this share of their range are one double root: the distance of the roots is then the
/// root of this number, about 6e-8, while the pose that their mean reaches is off by 4e-15 relative.
template <typename Scalar>
Scalar merge_share() {
  return Scalar(18) * epsilon<Scalar>();
}

/// How far off a pose the nearest joints may leave the arm's point and still count as a solution, as a share
/// of the arm's size: what a pose at the boundary of reach needs, since rounding puts every second one
/// outside.
inline constexpr double default_tolerance = 1e-13;

template <typename Scalar>
Scalar smaller(const Scalar& a, const Scalar& b) {
  return select(a < b, a, b);
}

template <typename Scalar>
Scalar larger(const Scalar& a, const Scalar& b) {
  return select(a > b, a, b);
}

template <typename Scalar>
Scalar magnitude(const Scalar& a) {
  return select(a < Scalar(0), Scalar(-a), a);
}
inline double magnitude(double a) { return std::fabs(a); }
inline double smaller(double a, double b) { return a < b ? a : b; }
inline double larger(double a, double b) { return a > b ? a : b; }

template <typename Scalar>
Scalar not_negative(const Scalar& a) {
  return select(a > Scalar(0), a, Scalar(0));
}

/// |magnitude| with the sign of `sign`, +0 and -0 counting as positive.
template <typename Scalar>
Scalar with_sign(const Scalar& magnitude, const Scalar& sign) {
  return select(sign < Scalar(0), Scalar(-magnitude), magnitude);
}

/// -a where the condition holds.
template <typename Scalar>
Scalar negated(const Mask<Scalar>& condition, const Scalar& a) {
  return select(condition, Scalar(-a), a);
}

// By the sign bit alone, -0 counting as negative: one instruction less than a comparison.

/// `negative` where the sign bit is set.
inline double select_by_sign(double sign, double negative, double otherwise) {
  return select(std::signbit(sign), negative, otherwise);
}
/// |magnitude| with the sign bit.
inline double with_sign_bit(double magnitude, double sign) { return std::copysign(magnitude, sign); }
/// -a where the sign bit is set.
inline double flipped(double a, double sign) { return a * std::copysign(1.0, sign); }

/// How blocks treat the ends of their range, where two solutions meet and rounding decides whether they
/// exist. `plain` is for regular poses: equations are taken at their word, and what should not be trusted is
/// said. The others are for poses near singular ones: whatever might exist is followed, and Newton steps and
/// the pose they reach decide; near_singular.h shows when each is used.
struct Boundary {
  double accept = 0;  ///< so far outside, as a share of the range, a branch still exists and is taken to the
                      ///< end of the range
  double doubt = 0;   ///< nearer to an end than this share, inside, the branch is doubtful
  double beyond = 0;  ///< the same outside: what is farther out is not for rounding to decide
  double unsure = 1e-7;  ///< nearer to an end than this share Newton steps judge what the branch leads to
  double floor = 0;      ///< least share of the range: what is nearer to the end is moved away from it
  double near = 1e18;    ///< a direction whose square is below this multiple of noise is nearly free, and
                         ///< accepted at any share
  bool wide = true;      ///< what is nearly free is doubtful, even if no pass would choose it
  bool choose = false;   ///< what is nearly free is chosen as if it were free
  bool take = false;     ///< places on a continuum are taken where nothing has been chosen, too
  double gap = 64;       ///< a free direction's equation holds if the square of what is left is below this
                         ///< multiple of noise
  double miss = 0;       ///< how far off the pose polished joints may leave the arm, as a share of its size
  double fold = 0;       ///< so far outside a wrist at the end of the arm's joints still exists, folded

  /// Where joints can follow a choice in two separate ranges it is in the other one.
  bool opposite = false;

  static constexpr Boundary plain(double tolerance) {
    Boundary boundary;
    boundary.doubt = 1e-7 + 100 * tolerance;
    boundary.beyond = 1e-10 + 100 * tolerance;
    boundary.miss = tolerance;
    boundary.fold = tolerance;
    return boundary;
  }

  // The passes of near_singular.h.

  /// From the ends of the ranges. What polishing leaves in the joints of an arm near a singular place of its
  /// own reaches the wrist magnified: half of the 1e-12 that no solution may miss its pose by.
  static constexpr Boundary ends(double tolerance) {
    Boundary boundary = careful(tolerance);
    boundary.unsure = 1e-7 + 100 * tolerance;
    boundary.wide = false;
    boundary.miss = tolerance;
    return boundary;
  }
  /// The same with a choice where an angle is nearly free.
  static constexpr Boundary chosen(double tolerance) {
    Boundary boundary = ends(tolerance);
    boundary.choose = true;
    return boundary;
  }
  /// The same where the choice leaves the joints after it out of reach: they are stretched to where it would
  /// be, and Newton's steps turn the chosen joint until they reach.
  static constexpr Boundary stretched(double tolerance) {
    Boundary boundary = chosen(tolerance);
    boundary.accept = 1e3;
    boundary.gap = 1e40;
    return boundary;
  }

  /// The same, or a pass of quartic/care.h that chooses, with the choice in the other of two ranges.
  [[nodiscard]] constexpr Boundary in_other_range() const {
    Boundary boundary = *this;
    boundary.opposite = true;
    return boundary;
  }

  // The passes of quartic/care.h.

  /// From the ends of the ranges, taking no miss but rounding.
  static constexpr Boundary careful(double tolerance) {
    Boundary boundary;
    boundary.accept = 1e-3 + 100 * tolerance;
    boundary.gap = 64e14;
    boundary.fold = tolerance > 5e-13 ? tolerance : 5e-13;
    return boundary;
  }
  /// The same with a choice where an angle is nearly free.
  static constexpr Boundary choosing(double tolerance) {
    Boundary boundary = careful(tolerance);
    boundary.choose = true;
    boundary.take = true;
    return boundary;
  }
  /// The same where the choice leaves the joints after it out of reach.
  static constexpr Boundary reaching(double tolerance) {
    Boundary boundary = choosing(tolerance);
    boundary.accept = 1e3;
    return boundary;
  }
  /// From the ends once more, for places on a continuum to which no choice has led.
  static constexpr Boundary taking(double tolerance) {
    Boundary boundary = careful(tolerance);
    boundary.take = true;
    return boundary;
  }
  /// From two places apart.
  static constexpr Boundary apart(double tolerance) {
    Boundary boundary = choosing(tolerance);
    boundary.floor = 1e-10;
    return boundary;
  }
  /// From the ends again, for poses that are out of reach by no more than the tolerance.
  static constexpr Boundary tolerant(double tolerance) {
    Boundary boundary = taking(tolerance);
    boundary.miss = tolerance;
    return boundary;
  }

  /// Whether this is the pass of a regular pose.
  [[nodiscard]] constexpr bool is_plain() const { return doubt > 0; }
};

/// What is known of the branch that a sequence of blocks follows.
template <typename Scalar>
struct Branch {
  Mask<Scalar> exists{true};      ///< false: no such solution
  Mask<Scalar> continuum{false};  ///< true: an angle was free and has been chosen
  Mask<Scalar> doubtful{
      false};  ///< true: rounding may have decided what exists, on this branch or on one before

  Mask<Scalar> unsure{false};  ///< the same on this branch alone, in passes near singular poses too

  /// Back to a fork; doubts stay.
  void resume(const Branch& fork) {
    exists = fork.exists;
    continuum = fork.continuum;
    unsure = fork.unsure;
  }
  void doubt(const Mask<Scalar>& condition) {
    doubtful = doubtful | (exists & condition);
    unsure = unsure | condition;
  }
  /// Where an angle is free it has been chosen, if the equation holds; elsewhere the branch is what a regular
  /// block has found.
  void take(const Mask<Scalar>& is_free, const Mask<Scalar>& holds, const Branch& regular) {
    doubtful = doubtful | (exists & is_free) | regular.doubtful;
    unsure = unsure | is_free | regular.unsure;
    exists = (is_free & exists & holds) | ((!is_free) & regular.exists);
    continuum = continuum | (exists & is_free);
  }
};

}  // namespace qvgen::inverse
