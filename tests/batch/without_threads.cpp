// SPDX-License-Identifier: MIT
// A program without oneTBB has the batch forms; threads alone need it.
#include <cmath>

#include <qvgen/robots/stranger/batch.h>

namespace arm = qvgen::robots::stranger;

int main() {
  constexpr std::size_t count = 9;
  arm::Geometry g;
  double angles[arm::dof * count] = {0.3}, poses[7 * count] = {};
  arm::forward_kinematics(qvgen::Batch<const double>(angles, count), qvgen::Batch<double>(poses, count), g);
  double norm = 0;
  for (std::size_t row = 0; row < 4; ++row) norm += poses[row * count] * poses[row * count];
  return std::abs(norm - 1) < 1e-15 ? 0 : 1;
}
