// SPDX-License-Identifier: MIT
// Two angles from two equations that are linear in the cosine and sine of each: two rods that hold an ankle,
// three that hold a planar platform. One angle is eliminated; what is left is a trigonometric polynomial of
// degree four in the other, so there are at most eight solutions. Its roots are isolated on the whole circle:
// an arc without a root is proved to have none by bounds of the derivatives, a root is alone in an arc where
// the slope has one sign. Short arcs without either verdict hold solutions that (nearly) meet. Newton's steps
// on the two equations themselves decide about every candidate, so the elimination costs no digits.
#pragma once

#include <array>
#include <limits>
#include <type_traits>

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

/// Candidates, tried by Newton's steps on both equations, and the solutions among them, each once.
template <typename Scalar>
class Solutions {
 public:
  Solutions(const TwoTurns<Scalar>& e, int most) : e_(e), most_(most) {}

  /// Tries u with the v that both waves have in common, if they tell one.
  bool take_common(const Rotor<Scalar>& u) {
    using std::sqrt;
    const Wave<Scalar> common = cross(of_second(e_.rows[0], u), of_second(e_.rows[1], u));
    const Scalar square = common.c * common.c + common.s * common.s;
    if (!(square > Scalar(tolerance::common_wave))) return false;
    const Scalar scale = with_sign(Scalar(Scalar(1) / sqrt(square)), common.one);
    return take(u, {scale * common.c, scale * common.s});
  }
  /// Tries u with both v at which the longer wave vanishes: where the waves are (nearly) the same.
  void take_both(const Rotor<Scalar>& u) {
    using std::sqrt;
    const Wave<Scalar> a = of_second(e_.rows[0], u), b = of_second(e_.rows[1], u);
    const Scalar square_a = a.c * a.c + a.s * a.s, square_b = b.c * b.c + b.s * b.s;
    const Wave<Scalar>& wave = square_a < square_b ? b : a;
    const Scalar square = square_a < square_b ? square_b : square_a;
    if (!(square > Scalar(tolerance::flat_wave))) return;
    const Scalar foot = -wave.one / square, height_square = Scalar(1) / square - foot * foot;
    const Scalar height = height_square > Scalar(0) ? Scalar(sqrt(height_square)) : Scalar(0);
    take(u, normalised({foot * wave.c - height * wave.s, foot * wave.s + height * wave.c}));
    take(u, normalised({foot * wave.c + height * wave.s, foot * wave.s - height * wave.c}));
  }
  [[nodiscard]] const TurnPairs<Scalar>& found() const { return found_; }

 private:
  static Rotor<Scalar> normalised(const Rotor<Scalar>& u) {
    using std::sqrt;
    return Scalar(Scalar(1) / sqrt(Scalar(u.cosine * u.cosine + u.sine * u.sine))) * u;
  }
  static Scalar distance(const Rotor<Scalar>& a, const Rotor<Scalar>& b) {
    return magnitude(a.cosine - b.cosine) + magnitude(a.sine - b.sine);
  }

  /// Newton's steps from a candidate; keeps where they end if both equations hold there.
  bool take(const Rotor<Scalar>& at, const Rotor<Scalar>& with) {
    Rotor<Scalar> u = normalised(at), v = normalised(with);
    const Scalar still = Scalar(2) * epsilon<Scalar>(), rounding = Scalar(64) * epsilon<Scalar>(), most(0.3);
    Scalar last(64);  // more than any gap
    Scalar apart(1);  // 0 where both equations' curves touch
    for (int step = 0; step < 40; ++step) {
      const Wave<Scalar> a = of_second(e_.rows[0], u), b = of_second(e_.rows[1], u);
      const Scalar gap_a = dot(a, v), gap_b = dot(b, v);
      const Scalar a_u = dot(of_second_by_first(e_.rows[0], u), v), a_v = slope(a, v);
      const Scalar b_u = dot(of_second_by_first(e_.rows[1], u), v), b_v = slope(b, v);
      const Scalar determinant = a_u * b_v - a_v * b_u;
      const Scalar size = (magnitude(a_u) + magnitude(a_v)) * (magnitude(b_u) + magnitude(b_v));
      apart = size > Scalar(0) ? Scalar(magnitude(determinant) / size) : Scalar(0);
      // Further steps would follow rounding alone: solutions meet here.
      const Scalar gap = magnitude(gap_a) + magnitude(gap_b);
      if (gap < rounding && !(gap < Scalar(0.5) * last)) break;
      last = gap;
      if (!(apart > Scalar(tolerance::curves_touch))) break;
      Scalar du = (a_v * gap_b - b_v * gap_a) / determinant, dv = (b_u * gap_a - a_u * gap_b) / determinant;
      const Scalar longest = magnitude(du) < magnitude(dv) ? magnitude(dv) : magnitude(du);
      if (!(longest < Scalar(tolerance::lost_turn))) return false;
      if (longest > most) {
        du = du * most / longest;
        dv = dv * most / longest;
      }
      u = turned_by(u, du);
      v = turned_by(v, dv);
      if (longest < still) break;
    }
    return keep(normalised(u), normalised(v), apart);
  }

  /// Keeps a solution, but for one that is there: as near as rounding may have moved it.
  bool keep(const Rotor<Scalar>& u, const Rotor<Scalar>& v, const Scalar& apart) {
    const Scalar enough = Scalar(tolerance::equation_rounding) * epsilon<Scalar>();
    for (const auto& m : e_.rows)
      if (!(magnitude(dot(of_second(m, u), v)) < enough)) return false;
    const bool meets = apart < Scalar(tolerance::curves_meet);
    const Scalar least(tolerance::same_turn), most(tolerance::same_turn_at_most);
    const Scalar moved = Scalar(tolerance::turn_rounding) * epsilon<Scalar>();
    const Scalar same = most * apart < moved ? most : moved < least * apart ? least : Scalar(moved / apart);
    for (int i = 0; i < found_.count; ++i) {
      const TurnPair<Scalar>& other = found_.root[static_cast<std::size_t>(i)];
      if (distance(other.first, u) < same && distance(other.second, v) < same) return true;
    }
    if (found_.count < most_) found_.root[static_cast<std::size_t>(found_.count++)] = {u, v, meets};
    return true;
  }

  const TwoTurns<Scalar>& e_;
  int most_;
  TurnPairs<Scalar> found_;
};

/// Arcs of the circle, halved until each has a verdict.
template <typename Scalar>
class Circle {
 public:
  Circle(const TwoTurns<Scalar>& e, const Harmonics<Scalar, 4>& f, int most)
      : f_(f), fourth_(fourth_bound(f)), noise_(noise_of(fourth_)), solutions_(e, most) {}

  /// False if arcs without a verdict are so many that the equations hold along a curve.
  bool search() {
    std::array<Rotor<Scalar>, half_of_arcs> middles;
    for (std::size_t i = 0; i < half_of_arcs; ++i)
      middles[i] = {Scalar(first_middles[i][0]), Scalar(first_middles[i][1])};
    const Jets<Scalar, 2 * half_of_arcs> at = jets_across(f_, middles);
    for (std::size_t i = 0; i < half_of_arcs; ++i) visit(middles[i], at.at(i), half_of_first, 1);
    for (std::size_t i = 0; i < half_of_arcs; ++i)
      visit({-middles[i].cosine, -middles[i].sine}, at.at(half_of_arcs + i), half_of_first, 1);
    return visits_ < most_visits;
  }
  [[nodiscard]] const TurnPairs<Scalar>& found() const { return solutions_.found(); }

 private:
  using Places = std::array<Rotor<Scalar>, 2>;
  static constexpr int most_visits = 1500;
  static constexpr std::size_t half_of_arcs = 8;
  static constexpr std::size_t depths = 9;
  static constexpr double half_of_first = 3.14159265358979323846 / (2 * half_of_arcs);
  /// Cosine and sine of the middles of the first arcs from -pi to 0.
  static constexpr double first_middles[half_of_arcs][2] = {
      {-0.9807852804032304, -0.1950903220161286}, {-0.8314696123025453, -0.5555702330196022},
      {-0.555570233019602, -0.8314696123025455},  {-0.1950903220161282, -0.9807852804032304},
      {0.19509032201612833, -0.9807852804032304}, {0.5555702330196021, -0.8314696123025453},
      {0.8314696123025453, -0.5555702330196021},  {0.9807852804032304, -0.19509032201612847}};
  /// Cosine and sine of half_of_first, of half of it, ...
  static constexpr double turns[depths + 1][2] = {
      {0.9807852804032304, 0.19509032201612825},   {0.9951847266721969, 0.0980171403295606},
      {0.9987954562051724, 0.049067674327418015},  {0.9996988186962042, 0.024541228522912288},
      {0.9999247018391445, 0.012271538285719925},  {0.9999811752826011, 0.006135884649154475},
      {0.9999952938095762, 0.003067956762965976},  {0.9999988234517019, 0.0015339801862847655},
      {0.9999997058628822, 0.0007669903187427045}, {0.9999999264657179, 0.00038349518757139556}};

  static Rotor<Scalar> turn_by(std::size_t depth) {
    return {Scalar(turns[depth][0]), Scalar(turns[depth][1])};
  }
  /// Rounding in the polynomial's values: those of its three squares are as large as the roots of its size.
  static Scalar noise_of(const Scalar& size) {
    using std::sqrt;
    return Scalar(32) * epsilon<Scalar>() * Scalar(sqrt(size));
  }

  /// Two arcs of one length, the first one first.
  void visit(const Places& middles, double half, std::size_t depth) {
    const Jets<Scalar, 2> at = jets(f_, middles);
    for (std::size_t i = 0; i < 2; ++i) visit(middles[i], at.at(i), half, depth);
  }

  void visit(const Rotor<Scalar>& middle, const Jet<Scalar>& at, double half, std::size_t depth) {
    if (++visits_ >= most_visits) return;
    const Scalar h(1.0001 * half);
    if (has_no_root(at, h)) return;
    if (has_one_slope(at, h)) return one_root(middle, at, half);
    if (depth > depths) return close_roots(middle, at, half);
    const Rotor<Scalar> turn = turn_by(depth);
    visit({middle * inverse(turn), middle * turn}, half / 2, depth + 1);
  }

  /// True if the slope changes by less than it is in the middle of the arc.
  bool has_one_slope(const Jet<Scalar>& at, const Scalar& h) const {
    const Scalar bend = magnitude(at.third) + fourth_ * h / Scalar(3);
    return magnitude(at.slope) > (magnitude(at.curvature) + bend * h / Scalar(2)) * h;
  }
  /// True if the arc's parabola stays farther from zero than the polynomial from the parabola.
  bool has_no_root(const Jet<Scalar>& at, const Scalar& h) const {
    const Scalar steep = magnitude(at.slope), bend = flipped_by(at.value, at.curvature);
    const Scalar farthest =
        (magnitude(at.third) + fourth_ * h / Scalar(4)) * (h * h * h / Scalar(6)) + noise_;
    const Scalar down = steep < bend * h ? Scalar(steep * steep / (Scalar(2) * bend))
                                         : Scalar((steep - bend * h / Scalar(2)) * h);
    return magnitude(at.value) - down > farthest;
  }
  /// The number with its sign changed where that of `by` is below zero.
  static Scalar flipped_by(const Scalar& by, const Scalar& number) {
    return by < Scalar(0) ? Scalar(-number) : number;
  }

  /// Newton's steps within the arc, where the slope has one sign. Those on both equations do the rest.
  void one_root(const Rotor<Scalar>& middle, const Jet<Scalar>& start, double half) {
    Jet<Scalar> at = start;
    Rotor<Scalar> u = middle;
    Scalar from(0);
    for (int step = 0; step < 8; ++step) {
      Scalar to = from - at.value / at.slope;
      if (magnitude(to) > Scalar(1.01 * half)) {
        if (magnitude(from) == Scalar(1.01 * half)) return;  // the root is outside
        to = with_sign(Scalar(1.01 * half), to);
      }
      const bool is_still = magnitude(to - from) < Scalar(tolerance::next_to_root);
      from = to;
      u = turned_by(middle, from);
      if (is_still) break;
      at = jets<Scalar, 1>(f_, {u}).at(0);
    }
    if (!solutions_.take_common(u)) solutions_.take_both(u);
  }

  /// Tries the places where the arc's parabola vanishes, or is nearest to zero.
  void close_roots(const Rotor<Scalar>& middle, const Jet<Scalar>& at, double half) {
    using std::sqrt;
    const Scalar most(4 * half);
    if (!(magnitude(at.curvature) > Scalar(0))) return try_all(middle);
    const Scalar centre = -at.slope / at.curvature;
    const Scalar square = centre * centre - Scalar(2) * at.value / at.curvature;
    if (magnitude(centre) > most) return try_all(middle);
    const Scalar off = square > Scalar(0) ? Scalar(sqrt(square)) : Scalar(0);
    if (off > most) return try_all(middle);
    try_all(turned_by(middle, Scalar(centre - off)));
    if (off > Scalar(0)) try_all(turned_by(middle, Scalar(centre + off)));
  }
  void try_all(const Rotor<Scalar>& u) {
    solutions_.take_common(u);
    solutions_.take_both(u);
  }

  const Harmonics<Scalar, 4>& f_;
  Scalar fourth_, noise_;
  Solutions<Scalar> solutions_;
  int visits_ = 0;
};

/// An equation with its largest coefficient one; all zeros stay.
template <typename Scalar>
TwoTurnsEquation<Scalar> scaled(TwoTurnsEquation<Scalar> m) {
  Scalar largest(0);
  for (const Scalar& each : m)
    if (!(magnitude(each) < largest)) largest = magnitude(each);
  if (largest > Scalar(0))
    for (Scalar& each : m) each = each / largest;
  return m;
}

}  // namespace two_turns_cases

/// All pairs of angles at which both equations vanish. `at_most_six`: so it is known of a planar platform.
template <typename Scalar>
TurnPairs<Scalar> two_turns(const TwoTurnsEquation<Scalar>& one, const TwoTurnsEquation<Scalar>& other,
                            bool at_most_six) {
  const TwoTurns<Scalar> e{{two_turns_cases::scaled(one), two_turns_cases::scaled(other)}};
  const auto f = two_turns_cases::eliminated(e);
  two_turns_cases::Circle<Scalar> circle(e, f, at_most_six ? 6 : 8);
  if (circle.search()) return circle.found();
  TurnPairs<Scalar> lost;
  if constexpr (std::is_floating_point_v<Scalar>) {
    constexpr Scalar none = std::numeric_limits<Scalar>::quiet_NaN();
    lost.count = 1;
    lost.root[0] = {{none, none}, {none, none}, true};
  }
  return lost;
}

}  // namespace qvgen::inverse
