// SPDX-License-Identifier: MIT
// Prints a table of poses of an arm that differs from its description, as a tracker would have measured them:
// the data of the worked example. Usage: write_poses ROBOT ROWS
#include <cstdlib>
#include <iomanip>
#include <iostream>

#include <Eigen/Geometry>

#include "simulate.h"

int main(int argc, char** argv) {
  using namespace calibrate_test;
  if (argc != 3) return 2;
  Scene scene = scene_of(argv[1], 1);
  stand_anywhere(scene);
  scene.noise = 5e-5;
  std::cout << "# made by write_poses: errors of 1 mm and 5 mrad, noise of 0.05 mm and 0.05 mrad\n"
            << std::setprecision(12);
  std::size_t joint = 0;
  for (const auto& each : scene.truth.joints)
    std::cout << "q" << ++joint << (each.revolute ? " [deg], " : " [mm], ");
  std::cout << "x [mm], y [mm], z [mm], qw, qx, qy, qz\n";
  for (const Measurement& row : measure(scene, static_cast<std::size_t>(std::atoi(argv[2]))).rows) {
    constexpr double degrees = 57.295779513082321, milli = 1e3;
    for (std::size_t i = 0; i < row.q.size(); ++i)
      std::cout << row.q[i] * (scene.truth.joints[i].revolute ? degrees : milli) << ", ";
    const Eigen::Quaterniond turn(motion(row.pose).linear());
    for (const double each : row.pose.position) std::cout << each * milli << ", ";
    std::cout << turn.w() << ", " << turn.x() << ", " << turn.y() << ", " << turn.z() << "\n";
  }
}
