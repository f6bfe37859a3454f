// SPDX-License-Identifier: MIT
// Two angles from two equations that are linear in the cosine and sine of each: two rods that hold an ankle,
// three that hold a planar platform. One angle is eliminated; what is left is a trigonometric polynomial of
// degree four in the other, so there are at most eight solutions. Its roots are isolated on the whole circle:
// an arc without a root is proved to have none by bounds of the derivatives, a root is alone in an arc where
// the slope has one sign. Short arcs without either verdict hold solutions that (nearly) meet. Newton's steps
// on the two equations themselves decide about every candidate, so the elimination costs no digits. C reads
// this text as well.
#pragma once

#include <array>

#include <qvgen/inverse/tolerances.h>
#include <qvgen/inverse/two_turns_polynomial.h>

namespace qvgen::inverse {

/// One solution: both angles.
template <typename Scalar>
struct TurnPair {
  Rotor<Scalar> first, second;
  bool meets = false;  ///< another solution is so near that rounding may have made two of one
};

/// Solutions in the order of the first angle, from -pi on. Where the equations have lost their meaning (both
/// hold along a curve) there is one root, which is not a number.
template <typename Scalar>
struct TurnPairs {
  int count = 0;
  std::array<TurnPair<Scalar>, 8> root;
};

namespace two_turns_cases {

/// Both equations, the polynomial that is left of them, and the solutions that have been found.
template <typename Scalar>
struct TurnSearch {
  TwoTurns<Scalar> e;
  Harmonics<Scalar> f;
  Scalar fourth;  ///< bound of f's fourth derivative
  Scalar noise;   ///< rounding in f's values
  int most = 8;   ///< solutions that are kept
  int visits = 0;
  TurnPairs<Scalar> found;
};

template <typename Scalar>
Rotor<Scalar> unit_turn(const Rotor<Scalar>& u) {
  using std::sqrt;
  return Scalar(Scalar(1) / sqrt(Scalar(u.cosine * u.cosine + u.sine * u.sine))) * u;
}
template <typename Scalar>
Scalar turns_apart(const Rotor<Scalar>& a, const Rotor<Scalar>& b) {
  return magnitude(a.cosine - b.cosine) + magnitude(a.sine - b.sine);
}

template <typename Scalar>
bool holds_at(const TwoTurnsEquation<Scalar>& m, const Rotor<Scalar>& u, const Rotor<Scalar>& v) {
  return magnitude(wave_at(wave_of_second(m, u), v)) <
         Scalar(tolerance::equation_rounding) * epsilon<Scalar>();
}

/// Keeps a solution, but for one that is there: as near as rounding may have moved it. `apart`: 0 where both
/// equations' curves touch. Returns false if it is none.
template <typename Scalar>
bool keep_turns(const Rotor<Scalar>& u, const Rotor<Scalar>& v, const Scalar& apart,
                TurnSearch<Scalar>& search) {
  if (!holds_at(search.e.one, u, v) || !holds_at(search.e.other, u, v)) return false;
  const Scalar least(tolerance::same_turn);
  const Scalar most(tolerance::same_turn_at_most);
  const Scalar moved = Scalar(tolerance::turn_rounding) * epsilon<Scalar>();
  const Scalar same = most * apart < moved ? most : moved < least * apart ? least : Scalar(moved / apart);
  for (int i = 0; i < search.found.count; ++i) {
    const TurnPair<Scalar> other = search.found.root[static_cast<std::size_t>(i)];
    if (turns_apart(other.first, u) < same && turns_apart(other.second, v) < same) return true;
  }
  if (search.found.count == search.most) return true;
  search.found.root[static_cast<std::size_t>(search.found.count++)] = {
      u, v, apart < Scalar(tolerance::curves_meet)};
  return true;
}

/// A turn that is as long as one but for rounding, brought to length one without a root.
template <typename Scalar>
Rotor<Scalar> unit_turn_again(const Rotor<Scalar>& u) {
  const Scalar square = u.cosine * u.cosine + u.sine * u.sine;
  return Scalar(Scalar(1.5) - Scalar(0.5) * square) * u;
}

/// Newton's steps from a candidate, two turns of length one; keeps where they end if both equations hold
/// there. Returns false else.
template <typename Scalar>
bool take_turns(const Rotor<Scalar>& at, const Rotor<Scalar>& with, TurnSearch<Scalar>& search) {
  // Middles of arcs have the digits of double; both corrections together give those of any scalar.
  Rotor<Scalar> u = unit_turn_again(unit_turn_again(at)), v = with;
  const Scalar still = Scalar(2) * epsilon<Scalar>(), rounding = Scalar(64) * epsilon<Scalar>(),
               most = Scalar(0.3);
  Scalar last(64);  // more than any gap
  Scalar apart(1);
  for (int step = 0; step < 40; ++step) {
    const Wave<Scalar> a = wave_of_second(search.e.one, u), b = wave_of_second(search.e.other, u);
    const Scalar gap_a = wave_at(a, v), gap_b = wave_at(b, v);
    const Scalar a_u = wave_at(wave_of_second_by_first(search.e.one, u), v), a_v = wave_slope(a, v);
    const Scalar b_u = wave_at(wave_of_second_by_first(search.e.other, u), v), b_v = wave_slope(b, v);
    const Scalar determinant = a_u * b_v - a_v * b_u;
    const Scalar size = (magnitude(a_u) + magnitude(a_v)) * (magnitude(b_u) + magnitude(b_v));
    apart = size > Scalar(0) ? Scalar(magnitude(determinant) / size) : Scalar(0);
    // Further steps would follow rounding alone: solutions meet here.
    const Scalar gap = magnitude(gap_a) + magnitude(gap_b);
    if (gap < rounding && !(gap < Scalar(0.5) * last)) break;
    last = gap;
    if (!(apart > Scalar(tolerance::curves_touch))) break;
    const Scalar share = Scalar(1) / determinant;
    Scalar du = (a_v * gap_b - b_v * gap_a) * share, dv = (b_u * gap_a - a_u * gap_b) * share;
    const Scalar longest = magnitude(du) < magnitude(dv) ? magnitude(dv) : magnitude(du);
    if (!(longest < Scalar(tolerance::lost_turn))) return false;
    if (longest > most) {
      du = du * most / longest;
      dv = dv * most / longest;
    }
    u = turned_by(u, du);
    v = turned_by(v, dv);
    // The rest is at most the square of the step, magnified where curves nearly touch.
    const Scalar magnified = Scalar(tolerance::step_to_rest) * longest;
    if (longest < still || magnified * magnified < still * apart * apart) break;
  }
  return keep_turns(unit_turn_again(u), unit_turn_again(v), apart, search);
}

/// Tries u with the v that both waves have in common. Returns false if they tell none.
template <typename Scalar>
bool take_common_turn(const Rotor<Scalar>& u, TurnSearch<Scalar>& search) {
  using std::sqrt;
  const Wave<Scalar> common =
      crossed_waves(wave_of_second(search.e.one, u), wave_of_second(search.e.other, u));
  const Scalar square = common.c * common.c + common.s * common.s;
  if (!(square > Scalar(tolerance::common_wave))) return false;
  const Scalar scale = with_sign(Scalar(Scalar(1) / sqrt(square)), common.one);
  return take_turns(u, Rotor<Scalar>{scale * common.c, scale * common.s}, search);
}

/// Tries u with both v at which the longer wave vanishes: where the waves are (nearly) the same.
template <typename Scalar>
void take_both_turns(const Rotor<Scalar>& u, TurnSearch<Scalar>& search) {
  using std::sqrt;
  const Wave<Scalar> a = wave_of_second(search.e.one, u), b = wave_of_second(search.e.other, u);
  const Scalar square_a = a.c * a.c + a.s * a.s, square_b = b.c * b.c + b.s * b.s;
  const Wave<Scalar> wave = square_a < square_b ? b : a;
  const Scalar square = square_a < square_b ? square_b : square_a;
  if (!(square > Scalar(tolerance::flat_wave))) return;
  const Scalar foot = -wave.one / square, height_square = Scalar(1) / square - foot * foot;
  const Scalar height = height_square > Scalar(0) ? Scalar(sqrt(height_square)) : Scalar(0);
  take_turns(u, unit_turn(Rotor<Scalar>{foot * wave.c - height * wave.s, foot * wave.s + height * wave.c}),
             search);
  take_turns(u, unit_turn(Rotor<Scalar>{foot * wave.c + height * wave.s, foot * wave.s - height * wave.c}),
             search);
}

template <typename Scalar>
void try_turns(const Rotor<Scalar>& u, TurnSearch<Scalar>& search) {
  take_common_turn(u, search);
  take_both_turns(u, search);
}

/// How far the nearest root of a jet is, by the series of its inverse: what is left is of the fourth order.
template <typename Scalar>
Scalar way_to_root(const Jet<Scalar>& at) {
  const Scalar share = Scalar(1) / at.slope;
  const Scalar way = -at.value * share, bend = Scalar(0.5) * at.curvature * share;
  return way * (Scalar(1) + way * ((Scalar(2) * bend * bend - at.third * share / Scalar(6)) * way - bend));
}

/// Steps to the arc's root, where the slope has one sign. Newton's on both equations do the rest. `half`:
/// half of the arc's length, rad.
template <typename Scalar>
void take_one_root(const Rotor<Scalar>& middle, const Jet<Scalar>& start, const Scalar& half,
                   TurnSearch<Scalar>& search) {
  Jet<Scalar> at = start;
  Rotor<Scalar> u = middle;
  const Scalar farthest = Scalar(1.01) * half;
  Scalar from(0);
  for (int step = 0; step < 8; ++step) {
    Scalar to = from + way_to_root(at);
    const bool is_inside = magnitude(to) <= farthest;
    if (!is_inside) {
      if (magnitude(from) == farthest) return;  // the root is outside
      to = with_sign(farthest, to);
    }
    const Scalar way = to - from;
    from = to;
    u = turned_by(u, Scalar(way + way * way * way / Scalar(12)));
    if (is_inside && magnitude(way) < Scalar(tolerance::next_to_root)) break;
    at = jet_at(search.f, u);
  }
  if (!take_common_turn(u, search)) take_both_turns(u, search);
}

/// Tries the places where the arc's parabola vanishes, or is nearest to zero.
template <typename Scalar>
void take_close_roots(const Rotor<Scalar>& middle, const Jet<Scalar>& at, const Scalar& half,
                      TurnSearch<Scalar>& search) {
  using std::sqrt;
  const Scalar most = Scalar(4) * half;
  const Scalar centre = -at.slope / at.curvature;
  const Scalar square = centre * centre - Scalar(2) * at.value / at.curvature;
  const Scalar off = square > Scalar(0) ? Scalar(sqrt(square)) : Scalar(0);
  if (!(magnitude(at.curvature) > Scalar(0)) || magnitude(centre) > most || off > most) {
    try_turns(middle, search);
    return;
  }
  try_turns(turned_by(middle, Scalar(centre - off)), search);
  if (off > Scalar(0)) try_turns(turned_by(middle, Scalar(centre + off)), search);
}

/// True if the slope changes by less than it is in the middle of the arc, which is h to either side.
template <typename Scalar>
bool has_one_slope(const Jet<Scalar>& at, const Scalar& h, const Scalar& fourth) {
  const Scalar bend = magnitude(at.third) + fourth * h / Scalar(3);
  return magnitude(at.slope) > (magnitude(at.curvature) + bend * h / Scalar(2)) * h;
}

/// How much farther the arc's parabola stays from zero than the polynomial from the parabola: where this is
/// positive the arc has no root. Without a branch, so that loops over arcs are done in lanes.
template <typename Scalar>
Scalar excess_of_value(const Scalar& value, const Scalar& slope, const Scalar& curvature, const Scalar& third,
                       const Scalar& h, const Scalar& fourth, const Scalar& noise) {
  const Scalar steep = magnitude(slope) + noise;  // never zero
  const Scalar bend = value < Scalar(0) ? Scalar(-curvature) : curvature;
  const Scalar farthest = (magnitude(third) + fourth * h / Scalar(4)) * (h * h * h / Scalar(6)) + noise;
  // The parabola comes down until its slope is zero, or to the arc's end.
  const Scalar way = steep / larger(steep, Scalar(bend * h)) * h;
  return magnitude(value) - (steep - bend * way / Scalar(2)) * way - farthest;
}

inline constexpr int most_arcs = 1500;
inline constexpr int arc_depths = 8;
inline constexpr double half_of_first_arc = 0.09817477042468103;  ///< pi / 32

/// Cosines and sines of half of a first arc, of half of that, ...
inline constexpr std::array<double, 9> arc_cosines = {
    0.9951847266721969, 0.9987954562051724, 0.9996988186962042, 0.9999247018391445, 0.9999811752826011,
    0.9999952938095762, 0.9999988234517019, 0.9999997058628822, 0.9999999264657179};
inline constexpr std::array<double, 9> arc_sines = {
    0.0980171403295606,    0.049067674327418015,  0.024541228522912288,
    0.012271538285719925,  0.006135884649154475,  0.003067956762965976,
    0.0015339801862847655, 0.0007669903187427045, 0.00038349518757139556};

/// Halves an arc that may have a root, whose middle has the jet `at`, until it has a verdict, at most
/// `arc_depths` times. Counts `visits`, of which there are at most `most_arcs`.
template <typename Scalar>
void visit_arc(const Rotor<Scalar>& middle, const Jet<Scalar>& at, const Scalar& half, int depth,
               TurnSearch<Scalar>& search) {
  if (++search.visits >= most_arcs) return;
  const Scalar h = Scalar(1.0001) * half;
  if (has_one_slope(at, h, search.fourth)) {
    take_one_root(middle, at, half, search);
  } else if (depth > arc_depths) {
    take_close_roots(middle, at, half, search);
  } else {
    const Rotor<Scalar> turn = {Scalar(arc_cosines[static_cast<std::size_t>(depth)]),
                                Scalar(arc_sines[static_cast<std::size_t>(depth)])};
    const Rotor<Scalar> left = middle * inverse(turn), right = middle * turn;
    const TwoJets<Scalar> jets = jets_at(search.f, left, right);
    const Jet<Scalar> first = {jets.value[0], jets.slope[0], jets.curvature[0], jets.third[0]};
    const Jet<Scalar> second = {jets.value[1], jets.slope[1], jets.curvature[1], jets.third[1]};
    const Scalar next = half / Scalar(2), reach = Scalar(1.0001) * next;
    std::array<Scalar, 2> excess;
    for (std::size_t i = 0; i < 2; ++i)
      excess[i] = excess_of_value(jets.value[i], jets.slope[i], jets.curvature[i], jets.third[i], reach,
                                  search.fourth, search.noise);
    if (!(excess[0] > Scalar(0))) visit_arc(left, first, next, depth + 1, search);
    if (!(excess[1] > Scalar(0))) visit_arc(right, second, next, depth + 1, search);
  }
}

/// Visits the arcs of the whole circle, but for those that have no root.
template <typename Scalar>
void visit_circle(TurnSearch<Scalar>& search) {
  const FirstJets<Scalar> jets = first_jets(search.f);
  const Scalar h = Scalar(1.0001) * Scalar(half_of_first_arc), fourth = search.fourth, noise = search.noise;
  std::array<Scalar, 32> excess;
  for (std::size_t i = 0; i < 32; ++i)
    excess[i] =
        excess_of_value(jets.value[i], jets.slope[i], jets.curvature[i], jets.third[i], h, fourth, noise);
  for (std::size_t i = 0; i < 32; ++i) {
    if (!(excess[i] > Scalar(0))) {
      const std::size_t k = i % 8;
      const Scalar side = i < 16 ? Scalar(1) : Scalar(-1);
      const Scalar c = side * Scalar(middle_cosines[k]), s = side * Scalar(middle_sines[k]);
      const bool is_on = i % 16 > 7;  // by a quarter turn
      const Rotor<Scalar> middle = {is_on ? Scalar(-s) : c, is_on ? c : s};
      const Jet<Scalar> at = {jets.value[i], jets.slope[i], jets.curvature[i], jets.third[i]};
      visit_arc(middle, at, Scalar(half_of_first_arc), 1, search);
    }
  }
}

/// The largest of three coefficients' magnitudes.
template <typename Scalar>
Scalar largest_of_three(const Scalar& a, const Scalar& b, const Scalar& c) {
  return larger(Scalar(larger(magnitude(a), magnitude(b))), magnitude(c));
}

/// An equation with its largest coefficient one; all zeros stay.
template <typename Scalar>
TwoTurnsEquation<Scalar> with_largest_one(const TwoTurnsEquation<Scalar>& m) {
  const Scalar n =
      largest_of_three(largest_of_three(m.c00, m.c01, m.c02), largest_of_three(m.c10, m.c11, m.c12),
                       largest_of_three(m.c20, m.c21, m.c22));
  if (!(n > Scalar(0))) return m;
  return {m.c00 / n, m.c01 / n, m.c02 / n, m.c10 / n, m.c11 / n, m.c12 / n, m.c20 / n, m.c21 / n, m.c22 / n};
}

}  // namespace two_turns_cases

/// All pairs of angles at which both equations vanish. `at_most_six`: so it is known of a planar platform.
template <typename Scalar>
TurnPairs<Scalar> two_turns(const TwoTurnsEquation<Scalar>& one, const TwoTurnsEquation<Scalar>& other,
                            bool at_most_six) {
  using std::sqrt;
  two_turns_cases::TurnSearch<Scalar> search;
  search.e = {two_turns_cases::with_largest_one(one), two_turns_cases::with_largest_one(other)};
  search.f = two_turns_cases::eliminated_turn(search.e);
  search.fourth = two_turns_cases::fourth_bound(search.f);
  // The values of its three squares are as large as the roots of its size.
  search.noise = Scalar(32) * epsilon<Scalar>() * Scalar(sqrt(search.fourth));
  if (at_most_six) search.most = 6;
  two_turns_cases::visit_circle(search);
  if (search.visits < two_turns_cases::most_arcs) return search.found;
  const Scalar none = not_a_number<Scalar>();
  TurnPairs<Scalar> lost;
  lost.count = 1;
  lost.root[0] = {{none, none}, {none, none}, true};
  return lost;
}

}  // namespace qvgen::inverse
