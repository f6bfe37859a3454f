// SPDX-License-Identifier: MIT
#pragma once

// Names for the 24 ways to write an orientation as three turns about coordinate axes.
//
// A convention is three letters, as scipy writes them. Capitals turn about the axes that have turned already
// ("ZYX": R = Rz(a) Ry(b) Rx(c)); small letters turn about the fixed axes ("xyz": R = Rz(c) Ry(b) Rx(a)).
// Angles are listed in the order of the letters. "ZYX" with (a, b, c) is "xyz" with (c, b, a).

#include <stdexcept>

namespace qvgen {

/// Three axes (0 is x, 1 is y, 2 is z), neighbours different, in the order of the angles.
struct EulerConvention {
  int first;
  int second;
  int third;
  bool fixed_axes;

  /// True if the first axis comes back as the third one, as in ZYZ.
  [[nodiscard]] constexpr bool is_proper() const { return first == third; }
};

constexpr bool operator==(const EulerConvention& a, const EulerConvention& b) {
  return a.first == b.first && a.second == b.second && a.third == b.third && a.fixed_axes == b.fixed_axes;
}
constexpr bool operator!=(const EulerConvention& a, const EulerConvention& b) { return !(a == b); }

/// True if every axis is 0, 1 or 2 and no axis is followed by itself.
constexpr bool is_valid(const EulerConvention& c) {
  const bool are_axes =
      c.first >= 0 && c.first < 3 && c.second >= 0 && c.second < 3 && c.third >= 0 && c.third < 3;
  return are_axes && c.first != c.second && c.second != c.third;
}

/// Returns the convention of three letters: "ZYX" about turned axes, "xyz" about fixed ones. Letters that
/// name none do not compile in a constant, and throw std::invalid_argument elsewhere.
constexpr EulerConvention euler_convention(const char (&letters)[4]) {
  const bool is_fixed = letters[0] >= 'x';
  const char x = is_fixed ? 'x' : 'X';
  const EulerConvention result{letters[0] - x, letters[1] - x, letters[2] - x, is_fixed};
  return is_valid(result) ? result
                          : throw std::invalid_argument(
                                "an Euler convention is three of XYZ or of xyz, none "
                                "followed by itself: \"ZYX\", \"xyz\", \"ZYZ\"");
}

/// A, B, C of KUKA: about z, the turned y, the turned x.
inline constexpr EulerConvention kuka_abc = euler_convention("ZYX");
/// EulerZYX of ABB's RAPID: about z, the turned y, the turned x. ABB's targets are quaternions: `from_wxyz`.
inline constexpr EulerConvention abb_zyx = euler_convention("ZYX");
/// W, P, R of Fanuc: about the fixed x, y, z.
inline constexpr EulerConvention fanuc_wpr = euler_convention("xyz");
/// Rx, Ry, Rz of Yaskawa: about the fixed x, y, z.
inline constexpr EulerConvention yaskawa_rxyz = euler_convention("xyz");
/// Rx, Ry, Rz of Staubli: about x, the turned y, the turned z.
inline constexpr EulerConvention staubli_rxyz = euler_convention("XYZ");
/// O, A, T of Kawasaki: about z, the turned y, the turned z.
inline constexpr EulerConvention kawasaki_oat = euler_convention("ZYZ");
/// Roll, pitch, yaw of ROS and URDF: about the fixed x, y, z.
inline constexpr EulerConvention ros_rpy = euler_convention("xyz");

}  // namespace qvgen
