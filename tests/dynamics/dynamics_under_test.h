// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "dual.h"
#include "lagrange.h"
#include "reference/dynamics.h"
#include "reference/load.h"

/// Laws that the generated dynamics of every robot obey, and the reference that they equal. A robot whose
/// inertial parameters are symbols gets random ones of real bodies; `gravity` differs from the default, so
/// that it is used.
template <class Robot>
class GeneratedDynamics : public testing::Test {
 protected:
  static constexpr int dof = Robot::dof;
  using Joints = typename Robot::template Joints<double>;
  using Inertia = typename Robot::template Inertia<double>;
  using Matrix = Eigen::Matrix<double, dof, dof>;
  using Vector = Eigen::Matrix<double, dof, 1>;
  static constexpr double gravity = 9.5;
  static constexpr int configurations = 300;

  GeneratedDynamics() {
    constexpr std::size_t count = Robot::inertia_names.size();
    const std::string file = Robot::description;
    if constexpr (count > 0) {
      std::array<double, count> numbers;
      reference::Values values;
      for (std::size_t i = 0; i < count; ++i)
        values[Robot::inertia_names[i]] = numbers[i] = plausible(Robot::inertia_names[i]);
      static_assert(sizeof(Inertia) == sizeof(numbers));
      inertia_ = std::bit_cast<Inertia>(numbers);
      chain_ = reference::load(file, values);
    } else {
      chain_ = reference::load(file);
    }
  }

  /// Masses near 2 kg, centres within a few centimetres, moments far from the triangle inequality's edge.
  double plausible(const std::string& name) {
    if (name[0] == 'm') return 2 + unit(random_);
    if (name[0] == 'c') return 0.1 * unit(random_);
    const bool product = name[0] == 'I' && name.size() > 2 &&
                         name[name.size() - 1] != name[name.size() - 2] && std::isalpha(name.back());
    if (product) return 0.02 * unit(random_);
    return 0.5 + 0.1 * unit(random_);
  }

  Joints random_joints() {
    Joints result;
    for (int i = 0; i < dof; ++i) result[i] = 3 * unit(random_);
    return result;
  }
  Eigen::Vector3d random_vector(double size) {
    const double x = unit(random_), y = unit(random_), z = unit(random_);
    return size * Eigen::Vector3d(x, y, z);
  }
  Vector reference_torque(const Joints& q, const Joints& qd, const Joints& qdd, double g) const {
    return reference::inverse_dynamics(chain_, q, qd, qdd, reference::Vector3d(0, 0, g));
  }
  /// Rounding of some hundred operations on values of the size of the largest: 1e3 ulp would be 2e-13.
  static void expect_close(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double tolerance = 1e-12) {
    EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance * (1 + b.cwiseAbs().maxCoeff()));
  }

  /// Ten of each link: mass, first moments, inertia about the origin of the link frame.
  Eigen::Matrix<double, 10 * dof, 1> standard_parameters() const {
    Eigen::Matrix<double, 10 * dof, 1> result;
    for (int i = 0; i < dof; ++i) {
      const reference::Joint& link = chain_.joints[static_cast<std::size_t>(i)];
      const Eigen::Vector3d& c = link.centre_of_mass;
      const Eigen::Matrix3d about_origin =
          link.inertia + link.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
      result.template segment<10>(10 * i) << link.mass, link.mass * c, about_origin.diagonal(),
          about_origin(0, 1), about_origin(1, 2), about_origin(0, 2);
    }
    return result;
  }

  std::uniform_real_distribution<double> unit{-1, 1};
  std::mt19937_64 random_{7};
  Inertia inertia_{};
  reference::Chain chain_;
};

template <int N>
Eigen::Matrix<Dual, N, 1> along(const Eigen::Matrix<double, N, 1>& x,
                                const Eigen::Matrix<double, N, 1>& direction) {
  Eigen::Matrix<Dual, N, 1> result;
  for (int i = 0; i < N; ++i) result[i] = Dual(x[i], direction[i]);
  return result;
}

template <class To, class From>
To with_scalar(const From& from) {
  if constexpr (std::is_empty_v<From>) {
    return {};
  } else {
    constexpr std::size_t count = sizeof(From) / sizeof(double);
    const auto numbers = std::bit_cast<std::array<double, count>>(from);
    To result;
    auto* fields = reinterpret_cast<Dual*>(&result);
    for (std::size_t i = 0; i < count; ++i) fields[i] = Dual(numbers[i]);
    return result;
  }
}

TYPED_TEST_SUITE_P(GeneratedDynamics);
