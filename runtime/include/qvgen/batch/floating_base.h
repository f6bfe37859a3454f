// SPDX-License-Identifier: MIT
// Configurations of robots whose base floats, as batches have them: seven rows of the base, w x y z of its
// orientation and its position, and the joints' rows.
#pragma once

#include <Eigen/Core>
#include <qvgen/floating_base.h>

namespace qvgen::batch {

template <class Lane, int dof>
[[gnu::always_inline]] inline FloatingConfiguration<Lane, dof> configuration_of(
    const Eigen::Matrix<Lane, 7, 1>& base, const Eigen::Matrix<Lane, dof, 1>& q) {
  FloatingConfiguration<Lane, dof> at;
  at.base.orientation = Quaternion<Lane>(base[0], base[1], base[2], base[3]);
  at.base.position << base[4], base[5], base[6];
  at.q = q;
  return at;
}

}  // namespace qvgen::batch
