// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/conic_circle.h>
#include <qvgen/inverse/slides.h>

namespace qvgen::inverse {

/// A slide t and a unit vector u that a linear equation and a distance bind: divisor t = l(u) and t² + 2 h t
/// + m(u) = 0 with l(u) = level + l·u, m(u) = mean + m·u; divisor is a part of a unit vector.
template <typename Scalar>
struct SlideAndTurn {
  Scalar divisor, h;
  Scalar level;
  Rotor<Scalar> l;
  Scalar mean;
  Rotor<Scalar> m;
};

template <typename Scalar>
struct SlideTurn {
  Rotor<Scalar> turn;
  Scalar slide;
  bool chosen = false;  ///< the slide was free
};

template <typename Scalar>
struct SlideTurns {
  int count = 0;
  std::array<SlideTurn<Scalar>, 4> root;

  void add(const SlideTurn<Scalar>& found) { root[static_cast<std::size_t>(count++)] = found; }
};

namespace slide_and_turn_cases {

/// The two unit vectors with v·u = rhs, as far as they exist or nearly so.
template <typename Scalar>
CircleRoots<Scalar> on_line(const Rotor<Scalar>& v, const Scalar& rhs, const Boundary& boundary) {
  using std::sqrt;
  CircleRoots<Scalar> found;
  const Scalar length = sqrt(Scalar(v.cosine * v.cosine + v.sine * v.sine));
  Branch<Scalar> branch;
  for (const double sign : {1.0, -1.0}) {
    const Rotor<Scalar> turn =
        circle_angle(Scalar(length - rhs), Scalar(length + rhs), Scalar(Scalar(1) / (Scalar(2) * length)),
                     Scalar(sign), boundary, branch);
    if (branch.exists)
      found.root[static_cast<std::size_t>(found.count++)] = Scalar(Scalar(1) / length) * (turn * v);
  }
  return found;
}

/// The divisor in the way: the slide eliminated, and squared, it is a quartic for u.
template <typename Scalar>
SlideTurns<Scalar> regular(const SlideAndTurn<Scalar>& e, const Boundary& boundary, const Scalar& pi) {
  const Scalar square = e.divisor * e.divisor;
  const Scalar twice = Scalar(2) * (e.level + e.h * e.divisor);
  const auto roots =
      conic_circle<Scalar>({e.l.cosine * e.l.cosine, Scalar(2) * e.l.cosine * e.l.sine, e.l.sine * e.l.sine,
                            twice * e.l.cosine + square * e.m.cosine, twice * e.l.sine + square * e.m.sine,
                            e.level * e.level + Scalar(2) * e.h * e.divisor * e.level + square * e.mean},
                           boundary, pi);
  SlideTurns<Scalar> found;
  for (int i = 0; i < roots.count; ++i) {
    const Rotor<Scalar>& u = roots.root[static_cast<std::size_t>(i)];
    found.add({u, (e.level + e.l.cosine * u.cosine + e.l.sine * u.sine) / e.divisor});
  }
  return found;
}

/// Next to no divisor: the linear equation gives u, the distance then the slide.
template <typename Scalar>
SlideTurns<Scalar> turn_first(const SlideAndTurn<Scalar>& e, const Scalar& tiny, const Boundary& boundary) {
  SlideTurns<Scalar> found;
  const auto turns = on_line(e.l, Scalar(-e.level), boundary);
  for (int i = 0; i < turns.count; ++i) {
    const Rotor<Scalar>& u = turns.root[static_cast<std::size_t>(i)];
    const Scalar m = e.mean + e.m.cosine * u.cosine + e.m.sine * u.sine;
    for (const double sign : {1.0, -1.0}) {
      Branch<Scalar> branch;
      const Scalar root =
          signed_root(Scalar(e.h * e.h - m), Scalar(e.h * e.h), tiny, Scalar(sign), boundary, branch);
      if (branch.exists) found.add({u, root - e.h});
    }
  }
  return found;
}

/// Without a linear equation the slide is free: chosen, as far as the turn can follow.
template <typename Scalar>
SlideTurns<Scalar> slide_chosen(const SlideAndTurn<Scalar>& e, const Scalar& choice,
                                const Rotor<Scalar>& spread, const Boundary& boundary) {
  using std::sqrt;
  const Scalar most = sqrt(Scalar(e.m.cosine * e.m.cosine + e.m.sine * e.m.sine));
  const Scalar middle = e.h * e.h - e.mean;
  const Scalar t = slide_between<Scalar>({e.h, Scalar(0)}, {Scalar(1), Scalar(0)}, middle - most,
                                         middle + most, choice, spread);
  SlideTurns<Scalar> found;
  const auto turns = on_line(e.m, Scalar(-(t * (t + Scalar(2) * e.h) + e.mean)), boundary);
  for (int i = 0; i < turns.count; ++i) found.add({turns.root[static_cast<std::size_t>(i)], t, true});
  return found;
}

}  // namespace slide_and_turn_cases

/// All solutions. Where the divisor vanishes the quartic falls apart into double roots that do not tell the
/// slide; there the starts that lack no more than the divisor's share are as good, for Newton's steps.
template <typename Scalar>
SlideTurns<Scalar> slide_and_turn(const SlideAndTurn<Scalar>& e, const Scalar& tiny,
                                  const Scalar& size_square, const Scalar& choice,
                                  const Rotor<Scalar>& spread, const Boundary& boundary, const Scalar& pi) {
  const Scalar little(tolerance::lost_divisor);
  if (magnitude(e.divisor) > little) return slide_and_turn_cases::regular(e, boundary, pi);
  const Scalar square = e.l.cosine * e.l.cosine + e.l.sine * e.l.sine;
  if (square > little * little * size_square) return slide_and_turn_cases::turn_first(e, tiny, boundary);
  if (e.level * e.level > little * little * size_square) return {};
  return slide_and_turn_cases::slide_chosen(e, choice, spread, boundary);
}

}  // namespace qvgen::inverse
