// SPDX-License-Identifier: MIT
// Inverse kinematics of arms and legs with closed loops. The chain to the tip is solved as if its joints had
// motors; its joints are then given, and the loops lead from them to the motors:
//
//     auto found = close_loops<Rows>(limb::inverse_kinematics(pose), [&](const auto& joints) { return
//     assemble(joints); });
//
// A parallelogram in front of a wrist and the rods of an ankle need no equations but those that the chain and
// the loops have anyway.
#pragma once

#include <array>

#include <Eigen/Core>
#include <qvgen/assembly.h>
#include <qvgen/inverse/solutions.h>

namespace qvgen {

/// Returns every assembly for every solution of a limb, a row with the values of all joints. A row's branch
/// is that of the limb times the number of assemblies that there can be, plus that of the assembly.
/// `assemble` gives the assemblies for a limb's joints.
///
/// Status: `unreachable` if no solution of the limb closes the loops, `singular` if a joint of the limb or a
/// passive one is free, `incomplete` if the limb or the loops say so, `invalid` if the limb is.
template <class Found, class Limb, class Assemble>
Found close_loops(const Limb& limb, const Assemble& assemble) {
  Found found;
  bool is_lost = limb.status == Status::incomplete;
  for (const auto& row : limb) {
    const auto set = assemble(row.q);
    is_lost = is_lost || set.status == Status::incomplete;
    for (const auto& each : set) {
      const int branch = row.branch * set.max_size + each.branch;
      inverse::append(found, each.q, branch, row.continuum || each.continuum);
      if (set.meets(each)) found.meeting.set(static_cast<std::size_t>(branch));
    }
  }
  found.effort = limb.effort;
  found.conclude();
  if (is_lost) found.status = Status::incomplete;
  if (limb.status == Status::invalid) found.status = Status::invalid;
  return found;
}

/// Returns these rows next to a seed, the values of all joints: angles by whole turns, the nearest row first.
template <class Found, class Limb, class Assemble, int dof, std::size_t count>
Found close_loops(const Limb& limb, const Assemble& assemble, const Eigen::Matrix<double, dof, 1>& seed,
                  const std::array<bool, count>& revolute) {
  Found found = close_loops<Found>(limb, assemble);
  if (!seed.allFinite()) {
    found.clear();
    found.status = Status::invalid;
  }
  inverse::put_near(found, seed, std::array<bool, count>{}, revolute);
  return found;
}

/// Returns the first assembly of a limb's one solution, or none. `assemble` gives the nearest to a seed
/// first.
template <int dof, class Near, class Assemble>
Solutions<dof, 1> close_loops_near(const Near& limb, const Assemble& assemble) {
  Solutions<dof, 1> found;
  found.status = limb.status;
  found.effort = limb.effort;
  if (limb.empty()) return found;
  const auto set = assemble(limb[0].q);
  if (set.status != Status::solved) found.status = set.status;
  if (!set.empty())
    inverse::append(found, set[0].q, limb[0].branch < 0 ? -1 : limb[0].branch * set.max_size + set[0].branch,
                    limb[0].continuum || set[0].continuum);
  return found;
}

}  // namespace qvgen
