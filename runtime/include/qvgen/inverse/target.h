// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/angles.h>

namespace qvgen::inverse {

/// Preferred value of each joint, taken if a pose leaves it free: zero, the caller's or nobody's. Angles come
/// with their cosines and sines.
template <int dof>
struct Preference {
  double angle[dof];
  double slide[dof];
  Rotor<double> turn[dof];
  Rotor<double> brief[dof];  ///< directions as short as `span` wants them
  Rotor<double> spread;      ///< (1, 0): slides are where they are preferred; turned: elsewhere in reach, see
                             ///< `slide_between`
  bool seeded = false;       ///< the caller's

  constexpr Preference() : angle{}, slide{}, turn{}, brief{}, spread{1, 0} {
    for (int i = 0; i < dof; ++i) choose(i, {1, 0});
  }
  constexpr void choose(int i, const Rotor<double>& direction) {
    turn[i] = direction;
    brief[i] = {brief_length * direction.cosine, brief_length * direction.sine};
  }
  /// Nobody's preference: a branch on which one would matter is doubtful, and has to be followed with one.
  static constexpr Preference nobodys() {
    Preference none;
    for (int i = 0; i < dof; ++i) {
      none.angle[i] = tolerance::farthest_joint;
      none.brief[i] = {0, 0};
    }
    return none;
  }
};

template <int dof>
inline constexpr Preference<dof> zero_preference{};
template <int dof>
inline constexpr Preference<dof> nobodys_preference = Preference<dof>::nobodys();

/// Pointers to a pose's numbers: x, y, z, w of its quaternion, then its position.
struct PoseNumbers {
  const double* quaternion;
  const double* position;
};

/// 1 / |q| of a valid pose's quaternion from |q|² - 1, which `unit_tolerance` keeps so small that its third
/// power is below rounding.
template <typename Scalar>
[[gnu::always_inline]] inline Scalar unit_scale(const Scalar& excess) {
  return Scalar(1) + excess * (Scalar(-0.5) + Scalar(0.375) * excess);
}
/// 1 / |q|², the same way.
template <typename Scalar>
[[gnu::always_inline]] inline Scalar square_scale(const Scalar& excess) {
  return Scalar(1) + excess * (excess - Scalar(1));
}

/// The part of a generated Target that is the same for every robot. Nothing but numbers, without Eigen: files
/// that are compiled for other machines than the rest read it. `Scalar`: a double, or one of each of several
/// poses.
template <int dof, typename Scalar = double>
struct TargetBase {
  static constexpr double noise = 16 * std::numeric_limits<double>::epsilon();
  static constexpr double tiny0 = noise * noise;  ///< square of noise in directions of unit length
  double tolerance;                               ///< see `default_tolerance`
  Boundary boundary;                              ///< how this pass treats the ends of ranges
  Scalar tiny1, tiny2,
      tiny4;  ///< squares of directions that are noise: of lengths, squared lengths, short lengths squared
  const Preference<dof>* preference;

  [[gnu::always_inline]] void set_size(const Scalar& square) {
    tiny1 = Scalar(noise * noise) * square;
    tiny2 = tiny1 * square;
    tiny4 = tiny1 * tiny1;
  }
};

}  // namespace qvgen::inverse
