// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <qvgen/inverse/certified/certify.h>

/// Proofs about motions of the joints along a way of the tool. For all poses P(u), u in U = [a, b], and a box
/// X of joint values, Krawczyk's operator K(X) = m - Y f(m, U) + (I - Y F'(X, U)) (X - m) is enclosed at
/// once. If it lies strictly inside X, each pose of U has exactly one solution in X; F' is regular there, so
/// that they are one continuous motion (implicit functions). Ways are halved until boxes are found, and two
/// neighbours belong together because one small box, proven at the place between them, lies in both.
namespace qvgen::inverse::certified {

/// Offsets that bend a straight way: with d(u) = f(u) a + g(u) b, a move (m) and a rotation vector d_r (rad),
/// the position is p(u) + d_p(u), the orientation exp(d_r(u)) R(u). Spline: f = u (1 - u)^2, g = -u^2 (1 -
/// u). Corners: f = max(0, begin - u)^2 / (4 begin), g = max(0, u - 1 + end)^2 / (4 end); zero where the
/// share is.
struct WayBend {
  enum class Kind { none, spline, corners };
  Kind kind = Kind::none;
  std::array<double, 6> a{}, b{};
  double begin = 0, end = 0;  ///< shares of the way that are rounded, at most 1/2
};

/// The tool's way from one pose to another, u from 0 to 1: with T(u) the turn by the rotation vector u
/// `turn`, orientation T(u) `from`, position `from` + u `move`; on a screw centre + T(u) (from - centre) + u
/// `move`. These numbers are exact. Its end and `to` may differ by rounding, which the proof covers. Of a
/// bent way `start` takes the place of `from`, which is where its bent form begins, to rounding.
struct Way {
  Pose<double> from, to;
  Vector3<double> turn, move, centre;
  bool winds;
  WayBend bend{};
  Pose<double> start{};

  [[nodiscard]] bool is_bent() const { return bend.kind != WayBend::Kind::none; }
};

/// Joint values at a place of the way.
struct TubeEnd {
  double u;
  double q[joints];
};

/// Parts of a way on which one motion is proven to be the only one in a tube around it.
struct TubeProof {
  static constexpr std::size_t most_gaps = 8;
  struct Gap {
    double from, to;
  };
  int boxes = 0;         ///< that were proven
  int tried = 0;         ///< stretches for which one was looked for
  double narrowest = 1;  ///< the least half width of a box, rad or m: no other motion is as near
  std::array<Interval, joints> range{};  ///< all joint values on the stretches that are proven, if there are
  std::array<Gap, most_gaps> gaps{};
  std::size_t gap_count = 0;  ///< stretches that are not proven, in rising order

  [[nodiscard]] bool is_proven() const { return gap_count == 0; }
};

/// Proves the motion between two places of a way, as far as that can be: next to singular poses it cannot.
/// `most` bounds the stretches that are tried. No heap, no exceptions.
TubeProof prove_tube(const Arm& arm, const Way& way, const TubeEnd& start, const TubeEnd& goal,
                     int most = 20000);

}  // namespace qvgen::inverse::certified
