// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "dual.h"

namespace qvgen::test {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using DualVector = Eigen::Matrix<Dual, Eigen::Dynamic, 1>;
using DualMatrix = Eigen::Matrix<Dual, Eigen::Dynamic, Eigen::Dynamic>;
using Wrench = Eigen::Matrix<double, 6, 1>;

struct TorqueDerivatives {
  VectorXd torque;
  MatrixXd by_position, by_rate;
};

/// The generated dynamics of one robot behind one type. Its inertial parameters, where they are symbols, are
/// those given when it is made. `g`: magnitude of gravity, downward; `falling`: the acceleration of free
/// fall.
class DynamicsUnderTest {
 public:
  virtual ~DynamicsUnderTest() = default;

  virtual VectorXd inverse(const VectorXd& q, const VectorXd& qd, const VectorXd& qdd, double g) const = 0;
  /// Some robots leave gravity in any direction, wrenches and derivatives to who names them; `has_requested`
  /// of the factory tells. Robots whose joints branch have no tool: `has_tool`.
  virtual VectorXd inverse(const VectorXd&, const VectorXd&, const VectorXd&, const Vector3d&) const {
    return {};
  }
  virtual VectorXd inverse(const VectorXd&, const VectorXd&, const VectorXd&, const Vector3d&,
                           const Wrench&) const {
    return {};
  }
  virtual DualVector inverse(const DualVector& q, const DualVector& qd, const DualVector& qdd,
                             double g) const = 0;
  /// With the angles' sines and cosines and the constants computed before.
  virtual VectorXd inverse_prepared(const VectorXd& q, const VectorXd& qd, const VectorXd& qdd,
                                    double g) const = 0;
  virtual VectorXd inverse_prepared(const VectorXd&, const VectorXd&, const VectorXd&, const Vector3d&,
                                    const Wrench&) const {
    return {};
  }
  virtual VectorXd gravity(const VectorXd& q, double g) const = 0;
  virtual VectorXd gravity(const VectorXd&, const Vector3d&) const { return {}; }
  virtual VectorXd coriolis(const VectorXd& q, const VectorXd& qd) const = 0;
  virtual MatrixXd coriolis_matrix(const VectorXd& q, const VectorXd& qd) const = 0;
  virtual MatrixXd mass(const VectorXd& q) const = 0;
  virtual DualMatrix mass(const DualVector& q) const = 0;
  virtual VectorXd forward(const VectorXd& q, const VectorXd& qd, const VectorXd& torque, double g) const = 0;
  virtual VectorXd forward(const VectorXd&, const VectorXd&, const VectorXd&, const Vector3d&) const {
    return {};
  }
  virtual VectorXd forward(const VectorXd&, const VectorXd&, const VectorXd&, const Vector3d&,
                           const Wrench&) const {
    return {};
  }
  virtual double kinetic(const VectorXd& q, const VectorXd& qd) const = 0;
  virtual Dual kinetic(const DualVector& q, const DualVector& qd) const = 0;
  virtual double potential(const VectorXd& q, double g) const = 0;
  virtual double potential(const VectorXd&, const Vector3d&) const { return 0; }
  virtual Dual potential(const DualVector& q, double g) const = 0;
  virtual TorqueDerivatives derivatives(const VectorXd&, const VectorXd&, const VectorXd&, double) const {
    return {};
  }
  /// Some robots leave the regressor to who names it; `has_regressor` of the factory tells.
  virtual VectorXd base_parameters(const VectorXd&) const { return {}; }
  virtual MatrixXd regressor(const VectorXd&, const VectorXd&, const VectorXd&, double) const { return {}; }
};

struct DynamicsFactory {
  std::string name, description;
  bool has_tool = true;
  bool has_requested = true;  ///< gravity in any direction, wrenches and derivatives
  bool has_regressor = true;
  std::vector<std::string> inertia_names;
  /// From the values of the inertial parameters.
  std::function<std::unique_ptr<DynamicsUnderTest>(const std::vector<double>&)> make;
};

inline std::vector<DynamicsFactory>& dynamics_under_test() {
  static std::vector<DynamicsFactory> all;
  return all;
}

inline bool add_dynamics(DynamicsFactory robot) {
  dynamics_under_test().push_back(std::move(robot));
  return true;
}

}  // namespace qvgen::test
