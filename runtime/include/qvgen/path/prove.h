// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <qvgen/inverse/certified/tube.h>
#include <qvgen/path/curve.h>
#include <qvgen/path/motions.h>

/// Proofs of motions: around each a tube in which it is the only continuous motion that follows the path, by
/// interval arithmetic (inverse/certified/tube.h). What cannot be proven, next to singular poses, is named.
namespace qvgen::path {

/// Result for one motion; gaps are reported one by one.
struct Proven {
  long boxes = 0;
  double narrowest = 1;  ///< the least half width of a box, rad or m
  bool is_whole = true;  ///< no gap
};

namespace proving {

inline inverse::certified::WayBend bend_of(const Bend& bend) {
  using Kind = inverse::certified::WayBend::Kind;
  inverse::certified::WayBend result;
  result.kind = bend.kind == Bend::Kind::spline ? Kind::spline : Kind::corners;
  std::copy(bend.a.data(), bend.a.data() + 6, result.a.begin());
  std::copy(bend.b.data(), bend.b.data() + 6, result.b.begin());
  result.begin = bend.begin;
  result.end = bend.end;
  return result;
}

/// Returns a piece as the proofs take it.
inline inverse::certified::Way way_of(const Curve& curve, std::size_t i) {
  const Piece piece = curve.piece(i);
  inverse::certified::Way way{curve.sample(i), curve.sample(i + 1), piece.turn(),
                              piece.move(),    piece.centre(),      piece.winds()};
  if (!piece.is_bent()) return way;
  way.start = way.from;
  way.from = curve.at(static_cast<double>(i));
  way.to = curve.at(static_cast<double>(i + 1));
  way.bend = bend_of(piece.bend());
  return way;
}

inline inverse::certified::TubeEnd end_of(double u, const Values& q) {
  inverse::certified::TubeEnd end{u, {}};
  std::copy(q.data(), q.data() + 6, end.q);
  return end;
}

}  // namespace proving

inline constexpr int most_tried = 50000;  ///< stretches of one motion

/// Proves one motion of a record that keeps joints at the samples; `take_gap(from, to)` is called with each
/// stretch that is not proven, in rising order.
template <int capacity, class TakeGap>
Proven prove(const inverse::certified::Arm& arm, const Curve& curve, const Record<capacity>& record,
             const Motion& motion, const TakeGap& take_gap) {
  Proven result;
  long tried = 0;
  double s = motion.begin.s, open = -1, open_end = -1;  // a gap that may go on
  Values q = motion.begin.q;
  const auto close = [&] {
    if (open >= 0) take_gap(open, open_end);
    open = -1;
  };
  const auto go_to = [&](double next_s, const Values& next) {
    const std::size_t i = curve.piece_at(s);
    const double offset = static_cast<double>(i);
    const inverse::certified::TubeProof proof = inverse::certified::prove_tube(
        arm, proving::way_of(curve, i), proving::end_of(s - offset, q),
        proving::end_of(next_s - offset, next), static_cast<int>(std::min(20000L, most_tried - tried)));
    tried += proof.tried;
    result.boxes += proof.boxes;
    result.narrowest = std::min(result.narrowest, proof.narrowest);
    for (std::size_t k = 0; k < proof.gap_count; ++k) {
      const double from = offset + proof.gaps[k].from, to = offset + proof.gaps[k].to;
      result.is_whole = false;
      if (open < 0 || from > open_end) close(), open = from;
      open_end = to;
    }
    s = next_s;
    q = next;
  };
  for (auto i = static_cast<std::size_t>(s) + 1; static_cast<double>(i) < motion.end.s; ++i) {
    Values next;
    if (record.at(i, motion.track, next)) go_to(static_cast<double>(i), next + motion.turns);
  }
  if (motion.end.s > s && curve.pieces() > 0) go_to(motion.end.s, motion.end.q);
  close();
  return result;
}

}  // namespace qvgen::path
