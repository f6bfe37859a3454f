// SPDX-License-Identifier: MIT
// Prints the log of a UR5 whose links, drives and payload are known here, as a controller would have recorded
// it: the data of the worked example. Usage: write_log SEED SECONDS PAYLOAD_KG
#include <cstdlib>
#include <iostream>

#include <fmt/format.h>

#include "simulated.h"

namespace {

constexpr double degree = 3.14159265358979323846 / 180;

/// The true arm: links like tubes, gears with friction.
reference::Chain true_arm(double payload) {
  reference::Chain chain = reference::load(QVGEN_SOURCE_DIR "/generator/robots/ur5.toml");
  constexpr double mass[] = {3.8, 8.2, 2.4, 1.2, 1.3, 0.25};
  constexpr double viscous[] = {12, 12, 9, 2.5, 2.5, 2}, coulomb[] = {9, 11, 7, 2, 1.8, 1.5};
  constexpr double rotor[] = {1.5, 1.5, 0.9, 0.25, 0.25, 0.25};
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    reference::Joint& joint = chain.joints[i];
    joint.mass = mass[i];
    joint.centre_of_mass = -0.45 * (joint.after.linear().transpose() * joint.after.translation()) +
                           Eigen::Vector3d(0.004, -0.01, 0.006 * static_cast<double>(i));
    const double length = std::max(0.1, joint.after.translation().norm());
    joint.inertia = mass[i] * length * length / 12 * Eigen::Vector3d(0.4, 1, 1.1).asDiagonal();
    joint.viscous_friction = viscous[i];
    joint.coulomb_friction = coulomb[i];
    joint.rotor_inertia = rotor[i];
  }
  if (payload == 0) return chain;
  reference::Joint& last = chain.joints.back();
  const Eigen::Vector3d at(0.02, 0, 0.06),
      both = (last.mass * last.centre_of_mass + payload * at) / (last.mass + payload);
  const auto about = [&](double m, const Eigen::Vector3d& c) -> Eigen::Matrix3d {
    const Eigen::Vector3d r = c - both;
    return m * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  };
  last.inertia += about(last.mass, last.centre_of_mass) + about(payload, at) +
                  payload * Eigen::Vector3d(0.002, 0.0025, 0.0015).asDiagonal().toDenseMatrix();
  last.centre_of_mass = both;
  last.mass += payload;
  return chain;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const auto seed = static_cast<unsigned>(std::atoi(argv[1]));
  const double seconds = std::atof(argv[2]);
  constexpr double rate = 200;
  qvgen::identify::MotionLog log = qvgen::test::simulated(
      true_arm(std::atof(argv[3])), static_cast<Eigen::Index>(rate * seconds), seed, seconds);
  qvgen::test::add_noise(log, Eigen::VectorXd::Map(std::array{1.0, 1.2, 0.7, 0.2, 0.2, 0.2}.data(), 6), seed);
  std::cout << "time [s]";
  for (const char* const name : {"q{} [deg]", "torque{} [Nm]"})
    for (int i = 1; i <= 6; ++i) std::cout << ", " << fmt::format(fmt::runtime(name), i);
  std::cout << "\n";
  for (Eigen::Index k = 0; k < log.samples(); ++k) {
    std::cout << fmt::format("{:.4f}", log.time[static_cast<std::size_t>(k)]);
    for (Eigen::Index i = 0; i < 6; ++i) std::cout << fmt::format(", {:.5f}", log.q(k, i) / degree);
    for (Eigen::Index i = 0; i < 6; ++i) std::cout << fmt::format(", {:.3f}", log.torque(k, i));
    std::cout << "\n";
  }
}
