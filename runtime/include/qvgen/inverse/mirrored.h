// SPDX-License-Identifier: MIT
// Inverse kinematics of a limb that is another one seen in a mirror (mirror_image.h): the rows of the other
// limb for the pose as it is seen there, their joints with the image's signs. Branches keep the numbers that
// they have in the other limb; distances from a seed are the same, so is the order by them.
#pragma once

#include <array>
#include <cstddef>

#include <qvgen/inverse/constants.h>
#include <qvgen/inverse/joint_limits.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/mirror_image.h>

namespace qvgen::inverse {

/// Returns rows of one limb as those of the other: Solutions or LimitedSolutions.
template <class Image, class Rows>
Rows mirrored_rows(Rows rows) {
  for (auto& row : rows) row.q = Image::template joints<double>(row.q);
  return rows;
}

/// Returns rows whose angles are in (-pi, pi], as they are in the other limb.
template <class Image, class Rows, std::size_t count>
Rows mirrored_rows(Rows rows, const std::array<bool, count>& revolute) {
  for (auto& row : rows) {
    row.q = Image::template joints<double>(row.q);
    for (int i = 0; i < Image::dof; ++i)
      if (revolute[static_cast<std::size_t>(i)] && row.q[i] <= -constant::half_turn)
        row.q[i] = constant::half_turn;
  }
  return rows;
}

/// Returns limits of one limb as those of the other: where a sign changes, the bounds change places.
template <class Image>
JointLimits<Image::dof> mirrored_limits(const JointLimits<Image::dof>& limits) {
  const Joints<Image::dof> lower = Image::template joints<double>(limits.lower);
  const Joints<Image::dof> upper = Image::template joints<double>(limits.upper);
  const Joints<Image::dof> signs = Image::template joints<double>(Joints<Image::dof>::Ones());
  JointLimits<Image::dof> result = limits;
  for (int i = 0; i < Image::dof; ++i) {
    result.lower[i] = signs[i] < 0 ? upper[i] : lower[i];
    result.upper[i] = signs[i] < 0 ? lower[i] : upper[i];
  }
  return result;
}

/// Returns all rows within limits, from those of the other limb within limits as it sees them.
template <class Image, int capacity, std::size_t count>
AllWithinLimits<Image::dof, capacity> mirrored_within(const AllWithinLimits<Image::dof, capacity>& all,
                                                      const JointLimits<Image::dof>& limits,
                                                      const std::array<bool, count>& revolute) {
  Solutions<Image::dof, capacity> rows;
  for (int k = 0; k < all.branches(); ++k) rows.append() = all.nearest_to_centre(k);
  AllWithinLimits<Image::dof, capacity> result(limits, revolute, Joints<Image::dof>::Zero());
  result.take(mirrored_rows<Image>(rows));
  result.effort = all.effort;
  result.status = all.status;
  return result;
}

}  // namespace qvgen::inverse
