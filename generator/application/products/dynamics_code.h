// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "application/dynamics_function.h"
#include "derive/dynamics/regressor.h"

namespace qvgen::application {

/// How a generated function of dynamics looks from outside.
struct DynamicsInterface {
  std::vector<std::string> arguments;  ///< of "q", "qd", "qdd", "torque"
  std::string type;                    ///< what it returns, in terms of {scalar}
  bool has_gravity = false;
  std::string summary;     ///< first lines of its doc comment, without ///
  bool in_struct = false;  ///< the result has members: torque, by_position, by_rate
};

/// The angles of all functions together: what DynamicsAngles holds.
std::vector<dag::Angle> angles_of(const std::vector<DynamicsFunction>& functions);

/// Template values of one function for one scalar type ("Scalar", "double", "float").
nlohmann::json dynamics_values(const model::Robot& robot, const DynamicsFunction& function,
                               const DynamicsInterface& interface, const std::vector<dag::Angle>& angles,
                               const std::string& scalar);

/// Template values of the base parameters and their map from the standard ones.
nlohmann::json base_parameter_values(const model::Robot& robot, const derive::dynamics::Regressor& regressor);

/// Interface of a quantity by its name.
DynamicsInterface dynamics_interface(const std::string& name);

}  // namespace qvgen::application
