// SPDX-License-Identifier: MIT
// The motion of a base that floats among the symbols of random trees.
#pragma once

#include "base_motion.h"
#include "model/coordinates.h"
#include "random_tree.h"

namespace qvgen::test::trees {

/// Adds the base's motion to the symbols' values, for gravity of 9.81 m/s^2.
inline void add_base(const BaseMotion& base, const VectorXd& force, Motion& motion) {
  using namespace derive::dynamics;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    motion.values[velocity_of(model::base_coordinate(k))] = base.velocity[i];
    motion.values[acceleration_of(model::base_coordinate(k))] = base.acceleration[i];
    motion.values[force_of(model::base_coordinate(k))] = force[i];
  }
  const Vector3d gravity = base.rotation.transpose() * Vector3d(0, 0, -9.81);
  for (std::size_t k = 0; k < 3; ++k)
    motion.values[gravity_component(k)] = gravity[static_cast<Eigen::Index>(k)];
  motion.values[gravity_component(3)] = 9.81 * base.q[2];
}

}  // namespace qvgen::test::trees
