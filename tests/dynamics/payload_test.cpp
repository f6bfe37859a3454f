// SPDX-License-Identifier: MIT
// A payload at run time against the reference, whose last link has it from the start.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/payload.h>
#include <qvgen/robots/puma560.h>
#include <qvgen/robots/puma560/dynamics_loads.h>

#include "reference/dynamics.h"
#include "reference/load.h"

namespace {

namespace arm = qvgen::robots::puma560;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Joints = arm::JointVector<double>;
using Payload = qvgen::Payload<double>;

/// The tensor of a body about another point.
Matrix3d moved(const Matrix3d& inertia, double mass, const Vector3d& way) {
  return inertia + mass * (way.squaredNorm() * Matrix3d::Identity() - way * way.transpose());
}

reference::Chain with_payload(reference::Chain chain, const Payload& payload) {
  reference::Joint& last = chain.joints.back();
  const Vector3d centre = chain.tool * payload.centre;
  const double mass = last.mass + payload.mass;
  const Vector3d both = (last.mass * last.centre_of_mass + payload.mass * centre) / mass;
  const Matrix3d turned = chain.tool.linear() * payload.inertia * chain.tool.linear().transpose();
  last.inertia =
      moved(last.inertia, last.mass, last.centre_of_mass - both) + moved(turned, payload.mass, centre - both);
  last.mass = mass;
  last.centre_of_mass = both;
  return chain;
}

class Random {
 public:
  Joints joints() {
    return 2 * Joints::NullaryExpr([&] { return uniform_(engine_); });
  }
  Vector3d vector() {
    return Vector3d::NullaryExpr([&] { return uniform_(engine_); });
  }
  Payload payload() {
    Matrix3d root;
    for (double& x : root.reshaped()) x = 0.1 * uniform_(engine_);
    return {2.5 + 2 * uniform_(engine_), 0.2 * vector(), root * root.transpose()};
  }

 private:
  std::mt19937 engine_{5};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

qvgen::ToolMotion<double> motion_of(const Joints& q, const Joints& qd, const Joints& qdd) {
  return {arm::forward_kinematics(q), arm::velocity(q, qd),
          arm::jacobian(q) * qdd + arm::jacobian_dot_times_qd(q, qd)};
}

/// Joint forces of the arm with a payload.
Joints torque_of(const Payload& payload, const Joints& q, const Joints& qd, const Joints& qdd,
                 const Vector3d& gravity) {
  const arm::Wrench<double> wrench = qvgen::payload_wrench(payload, motion_of(q, qd, qdd), gravity);
  return arm::inverse_dynamics(q, qd, qdd, {}, {}, gravity, wrench);
}

class PayloadTest : public testing::Test {
 protected:
  Random random_;
  reference::Chain chain_ = reference::load(QVGEN_SOURCE_DIR "/generator/robots/puma560.toml");
};

TEST_F(PayloadTest, TorqueIsThatOfAnArmThatHasIt) {
  for (int i = 0; i < 200; ++i) {
    const Payload payload = random_.payload();
    const Joints q = random_.joints(), qd = random_.joints(), qdd = random_.joints();
    const Vector3d gravity = 9.81 * random_.vector();
    const auto expected = reference::inverse_dynamics(with_payload(chain_, payload), q, qd, qdd, -gravity);
    ASSERT_LT((torque_of(payload, q, qd, qdd, gravity) - expected).norm(), 1e-12 * (1 + expected.norm()));
  }
}

TEST_F(PayloadTest, MassMatrixAndAccelerations) {
  for (int i = 0; i < 200; ++i) {
    const Payload payload = random_.payload();
    const Joints q = random_.joints(), qd = random_.joints(), torque = 50 * random_.joints();
    const Vector3d gravity = 9.81 * random_.vector();
    const auto heavier = with_payload(chain_, payload);
    const arm::Jacobian<double> j = arm::jacobian(q);
    const auto inertia = qvgen::payload_inertia(payload, arm::forward_kinematics(q).orientation);
    const Eigen::Matrix<double, 6, 6> masses = arm::mass_matrix(q);
    const Eigen::Matrix<double, 6, 6> whole = masses + j.transpose() * inertia * j;
    ASSERT_LT((whole - reference::mass_matrix(heavier, q)).norm(), 1e-12 * whole.norm());
    const Joints bias = torque_of(payload, q, qd, Joints::Zero(), gravity);
    const Joints found = qvgen::forward_dynamics_with_payload<double, 6>(masses, j, inertia, torque, bias);
    const auto expected = reference::forward_dynamics(heavier, q, qd, torque, -gravity);
    ASSERT_LT((found - expected).norm(), 1e-10 * (1 + expected.norm()));
  }
}

TEST_F(PayloadTest, NothingAddsNothing) {
  const Joints q = random_.joints(), qd = random_.joints(), qdd = random_.joints();
  EXPECT_TRUE(qvgen::payload_wrench(Payload(), motion_of(q, qd, qdd), Vector3d(0, 0, -9.81)).isZero(0));
  EXPECT_TRUE(qvgen::payload_inertia(Payload(), Eigen::Quaterniond::Identity()).isZero(0));
  const Eigen::Matrix<double, 6, 6> none = -Eigen::Matrix<double, 6, 6>::Identity();
  EXPECT_TRUE((qvgen::forward_dynamics_with_payload<double, 6>(none, arm::jacobian(q), 0 * none, q, qd)
                   .array()
                   .isNaN())
                  .all());
}

}  // namespace
