// SPDX-License-Identifier: MIT
// Lagrange's equations of a mechanism with loops in its motors' coordinates, in sixty digits. Newton's steps
// close the loops for values of the motors; so kinetic and potential energy are functions of the motors'
// values and rates, which differences of step 1e-20 differentiate. No constraint's force and no second
// derivative of a loop occurs.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "dynamics/lagrangian.h"
#include "jacobian/exact_scalar.h"
#include "reference/linear_algebra.h"
#include "reference/loops.h"

namespace qvgen::test::loops {

class EmbeddedEnergy {
 public:
  using Values = std::vector<Exact>;

  /// At joints that close the loops to rounding, next to which all other joints are found.
  EmbeddedEnergy(const reference::LoopMechanism& of, const Eigen::VectorXd& q)
      : of_(&of), seed_(exact(q)), step_(Exact::power_of_ten(-20)) {
    const Eigen::MatrixXd by_joints = reference::gap_jacobian(of, q);
    Eigen::MatrixXd passive(by_joints.rows(), static_cast<Eigen::Index>(of.passive.size()));
    for (std::size_t i = 0; i < of.passive.size(); ++i)
      passive.col(static_cast<Eigen::Index>(i)) = by_joints.col(of.passive[i]);
    inverse_.resize(passive.cols(), passive.rows());
    for (Eigen::Index row = 0; row < passive.rows(); ++row)
      inverse_.col(row) =
          reference::least_squares(passive, Eigen::VectorXd(Eigen::VectorXd::Unit(passive.rows(), row)));
  }

  [[nodiscard]] static Values exact(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }
  [[nodiscard]] static Eigen::VectorXd rounded(const Values& values) {
    Eigen::VectorXd result(static_cast<Eigen::Index>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i)
      result[static_cast<Eigen::Index>(i)] = static_cast<double>(values[i]);
    return result;
  }

  /// All joints for values of the motors.
  [[nodiscard]] Values joints(const Values& a) const {
    Values q = seed_;
    for (std::size_t i = 0; i < a.size(); ++i) q[static_cast<std::size_t>(of_->driven[i])] = a[i];
    constexpr int most_steps = 60;
    for (int k = 0; k < most_steps; ++k) {
      const Values off = gaps(q);
      double worst = 0;
      for (const Exact& each : off) worst = std::max(worst, std::abs(static_cast<double>(each)));
      if (worst < 1e-55) return q;
      for (std::size_t i = 0; i < of_->passive.size(); ++i)
        for (std::size_t row = 0; row < off.size(); ++row)
          q[static_cast<std::size_t>(of_->passive[i])] -=
              Exact(inverse_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(row))) * off[row];
    }
    throw std::runtime_error("the loops do not close in sixty digits");
  }

  /// Forces of the motors at their values a, rates and accelerations.
  [[nodiscard]] Values forces(const Values& a, const Values& ad, const Values& add) const {
    const Exact half(0.5);
    const Values after = moved(a, ad, step_), before = moved(a, ad, -step_);
    const Values faster = moved(ad, add, step_), slower = moved(ad, add, -step_);
    const Values qd = rates(a, ad);
    Values result;
    for (std::size_t k = 0; k < a.size(); ++k) {
      Values unit(a.size(), Exact(0.0));
      unit[k] = Exact(1.0);
      const Exact by_time = (momentum(after, faster, unit) - momentum(before, slower, unit)) * half / step_;
      const Exact by_place =
          (energy(moved(a, unit, step_), ad) - energy(moved(a, unit, -step_), ad)) * half / step_;
      result.push_back(by_time - by_place + losses(rates(a, unit), qd));
    }
    return result;
  }

 private:
  using Body = lagrange::Body<Exact>;
  using Vector = lagrange::Vector<Exact>;

  [[nodiscard]] static Values moved(Values values, const Values& way, const Exact& by) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += by * way[i];
    return values;
  }
  [[nodiscard]] Values rates(const Values& a, const Values& ad) const {
    const Values after = joints(moved(a, ad, step_));
    Values result = joints(moved(a, ad, -step_));
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = (after[i] - result[i]) * Exact(0.5) / step_;
    return result;
  }
  /// Kinetic less potential energy, that of rotors included.
  [[nodiscard]] Exact energy(const Values& a, const Values& ad) const {
    const Values qd = rates(a, ad);
    Exact sum = lagrange::lagrangian(of_->chain, joints(a), qd, Eigen::Vector3d(0, 0, -9.81));
    for (std::size_t i = 0; i < qd.size(); ++i)
      sum += Exact(of_->chain.joints[i].rotor_inertia / 2) * qd[i] * qd[i];
    return sum;
  }
  /// The derivative of the energy by a rate, of which it is a polynomial of degree two.
  [[nodiscard]] Exact momentum(const Values& a, const Values& ad, const Values& unit) const {
    return (energy(a, moved(ad, unit, Exact(1.0))) - energy(a, moved(ad, unit, Exact(-1.0)))) * Exact(0.5);
  }
  [[nodiscard]] Exact losses(const Values& by_motor, const Values& qd) const {
    Exact sum(0.0);
    for (std::size_t i = 0; i < qd.size(); ++i) {
      const reference::Joint& joint = of_->chain.joints[i];
      const double sign = static_cast<double>(qd[i]) < 0 ? -1 : 1;
      sum += by_motor[i] * (Exact(joint.viscous_friction) * qd[i] + Exact(sign * joint.coulomb_friction));
    }
    return sum;
  }

  /// Gaps of points that are one, of rods and of gears, with the derivatives that the reference has where the
  /// loops are closed.
  [[nodiscard]] Values gaps(const Values& q) const {
    const std::vector<Body> links = bodies(q);
    const auto end = [&](const reference::Closure& closure, std::size_t i) {
      const Eigen::Index link = closure.links.at(i);
      Body body = link < 0 ? base() : links[static_cast<std::size_t>(link)];
      body.move(lagrange::vector<Exact>(closure.points.at(i)));
      return body.position;
    };
    Values result;
    for (const reference::Closure& closure : of_->closures) {
      if (closure.is_rigid) throw std::runtime_error("no links that are one in sixty digits");
      const Vector way = difference(end(closure, 0), end(closure, 1));
      if (closure.is_rod()) {
        const Exact length = closure.length_joint < 0 ? Exact(closure.length)
                                                      : q[static_cast<std::size_t>(closure.length_joint)];
        result.push_back((lagrange::dot(way, way) - length * length) * Exact(0.5) / length);
      } else {
        result.insert(result.end(), way.begin(), way.end());
      }
    }
    for (const reference::Gear& gear : of_->gears) {
      Exact sum = q[static_cast<std::size_t>(gear.joint)] - Exact(gear.offset);
      for (const auto& [leader, ratio] : gear.leaders)
        sum -= Exact(ratio) * q[static_cast<std::size_t>(leader)];
      result.push_back(sum);
    }
    return result;
  }
  [[nodiscard]] static Vector difference(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  [[nodiscard]] Body base() const {
    const Vector none = lagrange::vector<Exact>(Eigen::Vector3d(0, 0, 0));
    return {lagrange::matrix<Exact>(of_->chain.base.linear()),
            lagrange::vector<Exact>(of_->chain.base.translation()), none, none};
  }
  [[nodiscard]] std::vector<Body> bodies(const Values& q) const {
    std::vector<Body> links;
    for (std::size_t i = 0; i < q.size(); ++i) {
      const Eigen::Index parent = of_->chain.parent_of(i);
      Body body = parent < 0 ? base() : links[static_cast<std::size_t>(parent)];
      body.cross_joint(of_->chain.joints[i], q[i], Exact(0.0));
      links.push_back(body);
    }
    return links;
  }

  const reference::LoopMechanism* of_;
  Values seed_;
  Exact step_;
  Eigen::MatrixXd inverse_;  ///< of the derivatives by passive joints; steps go by it
};

}  // namespace qvgen::test::loops
