// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "derive/dynamics/regressor.h"
#include "optimise/dynamics_function.h"

namespace qvgen::emit {

/// How a function is told of gravity: not at all, by the magnitude of what falls along the world's -z, or by
/// the acceleration of free fall.
enum class Gravity { none, magnitude, vector };

/// How a generated function of dynamics looks from outside.
struct DynamicsInterface {
  std::vector<std::string> arguments;  ///< of "q", "qd", "qdd", "torque"
  std::string type;                    ///< what it returns, in terms of {scalar}
  Gravity gravity = Gravity::none;
  std::string summary;         ///< first lines of its doc comment, without ///
  bool in_struct = false;      ///< the result has members: torque, by_position, by_rate
  std::string overloads = {};  ///< the function that it is an overload of, or nothing
  bool wrench = false;         ///< whether it takes a wrench on the tool
};

/// The angles of all functions together: what DynamicsAngles holds.
std::vector<dag::Angle> angles_of(const std::vector<optimise::DynamicsFunction>& functions);

/// Template values of one function for one scalar type ("Scalar", "double", "float").
nlohmann::json dynamics_values(const model::Robot& robot, const optimise::DynamicsFunction& function,
                               const DynamicsInterface& interface, const std::vector<dag::Angle>& angles,
                               const std::string& scalar);

/// Template values of the base parameters and their map from the standard ones.
nlohmann::json base_parameter_values(const model::Robot& robot, const derive::dynamics::Regressor& regressor);

/// Interface of a quantity by its name.
DynamicsInterface dynamics_interface(const std::string& name);

}  // namespace qvgen::emit
