// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <qvgen/batch/dispatch.h>
#include <qvgen/batch/solutions.h>
#include <qvgen/batch/staging.h>
#include <qvgen/batch/wanted.h>
#include <qvgen/pose.h>

// Shared parts of batched inverse kinematics; no robot is named here.
namespace qvgen::batch {

/// How many poses are solved side by side at most.
inline constexpr std::size_t block = 64;

/// w, x, y, z of the quaternion, then the position.
inline Pose<double> pose_at(const Batch<const double>& poses, std::size_t k) {
  return {{poses(0, k), poses(1, k), poses(2, k), poses(3, k)}, {poses(4, k), poses(5, k), poses(6, k)}};
}

/// One vector of a batch.
template <int dof>
Eigen::Matrix<double, dof, 1> joints_at(const Batch<const double>& all, std::size_t k) {
  Eigen::Matrix<double, dof, 1> q;
  for (int i = 0; i < dof; ++i) q[i] = all(static_cast<std::size_t>(i), k);
  return q;
}

inline void put_pose(const Pose<double>& pose, const Batch<double>& poses, std::size_t k) {
  const double numbers[] = {pose.orientation.w(), pose.orientation.x(), pose.orientation.y(),
                            pose.orientation.z(), pose.position.x(),    pose.position.y(),
                            pose.position.z()};
  for (std::size_t i = 0; i < 7; ++i) poses(i, k) = numbers[i];
}

/// Writes the solutions of a single call into a batch, at configuration `k`.
template <int dof, int capacity>
void put(const Solutions<dof, capacity>& single, const BatchOfSolutions& found, std::size_t k) {
  unsigned marks = 0;
  for (int s = 0; s < capacity; ++s) {
    const bool is_row = s < single.size();
    for (int i = 0; i < dof; ++i)
      found.q(static_cast<std::size_t>(s * dof + i), k) =
          is_row ? single[s].q[i] : std::numeric_limits<double>::quiet_NaN();
    if (found.branch.data != nullptr)
      found.branch(static_cast<std::size_t>(s), k) = is_row ? single[s].branch : -1;
    if (is_row && single[s].continuum) marks |= 1U << s;
  }
  found.count(0, k) = single.size();
  found.status(0, k) = single.status;
  if (found.marks.data != nullptr) found.marks(0, k) = marks;
}

/// `single(k)` for each pose k.
template <class Single>
void one_by_one(std::size_t count, const BatchOfSolutions& found, const Single& single) {
  for (std::size_t k = 0; k < count; ++k) put(single(k), found, k);
}

/// Solves a batch by `lanes(set, first, count, found)`, which solves some poses side by side and returns a
/// bit for each that is to be solved alone. Without vector registers all are.
template <int dof, int capacity, class Lanes, class Single>
void side_by_side(InstructionSet set, std::size_t count, const BatchOfSolutions& found, const Lanes& lanes,
                  const Single& single) {
  with_set(set, [&](auto chosen) {
    if constexpr (std::is_same_v<decltype(chosen), Baseline>) {
      one_by_one(count, found, single);
    } else {
      Staging<Baseline, double, std::size_t(dof * capacity), block> q(found.q, count);
      Staging<Baseline, int, std::size_t(capacity), block> branches(found.branch, count);
      for (std::size_t first = 0; first < count; first += block) {
        const std::size_t part = std::min(count - first, block);
        BatchOfSolutions place = found.part(first, part);
        place.q = q.place(first, part);
        place.branch = branches.place(first, place.branch.count);
        std::uint64_t doubtful = lanes(chosen, first, part, place);
        for (std::size_t k = 0; doubtful != 0; ++k, doubtful >>= 1)
          if ((doubtful & 1) != 0) put(single(first + k), place, k);
        q.finish(first, part);
        branches.finish(first, part);
      }
    }
  });
}

}  // namespace qvgen::batch
