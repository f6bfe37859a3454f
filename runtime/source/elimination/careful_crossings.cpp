// SPDX-License-Identifier: MIT
// Rows at which curves of solutions cross. Two joints or more are idle there, and to first order nothing says
// which way leads on; a step far enough from the crossing is on one curve alone, where steps converge.
#include <qvgen/inverse/continuum.h>

#include "careful.h"

namespace qvgen::inverse::elimination {
namespace {

using Newton = polishing::Newton<double, joints, 3>;

/// How far an idle joint is moved from a crossing, rad or share of the size.
constexpr double step_aside = 0.1;
/// Joint values this far from the row, squared, are elsewhere: steps have gone astray.
constexpr double astray = 0.25;
/// A row this near, squared, is the one that was found.
constexpr double known = 1e-6;

}  // namespace

/// Returns where Newton's steps lead with one joint of a row held aside by so much, and whether to the pose.
Careful::Beside Careful::polished_beside(const Row& row, std::size_t joint, double by) {
  Beside beside{false, row.values, {}};
  Newton(task_).advance(joint, task_.arm[joint].revolute ? by : by * setup_.chain.size, beside.values);
  Held<joints> held{};
  held[joint] = true;
  const double share = std::max(tolerance_, default_tolerance);
  beside.reaches = polish(task_, {share}, beside.values, beside.there, walks_, held);
  return beside;
}

/// True if solutions go on where one idle joint of a row is moved by so much; sets `unsure_` where a solution
/// is there that no row stands for.
bool Careful::goes_on_beside(const Row& row, std::size_t joint, double by) {
  const Beside beside = polished_beside(row, joint, by);
  if (!beside.reaches || distance_square(beside.values, row.values) > astray) return false;
  const bool is_known = std::any_of(rows_, rows_ + size_, [&](const Row& each) {
    return distance_square(each.values, beside.values) < known;
  });
  if (is_known) return false;
  if (Idling<double, joints, 3>(task_, walks_).is_continuum(beside.values, beside.there)) return true;
  unsure_ = true;
  return false;
}

/// Returns what is left of the way to the pose, as a share of the size, with a joint held aside of a row.
double Careful::miss_beside(const Row& row, std::size_t joint, double by) {
  return std::sqrt(polished_beside(row, joint, by).there.error / task_.size_square);
}

/// True if three solutions meet in a row, at least: the miss beside it grows with the third power of the way.
/// It does with the second where two meet, and hardly next to a continuum.
bool Careful::three_meet_in(const Row& row, std::size_t idle_joint) {
  constexpr double little = 0.02, more = 0.2, growth = 300;
  const double near = miss_beside(row, idle_joint, little), far = miss_beside(row, idle_joint, more);
  return far > growth * near;
}

void Careful::look_along_crossings() {
  for (int i = 0; i < size_; ++i) {
    Row& row = rows_[i];
    if (row.continuum) continue;
    const auto idle = Newton::idle(Newton(task_).reached(row.values));
    if (std::count(idle.is.begin(), idle.is.end(), true) < 2) continue;
    for (std::size_t j = 0; j < joints && !row.continuum; ++j)
      row.continuum =
          idle.is[j] && (goes_on_beside(row, j, step_aside) || goes_on_beside(row, j, -step_aside));
  }
}

}  // namespace qvgen::inverse::elimination
