// SPDX-License-Identifier: MIT
#include "valley.h"

namespace qvgen::inverse::elimination {

bool ValleyWalk::begin(const Values& start, Floor& floor) const {
  floor.values = start;
  floor.at = newton_.reached(start);
  auto columns = floor.at.jacobian;
  const auto idle = polishing::dependent(columns, shallow);
  if (idle.least == joints) return false;
  Held<joints> held{};
  held[idle.least] = true;
  floor.lead = idle.least;
  if (!is_nothing(floor.at)) polish(task_, {0, 1}, floor.values, floor.at, budget_, held);
  return floor.at.error < highest * highest * task_.size_square && look(1, floor);
}

/// Sets where the floor leads on, the fastest joint with speed 1.
bool ValleyWalk::look(double direction, Floor& floor) const {
  auto columns = floor.at.jacobian;
  const auto idle = polishing::dependent(columns, shallow);
  if (idle.least == joints) return false;
  Way way = newton_.following(floor.at, idle.least, 1);
  double fastest = 0, along = 0;
  std::size_t lead = idle.least;
  for (std::size_t i = 0; i < joints; ++i) {
    const double speed = std::abs(way[i]) / unit(i);
    if (speed > fastest) lead = i;
    fastest = std::max(fastest, speed);
    along += way[i] * floor.way[i];
  }
  const double scale = (along == 0 ? direction : along < 0 ? -1 : 1) / fastest;
  for (double& each : way) each *= scale;
  floor.way = way;
  floor.lead = lead;
  return true;
}

/// So far along the tangent, and back onto the floor.
bool ValleyWalk::go(double by, const Floor& from, Floor& to) const {
  to = from;
  for (std::size_t i = 0; i < joints; ++i) newton_.advance(i, by * from.way[i], to.values);
  Held<joints> held{};
  held[from.lead] = true;
  const Values ahead = to.values;
  polish(task_, {0, 1}, to.values, to.at, budget_, held);
  if (!(to.at.error < highest * highest * task_.size_square)) return false;
  if (distance_square(ahead, to.values) > longest * longest) return false;
  return look(1, to);
}

}  // namespace qvgen::inverse::elimination
