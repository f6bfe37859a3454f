// SPDX-License-Identifier: MIT
#pragma once

#include "candidates.h"
#include "newton.h"
#include "slide_joints.h"

namespace qvgen::inverse::general {
namespace {

/// Joints are a solution if they miss the pose by no more than this, squared.
inline constexpr double good_miss = 1e-26;
/// Two solutions are one if they are no further apart than this, squared.
inline constexpr double same_distance = 1e-13;

inline double squared_distance(const JointPairs& a, const JointPairs& b) {
  double sum = 0;
  for (int j = 0; j < joints; ++j) {
    const double x = a.cosine[j] - b.cosine[j], y = a.sine[j] - b.sine[j];
    sum += x * x + y * y;
  }
  return sum;
}

/// One elimination in lanes.
template <int width>
class Eliminated {
  using T = Lanes<width>;

 public:
  Eliminated(const Chain& chain, const Elimination& e, const Goal& goal, double tolerance, Gathered& found)
      : chain_(chain), e_(e), goal_(goal), found_(found), rows_before_(found.rows) {
    set_pose(e, chain, goal, system_);
    Candidates candidates;
    const double noise = find_candidates<width>(system_, e.pair, tolerance, candidates);
    constexpr double loud = 1e-7;
    found.loud = !(noise < loud) || (e.pair == Pair::slides && vanishes());
    if (found.loud || candidates.overflow) found.doubtful = true;
    for (int first = 0; first < candidates.count; first += width) follow(candidates, first);
    if (e.pair == Pair::slides) look_in_line();
    int all = found.rows - rows_before_;
    for (int k = 0; k < rows_before_; ++k) all += seen_[k] ? 1 : 0;
    // The sixteen solutions (of two slides eight) over the complex numbers: those that are not real come in
    // pairs.
    if (all % 2 != 0) found.doubtful = true;
  }

 private:
  /// At four angles that are spread over the circle.
  [[nodiscard]] bool vanishes() const {
    const Lanes<4> cosines = {0.96, -0.28, -0.96, 0.28}, sines = {0.28, 0.96, -0.28, -0.96};
    return nearly_vanishes(system_.slides, cosines, sines);
  }

  static constexpr double in_line = 1e-6;  ///< the square of the sine between two axes
  static constexpr double half_root_3 = 0.86602540378443865;

  void follow(const Candidates& candidates, int first) {
    const int count = candidates.count - first < width ? candidates.count - first : width;
    T cosine, sine;
    for (int i = 0; i < width; ++i) {
      const Direction& angle = candidates.list[first + (i < count ? i : 0)].angle;
      cosine[i] = angle.cosine;
      sine[i] = angle.sine;
    }
    JointLanes<T> start, q;
    if (e_.pair == Pair::slides)
      substitute_slides(e_, system_.slides, chain_.size, cosine, sine, Taken{}, start);
    else
      substitute_back(e_, system_, chain_.size, cosine, sine, start);
    q = start;
    polish(count, q);
    const T miss = squared_miss(chain_, goal_, q);
    for (int i = 0; i < count; ++i) {
      if (candidates.list[first + i].is_doubtful()) found_.doubtful = true;
      if (!(miss[i] < good_miss && is_new(lane(q, i)))) offer_start(lane(start, i));
    }
  }

  /// Of two slides. Where the axes of two turns are in line their sum alone is known: there steps begin at
  /// all that may be.
  void offer_in_line(const T& cosine, const T& sine, const T& across, int count) {
    const Direction sixths[6] = {{1, 0},  {0.5, half_root_3},   {-0.5, half_root_3},
                                 {-1, 0}, {-0.5, -half_root_3}, {0.5, -half_root_3}};
    for (const Direction& by : sixths)
      for (const double sign : {1.0, -1.0}) {
        JointLanes<T> start;
        substitute_slides(e_, system_.slides, chain_.size, cosine, sine, {sign, by.cosine, by.sine}, start);
        for (int i = 0; i < count; ++i)
          if (!(across[i] > in_line)) offer_start(lane(start, i));
      }
  }

  /// The outer angles at which those axes come nearest to being in line: the polynomial has roots there that
  /// rounding hides.
  void look_in_line() {
    const Lanes<4> cosines = {1, 0, -1, 0}, sines = {0, 1, 0, -1};
    const Lanes<4> n = AtOuter<Lanes<4>>(system_.slides, cosines, sines).between;
    const double mean = (n[0] + n[2]) / 2, x = (n[0] - n[2]) / 2, y = (n[1] - n[3]) / 2;
    const double most = std::sqrt(x * x + y * y);
    if (!(most > 1e-9)) return;
    for (const double sign : {1.0, -1.0}) {
      const double nearest = mean + sign * most;
      if (1 - nearest * nearest > in_line) continue;
      offer_in_line(spread<T>(sign * x / most), spread<T>(sign * y / most), T{}, 1);
    }
  }

  /// Newton's steps until all lanes are as good as they get.
  void polish(int count, JointLanes<T>& q) const {
    constexpr int most_steps = 9;
    constexpr double last = 1e-16;  // one step from here is the last
    double before[width];
    bool stuck[width] = {};
    for (double& x : before) x = 1e300;
    for (int step = 0; step < most_steps; ++step) {
      const T miss = newton_step(chain_, goal_, q);
      bool open = false;
      for (int i = 0; i < count; ++i) {
        if (step > 3 && !(miss[i] <= 0.25 * before[i])) stuck[i] = true;
        open = open || (!(miss[i] <= last) && !stuck[i]);
        before[i] = miss[i];
      }
      if (!open) break;
    }
  }

  /// Takes a solution, unless this elimination has come to it before.
  bool is_new(const JointPairs& values) {
    for (int k = rows_before_; k < found_.rows; ++k)
      if (squared_distance(found_.row[k], values) < same_distance) return false;
    for (int k = 0; k < rows_before_; ++k)
      if (squared_distance(found_.row[k], values) < same_distance) {
        seen_[k] = true;
        return true;
      }
    found_.add_row(values);
    return true;
  }

  void offer_start(const JointPairs& values) {
    found_.doubtful = true;
    for (int j = 0; j < joints; ++j)
      if (!std::isfinite(values.cosine[j]) || !std::isfinite(values.sine[j])) return;
    found_.add_start(values);
  }

  static JointPairs lane(const JointLanes<T>& q, int i) {
    JointPairs result;
    for (int j = 0; j < joints; ++j) {
      result.cosine[j] = q.cosine[j][i];
      result.sine[j] = q.sine[j][i];
    }
    return result;
  }

  const Chain& chain_;
  const Elimination& e_;
  const Goal& goal_;
  Gathered& found_;
  int rows_before_;
  bool seen_[Gathered::most_rows] = {};
  PoseSystem system_;
};

template <int width>
void eliminate_once(const Chain& chain, const Elimination& e, const Goal& goal, double tolerance,
                    Gathered& found) {
  Eliminated<width>(chain, e, goal, tolerance, found);
}

}  // namespace
}  // namespace qvgen::inverse::general
