// SPDX-License-Identifier: MIT
// A planner's batch: all solutions of many grasp poses at once, those within limits, and the pose whose
// joints are nearest to where the arm stands. The arm is described in my_arm.toml.
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

#include <qvgen/robots/my_arm.h>
#include <qvgen/robots/my_arm/batch.h>

namespace arm = qvgen::robots::my_arm;
using Joints = arm::JointVector<double>;

namespace {

constexpr std::size_t rows_a_pose = arm::Solutions::max_size;

/// Returns grasp poses over a table, one a column: w x y z of the quaternion, then metres. The tool points
/// down, turned about the vertical.
std::vector<double> grasps(std::size_t count) {
  std::vector<double> numbers(7 * count);
  const qvgen::Batch<double> poses{numbers.data(), count};
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count),
                 turn = 6.283185307179586 * share;
    const double half = std::sqrt(0.5);
    const Eigen::Quaterniond down(half, 0, half, 0), about(std::cos(turn / 2), 0, 0, std::sin(turn / 2));
    const Eigen::Quaterniond q = about * down;
    const double values[7] = {q.w(), q.x(), q.y(), q.z(), 0.3 + 0.9 * share, 0.4 * std::cos(7 * turn), 0.1};
    for (std::size_t i = 0; i < 7; ++i) poses(i, k) = values[i];
  }
  return numbers;
}

}  // namespace

int main() {
  constexpr std::size_t count = 10'000;
  const std::vector<double> numbers = grasps(count);
  std::vector<double> joints(rows_a_pose * arm::dof * count);
  std::vector<int> sizes(count);
  std::vector<qvgen::Status> status(count);
  const qvgen::Batch<double> q{joints.data(), count};
  arm::inverse_kinematics(qvgen::Batch<const double>{numbers.data(), count},
                          {q, {sizes.data(), count}, {status.data(), count}, {}, {}});

  const Joints here = Joints::Zero();
  const arm::Limits limits;
  std::size_t reached = 0, best = count;
  double least = INFINITY;
  for (std::size_t k = 0; k < count; ++k) {
    bool is_reached = false;
    for (std::size_t s = 0; s < static_cast<std::size_t>(sizes[k]); ++s) {
      Joints row;
      for (int i = 0; i < arm::dof; ++i) row[i] = q(s * arm::dof + static_cast<std::size_t>(i), k);
      if ((row.array() < limits.lower.array()).any() || (row.array() > limits.upper.array()).any()) continue;
      is_reached = true;
      const double distance = qvgen::joint_distance<arm::dof>(here, row, arm::is_revolute);
      if (distance < least) least = distance, best = k;
    }
    reached += is_reached ? 1 : 0;
  }
  std::printf("%zu of %zu grasps within limits, the nearest is number %zu, %.2f rad away\n", reached, count,
              best, least);
  return reached > 0 && reached < count && std::isfinite(least) ? 0 : 1;
}
