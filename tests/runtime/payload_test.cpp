// SPDX-License-Identifier: MIT
// A payload's wrench against the reference: an arm without inertia of its own whose last link is the payload.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/payload.h>

#include "reference/dynamics.h"
#include "reference/load.h"

namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Vector6d = Eigen::Matrix<double, 6, 1>;

class Payload : public testing::Test {
 protected:
  Payload() {
    reference::Joint& last = chain_.joints.back();
    const Eigen::Matrix3d turned = chain_.tool.linear();
    last.mass = box_.mass;
    last.centre_of_mass = chain_.tool * box_.centre_of_mass;
    last.inertia = turned * box_.inertia * turned.transpose();
  }

  VectorXd random() {
    return VectorXd::NullaryExpr(chain_.size(),
                                 [&] { return std::uniform_real_distribution(-3.0, 3.0)(random_); });
  }

  /// The derivative of J qd by time at constant rates.
  [[nodiscard]] Vector6d acceleration_bias(const VectorXd& q, const VectorXd& qd) const {
    const double step = 1e-5;
    return (reference::jacobian(chain_, q + step * qd) - reference::jacobian(chain_, q - step * qd)) * qd /
           (2 * step);
  }

  reference::Chain chain_ = reference::load(QVGEN_SOURCE_DIR "/tests/dynamics/robots/oblique.toml", {});
  const qvgen::Payload<double> box_{
      2.5,
      {0.02, -0.03, 0.06},
      (Eigen::Matrix3d() << 0.02, 0.003, -0.001, 0.003, 0.03, 0.002, -0.001, 0.002, 0.025).finished()};

 private:
  std::mt19937 random_{3};
};

TEST_F(Payload, WrenchIsWhatTheArmFeels) {
  const Vector3d fall(1, -2, -9);
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = random(), qd = random(), qdd = random();
    const MatrixXd jacobian = reference::jacobian(chain_, q);
    const Vector6d twist = jacobian * qd, acceleration = jacobian * qdd + acceleration_bias(q, qd);
    const Eigen::Matrix3d rotation = reference::forward_kinematics(chain_, q).linear();
    const Vector6d wrench = qvgen::payload_wrench<double>(box_, rotation, twist, acceleration, fall);
    const VectorXd expected = reference::inverse_dynamics(chain_, q, qd, qdd, -fall);
    // The second difference of the acceleration leaves 1e-10 of its size.
    EXPECT_LE((-jacobian.transpose() * wrench - expected).cwiseAbs().maxCoeff(),
              1e-7 * (1 + expected.cwiseAbs().maxCoeff()));
  }
}

TEST_F(Payload, MassMatrixIsTheArms) {
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = random();
    const MatrixXd jacobian = reference::jacobian(chain_, q);
    const Eigen::Matrix3d rotation = reference::forward_kinematics(chain_, q).linear();
    const MatrixXd found =
        jacobian.transpose() * qvgen::payload_mass_matrix<double>(box_, rotation) * jacobian;
    const MatrixXd expected = reference::mass_matrix(chain_, q);
    EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 1e-12 * (1 + expected.cwiseAbs().maxCoeff()));
  }
}

TEST_F(Payload, NothingWeighsNothing) {
  const Vector6d motion = Vector6d::Constant(2);
  const auto wrench =
      qvgen::payload_wrench<double>({}, Eigen::Matrix3d::Identity(), motion, motion, {0, 0, -9.8});
  EXPECT_EQ(wrench, Vector6d::Zero().eval());
}

}  // namespace
