// SPDX-License-Identifier: MIT
#pragma once

#include "newton.h"
#include "roots.h"

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
    found.loud = !(noise < loud);
    if (found.loud || candidates.overflow) found.doubtful = true;
    for (int first = 0; first < candidates.count; first += width) follow(candidates, first);
    int all = found.rows - rows_before_;
    for (int k = 0; k < rows_before_; ++k) all += seen_[k] ? 1 : 0;
    // The sixteen solutions over the complex numbers: those that are not real come in pairs.
    if (all % 2 != 0) found.doubtful = true;
  }

 private:
  void follow(const Candidates& candidates, int first) {
    const int count = candidates.count - first < width ? candidates.count - first : width;
    T cosine, sine;
    for (int i = 0; i < width; ++i) {
      const Direction& angle = candidates.list[first + (i < count ? i : 0)].angle;
      cosine[i] = angle.cosine;
      sine[i] = angle.sine;
    }
    JointLanes<T> start, q;
    substitute_back(e_, system_, chain_.size, cosine, sine, start);
    q = start;
    polish(count, q);
    const T miss = squared_miss(chain_, goal_, q);
    for (int i = 0; i < count; ++i) {
      if (candidates.list[first + i].is_doubtful()) found_.doubtful = true;
      if (!(miss[i] < good_miss && is_new(lane(q, i)))) offer_start(lane(start, i));
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
