// SPDX-License-Identifier: MIT
// Assemblies of a platform on six rods from its places: the joints that carry the platform are those of an
// arm whose tip is there, and Newton's steps take the last roundings out of them.
#pragma once

#include <Eigen/Core>
#include <qvgen/assembly.h>
#include <qvgen/inverse/six_rods/places.h>
#include <qvgen/loop_motion.h>
#include <qvgen/pose.h>

namespace qvgen::inverse::six_rods {

inline Pose<double> pose_of(const Place& place) {
  const auto& x = place.turn;
  const auto& p = place.position;
  return {{x[0], x[1], x[2], x[3]}, {p[0], p[1], p[2]}};
}

/// Leaves out rows whose gap, m, is wider than allowed; false if there are any.
template <class Found, class Gaps>
bool keep_closed(Found& found, const Gaps& gaps, double allowed) {
  int kept = 0;
  for (auto& row : found)
    if (gaps(row.q).cwiseAbs().maxCoeff() <= allowed) found[kept++] = row;
  const bool are_all = kept == found.size();
  found.truncate(kept);
  return are_all;
}

/// Returns a row for each place. Its branch is the number of the path that led there. `arm(pose)` gives the
/// solutions of the chain to the platform, the first of which is taken; its joints are those at `chain` of
/// all joints. `q` has the driven ones. `gaps` and `jacobian`: as follow_loops has them.
///
/// Status: `incomplete` where places (nearly) meet, which `meets` says of their rows, or if one is lost.
template <class Found, int count, int dof, std::size_t joints, std::size_t passive_count, class Arm,
          class Gaps, class Jacobian>
Found assemblies(const Start<count>& start, const std::array<double, rod_count>& lengths, Joints<dof> q,
                 const std::array<int, joints>& chain,
                 const std::array<bool, static_cast<std::size_t>(dof)>& revolute,
                 const std::array<int, passive_count>& passive, double tolerance, const Arm& arm,
                 const Gaps& gaps, const Jacobian& jacobian) {
  Found found;
  const Places<count> places = find_places(start, lengths);
  bool is_lost = !places.complete;
  for (int i = 0; i < places.size; ++i) {
    const Place& place = places.rows[static_cast<std::size_t>(i)];
    const auto solutions = arm(pose_of(place));
    if (solutions.empty()) {
      is_lost = true;
      continue;
    }
    for (std::size_t k = 0; k < joints; ++k) q[chain[k]] = solutions[0].q[static_cast<int>(k)];
    append_assembly(found, q, place.path, solutions[0].continuum, place.meets, revolute);
  }
  const double size = start.unit + *std::max_element(lengths.begin(), lengths.end());
  is_lost = !close_well(found, revolute, passive, gaps, jacobian, 2e-14 * size) || is_lost;
  is_lost = !keep_closed(found, gaps, std::max(tolerance, 1e-13) * size) || is_lost;
  found.conclude();
  if (is_lost) found.status = Status::incomplete;
  return found;
}

}  // namespace qvgen::inverse::six_rods
