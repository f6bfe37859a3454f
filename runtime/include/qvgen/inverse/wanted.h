// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/along_continuum.h>
#include <qvgen/inverse/lanes.h>

/// Solutions next to a seed and within limits, as generated code asks for them. Nearly all poses are regular:
/// no preference matters, no joint is free, and lanes choose the wanted rows before these are written. Only
/// where that does not answer all solutions are looked at: near singular poses, where nothing is inside, and
/// without lanes.
///
/// Generated code says how a pose is solved:
///
///     lanes(wanted)    in lanes, if nothing there is singular
///     regular(found)   the same one branch after the other; false where something is singular
///     all()            all solutions, near singular poses too
///     bring(found)     moves what is free to where it is inside
namespace qvgen::inverse {

/// No row, because there are no lanes: they have not looked at the pose.
inline constexpr RowCount without_lanes{-2, false};

/// True if all joints are finite; takes fewer steps than Eigen's `allFinite`.
template <int dof>
bool is_finite(const Joints<dof>& q) {
  double sum = 0;
  for (int i = 0; i < dof; ++i) sum += 0 * q[i];
  return sum == 0;
}

/// Has lanes write the wanted rows.
template <int dof, int capacity, std::size_t count, class Lanes>
RowCount choose_in_lanes(const Lanes& lanes, const JointLimits<dof>& limits, const Joints<dof>& seed,
                         const std::array<bool, count>& revolute, bool is_sorted,
                         Solutions<dof, capacity>& found) {
  alignas(32) double room[room_of_wanted(dof, capacity)];
  const WantedRows wanted{limits.lower.data(), limits.upper.data(), seed.data(),
                          revolute.data(),     is_sorted,           room,
                          row_places(found)};
  return lanes(wanted);
}

/// True if lanes have answered what is asked for rows within limits. If solutions exist but none is inside
/// one of them may still be brought there.
inline bool is_answered(const RowCount& chosen) {
  return chosen.rows > 0 || (chosen.rows == 0 && chosen.found == 0);
}

/// One row for each branch that has one inside limits, the nearest to the seed first.
template <int dof, int capacity, std::size_t count, class Lanes, class Regular, class All, class Bring>
LimitedSolutions<dof, capacity> next_to_seed(const Joints<dof>& seed, const JointLimits<dof>& limits,
                                             const std::array<bool, count>& revolute, const Lanes& lanes,
                                             const Regular& regular, const All& all, const Bring& bring) {
  LimitedSolutions<dof, capacity> found;
  const RowCount chosen = choose_in_lanes<dof, capacity>(lanes, limits, seed, revolute, true, found);
  if (is_answered(chosen) && (chosen.rows > 0 || is_finite(seed))) {
    conclude(found, chosen);
    return found;
  }
  const Within<dof> within(limits, revolute, seed);
  const auto choose = [&](const Solutions<dof, capacity>& rows) { return nearest_within(rows, within); };
  // Without a free joint the seed chooses nothing, and neither its sines nor an order of all rows are needed.
  Solutions<dof, capacity> rows;
  if (chosen.rows == without_lanes.rows && is_finite(seed) && regular(rows)) {
    found = choose(rows);
    if (!found.empty() || rows.empty()) return found;
  }
  found = chosen_within(all(), choose, bring);
  return found;
}

/// Every representative inside limits.
template <int dof, int capacity, std::size_t count, class Lanes, class All, class Bring>
AllWithinLimits<dof, capacity> every_within(const JointLimits<dof>& limits,
                                            const std::array<bool, count>& revolute, const Lanes& lanes,
                                            const All& all, const Bring& bring) {
  AllWithinLimits<dof, capacity> result(limits, revolute, Joints<dof>::Zero());
  const RowCount chosen =
      choose_in_lanes<dof>(lanes, limits, result.centre(), revolute, false, result.room());
  if (is_answered(chosen)) {
    result.take_rows(chosen.rows);
    return result;
  }
  Solutions<dof, capacity> found = all();
  const bool is_regular = found.status == Status::solved && found.effort.passes == 0;
  if (!is_regular) bring(found);
  result.take(found);
  if (!result.empty() || found.empty() || !is_regular) return result;
  bring(found);
  result.take(found);
  return result;
}

}  // namespace qvgen::inverse
