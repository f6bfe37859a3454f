// SPDX-License-Identifier: MIT
// Two angles from two equations that are linear in the cosine and sine of each: two rods that hold an ankle,
// three that hold a planar platform. One angle is eliminated; what is left is a trigonometric polynomial of
// degree four in the other, so there are at most eight solutions. Its roots are isolated on the whole circle:
// an arc without a root is proved to have none by bounds of the derivatives, a root is alone in an arc where
// the slope has one sign. Short arcs without either verdict hold solutions that (nearly) meet. Newton's steps
// on the two equations themselves decide about every candidate, so the elimination costs no digits.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <qvgen/inverse/angles.h>

namespace qvgen::inverse {

/// sum of m[3 j + k] a_j b_k with a = (1, cos u, sin u) and b = (1, cos v, sin v).
template <typename Scalar>
using TwoTurnsEquation = std::array<Scalar, 9>;

/// Both equations, which are to vanish.
template <typename Scalar>
struct TwoTurns {
  std::array<TwoTurnsEquation<Scalar>, 2> rows;
};

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

/// one + c cos + s sin of an angle.
template <typename Scalar>
struct Wave {
  Scalar one, c, s;
};

template <typename Scalar>
Scalar dot(const Wave<Scalar>& wave, const Rotor<Scalar>& at) {
  return wave.one + wave.c * at.cosine + wave.s * at.sine;
}
template <typename Scalar>
Scalar slope(const Wave<Scalar>& wave, const Rotor<Scalar>& at) {
  return wave.s * at.cosine - wave.c * at.sine;
}

/// An equation at a value of u: a wave of v.
template <typename Scalar>
Wave<Scalar> of_second(const TwoTurnsEquation<Scalar>& m, const Rotor<Scalar>& u) {
  const auto entry = [&](std::size_t k) { return m[k] + m[3 + k] * u.cosine + m[6 + k] * u.sine; };
  return {entry(0), entry(1), entry(2)};
}
/// Its derivative by u.
template <typename Scalar>
Wave<Scalar> of_second_by_first(const TwoTurnsEquation<Scalar>& m, const Rotor<Scalar>& u) {
  const auto entry = [&](std::size_t k) { return m[6 + k] * u.cosine - m[3 + k] * u.sine; };
  return {entry(0), entry(1), entry(2)};
}

template <typename Scalar>
Wave<Scalar> cross(const Wave<Scalar>& a, const Wave<Scalar>& b) {
  return {a.c * b.s - a.s * b.c, a.s * b.one - a.one * b.s, a.one * b.c - a.c * b.one};
}

/// Real trigonometric polynomial: the coefficients of e^(i k u) for k = 0, ..., degree; those of -k are their
/// conjugates.
template <typename Scalar, std::size_t degree>
using Harmonics = std::array<Rotor<Scalar>, degree + 1>;

template <typename Scalar>
Harmonics<Scalar, 1> harmonics(const Scalar& one, const Scalar& c, const Scalar& s) {
  const Scalar half(0.5);
  return {{{one, Scalar(0)}, {half * c, -half * s}}};
}

template <typename Scalar, std::size_t degree>
Harmonics<Scalar, 2 * degree> product(const Harmonics<Scalar, degree>& a,
                                      const Harmonics<Scalar, degree>& b) {
  constexpr int n = static_cast<int>(degree);
  const auto of = [](const Harmonics<Scalar, degree>& f, int k) {
    return k < 0 ? inverse(f[static_cast<std::size_t>(-k)]) : f[static_cast<std::size_t>(k)];
  };
  Harmonics<Scalar, 2 * degree> result;
  for (int k = 0; k <= 2 * n; ++k) {
    Rotor<Scalar> sum{Scalar(0), Scalar(0)};
    for (int j = k - n; j <= n; ++j) {
      const Rotor<Scalar> term = of(a, j) * of(b, k - j);
      sum = {sum.cosine + term.cosine, sum.sine + term.sine};
    }
    result[static_cast<std::size_t>(k)] = sum;
  }
  return result;
}

template <typename Scalar, std::size_t degree>
void add(Harmonics<Scalar, degree>& sum, double factor, const Harmonics<Scalar, degree>& f) {
  for (std::size_t k = 0; k <= degree; ++k) {
    sum[k].cosine = sum[k].cosine + Scalar(factor) * f[k].cosine;
    sum[k].sine = sum[k].sine + Scalar(factor) * f[k].sine;
  }
}

/// The second angle eliminated: (1, cos v, sin v) is along the cross product of both waves, whose entries are
/// polynomials in u; cos² + sin² = 1 makes them one of degree four.
template <typename Scalar>
Harmonics<Scalar, 4> eliminated(const TwoTurns<Scalar>& e) {
  const auto wave = [&](std::size_t row, std::size_t k) {
    const auto& m = e.rows[row];
    return harmonics(m[k], m[3 + k], m[6 + k]);
  };
  Harmonics<Scalar, 4> sum{};
  for (Rotor<Scalar>& each : sum) each = {Scalar(0), Scalar(0)};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    Harmonics<Scalar, 2> entry = product<Scalar, 1>(wave(0, i), wave(1, j));
    add<Scalar, 2>(entry, -1, product<Scalar, 1>(wave(0, j), wave(1, i)));
    add<Scalar, 4>(sum, k == 0 ? -1 : 1, product<Scalar, 2>(entry, entry));
  }
  return sum;
}

/// Value and two derivatives of a polynomial.
template <typename Scalar>
struct Jet {
  Scalar value, slope, curvature;
};

template <typename Scalar>
Jet<Scalar> jet(const Harmonics<Scalar, 4>& f, const Rotor<Scalar>& u) {
  Jet<Scalar> result{f[0].cosine, Scalar(0), Scalar(0)};
  Rotor<Scalar> power = u;
  for (std::size_t k = 1; k <= 4; ++k) {
    const Rotor<Scalar> term = f[k] * power;
    const Scalar n(static_cast<double>(2 * k)), order(static_cast<double>(k));
    result.value = result.value + Scalar(2) * term.cosine;
    result.slope = result.slope - n * term.sine;
    result.curvature = result.curvature - n * order * term.cosine;
    if (k < 4) power = power * u;
  }
  return result;
}

/// Bound of the third derivative.
template <typename Scalar>
Scalar third_bound(const Harmonics<Scalar, 4>& f) {
  Scalar sum(0);
  for (std::size_t k = 1; k <= 4; ++k)
    sum = sum + Scalar(static_cast<double>(2 * k * k * k)) * (magnitude(f[k].cosine) + magnitude(f[k].sine));
  return sum;
}

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
    if (!(square > Scalar(1e-14))) return false;
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
    if (!(square > Scalar(1e-20))) return;
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
    Scalar last(1e6);
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
      if (!(apart > Scalar(1e-12))) break;
      Scalar du = (a_v * gap_b - b_v * gap_a) / determinant, dv = (b_u * gap_a - a_u * gap_b) / determinant;
      const Scalar longest = magnitude(du) < magnitude(dv) ? magnitude(dv) : magnitude(du);
      if (!(longest < Scalar(1e100))) return false;
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
    const Scalar enough = Scalar(4e3) * epsilon<Scalar>();
    for (const auto& m : e_.rows)
      if (!(magnitude(dot(of_second(m, u), v)) < enough)) return false;
    const bool meets = apart < Scalar(3e-6);
    const Scalar least(1e-9), moved = Scalar(450) * epsilon<Scalar>();
    const Scalar same = apart < Scalar(1e6) * moved ? Scalar(1e-6)
                        : moved < least * apart     ? least
                                                    : Scalar(moved / apart);
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
      : f_(f), third_(third_bound(f)), solutions_(e, most) {}

  /// False if arcs without a verdict are so many that the equations hold along a curve.
  bool search() {
    const Rotor<Scalar> first = turn_by(0), next = first * first;
    Rotor<Scalar> middle = {-first.cosine, -first.sine};
    for (int i = 0; i < first_arcs; ++i) {
      visit(middle, half_of_first, 1);
      middle = middle * next;
    }
    return visits_ < most_visits;
  }
  [[nodiscard]] const TurnPairs<Scalar>& found() const { return solutions_.found(); }

 private:
  static constexpr int first_arcs = 16, most_visits = 1500;
  static constexpr std::size_t depths = 9;
  static constexpr double half_of_first = 3.14159265358979323846 / first_arcs;
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

  void visit(const Rotor<Scalar>& middle, double half, std::size_t depth) {
    if (++visits_ >= most_visits) return;
    const Jet<Scalar> at = jet(f_, middle);
    const Scalar h(1.0001 * half), bend = magnitude(at.curvature) + third_ * h;
    if (magnitude(at.value) > (magnitude(at.slope) + bend * h / Scalar(2)) * h) return;
    if (magnitude(at.slope) > bend * h) return one_root(middle, at, half);
    if (depth > depths) return close_roots(middle, at, half);
    visit(middle * inverse(turn_by(depth)), half / 2, depth + 1);
    visit(middle * turn_by(depth), half / 2, depth + 1);
  }

  /// Newton's steps within the arc, where the slope has one sign.
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
      const bool is_still = magnitude(to - from) < Scalar(1e-9);
      from = to;
      u = turned_by(middle, from);
      if (is_still) break;
      at = jet(f_, u);
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
  Scalar third_;
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
