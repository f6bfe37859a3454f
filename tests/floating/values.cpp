// SPDX-License-Identifier: MIT
// Writes what the quadruped's functions give at random motions, for compare_with_peers.py: names of the
// joints, then for each motion a line a quantity, in the notations of Pinocchio and MuJoCo.
#include <cstdio>
#include <string>

#include <qvgen/base_conventions.h>

#include "quad.h"

namespace {

template <class Values>
void write(const char* name, const Values& values) {
  std::printf("%s", name);
  for (Eigen::Index k = 0; k < values.cols(); ++k)
    for (Eigen::Index i = 0; i < values.rows(); ++i) std::printf(" %.17g", values(i, k));
  std::printf("\n");
}

}  // namespace

int main() {
  using namespace qvgen;
  using namespace qvgen::test::floating;
  constexpr double gravity = 9.81;
  std::printf("joints");
  for (const char* name : quad::joint_names) std::printf(" %s", name);
  std::printf("\ntips");
  for (const char* name : quad::tip_names) std::printf(" %s", name);
  std::printf("\n");
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const QuadMotion m(seed);
    const Rates coriolis = quad::coriolis_torque(m.at, m.qd);
    const Rates found = quad::forward_dynamics(m.at, m.qd, m.force, {}, {}, gravity);
    const auto c = centroidal(m.at, quad::momentum_matrix(m.at));
    write("pinocchio_position", Pinocchio::position(m.at));
    write("mujoco_position", MuJoCo::position(m.at));
    write("velocity", m.qd);
    write("mujoco_velocity", MuJoCo::velocity(m.at, m.qd));
    write("acceleration", m.qdd);
    write("mujoco_acceleration", MuJoCo::acceleration(m.at, m.qd, m.qdd));
    write("force", m.force);
    const Rates torque = quad::inverse_dynamics(m.at, m.qd, m.qdd, {}, {}, gravity);
    write("inverse_dynamics", torque);
    write("mujoco_inverse_dynamics", MuJoCo::force(m.at, torque));
    write("gravity", quad::gravity_torque(m.at, {}, {}, gravity));
    write("mass_matrix", quad::mass_matrix(m.at));
    write("forward_dynamics", found);
    write("kinetic_energy", Eigen::Matrix<double, 1, 1>(quad::kinetic_energy(m.at, m.qd)));
    write("centre_of_mass", c.centre);
    write("centre_of_mass_velocity", c.velocity(m.qd));
    write("centroidal_matrix", c.matrix);
    write("centroidal_rate", c.momentum_rate(m.qdd, coriolis));
    for (const auto& tip : quad::tip_motions(m.at, m.qd)) {
      write("tip_position", tip.pose.position);
      write("tip_jacobian", tip.jacobian);
      write("tip_bias", tip.bias);
    }
    std::printf("end\n");
  }
  return 0;
}
