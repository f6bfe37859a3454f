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

/// The tool's way from one pose to another, u from 0 to 1: with T(u) the turn by the rotation vector u
/// `turn`, orientation T(u) `from`, position `from` + u `move`; on a screw centre + T(u) (from - centre) + u
/// `move`. These numbers are exact. Its end and `to` may differ by rounding, which the proof covers.
struct Way {
  Pose<double> from, to;
  Vector3<double> turn, move, centre;
  bool winds;
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
