// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "dynamics_under_test.h"
#include "reference/dynamics.h"
#include "reference/load.h"

namespace qvgen::test {

/// Laws that the generated dynamics of every robot obey, and the reference that they equal. A robot whose
/// inertial parameters are symbols gets random ones of real bodies; `gravity` differs from the default, so
/// that it is used.
class GeneratedDynamics : public testing::TestWithParam<DynamicsFactory> {
 protected:
  static constexpr double gravity = 9.5;
  static constexpr int configurations = 150;

  GeneratedDynamics() {
    reference::Values values;
    std::vector<double> numbers;
    for (const std::string& name : GetParam().inertia_names) {
      numbers.push_back(plausible(name));
      values[name] = numbers.back();
    }
    chain_ = reference::load(GetParam().description, values);
    robot_ = GetParam().make(numbers);
  }

  const DynamicsUnderTest& robot() const { return *robot_; }
  Eigen::Index dof() const { return chain_.size(); }

  /// Masses near 2 kg, centres within a few centimetres, moments far from the triangle inequality's edge.
  double plausible(const std::string& name) {
    if (name[0] == 'm') return 2 + unit(random_);
    if (name[0] == 'c') return 0.1 * unit(random_);
    const bool product = name[0] == 'I' && name.size() > 2 &&
                         name[name.size() - 1] != name[name.size() - 2] && std::isalpha(name.back());
    if (product) return 0.02 * unit(random_);
    return 0.5 + 0.1 * unit(random_);
  }

  VectorXd random_joints() {
    VectorXd result(dof());
    for (double& x : result) x = 3 * unit(random_);
    return result;
  }
  Vector3d random_vector(double size) {
    const double x = unit(random_), y = unit(random_), z = unit(random_);
    return size * Vector3d(x, y, z);
  }
  VectorXd reference_torque(const VectorXd& q, const VectorXd& qd, const VectorXd& qdd, double g) const {
    return reference::inverse_dynamics(chain_, q, qd, qdd, reference::Vector3d(0, 0, g));
  }
  /// Rounding of some hundred operations on values of the size of the largest: 1e3 ulp would be 2e-13.
  static void expect_close(const MatrixXd& a, const MatrixXd& b, double tolerance = 1e-12) {
    EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance * (1 + b.cwiseAbs().maxCoeff()));
  }

  /// Ten of each link: mass, first moments, inertia about the origin of the link frame.
  VectorXd standard_parameters() const {
    const auto links = static_cast<Eigen::Index>(chain_.joints.size());
    VectorXd result(10 * links);
    for (Eigen::Index i = 0; i < links; ++i) {
      const reference::Joint& link = chain_.joints[static_cast<std::size_t>(i)];
      const Vector3d& c = link.centre_of_mass;
      const Eigen::Matrix3d about_origin =
          link.inertia + link.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
      result.segment<10>(10 * i) << link.mass, link.mass * c, about_origin.diagonal(), about_origin(0, 1),
          about_origin(1, 2), about_origin(0, 2);
    }
    return result;
  }

  std::uniform_real_distribution<double> unit{-1, 1};
  std::mt19937_64 random_{7};
  reference::Chain chain_;

 private:
  std::unique_ptr<DynamicsUnderTest> robot_;
};

/// x moving in a direction.
inline DualVector along(const VectorXd& x, const VectorXd& direction) {
  DualVector result(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) result[i] = Dual(x[i], direction[i]);
  return result;
}

inline std::string name_of(const testing::TestParamInfo<DynamicsFactory>& info) { return info.param.name; }

}  // namespace qvgen::test
