// SPDX-License-Identifier: MIT
// Starts from which steps end short of the pose. Next to a continuum the miss has a valley, in which one
// joint is idle: across it steps converge, along it the miss grows with the way's square or cube only. Steps
// that go both ways at once leave a valley that bends. Here they go along it and back to its floor in turn;
// valleys in which no solution is found are remembered, since there may be one.
#include <algorithm>

#include "careful.h"

namespace qvgen::inverse::elimination {
namespace {

using Newton = polishing::Newton<double, joints, 3>;

// Misses are shares of the size.

/// Farther off there is no valley to be seen.
constexpr double valley_miss = 1e-4;
/// A start that misses more may be where two solutions would meet beyond the boundary of reach.
constexpr double most_stray_miss = 1e-7;
/// Places so far along a continuum, rad or share of the size, miss no more than this; where two solutions
/// meet it is 1e-3.
constexpr double aside = 0.1, miss_beside_continuum = 1e-6;
/// Farther along, rad or share of the size, a valley is not straight.
constexpr double longest_way = 0.1;
/// A way along a valley leads on if it leaves less than this share of the squared miss.
constexpr double gain = 1e-2;
/// Rows this near stand for a valley.
constexpr double near_row = 0.2;

}  // namespace

/// Takes values at which steps end short of the pose to the floor of a valley, then along it. Returns whether
/// that leads on.
bool Careful::goes_down_valley(Values& values) {
  const auto start = Newton(task_).reached(values);
  const auto across = Newton::idle(start);
  if (!(start.error < valley_miss * valley_miss * task_.size_square) || across.least == joints) return false;
  Reached<double, joints, 3> floor;
  return polish(task_, {0, 1}, values, floor, walks_, across.is) || goes_along_valley(floor, values);
}

/// Takes values on the floor of a valley to where two solutions would meet: there the miss is a square, so
/// Newton's step along the idle joint is half the way. Returns whether that leads on.
bool Careful::goes_along_valley(const Reached<double, joints, 3>& floor, Values& values) {
  const auto idle = Newton::idle(floor);
  if (idle.least == joints) return false;
  const double unit = task_.arm[idle.least].revolute ? 1 : setup_.chain.size;
  const double way = 2 * std::sqrt(floor.error / idle.square);
  if (!(way < longest_way * unit)) return false;
  double least = floor.error;
  const Values from = values;
  for (const double by : {way, -way}) {
    Values along = from;
    const auto steps = Newton(task_).following(floor, idle.least, by);
    for (std::size_t j = 0; j < joints; ++j) Newton(task_).advance(j, steps[j], along);
    Reached<double, joints, 3> there;
    polish(task_, {0, 1}, along, there, walks_, idle.is);
    if (!(there.error < least)) continue;
    least = there.error;
    values = along;
  }
  return least < gain * floor.error;
}

/// Remembers values at which steps have ended short of the pose, if they are next to a continuum for which no
/// row stands.
void Careful::add_stray(const Values& values) {
  if (stray_count_ < most_strays && !has_row_near(values, near_row) && is_next_to_continuum(values))
    stray_[stray_count_++] = values;
}

bool Careful::has_row_near(const Values& values, double near) const {
  return std::any_of(rows_, rows_ + size_,
                     [&](const Row& row) { return distance_square(row.values, values) < near * near; });
}

/// True if values that nearly reach the pose can be moved on, and nearly reach it still.
bool Careful::is_next_to_continuum(const Values& values) {
  const auto at = Newton(task_).reached(values);
  const auto idle = Newton::idle(at);
  if (idle.least == joints || !(at.error < most_stray_miss * most_stray_miss * task_.size_square))
    return false;
  const Row row{values, false, false};
  return miss_beside(row, idle.least, aside) < miss_beside_continuum ||
         miss_beside(row, idle.least, -aside) < miss_beside_continuum;
}

/// True if there is a valley for which no row stands in the end: it may have a solution.
bool Careful::has_lonely_stray() const {
  const bool trusts_walks = !any_is_on_plain();
  for (int k = 0; k < stray_count_; ++k)
    if (!(trusts_walks && is_searched_[k]) && !has_row_near(stray_[k], near_row)) return true;
  return false;
}

bool Careful::any_is_on_continuum() const {
  return std::any_of(rows_, rows_ + size_, [](const Row& row) { return row.continuum; });
}

}  // namespace qvgen::inverse::elimination
