// SPDX-License-Identifier: MIT
// Ways of motors from a seed, and orders of rows by them.
//
// A turn of a joint is one of a motor only where that motor moves it alone, without a gear. So ways of motors
// cannot be taken the short way round one by one: each joint goes the short way, and the motors with it.
#pragma once

#include <cstddef>

#include <qvgen/inverse/nearest.h>

namespace qvgen {

/// In the place of `is_revolute`: rows are of motors, and whole turns those of the joints of `Map`, which has
/// `joints`, `motors` and `is_revolute`.
template <class Map>
struct TurnsOfMotors {};

namespace inverse {

/// Returns the way of motors from a seed to a row without limits.
template <class Map, int capacity>
Joints<Map::dof> way_of_motors(const Joints<Map::dof>& seed, const Solutions<Map::dof, capacity>& /*of*/,
                               const Joints<Map::dof>& q) {
  auto joints = Map::joints(q - seed);
  for (int i = 0; i < joints.size(); ++i)
    if (Map::is_revolute[static_cast<std::size_t>(i)]) joints[i] = without_turns(joints[i]);
  return Map::motors(joints);
}
/// Returns that to a row within limits, whose turns count.
template <class Map, int capacity>
Joints<Map::dof> way_of_motors(const Joints<Map::dof>& seed,
                               const LimitedSolutions<Map::dof, capacity>& /*of*/,
                               const Joints<Map::dof>& q) {
  return q - seed;
}

}  // namespace inverse

/// Puts rows of motors in the order of a metric of their ways from a seed, the least first.
template <class Found, class Map, class Metric>
void sort_by(Found& found, const Joints<Map::dof>& seed, const TurnsOfMotors<Map>& /*turns*/,
             const Metric& metric) {
  inverse::sort_rows(
      found, [&](const Joints<Map::dof>& q) { return metric(inverse::way_of_motors<Map>(seed, found, q)); });
}

/// Returns the row of motors whose way from a seed is the least by a metric; null if there is none.
template <class Found, class Map, class Metric>
const Solution<Map::dof>* nearest(const Found& found, const Joints<Map::dof>& seed,
                                  const TurnsOfMotors<Map>& /*turns*/, const Metric& metric) {
  return inverse::nearest_row(
      found, [&](const Joints<Map::dof>& q) { return metric(inverse::way_of_motors<Map>(seed, found, q)); });
}

/// Puts rows of motors in order of their distance from the seed; equal distances keep their order.
template <class Found, class Map>
void sort_by_distance(Found& found, const Joints<Map::dof>& seed, const TurnsOfMotors<Map>& turns) {
  sort_by(found, seed, turns, [](const Joints<Map::dof>& way) { return way.squaredNorm(); });
}

/// Returns the row of motors nearest to the seed; null if there is none.
template <class Found, class Map>
const Solution<Map::dof>* nearest(const Found& found, const Joints<Map::dof>& seed,
                                  const TurnsOfMotors<Map>& turns) {
  return nearest(found, seed, turns, [](const Joints<Map::dof>& way) { return way.squaredNorm(); });
}

/// Motors that continue a path: the row nearest to `previous`, without limits unwound by whole turns of
/// joints so that none jumps. False, and `next` untouched, if there is no row.
template <class Found, class Map>
bool continued(const Found& found, const Joints<Map::dof>& previous, const TurnsOfMotors<Map>& turns,
               Joints<Map::dof>& next) {
  const Solution<Map::dof>* row = nearest(found, previous, turns);
  if (row != nullptr) next = previous + inverse::way_of_motors<Map>(previous, found, row->q);
  return row != nullptr;
}

}  // namespace qvgen
