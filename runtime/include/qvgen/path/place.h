// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <Eigen/LU>
#include <qvgen/path/arm.h>

/// All solutions at one place of the path, and which solution at the next place each of them becomes.
///
/// Solutions are matched by their branch where branches keep their numbers, else by distance. Either way a
/// joint may go so far only, and the determinant of the Jacobian keeps its sign: next to a wrist that is
/// nearly stretched the nearest solution is on the wrong side of it.
namespace qvgen::path {

template <class Arm>
struct Place {
  static constexpr std::size_t capacity = static_cast<std::size_t>(Arm::capacity);
  double u = 0;  ///< within a piece of the path, from 0 to 1
  typename Arm::Found found;
  std::array<bool, capacity>
      positive;  ///< the sign of the Jacobian's determinant, where branches have no numbers

  /// False where a joint is free, so that its value says nothing.
  [[nodiscard]] bool is_clear() const { return found.status != Status::singular; }
};

/// Sets the signs by which rows are matched.
template <class Arm>
void add_signs(const Arm& arm, Place<Arm>& place) {
  if (arm.stable_branches) return;
  for (int i = 0; i < place.found.size(); ++i)
    place.positive[static_cast<std::size_t>(i)] = arm.jacobian(place.found[i].q).determinant() > 0;
}

/// Which row at the next place each row becomes.
template <class Arm>
struct Match {
  static constexpr std::size_t capacity = static_cast<std::size_t>(Arm::capacity);
  std::array<int, capacity> to;    ///< of each row the next one, or -1
  std::array<int, capacity> from;  ///< and back
  bool is_far = false;             ///< a row of one branch has gone too far to be sure

  [[nodiscard]] int ended(int rows) const { return count_open(to, rows); }
  [[nodiscard]] int begun(int rows) const { return count_open(from, rows); }

  Match() {
    to.fill(-1);
    from.fill(-1);
  }
  void join(int a, int b) {
    to[static_cast<std::size_t>(a)] = b;
    from[static_cast<std::size_t>(b)] = a;
  }

 private:
  static int count_open(const std::array<int, capacity>& rows, int size) {
    int open = 0;
    for (int i = 0; i < size; ++i) open += static_cast<int>(rows[static_cast<std::size_t>(i)] < 0);
    return open;
  }
};

/// Largest difference of a joint.
inline double distance(const Values& a, const Values& b, const JointKinds<6>& revolute) {
  double most = 0;
  for (int i = 0; i < 6; ++i) {
    const double off = std::abs(a[i] - b[i]);
    const bool turns = revolute[static_cast<std::size_t>(i)] && off > 0.5 * whole_turn;
    most = std::max(most, turns ? std::abs(whole_turn - off) : off);
  }
  return most;
}

/// True if some joint differs by more than a bound.
inline bool are_apart(const Values& a, const Values& b, double bound, const JointKinds<6>& revolute) {
  for (int i = 0; i < 6; ++i) {
    const double off = std::abs(a[i] - b[i]);
    const bool turns = revolute[static_cast<std::size_t>(i)] && off > 0.5 * whole_turn;
    if ((turns ? std::abs(whole_turn - off) : off) > bound) return true;
  }
  return false;
}

/// Finds the row nearest to some joints, and the distance of the second nearest.
struct Nearest {
  int row = -1;
  double first = std::numeric_limits<double>::infinity(), second = first;

  template <class Found>
  static Nearest of(const Found& found, const Values& q, const JointKinds<6>& revolute, int but = -1) {
    Nearest nearest;
    for (int i = 0; i < found.size(); ++i)
      if (i != but) nearest.see(i, distance(found[i].q, q, revolute));
    return nearest;
  }

 private:
  void see(int i, double away) {
    if (away < first) {
      second = first;
      first = away;
      row = i;
    } else if (away < second) {
      second = away;
    }
  }
};

namespace matching {

/// Rows of the same branch.
template <class Arm>
void by_branch(const Arm& arm, const Place<Arm>& a, const Place<Arm>& b, double longest, Match<Arm>& match) {
  const int count = b.found.size();
  for (int i = 0; i < a.found.size(); ++i) {
    const int start = i < count ? i : 0;  // as a rule it stands at the same place
    for (int k = 0; k < count; ++k) {
      const int j = start + k < count ? start + k : start + k - count;
      if (b.found[j].branch != a.found[i].branch) continue;
      const bool is_far = distance(a.found[i].q, b.found[j].q, arm.revolute) > longest;
      match.is_far = match.is_far || is_far;
      if (!is_far) match.join(i, j);
      break;
    }
  }
}

/// Rows that are nearest to each other by far.
template <class Arm>
void by_distance(const Arm& arm, const Place<Arm>& a, const Place<Arm>& b, double longest, bool strict,
                 Match<Arm>& match) {
  for (int i = 0; i < a.found.size(); ++i) {
    const Nearest to = Nearest::of(b.found, a.found[i].q, arm.revolute);
    if (!(to.first <= longest)) continue;
    const Nearest back = Nearest::of(a.found, b.found[to.row].q, arm.revolute);
    const double gap = std::min(to.second, back.second);
    const bool same =
        !strict || a.positive[static_cast<std::size_t>(i)] == b.positive[static_cast<std::size_t>(to.row)];
    if (back.row == i && same && to.first <= (strict ? 0.25 : 0.5) * gap) match.join(i, to.row);
  }
}

}  // namespace matching

/// Matches the rows of two places that a regular stretch of the path is between.
template <class Arm>
Match<Arm> matched(const Arm& arm, const Place<Arm>& a, const Place<Arm>& b, double longest) {
  Match<Arm> match;
  if (arm.stable_branches)
    matching::by_branch(arm, a, b, longest, match);
  else
    matching::by_distance(arm, a, b, longest, true, match);
  return match;
}

/// Matches the rows on both sides of a singular pose, where branches may exchange their numbers.
template <class Arm>
Match<Arm> matched_across(const Arm& arm, const Place<Arm>& a, const Place<Arm>& b, double longest) {
  Match<Arm> match;
  matching::by_distance(arm, a, b, longest, false, match);
  return match;
}

}  // namespace qvgen::path
