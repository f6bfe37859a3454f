// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <qvgen/path/limits_on_track.h>
#include <qvgen/path/step.h>

/// Things that two steps may hide: solutions that meet and part between places, and joints that touch a
/// limit. Both are judged by parabolas through three places: of the square of the distance of two solutions,
/// which is linear where they meet, and of each joint.
namespace qvgen::path {

/// A parabola through values at 0, 1/2 and 1.
struct Parabola {
  double first, middle, last;

  [[nodiscard]] double bend() const { return 2 * (first - 2 * middle + last); }
  [[nodiscard]] double slope() const { return 4 * middle - 3 * first - last; }
  /// The extreme value between 0 and 1; the middle value if it is not there.
  [[nodiscard]] double extreme() const {
    const double at = -slope(), twice = 2 * bend();
    const bool is_inside = twice > 0 ? at > 0 && at < twice : at < 0 && at > twice;
    return is_inside ? first - 0.5 * slope() * slope() / twice : middle;
  }
  [[nodiscard]] double most() const { return std::max({first, middle, last}); }
  [[nodiscard]] double least() const { return std::min({first, middle, last}); }
};

/// True if a step leaves no room for what it might hide: all rows go on, and each goes a small part of its
/// way to the nearest other one. For two to meet on the way they would have to be far faster there than on
/// the whole.
template <class Arm>
bool is_calm(const Arm& arm, const Place<Arm>& a, const Place<Arm>& b, const Match<Arm>& match) {
  constexpr double share = 0.2, far = 1;
  const int count = a.found.size();
  if (count != b.found.size()) return false;
  std::array<double, Place<Arm>::capacity> way;
  for (int i = 0; i < count; ++i) {
    const int j = match.to[static_cast<std::size_t>(i)];
    if (j < 0) return false;
    way[static_cast<std::size_t>(i)] = distance(a.found[i].q, b.found[j].q, arm.revolute);
    if (way[static_cast<std::size_t>(i)] > share * far) return false;
  }
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < i; ++k) {
      const double longest = std::max(way[static_cast<std::size_t>(i)], way[static_cast<std::size_t>(k)]);
      if (!are_apart(a.found[i].q, a.found[k].q, longest / share, arm.revolute)) return false;
    }
  return true;
}

template <class Arm>
class Hidden {
  using Coupling = typename Arm::Limited;

 public:
  Hidden(const Arm& arm, const Place<Arm>& a, const Place<Arm>& m, const Place<Arm>& b,
         const Step<Arm>& first, const Step<Arm>& second)
      : arm_(arm), a_(a), m_(m), b_(b), first_(first.match), second_(second.match) {}

  /// True if two solutions may meet between the places.
  [[nodiscard]] bool meeting() const {
    for (int i = 0; i < m_.found.size(); ++i)
      for (int k = 0; k < i; ++k)
        if (may_meet(i, k)) return true;
    return false;
  }

  /// True if a value of a row of `a`, whose joints on the track are `u`, may touch a limit of its cell that
  /// no place shows.
  [[nodiscard]] bool touch(int row, const Values& u,
                           const typename LimitsOnTrack<Coupling>::Cell& cell) const {
    const int middle = first_.to[static_cast<std::size_t>(row)];
    const int last = middle < 0 ? -1 : second_.to[static_cast<std::size_t>(middle)];
    if (last < 0) return false;
    const Values at_middle = u + difference(m_.found[middle].q, a_.found[row].q, arm_.revolute);
    const Values at_last = at_middle + difference(b_.found[last].q, m_.found[middle].q, arm_.revolute);
    const Joints<Coupling::values> first = arm_.coupling.of(u), second = arm_.coupling.of(at_middle),
                                   third = arm_.coupling.of(at_last);
    for (int i = 0; i < Coupling::values; ++i)
      if (touches({first[i], second[i], third[i]}, cell.below[i], cell.above[i])) return true;
    return false;
  }

 private:
  static constexpr double far = 1;  ///< rad or m: solutions that are farther apart cannot meet within a step

  static bool touches(const Parabola& joint, double below, double above) {
    const double extreme = joint.extreme();
    return (joint.most() < above && extreme >= above + limit_slack) ||
           (joint.least() > below && extreme <= below - limit_slack);
  }

  [[nodiscard]] bool may_meet(int i, int k) const {
    if (distance(m_.found[i].q, m_.found[k].q, arm_.revolute) > far) return false;
    const int before_i = first_.from[static_cast<std::size_t>(i)],
              before_k = first_.from[static_cast<std::size_t>(k)],
              behind_i = second_.to[static_cast<std::size_t>(i)],
              behind_k = second_.to[static_cast<std::size_t>(k)];
    if (before_i < 0 || before_k < 0 || behind_i < 0 || behind_k < 0) return false;
    const Parabola square{apart(a_, before_i, before_k), apart(m_, i, k), apart(b_, behind_i, behind_k)};
    return square.bend() > 0 && square.extreme() < 0.1 * square.most();
  }

  [[nodiscard]] double apart(const Place<Arm>& place, int i, int k) const {
    return difference(place.found[i].q, place.found[k].q, arm_.revolute).squaredNorm();
  }

  const Arm& arm_;
  const Place<Arm>&a_, &m_, &b_;
  const Match<Arm>&first_, &second_;
};

}  // namespace qvgen::path
