// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "derive/dynamics/drive_regressor.h"
#include "derive/dynamics/regressor.h"
#include "emit/code.h"
#include "emit/cpp/printer.h"
#include "optimise/dynamics.h"

namespace qvgen::emit {

/// How a function is told of gravity: not at all, by the magnitude of what falls along the world's -z, or by
/// the acceleration of free fall.
enum class Gravity { none, magnitude, vector };

/// Result of a function, and so the order of its outputs.
enum class Result {
  scalar,
  vector,            ///< a number for each joint
  symmetric_matrix,  ///< joints by joints; the outputs are the upper triangle, row by row
  matrix,            ///< joints by joints, row by row
  momentum_matrix,   ///< six by joints, row by row
  regressor,         ///< joints by base parameters, column by column
  drive_regressor,   ///< joints by identifiable parameters, column by column
  derivatives,       ///< a vector, then for each joint its derivatives by position, and those by rate
  point,             ///< three coordinates
  point_derivatives  ///< three by joints, column by column
};

/// How a generated function of dynamics looks from outside.
struct DynamicsInterface {
  std::vector<std::string> arguments;  ///< of "q", "qd", "qdd", "torque"
  Result result = Result::vector;
  Gravity gravity = Gravity::none;
  std::string summary;         ///< first lines of its doc comment, without ///
  std::string overloads = {};  ///< the function that it is an overload of, or nothing
  bool wrench = false;         ///< whether it takes a wrench on the tool
};

/// The angles of all functions together: what DynamicsAngles holds.
std::vector<dag::Angle> angles_of(const std::vector<optimise::Optimised>& functions);

/// The code of a function: what no joint variable takes part in, its outputs being k[0], k[1], ..., and the
/// rest.
struct DynamicsCode {
  Code set_up;
  Code code;
};
DynamicsCode dynamics_code(const model::Robot& robot, const optimise::Optimised& function,
                           const std::vector<dag::Angle>& angles, const ast::Printer& language = plain_cpp(),
                           int longest_inline = ast::usual_inline);
Code base_parameters_code(const model::Robot& robot, const derive::dynamics::Regressor& regressor,
                          const ast::Printer& language = plain_cpp());

/// The mass of all links; its only output.
Code total_mass_code(const model::Robot& robot, const ast::Printer& language = plain_cpp());

/// The parameters of a regressor with drives in terms of standard and drive parameters, and its template
/// values.
Code identifiable_parameters_code(const model::Robot& robot, const derive::dynamics::Regressor& regressor,
                                  const ast::Printer& language = plain_cpp());
nlohmann::json identifiable_parameter_values(const model::Robot& robot,
                                             const derive::dynamics::DriveRegressor& regressor);

/// The type of a function's constants: InverseDynamicsConstants of inverse_dynamics.
std::string constants_type(const std::string& function);

/// The lines of a function's doc comment, each with ///.
std::string dynamics_doc(const model::Robot& robot, const optimise::Optimised& function,
                         const DynamicsInterface& interface);

/// Template values of one function for one scalar type ("Scalar", "double", "float").
nlohmann::json dynamics_values(const model::Robot& robot, const optimise::Optimised& function,
                               const DynamicsInterface& interface, const std::vector<dag::Angle>& angles,
                               const std::string& scalar);

/// Template values of the base parameters and their map from the standard ones.
nlohmann::json base_parameter_values(const model::Robot& robot, const derive::dynamics::Regressor& regressor);

/// Interface of a quantity by its name.
DynamicsInterface dynamics_interface(const std::string& name);
/// True if there is a quantity of that name.
bool is_dynamics_function(const std::string& name);

/// Returns the C++ type of a result; `floats`: the robot has a base that floats.
std::string type_of(Result result, const std::string& scalar, bool floats = false);
/// Returns the place of each of `count` outputs in the result: "result(0, 1) = result(1, 0)".
std::vector<std::string> places_of(Result result, std::size_t dof, std::size_t count);

}  // namespace qvgen::emit
