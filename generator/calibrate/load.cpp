// SPDX-License-Identifier: MIT
#include "calibrate/load.h"

#include <random>

namespace qvgen::calibrate {

std::vector<double> greatest_loads(const Geometry<double>& geometry) {
  constexpr int postures = 400;
  constexpr double rounding = 1e-9;
  std::vector<double> greatest(geometry.joints.size(), 0.0);
  if (geometry.bodies.empty()) return greatest;
  std::mt19937 random(1);
  for (int i = 0; i < postures; ++i) {
    std::vector<double> q(geometry.turning.size());
    for (double& each : q) each = 6.283185307179586 * (static_cast<double>(random()) / 4294967296.0);
    const std::vector<double> loads = loads_of(geometry, posture_of(geometry, q.data()), 1.0);
    for (std::size_t k = 0; k < loads.size(); ++k) greatest[k] = std::max(greatest[k], std::abs(loads[k]));
  }
  for (double& each : greatest) each = each > rounding ? standard_gravity * each : 0;
  return greatest;
}

}  // namespace qvgen::calibrate
