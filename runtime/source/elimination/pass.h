// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "angles.h"
#include "candidates.h"
#include "newton.h"
#include "slide_starts.h"

namespace qvgen::inverse::elimination {
namespace {

/// Further than this, in joints, steps may have passed a solution by, squared.
inline constexpr double far_distance = 1e-2;
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
 public:
  Eliminated(const Chain& chain, const Elimination& e, const Goal& goal, double tolerance, Gathered& found)
      : chain_(chain), e_(e), goal_(goal), found_(found), rows_before_(found.rows) {
    set_pose<width>(e, chain, goal, system_);
    Candidates candidates;
    const double noise = find_candidates<width>(system_, e.pair, tolerance, candidates);
    found.magnified += candidates.faint_count;
    constexpr double loud = 1e-7;
    const bool drowns = !(noise < loud), slides = e.pair == Pair::slides;
    found.loud = drowns || (slides && vanishes());
    if (found.loud || candidates.overflow) found.doubtful = true;
    // Arms with two slides have a better way then.
    for (int first = 0; first < candidates.count && !(drowns && slides); first += width)
      in_lanes<width>(candidates.count - first,
                      [&](auto lanes, int some) { follow<lanes>(candidates, first, some); });
    if (leaves_doubt(candidates)) found.doubtful = true;
    if (has_doubtful(candidates)) found.has_twins = true;
    if (slides) look_beside_roots();
    found.met = found.rows - rows_before_;
    for (int k = 0; k < rows_before_; ++k) found.met += seen_[k] ? 1 : 0;
    // The sixteen solutions (of two slides eight) over the complex numbers: those that are not real come in
    // pairs.
    if (found.met % 2 != 0) found.doubtful = true;
  }

 private:
  /// At four angles that are spread over the circle.
  [[nodiscard]] bool vanishes() const {
    const Lanes<4> cosines = {0.96, -0.28, -0.96, 0.28}, sines = {0.28, 0.96, -0.28, -0.96};
    return nearly_vanishes(system_.slides, cosines, sines);
  }

  template <int lanes>
  void follow(const Candidates& candidates, int first, int count) {
    using T = Lanes<lanes>;
    T cosine, sine;
    for (int i = 0; i < lanes; ++i) {
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
    const T miss = steps_to<lanes>(chain_, goal_, count, q);
    for (int i = 0; i < count; ++i) {
      const bool leads = miss[i] < good_miss;
      const JointPairs from = lane(start, i), to = lane(q, i);
      if (!leads || !is_new(to))
        offer_start(from, leads && squared_distance(from, to) < far_distance, to);
      else
        is_own_[first + i] = is_at(candidates.list[first + i], to);
    }
    if (e_.pair != Pair::slides) return;
    const auto is_doubtful = [&](int i) { return candidates.list[first + i].is_doubtful(); };
    bool any = false;
    for (int i = 0; i < count; ++i) any = any || is_doubtful(i);
    if (any) slide_starts<lanes>().offer_other_sign(cosine, sine, count, is_doubtful);
  }

  /// True if joints have the outer angle of a candidate.
  [[nodiscard]] bool is_at(const Candidate& candidate, const JointPairs& values) const {
    const int j = e_.joint[3];
    const double x = values.cosine[j] - candidate.angle.cosine;
    const double y = values.sine[j] * (e_.backwards ? -1 : 1) - candidate.angle.sine;
    return x * x + y * y < 4 * candidate.spread * candidate.spread;
  }

  /// True if two roots that are not told apart, and are all that there can be, have each led to a solution of
  /// its own.
  [[nodiscard]] bool is_settled(const Candidates& candidates, int i) const {
    const int twin = candidates.list[i].twin;
    return e_.pair != Pair::slides && twin != i && is_own_[i] && is_own_[twin];
  }
  [[nodiscard]] bool leaves_doubt(const Candidates& candidates) const {
    for (int i = 0; i < candidates.count; ++i)
      if (candidates.list[i].is_doubtful() && !is_settled(candidates, i)) return true;
    return false;
  }
  [[nodiscard]] static bool has_doubtful(const Candidates& candidates) {
    return std::any_of(candidates.list, candidates.list + candidates.count,
                       [](const Candidate& each) { return each.is_doubtful(); });
  }

  /// Looks for further starts beside the roots of an arm with two slides.
  void look_beside_roots() {
    const auto starts = slide_starts<width>();
    starts.offer_in_line();
    if (found_.loud) found_.faint = starts.offer_each_sign();
  }

  struct Offer {
    Eliminated* pass;
    void operator()(const JointPairs& values) const { pass->offer_start(values, false, values); }
  };
  template <int lanes>
  [[nodiscard]] SlideStarts<lanes, Offer> slide_starts() {
    return {e_, system_.slides, chain_.size, offer_};
  }

  /// Takes a solution, unless this elimination has come to it before.
  bool is_new(const JointPairs& values) {
    for (int k = rows_before_; k < found_.rows; ++k)
      if (squared_distance(found_.row[k], values) < same_distance) return false;
    for (int k = 0; k < rows_before_; ++k)
      if (squared_distance(found_.row[k], values) < same_distance) {
        const bool is_new = !seen_[k];
        seen_[k] = true;
        return is_new;
      }
    found_.add_row(values);
    return true;
  }

  /// `leads`: by Newton's steps to a solution that has been found before.
  void offer_start(const JointPairs& values, bool leads, const JointPairs& solution) {
    found_.doubtful = true;
    for (int j = 0; j < joints; ++j)
      if (!std::isfinite(values.cosine[j]) || !std::isfinite(values.sine[j])) return;
    found_.add_start({values, leads, solution});
  }

  const Chain& chain_;
  const Elimination& e_;
  const Goal& goal_;
  Gathered& found_;
  int rows_before_;
  bool seen_[Gathered::most_rows] = {};
  bool is_own_[most_candidates] =
      {};  ///< candidates that have led to a solution at their angle, each to another
  PoseSystem system_;
  Offer offer_{this};
};

/// Newton's steps from each of some joint values, which take what they come to if that is a solution not far
/// away.
template <int width>
void lead_in_lanes(const Chain& chain, const Goal& goal, int count, JointPairs* values) {
  for (int first = 0; first < count; first += width) {
    const int some = count - first < width ? count - first : width;
    JointLanes<Lanes<width>> q;
    for (int i = 0; i < width; ++i)
      for (int j = 0; j < joints; ++j) {
        const JointPairs& each = values[first + (i < some ? i : 0)];
        q.cosine[j][i] = each.cosine[j];
        q.sine[j][i] = each.sine[j];
      }
    const Lanes<width> miss = steps_to<width>(chain, goal, some, q);
    for (int i = 0; i < some; ++i) {
      const JointPairs end = lane(q, i);
      if (miss[i] < good_miss && squared_distance(end, values[first + i]) < far_distance)
        values[first + i] = end;
    }
  }
}

template <int width>
void eliminate_once(const Chain& chain, const Elimination& e, const Goal& goal, double tolerance,
                    Gathered& found) {
  Eliminated<width>(chain, e, goal, tolerance, found);
}

}  // namespace
}  // namespace qvgen::inverse::elimination
