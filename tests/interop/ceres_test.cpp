// SPDX-License-Identifier: MIT
// Costs of poses: their Jacobians against differences, and problems that Ceres solves to the pose.
#include <random>

#include <ceres/ceres.h>
#include <ceres/sized_cost_function.h>
#include <gtest/gtest.h>
#include <qvgen/pose_cost.h>
#include <qvgen/robots/puma560.h>
#include <qvgen/robots/ur5.h>

namespace {

template <int dof>
using Joints = Eigen::Matrix<double, dof, 1>;

const auto puma560 = [](const Joints<6>& q) {
  return std::pair{qvgen::robots::puma560::forward_kinematics(q), qvgen::robots::puma560::jacobian(q)};
};
const auto ur5 = [](const Joints<6>& q) {
  return std::pair{qvgen::robots::ur5::forward_kinematics(q), qvgen::robots::ur5::jacobian(q)};
};

Joints<6> random_joints(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  Joints<6> q;
  for (double& each : q) each = uniform(random);
  return q;
}

/// Compares the Jacobian of a cost at joints with central differences of its residuals.
template <class Cost>
void expect_derivative(const Cost& cost, const Joints<6>& q) {
  const auto residuals = [&](const Joints<6>& at, double* jacobian) {
    Joints<6> result;
    const double* parameters[] = {at.data()};
    double* jacobians[] = {jacobian};
    EXPECT_TRUE(cost.Evaluate(parameters, result.data(), jacobian == nullptr ? nullptr : jacobians));
    return result;
  };
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> jacobian;
  residuals(q, jacobian.data());
  const double step = 1e-6;
  for (int k = 0; k < 6; ++k) {
    const Joints<6> way = step * Joints<6>::Unit(k);
    const Joints<6> slope = (residuals(q + way, nullptr) - residuals(q - way, nullptr)) / (2 * step);
    EXPECT_LT((jacobian.col(k) - slope).norm(), 2e-7 * (1 + slope.norm()))
        << "joint " << k << " at " << q.transpose();
  }
}

TEST(PoseCost, JacobianIsTheDerivative) {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    const Joints<6> q = random_joints(random, 3), other = random_joints(random, 3);
    const auto target = puma560(other).first;
    const double turn =
        qvgen::rotation_vector<double>(puma560(q).first.orientation * target.orientation.conjugate()).norm();
    if (turn > 3.1) continue;  // next to half a turn the rotation vector jumps
    expect_derivative(*qvgen::pose_cost<6>(target, puma560, 0.3), q);
  }
}

TEST(PoseCost, JacobianNextToTheTarget) {
  std::mt19937 random(6);
  for (const double size : {0.0, 1e-9, 1e-3, 4.9e-3, 5.1e-3, 0.02}) {
    const Joints<6> q = random_joints(random, 1);
    const auto target = ur5(q + random_joints(random, size)).first;
    expect_derivative(*qvgen::pose_cost<6>(target, ur5), q);
  }
}

TEST(PoseCost, CeresReachesThePose) {
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i) {
    const Joints<6> goal = random_joints(random, 1.2);
    const auto target = ur5(goal).first;
    Joints<6> q = goal + random_joints(random, 0.1);
    ceres::Problem problem;
    problem.AddResidualBlock(qvgen::pose_cost<6>(target, ur5).release(), nullptr, q.data());
    ceres::Solver::Options options;
    options.logging_type = ceres::SILENT;
    options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 1e-16;
    options.max_num_iterations = 200;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    EXPECT_LT(summary.final_cost, 1e-18) << summary.BriefReport();
    EXPECT_LT((ur5(q).first.position - target.position).norm(), 1e-9);
    EXPECT_GT(std::abs(ur5(q).first.orientation.dot(target.orientation)), 1 - 1e-15);
  }
}

TEST(PoseCost, WhatIsNoNumberIsRefused) {
  Joints<6> q = Joints<6>::Zero(), residuals;
  q[2] = std::nan("");
  const double* parameters[] = {q.data()};
  EXPECT_FALSE(qvgen::pose_cost<6>(ur5(Joints<6>::Zero()).first, ur5)
                   ->Evaluate(parameters, residuals.data(), nullptr));
}

}  // namespace
