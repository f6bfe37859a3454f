// SPDX-License-Identifier: MIT
#pragma once

#include "candidate.h"

namespace qvgen::inverse::elimination {
namespace {

/// The real roots of a trigonometric polynomial of degree eight. Over each of eight arcs it is a polynomial
/// in Bernstein form: coefficients of one sign prove that there is no root, one change of sign that there is
/// one; else the arc is halved, down to where two roots are not told apart.
template <int width>
class RootFinder {
 public:
  /// `allowed`: a tenth of how far off zero the polynomial may be at a double root. `farthest`: only arcs
  /// nearer to 0 than this are looked at, rad. `may_be_faint`: faint stretches are put aside.
  RootFinder(const Trigonometric& f, double allowed, double farthest, bool may_be_faint, Candidates& found)
      : f_(f),
        may_be_faint_(may_be_faint),
        faint_below_(1e3 * larger_of(1e-12, 100 * f.noise)),
        tolerance_(larger_of(10 * allowed, faint_below_ / 1e3)),
        found_(found) {
    for (int k = 0; k <= degree; ++k) slope_[k] = {k * f.sine[k], -k * f.cosine[k]};
    for (int first = 0; first < arcs; first += width) look_at_arcs(first, farthest);
    while (cells_ > 0) in_lanes<width>(cells_, [this](auto lanes, int count) { halve<lanes>(count); });
    for (int first = 0; first < brackets_; first += width)
      in_lanes<width>(brackets_ - first, [&](auto lanes, int count) { close_in<lanes>(first, count); });
  }

 private:
  static constexpr int most_cells = 64;
  /// Shorter parts are not halved, in units of half an arc: about 0.8 mrad.
  static constexpr double smallest = 0.004;
  /// The least tolerance of a part, as a share of the largest coefficient of its arc.
  static constexpr double relative_tolerance = 1e-11;

  /// A part of an arc, from low to high: tangents of half angles, in units of the arc's largest. `tolerance`:
  /// of coefficients.
  struct Part {
    double low, high;
    int arc;
    double tolerance;
  };
  struct Cell {
    Part part;
    double control[controls];
  };
  struct Bracket {
    Part part;
    double at_low, at_high;
  };

  static Direction middle_of(int arc) { return {arc_table.cosine[1][arc], arc_table.sine[1][arc]}; }

  static Direction angle_of(int arc, double place) {
    const double t = tangent_of_arc * place, scale = 1 / (1 + t * t);
    return sum_of(middle_of(arc), {(1 - t * t) * scale, 2 * t * scale});
  }

  void look_at_arcs(int first, double farthest) {
    using T = Lanes<width>;
    T even[degree + 1], odd[degree + 1];
    even[0] = spread<T>(f_.cosine[0]);
    for (int k = 1; k <= degree; ++k) {
      const T c = load<width>(arc_table.cosine[k] + first), s = load<width>(arc_table.sine[k] + first);
      even[k] = f_.cosine[k] * c + f_.sine[k] * s;
      odd[k] = f_.sine[k] * c - f_.cosine[k] * s;
    }
    T control[controls];
    T largest{};
    for (int i = 0; i <= degree; ++i) {
      T e = even[0] * bernstein_table.cosine[i][0], o{};
      for (int k = 1; k <= degree; ++k) {
        e += even[k] * bernstein_table.cosine[i][k];
        o += odd[k] * bernstein_table.sine[i][k];
      }
      control[i] = e + o;
      control[controls - 1 - i] = e - o;
      const T most = magnitude_of(e) + magnitude_of(o);
      largest = most > largest ? most : largest;
    }
    Part parts[width];
    for (int i = 0; i < width; ++i) {
      const int arc = first + i;
      parts[i] = {-1, 1, arc, larger_of(tolerance_, relative_tolerance * largest[i])};
      constexpr double half_arc = 0.39269908169872414, half_turn = 3.1415926535897931;
      bool skip = farthest < half_turn && middle_of(arc).cosine < std::cos(farthest + half_arc);
      if (!skip && may_be_faint_ && largest[i] < faint_below_)
        skip = found_.add_faint(middle_of(arc), half_arc);
      if (skip)
        for (T& c : control) c[i] = 1e9;
    }
    sort(control, parts, width);
  }

  /// Sets the lanes that have no root for sure, and those that may have several. Coefficients within the
  /// tolerance may be rounding, and tell no sign.
  template <class T>
  static void count_changes(const T (&control)[controls], const T& tolerance, unsigned& none,
                            unsigned& several) {
    unsigned once = 0, twice = 0, before = sign_mask(control[0]);
    T least = magnitude_of(control[0]);
    for (int i = 1; i < controls; ++i) {
      const unsigned now = sign_mask(control[i]);
      const unsigned change = now ^ before;
      twice |= once & change;
      once |= change;
      before = now;
      const T size = magnitude_of(control[i]);
      least = size < least ? size : least;
    }
    const unsigned small = sign_mask(T(least - tolerance));
    none = ~once & ~small;
    several = twice | small;
  }

  template <class T>
  void sort(const T (&control)[controls], const Part* parts, int count) {
    T tolerance;
    for (unsigned i = 0; i < lane_count<T>; ++i)
      tolerance[i] = parts[static_cast<int>(i) < count ? i : 0].tolerance;
    unsigned none, several;
    count_changes(control, tolerance, none, several);
    for (int i = 0; i < count; ++i) {
      if ((none >> i & 1U) != 0) continue;
      if ((several >> i & 1U) == 0)
        add_bracket({parts[i], control[0][i], control[controls - 1][i]});
      else
        look_closer(control, i, parts[i]);
    }
  }

  /// A part that may have several roots: faint stretches are put aside, and where there is nothing but
  /// rounding smaller parts would tell no more.
  template <class T>
  void look_closer(const T (&control)[controls], int lane, const Part& part) {
    double largest = 0;
    for (const T& c : control) largest = larger_of(largest, std::fabs(c[lane]));
    const bool is_arc = part.high - part.low > 1.9;
    if (may_be_faint_ && !is_arc && largest < faint_below_ && put_aside(part)) return;
    if (!(largest < part.tolerance || part.high - part.low < smallest)) return add_cell(control, lane, part);
    if (is_monotonic(control, lane, part.tolerance)) return add_single_root(part);
    look_at_double_root(part, is_bent_to_one_side(control, lane, part.tolerance));
  }

  /// True if the polynomial rises or falls all over a part, so that it has one root at most. A coefficient's
  /// rounding is a hundredth of the tolerance, so a difference of two may be two hundredths: it has a sign if
  /// it is more than three.
  template <class T>
  static bool is_monotonic(const T (&control)[controls], int lane, double tolerance) {
    double least = 1e300, most = -1e300;
    for (int i = 1; i < controls; ++i) {
      const double rise = control[i][lane] - control[i - 1][lane];
      least = smaller_of(least, rise);
      most = larger_of(most, rise);
    }
    constexpr double sure = 1.0 / 32;
    return least > sure * tolerance || most < -sure * tolerance;
  }

  /// True if the polynomial bends to one side all over a part, so that it has two roots at most. Second
  /// differences have to be well above the tolerance, since halvings make them four times smaller each.
  template <class T>
  static bool is_bent_to_one_side(const T (&control)[controls], int lane, double tolerance) {
    double least = 1e300, most = -1e300;
    for (int i = 2; i < controls; ++i) {
      const double bend = control[i][lane] - 2 * control[i - 1][lane] + control[i - 2][lane];
      least = smaller_of(least, bend);
      most = larger_of(most, bend);
    }
    return least > 4 * tolerance || most < -4 * tolerance;
  }

  bool put_aside(const Part& part) {
    const Direction low = angle_of(part.arc, part.low), high = angle_of(part.arc, part.high);
    const Direction middle = angle_of(part.arc, (part.low + part.high) / 2);
    const double sine = high.sine * low.cosine - high.cosine * low.sine;
    const double cosine = high.cosine * low.cosine + high.sine * low.sine;
    return found_.add_faint(middle, std::atan2(sine, cosine) / 2);
  }

  void add_bracket(const Bracket& bracket) {
    found_.overflow = found_.overflow || brackets_ == most_cells;
    if (brackets_ < most_cells) bracket_[brackets_++] = bracket;
  }

  template <class T>
  void add_cell(const T (&control)[controls], int lane, const Part& part) {
    found_.overflow = found_.overflow || cells_ == most_cells;
    if (cells_ == most_cells) return;
    Cell& cell = cell_[cells_++];
    cell.part = part;
    for (int k = 0; k < controls; ++k) cell.control[k] = control[k][lane];
  }

  /// De Casteljau's algorithm on the last cells.
  template <int lanes>
  void halve(int count) {
    using T = Lanes<lanes>;
    cells_ -= count;
    T control[controls], other[controls];
    Part low[lanes], high[lanes];
    for (int i = 0; i < lanes; ++i) {
      const Cell& cell = cell_[cells_ + (i < count ? i : 0)];
      low[i] = high[i] = cell.part;
      low[i].high = high[i].low = (cell.part.low + cell.part.high) / 2;
      for (int k = 0; k < controls; ++k) control[k][i] = cell.control[k];
    }
    T work[controls];
    for (int k = 0; k < controls; ++k) work[k] = control[k];
    other[controls - 1] = work[controls - 1];
#pragma GCC unroll 16
    for (int j = 1; j < controls; ++j) {
#pragma GCC unroll 16
      for (int k = 0; k < controls - j; ++k) work[k] = 0.5 * (work[k] + work[k + 1]);
      control[j] = work[0];
      other[controls - 1 - j] = work[controls - 1 - j];
    }
    sort(control, low, count);
    sort(other, high, count);
  }

  static double width_of(const Part& part) { return 2 * tangent_of_arc * (part.high - part.low); }

  /// Turns from the middle of a part.
  static Direction beside_middle(const Part& part, double turn) {
    return sum_of(angle_of(part.arc, (part.low + part.high) / 2), {std::cos(turn), std::sin(turn)});
  }

  /// Adds the root of a part in which the polynomial is monotonic, next to one of its ends, or none.
  void add_single_root(const Part& part) {
    const double farthest = 0.6 * width_of(part);
    double root = 0;
    for (int step = 0; step < 4; ++step) {
      const Value v = value_at(f_, beside_middle(part, root));
      root -= v.value / v.slope;
      if (!(std::fabs(root) < farthest)) return add_unsteady_root(part);
    }
    found_.add_once(beside_middle(part, root), 0);
  }

  /// Adds the middle of a part that has a root to which Newton's steps do not lead.
  void add_unsteady_root(const Part& part) {
    const double low = value_at(f_, angle_of(part.arc, part.low)).value;
    const double high = value_at(f_, angle_of(part.arc, part.high)).value;
    if (low * high < 0) found_.add_once(beside_middle(part, 0), width_of(part));
  }

  /// Adds the roots of the parabola about a stationary point, or of one that is a tolerance off: there two
  /// roots are too near to be told apart, or the polynomial hardly misses zero. What is no parabola may have
  /// roots elsewhere in the part.
  void look_at_double_root(const Part& part, bool are_all) {
    const double width_of_part = width_of(part);
    double by = 0;
    const auto at = [&](double turn) { return beside_middle(part, turn); };
    Value v = value_at(f_, at(0));
    for (int step = 0; step < 3; ++step) {
      const double next = by - v.slope / v.bend;
      if (!(std::fabs(next) < 2 * width_of_part)) break;
      by = next;
      v = value_at(f_, at(by));
    }
    const double square = -2 * v.value / v.bend;
    if (std::fabs(v.value) > 30 * part.tolerance && square < 0) {
      if (!are_all) found_.add_once(at(0), width_of_part);
      return;
    }
    const double unsure = smaller_of(0.01, 2 * part.tolerance / std::fabs(v.bend));
    const double apart = std::sqrt(larger_of(unsure, square));
    if (are_all) return found_.add_twins(at(by - apart), at(by + apart), apart);
    found_.add_once(at(by - apart), apart);
    found_.add_once(at(by + apart), apart);
  }

  /// Newton steps kept in their brackets.
  template <int lanes>
  void close_in(int first, int count) {
    using T = Lanes<lanes>;
    T low, high, at_low, at_high, c0, s0;
    for (int i = 0; i < lanes; ++i) {
      const Bracket& b = bracket_[first + (i < count ? i : 0)];
      const Direction middle = middle_of(b.part.arc);
      low[i] = b.part.low;
      high[i] = b.part.high;
      at_low[i] = b.at_low;
      at_high[i] = b.at_high;
      c0[i] = middle.cosine;
      s0[i] = middle.sine;
    }
    T x = low + (high - low) * at_low / (at_low - at_high);
    x = x >= low && x <= high ? x : T(0.5 * (low + high));
    T cosine{}, sine{};
    // A step of this length, in units of the arc's tangent, leaves rounding only.
    constexpr double short_step = 1e-7;
    constexpr int most_steps = 6;
    bool arrived = false;
    for (int step = 0;; ++step) {
      const T t = x * tangent_of_arc;
      const T scale = 1 / (1 + t * t);
      const T c = (1 - t * t) * scale, s = 2 * t * scale;
      cosine = c0 * c - s0 * s;
      sine = s0 * c + c0 * s;
      if (arrived || step == most_steps) break;
      T value, slope;
      evaluate(cosine, sine, value, slope);
      const T next = x - value / (slope * (2 * tangent_of_arc) * scale);
      const auto same = (value < 0) == (at_low < 0);
      low = same ? x : low;
      high = same ? high : x;
      const T middle = 0.5 * (low + high);
      T y = next >= low ? next : middle;
      y = next <= high ? y : middle;
      arrived = sign_mask(T(magnitude_of(T(y - x)) - short_step)) == all_lanes<T>;
      x = y;
    }
    for (int i = 0; i < count; ++i) found_.add_once({cosine[i], sine[i]}, 0);
  }

  /// By Horner's rule, in the square of z = cos + i sin: a sum of (re - i im) z^2n.
  template <class T>
  struct Sum {
    T re{}, im{};

    QVGEN_LANES void next(const Direction& coefficient, const T& c, const T& s) {
      const T r = (coefficient.cosine + re * c) - im * s;
      im = (im * c - coefficient.sine) + re * s;
      re = r;
    }
  };

  /// Value and slope: the real parts of the sums of (a - i b) z^k and of its derivative, even and odd powers
  /// apart, since the time until the last product is what counts.
  template <class T>
  QVGEN_LANES void evaluate(const T& c, const T& s, T& value, T& slope) const {
    const T c2 = c * c - s * s, s2 = 2 * c * s;
    Sum<T> even, odd, slope_even, slope_odd;
#pragma GCC unroll 5
    for (int k = degree; k >= 0; k -= 2) {
      even.next({f_.cosine[k], f_.sine[k]}, c2, s2);
      slope_even.next(slope_[k], c2, s2);
      if (k == 0) break;
      odd.next({f_.cosine[k - 1], f_.sine[k - 1]}, c2, s2);
      slope_odd.next(slope_[k - 1], c2, s2);
    }
    value = even.re + (c * odd.re - s * odd.im);
    slope = slope_even.re + (c * slope_odd.re - s * slope_odd.im);
  }

  const Trigonometric& f_;
  Direction slope_[degree + 1];  ///< the derivative's coefficients
  bool may_be_faint_;
  double faint_below_;  ///< arcs whose coefficients are all smaller are faint
  double tolerance_;    ///< of coefficients: at least a hundred times their rounding
  Candidates& found_;
  int cells_ = 0;
  Cell cell_[most_cells + 2 * width];
  int brackets_ = 0;
  Bracket bracket_[most_cells];
};

}  // namespace
}  // namespace qvgen::inverse::elimination
