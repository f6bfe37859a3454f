// SPDX-License-Identifier: MIT
// Motions of arms whose parameters are known: torques come from the tests' own dynamics, which share no code
// with the generator.
#pragma once

#include <random>
#include <string>

#include "description/reader.h"
#include "identify/arm_regressor.h"
#include "identify/motion_log.h"
#include "reference/dynamics.h"
#include "reference/load.h"

namespace qvgen::test {

inline const Eigen::Vector3d gravity{0, 0, 9.80665};

inline model::Robot read_arm(const std::string& text) {
  const description::ReadResult result = description::read_text(text, "arm.toml");
  if (!result.robot)
    throw std::runtime_error(description::to_string(result.diagnostics.front()) + "\n" + text);
  return *result.robot;
}

inline void fill_torques(const reference::Chain& chain, identify::MotionLog& log) {
  for (Eigen::Index k = 0; k < log.samples(); ++k)
    log.torque.row(k) = reference::inverse_dynamics(
        chain, log.q.row(k).transpose(), log.qd.row(k).transpose(), log.qdd.row(k).transpose(), gravity);
}

/// A motion of some sines a joint with exact rates and accelerations, and the torques of the chain.
inline identify::MotionLog simulated(const reference::Chain& chain, Eigen::Index samples, unsigned seed,
                                     double seconds = 10) {
  const Eigen::Index n = chain.size();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> phase(-3, 3), size(0.2, 0.6), rate(0.5, 3);
  identify::MotionLog log{"simulated", {}, {}, {}, {}, {}};
  for (Eigen::MatrixXd* part : {&log.q, &log.qd, &log.qdd, &log.torque}) part->setZero(samples, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (int wave = 0; wave < 4; ++wave) {
      const double w = rate(random), p = phase(random), a = size(random);
      for (Eigen::Index k = 0; k < samples; ++k) {
        const double t = w * seconds * static_cast<double>(k) / static_cast<double>(samples) + p;
        log.q(k, i) += a * std::sin(t);
        log.qd(k, i) += a * w * std::cos(t);
        log.qdd(k, i) -= a * w * w * std::sin(t);
      }
    }
  for (Eigen::Index k = 0; k < samples; ++k)
    log.time.push_back(seconds * static_cast<double>(k) / static_cast<double>(samples));
  fill_torques(chain, log);
  return log;
}

inline void add_noise(identify::MotionLog& log, const Eigen::VectorXd& deviation, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (Eigen::Index i = 0; i < log.joints(); ++i)
    for (Eigen::Index k = 0; k < log.samples(); ++k) log.torque(k, i) += deviation[i] * normal(random);
}

/// Standard parameters of all links, then the four drive parameters of all joints and of all motors, as
/// identify::ArmRegressor::combination takes them.
inline Eigen::VectorXd parameters_of(const reference::Chain& chain) {
  const auto links = static_cast<Eigen::Index>(chain.joints.size());
  Eigen::VectorXd x(14 * links + 4 * static_cast<Eigen::Index>(chain.motors.size()));
  for (Eigen::Index i = 0; i < links; ++i) {
    const reference::Joint& joint = chain.joints[static_cast<std::size_t>(i)];
    const Eigen::Vector3d c = joint.centre_of_mass;
    const Eigen::Matrix3d about_origin =
        joint.inertia + joint.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
    x.segment(10 * i, 10) << joint.mass, joint.mass * c, about_origin(0, 0), about_origin(1, 1),
        about_origin(2, 2), about_origin(0, 1), about_origin(1, 2), about_origin(0, 2);
    x.segment(10 * links + 4 * i, 4) << joint.rotor_inertia, joint.viscous_friction, joint.coulomb_friction,
        0;
  }
  Eigen::Index place = 14 * links;
  for (const reference::Motor& motor : chain.motors) {
    x.segment(place, 4) << motor.rotor_inertia, motor.viscous_friction, motor.coulomb_friction, 0;
    place += 4;
  }
  return x;
}

/// The chain with these parameters in place of its own; offsets are left out.
inline reference::Chain with_parameters(reference::Chain chain, const Eigen::VectorXd& x) {
  const auto links = static_cast<Eigen::Index>(chain.joints.size());
  for (Eigen::Index i = 0; i < links; ++i) {
    reference::Joint& joint = chain.joints[static_cast<std::size_t>(i)];
    const Eigen::VectorXd p = x.segment(10 * i, 10), d = x.segment(10 * links + 4 * i, 4);
    joint.mass = p[0];
    joint.centre_of_mass =
        p[0] == 0 ? Eigen::Vector3d(p.segment(1, 3)) : Eigen::Vector3d(p.segment(1, 3) / p[0]);
    joint.inertia << p[4], p[7], p[9], p[7], p[5], p[8], p[9], p[8], p[6];
    const Eigen::Vector3d c = joint.centre_of_mass;
    joint.inertia -= p[0] * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
    joint.rotor_inertia = d[0];
    joint.viscous_friction = d[1];
    joint.coulomb_friction = d[2];
  }
  Eigen::Index place = 14 * links;
  for (reference::Motor& motor : chain.motors) {
    motor.rotor_inertia = x[place];
    motor.viscous_friction = x[place + 1];
    motor.coulomb_friction = x[place + 2];
    place += 4;
  }
  return chain;
}

}  // namespace qvgen::test
