// SPDX-License-Identifier: MIT
#pragma once

#include "careful.h"

namespace qvgen::inverse::elimination {

/// Solutions in a valley of the miss. Next to a continuum one joint is nearly idle: the others, by least
/// squares, follow it along the valley's floor. What is still missing there has one direction, so that it is
/// a signed number; it is zero at solutions and nowhere else. So a valley is searched as a line is: every
/// change of sign has a solution, and so may every place at which the miss is least.
class ValleyWalk {
 public:
  ValleyWalk(const Task& task, Budget& budget) : task_(task), newton_(task), budget_(budget) {}

  using At = Reached<double, joints, 3>;
  using Way = polishing::Vector<double, joints>;
  /// A place on the floor, and where the floor goes on from there.
  struct Floor {
    Values values;
    At at;
    Way way{};
    std::size_t lead = joints;  ///< joint that the others follow
  };

  /// Finds the floor next to joint values; false if there is none.
  [[nodiscard]] bool begin(const Values& start, Floor& floor) const;
  /// Walks in one direction until the valley closes or ends. `passes(floor)` is called at each step,
  /// `leads(values)` next to what may be a solution. Returns true if the valley has closed.
  template <class Passes, class Leads>
  bool follow(const Floor& start, double direction, double farthest, const Passes& passes,
              const Leads& leads) const;

 private:
  static constexpr double longest = 0.1;     ///< rad, or a share of the size
  static constexpr double nearest = 1e-3;    ///< likewise, from a solution: two may be 1e-3 apart
  static constexpr double shortest = 0.012;  ///< likewise
  static constexpr double highest = 1e-2;    ///< miss, as a share of the size: no valley any more
  static constexpr double shallow = 0.003;   ///< what an idle joint adds to the others, as a share
  static constexpr double rounding = 1e-14;  ///< misses that have no sign, as shares of the size

  [[nodiscard]] bool look(double direction, Floor& floor) const;
  [[nodiscard]] bool go(double by, const Floor& from, Floor& to) const;
  [[nodiscard]] double unit(std::size_t joint) const {
    return task_.arm[joint].revolute ? 1 : std::sqrt(task_.size_square);
  }
  static double product(const At& a, const At& b) { return sum_of_products(a.off, b.off); }
  [[nodiscard]] bool is_nothing(const At& at) const {
    return at.error < rounding * rounding * task_.size_square;
  }
  /// Signed miss at a place, in the direction of another.
  static double signed_miss(const At& at, const At& other) {
    return std::copysign(std::sqrt(at.error), product(at, other));
  }
  template <class Leads>
  void locate(const Floor& from, double low, double low_miss, double high, double high_miss,
              const Leads& leads) const;
  template <class Leads>
  void look_between(const Floor& before, double back, const Floor& here, double ahead, const Floor& next,
                    const Leads& leads) const;

  const Task& task_;
  polishing::Newton<double, joints, 3> newton_;
  Budget& budget_;
};

/// Narrows a change of sign between two places, by false position.
template <class Leads>
void ValleyWalk::locate(const Floor& from, double low, double low_miss, double high, double high_miss,
                        const Leads& leads) const {
  Floor place;
  int side = 0;
  for (int k = 0; k < 6; ++k) {
    const double middle = (low * high_miss - high * low_miss) / (high_miss - low_miss);
    if (!go(middle, from, place)) return;
    if (is_nothing(place.at) || high - low < 1e-6) break;
    const double miss = signed_miss(place.at, from.at);
    if ((miss > 0) == (low_miss > 0)) {
      low = middle;
      low_miss = miss;
      if (side == -1) high_miss /= 2;
      side = -1;
    } else {
      high = middle;
      high_miss = miss;
      if (side == 1) low_miss /= 2;
      side = 1;
    }
  }
  leads(place.values);
}

/// Looks at the least miss among three places of one sign.
template <class Leads>
void ValleyWalk::look_between(const Floor& before, double back, const Floor& here, double ahead,
                              const Floor& next, const Leads& leads) const {
  const double middle = std::sqrt(here.at.error);
  double left = signed_miss(before.at, here.at), right = signed_miss(next.at, here.at);
  if (!(left > middle && right > middle)) return;
  double t = 0, miss = middle, low = -back, high = ahead;
  Values least_at = here.values;
  for (int k = 0; k < 7; ++k) {
    const double sl = (miss - left) / (t - low), sr = (right - miss) / (high - t);
    const double curve = (sr - sl) / (high - low);
    const double slope = (sl * (high - t) + sr * (t - low)) / (high - low);
    if (!(curve > 0)) break;
    const double by = -slope / (2 * curve), least = miss - slope * slope / (4 * curve);
    if (!(least < 0.3 * miss)) break;
    Floor place;
    double at = std::min(std::max(t + by, low + 0.1 * (t - low)), high - 0.1 * (high - t));
    if (!go(at, here, place)) break;
    const double there = is_nothing(place.at) ? 0 : signed_miss(place.at, here.at);
    if (there < 0) {
      locate(here, low, left, at, there, leads);
      locate(here, at, there, high, right, leads);
      return;
    }
    if (there < 1e-12 * std::sqrt(task_.size_square)) return leads(place.values);
    if (there >= miss) {
      (at < t ? low : high) = at;
      (at < t ? left : right) = there;
    } else {
      (at < t ? high : low) = t;
      (at < t ? right : left) = miss;
      t = at;
      miss = there;
      least_at = place.values;
    }
  }
  // Steps of all joints find two solutions that nearly meet.
  if (miss < 0.05 * middle) leads(least_at);
}

template <class Passes, class Leads>
bool ValleyWalk::follow(const Floor& start, double direction, double farthest, const Passes& passes,
                        const Leads& leads) const {
  Floor here = start, before;
  for (double& each : here.way) each *= direction;
  // Next to a solution there may be others, at any distance.
  const bool at_solution = is_nothing(here.at);
  double step = at_solution ? nearest : longest, back = longest;
  bool has_before = !at_solution && go(-longest, here, before) && !is_nothing(before.at);
  for (double gone = 0; gone < farthest;) {
    if (budget_.spent.used_up) return false;
    Floor next;
    if (!go(step, here, next)) {
      if (gone < shortest || (step /= 2) < shortest) return false;
      has_before = false;
      continue;
    }
    passes(next);
    const bool here_counts = !is_nothing(here.at), next_counts = !is_nothing(next.at);
    if (here_counts && next_counts) {
      const double ahead = signed_miss(next.at, here.at);
      if (ahead < 0)
        locate(here, 0, std::sqrt(here.at.error), step, ahead, leads);
      else if (has_before)
        look_between(before, back, here, step, next, leads);
    } else if (!next_counts && here_counts) {
      leads(next.values);
    }
    has_before = here_counts && next_counts;
    gone += step;
    back = step;
    before = here;
    here = next;
    step = std::min(longest, 3 * step);
    if (gone > 1 && distance_square(here.values, start.values) < longest * longest) return true;
  }
  return false;
}

}  // namespace qvgen::inverse::elimination
