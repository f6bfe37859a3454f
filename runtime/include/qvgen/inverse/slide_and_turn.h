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
};

template <typename Scalar>
void add_slide_turn(const Rotor<Scalar>& turn, const Scalar& slide, bool chosen, SlideTurns<Scalar>& found) {
  found.root[static_cast<std::size_t>(found.count++)] = {turn, slide, chosen};
}

/// The two unit vectors with v·u = rhs, as far as they exist or nearly so.
template <typename Scalar>
CircleRoots<Scalar> on_line(const Rotor<Scalar>& v, const Scalar& rhs, const Boundary& boundary) {
  using std::sqrt;
  CircleRoots<Scalar> found;
  const Scalar length = sqrt(Scalar(v.cosine * v.cosine + v.sine * v.sine));
  Branch<Scalar> branch;
  for (int sign = 1; sign >= -1; sign -= 2) {
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
void slide_by_quartic(const SlideAndTurn<Scalar>& e, const Boundary& boundary, const Scalar& pi,
                      SlideTurns<Scalar>& found) {
  const Scalar square = e.divisor * e.divisor;
  const Scalar twice = Scalar(2) * (e.level + e.h * e.divisor);
  const Conic<Scalar> conic = {e.l.cosine * e.l.cosine,
                               Scalar(2) * e.l.cosine * e.l.sine,
                               e.l.sine * e.l.sine,
                               twice * e.l.cosine + square * e.m.cosine,
                               twice * e.l.sine + square * e.m.sine,
                               e.level * e.level + Scalar(2) * e.h * e.divisor * e.level + square * e.mean};
  const CircleRoots<Scalar> roots = conic_circle(conic, boundary, pi);
  for (int i = 0; i < roots.count; ++i) {
    const Rotor<Scalar>& u = roots.root[static_cast<std::size_t>(i)];
    add_slide_turn(u, Scalar((e.level + e.l.cosine * u.cosine + e.l.sine * u.sine) / e.divisor), false,
                   found);
  }
}

/// Next to no divisor: the linear equation gives u, the distance then the slide.
template <typename Scalar>
void turn_then_slide(const SlideAndTurn<Scalar>& e, const Scalar& tiny, const Boundary& boundary,
                     SlideTurns<Scalar>& found) {
  const CircleRoots<Scalar> roots = on_line(e.l, Scalar(-e.level), boundary);
  for (int i = 0; i < roots.count; ++i) {
    const Rotor<Scalar>& u = roots.root[static_cast<std::size_t>(i)];
    const Scalar m = e.mean + e.m.cosine * u.cosine + e.m.sine * u.sine;
    for (int sign = 1; sign >= -1; sign -= 2) {
      Branch<Scalar> branch;
      const Scalar root =
          signed_root(Scalar(e.h * e.h - m), Scalar(e.h * e.h), tiny, Scalar(sign), boundary, branch);
      if (branch.exists) add_slide_turn(u, Scalar(root - e.h), false, found);
    }
  }
}

/// Without a linear equation the slide is free: chosen, as far as the turn can follow.
template <typename Scalar>
void slide_chosen(const SlideAndTurn<Scalar>& e, const Scalar& choice, const Rotor<Scalar>& spread,
                  const Boundary& boundary, SlideTurns<Scalar>& found) {
  using std::sqrt;
  const Scalar most = sqrt(Scalar(e.m.cosine * e.m.cosine + e.m.sine * e.m.sine));
  const Scalar middle = e.h * e.h - e.mean;
  const Scalar t = slide_between(Rotor<Scalar>{e.h, Scalar(0)}, Rotor<Scalar>{Scalar(1), Scalar(0)},
                                 Scalar(middle - most), Scalar(middle + most), choice, spread);
  const CircleRoots<Scalar> roots = on_line(e.m, Scalar(-(t * (t + Scalar(2) * e.h) + e.mean)), boundary);
  for (int i = 0; i < roots.count; ++i)
    add_slide_turn(roots.root[static_cast<std::size_t>(i)], t, true, found);
}

/// All solutions. Where the divisor vanishes the quartic falls apart into double roots that do not tell the
/// slide; there the starts that lack no more than the divisor's share are as good, for Newton's steps.
template <typename Scalar>
SlideTurns<Scalar> slide_and_turn(const SlideAndTurn<Scalar>& e, const Scalar& tiny,
                                  const Scalar& size_square, const Scalar& choice,
                                  const Rotor<Scalar>& spread, const Boundary& boundary, const Scalar& pi) {
  const Scalar little(tolerance::lost_divisor);
  const Scalar square = e.l.cosine * e.l.cosine + e.l.sine * e.l.sine;
  SlideTurns<Scalar> found;
  if (magnitude(e.divisor) > little)
    slide_by_quartic(e, boundary, pi, found);
  else if (square > little * little * size_square)
    turn_then_slide(e, tiny, boundary, found);
  else if (!(e.level * e.level > little * little * size_square))
    slide_chosen(e, choice, spread, boundary, found);
  return found;
}

}  // namespace qvgen::inverse
