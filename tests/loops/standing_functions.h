// SPDX-License-Identifier: MIT
// Generated functions in C of a mechanism with loops on a base that stands, and the laws of its motion: rates
// and accelerations keep the reference's gaps closed, multipliers say how motors move it, and its kinetic
// energy is that of its links.
#pragma once

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "compiled_loops.h"
#include "reference/dynamics.h"
#include "reference/linear_algebra.h"
#include "reference/loops.h"

namespace qvgen::test::loops {

/// Functions of a mechanism by its name, at its own geometry and inertia.
class StandingFunctions {
 public:
  StandingFunctions(const Compiled& compiled, std::string name, const reference::LoopMechanism& of)
      : compiled_(&compiled),
        name_(std::move(name)),
        dof_(static_cast<Eigen::Index>(of.chain.joints.size())),
        driven_(static_cast<Eigen::Index>(of.driven.size())) {}

  [[nodiscard]] Set assemble(const VectorXd& a) const {
    return compiled_->solve(name_ + "_assemble", a, dof_);
  }
  [[nodiscard]] MatrixXd rates(const VectorXd& q) const {
    MatrixXd result(driven_, dof_);
    get<void(const double*, const double*, double*)>("rates")(q.data(), nullptr, result.data());
    return result.transpose();
  }
  [[nodiscard]] double drive_measure(const VectorXd& q) const {
    return get<double(const double*, const double*)>("drive_measure")(q.data(), nullptr);
  }
  [[nodiscard]] VectorXd accelerations(const VectorXd& q, const VectorXd& qd, const VectorXd& add) const {
    VectorXd result(dof_);
    get<void(const double*, const double*, const double*, const double*, double*)>("accelerations")(
        q.data(), qd.data(), add.data(), nullptr, result.data());
    return result;
  }
  [[nodiscard]] MatrixXd mass_matrix(const VectorXd& q) const {
    MatrixXd result(driven_, driven_);
    get<void(const double*, const double*, const double*, double*)>("driven_mass_matrix")(
        q.data(), nullptr, nullptr, result.data());
    return result;
  }
  [[nodiscard]] VectorXd inverse_dynamics(const VectorXd& q, const VectorXd& ad, const VectorXd& add) const {
    return dynamics("driven_inverse_dynamics", q, ad, add, driven_);
  }
  [[nodiscard]] VectorXd forward_dynamics(const VectorXd& q, const VectorXd& ad,
                                          const VectorXd& forces) const {
    return dynamics("driven_forward_dynamics", q, ad, forces, driven_);
  }

 private:
  template <class Function>
  [[nodiscard]] Function* get(const std::string& function) const {
    return compiled_->get<Function>(name_ + "_" + function);
  }
  [[nodiscard]] VectorXd dynamics(const std::string& function, const VectorXd& q, const VectorXd& ad,
                                  const VectorXd& more, Eigen::Index size) const {
    constexpr double gravity = 9.81;  // m/s^2, as the reference has it
    VectorXd result(size);
    get<void(const double*, const double*, const double*, const double*, const double*, double, double*)>(
        function)(q.data(), ad.data(), more.data(), nullptr, nullptr, gravity, result.data());
    return result;
  }
  const Compiled* compiled_;
  std::string name_;
  Eigen::Index dof_, driven_;
};

/// Expects the laws of a random motion at joints q, where the loops are closed, apart from dead centres.
inline void expect_motion_laws(const StandingFunctions& m, const reference::LoopMechanism& of,
                               const VectorXd& q, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-2, 2);
  const auto driven = static_cast<Eigen::Index>(of.driven.size());
  const auto draw = [&] { return VectorXd::NullaryExpr(driven, [&] { return unit(random); }).eval(); };
  const VectorXd ad = draw(), add = draw(), forces = draw();
  const MatrixXd rates = m.rates(q);
  const VectorXd qd = rates * ad, qdd = m.accelerations(q, qd, add);
  const double scale = 1 + qdd.norm() + qd.squaredNorm();
  const MatrixXd jacobian = reference::gap_jacobian(of, q);
  EXPECT_LT((jacobian * qd).norm(), 1e-10 * scale * (1 + of.size));
  const double step = 1e-5;
  const MatrixXd bent =
      (reference::gap_jacobian(of, q + step * qd) - reference::gap_jacobian(of, q - step * qd)) / (2 * step);
  EXPECT_LT((jacobian * qdd + bent * qd).norm(), 1e-7 * scale * (1 + qd.norm()) * (1 + of.size));
  VectorXd on_joints = VectorXd::Zero(q.size());
  for (Eigen::Index i = 0; i < driven; ++i) on_joints[of.driven[static_cast<std::size_t>(i)]] = forces[i];
  const VectorXd expected = reference::constrained_acceleration(of, q, qd, on_joints);
  const VectorXd found = m.forward_dynamics(q, ad, forces);
  for (Eigen::Index i = 0; i < driven; ++i)
    EXPECT_NEAR(found[i], expected[of.driven[static_cast<std::size_t>(i)]],
                2e-6 * (1 + expected.norm()) * (1 + qd.norm()));
  EXPECT_LT((m.inverse_dynamics(q, ad, found) - forces).norm(),
            1e-9 * (1 + forces.norm() + (m.mass_matrix(q) * found).norm()));
  const double energy = reference::kinetic_energy(of.chain, q, qd);
  EXPECT_NEAR(ad.dot(m.mass_matrix(q) * ad) / 2, energy, 1e-11 * (1 + energy));
}

}  // namespace qvgen::test::loops
