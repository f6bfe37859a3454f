// SPDX-License-Identifier: MIT
#include "derive/dynamics/drive_parameters.h"
#include "emit/c/parts.h"
#include "emit/c/printer.h"
#include "emit/leaves.h"
#include "emit/render.h"
#include "emit/template_values.h"
#include "model/coordinates.h"
#include "model/followers.h"

namespace qvgen::emit::c {
namespace {

Parameter inertia(const model::Robot& robot) { return {"const " + robot.name + "_inertia* ", "inertia"}; }

Parameter result_of(const model::Robot& robot, Result result, std::size_t outputs) {
  const std::size_t dof = model::coordinate_count(robot);
  switch (result) {
    case Result::scalar:
    case Result::vector:
      return result_array(dof);
    case Result::symmetric_matrix:
    case Result::matrix:
      return result_matrix(dof, dof);
    case Result::regressor:
    case Result::drive_regressor:
      return result_matrix(dof, outputs / dof);
    case Result::derivatives:
      return result_struct(robot, "inverse_dynamics_derivatives_result");
    case Result::momentum_matrix:
      return result_matrix(6, outputs / 6);
    case Result::point:
      return result_array(3);
    case Result::point_derivatives:
      return result_matrix(3, model::driven_count(robot));
  }
  return {};
}

/// Adds an argument of C. Velocities, accelerations and forces have the six of a base that floats in front.
void add_argument(const model::Robot& robot, const std::string& name, std::vector<Parameter>& list) {
  const bool is_velocity = robot.floating_base && name != "q";
  if (robot.floating_base && name == "q") list.push_back({"const double ", "base", "[7]"});
  list.push_back(is_velocity ? Parameter{"const double ", name,
                                         "[" + std::to_string(model::coordinate_count(robot)) + "]"}
                             : joint_array(robot, name));
}

/// True for functions under gravity of a base that floats: they take any direction, or a magnitude along -z.
bool takes_any_gravity(const model::Robot& robot, const DynamicsInterface& interface) {
  return robot.floating_base && interface.gravity != Gravity::none;
}

/// Gravity as a floating base sees it (floating_base.h): in its own frame, and minus its product with the
/// position. The terms' order is such that gravity along -z gives what its magnitude gives in C++.
std::vector<std::string> gravity_at_base() {
  return {"const double w = base[0], x = base[1], y = base[2], z = base[3];",
          "const double seen_gravity[4] = {",
          "    gravity[0] - 2 * gravity[0] * (y * y + z * z) + 2 * gravity[1] * (x * y + w * z) - "
          "2 * gravity[2] * (w * y - x * z),",
          "    2 * gravity[0] * (x * y - w * z) + gravity[1] - 2 * gravity[1] * (x * x + z * z) + "
          "2 * gravity[2] * (y * z + w * x),",
          "    2 * gravity[0] * (x * z + w * y) + 2 * gravity[1] * (y * z - w * x) - "
          "2 * gravity[2] * (x * x + y * y) + gravity[2],",
          "    -(gravity[0] * base[4] + gravity[1] * base[5] + gravity[2] * base[6])};"};
}

std::vector<Parameter> parameters_of(const model::Robot& robot, const DynamicsInterface& interface,
                                     std::size_t outputs) {
  std::vector<Parameter> list;
  for (const std::string& name : interface.arguments) add_argument(robot, name, list);
  list.push_back(geometry(robot));
  list.push_back(inertia(robot));
  if (interface.gravity == Gravity::magnitude) list.push_back({"double ", "gravity"});
  if (interface.gravity == Gravity::vector) list.push_back({"const double ", "gravity", "[3]"});
  if (interface.wrench) list.push_back({"const double ", "wrench", "[6]"});
  if (interface.result != Result::scalar) list.push_back(result_of(robot, interface.result, outputs));
  return list;
}

/// Writes the values that depend on no joint variable, in a scope of their own.
std::vector<std::string> set_up(const Code& code) {
  if (code.outputs.empty()) return {};
  std::vector<std::string> lines{"double k[" + std::to_string(code.outputs.size()) + "];", "{"};
  for (const std::string& line : temporaries(code)) lines.push_back("  " + line);
  for (std::size_t i = 0; i < code.outputs.size(); ++i)
    lines.push_back("  k[" + std::to_string(i) + "] = " + code.outputs[i].expression + ";");
  lines.push_back("}");
  return lines;
}

/// Output i goes where C++ puts it.
std::vector<std::string> assignments(const DynamicsInterface& interface, std::size_t dof, const Code& code) {
  if (interface.result == Result::scalar) return {"return " + code.outputs.front().expression + ";"};
  const std::vector<std::string> places = places_of(interface.result, dof, code.outputs.size());
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::string target = place(places[i], false);
    if (interface.result == Result::derivatives) target.replace(target.find('.'), 1, "->");
    lines.push_back(target + " = " + code.outputs[i].expression + ";");
  }
  return lines;
}

std::vector<std::string> without_slashes(const std::string& doc) {
  std::vector<std::string> lines = split_lines(doc);
  for (std::string& line : lines) line.erase(0, 4);
  return lines;
}

const char* const with_vector = "_with_gravity_vector";
const char* const base_line = "`base`: its orientation w x y z and its position in the world, m.";

Function function_of(const model::Robot& robot, const optimise::Optimised& from) {
  DynamicsInterface interface = dynamics_interface(from.name);
  const bool any_gravity = takes_any_gravity(robot, interface);
  if (any_gravity) interface.gravity = Gravity::vector;
  const auto angles = angles_of(from.function);
  const DynamicsCode code = dynamics_code(robot, from, angles, printer());
  Function function{from.name + (any_gravity ? with_vector : ""),
                    without_slashes(dynamics_doc(robot, from, interface)),
                    parameters_of(robot, interface, code.code.outputs.size())};
  if (interface.result == Result::scalar) function.result = "double";
  if (robot.floating_base) function.doc.emplace_back(base_line);
  if (any_gravity) {
    function.doc.emplace_back("`gravity`: acceleration of free fall in the world, m/s^2.");
    append(function.statements, gravity_at_base());
  }
  append(function.statements, set_up(code.set_up));
  append(function.statements, sine_cosine_statements(robot, from.function, angles));
  append(function.statements, temporaries(code.code));
  append(function.statements, assignments(interface, model::coordinate_count(robot), code.code));
  return function;
}

/// A function for gravity along -z: it calls the one for any direction.
Function under_usual_gravity(const model::Robot& robot, const optimise::Optimised& from) {
  const DynamicsInterface interface = dynamics_interface(from.name);
  const std::vector<Parameter> parameters = parameters_of(robot, interface, from.function.outputs.size());
  Function function{from.name, split_lines(interface.summary), parameters};
  function.doc.push_back("Gravity of the magnitude `gravity`, m/s^2, is along the world's -z; " + robot.name +
                         "_" + from.name + with_vector);
  function.doc.emplace_back("takes any. `base`: as there.");
  std::string arguments;
  for (const Parameter& parameter : parameters)
    arguments += (arguments.empty() ? "" : ", ") + (parameter.name == "gravity" ? "falling" : parameter.name);
  const bool gives = interface.result == Result::scalar;
  if (gives) function.result = "double";
  function.statements = {
      "const double falling[3] = {0, 0, -gravity};",
      (gives ? "return " : "") + robot.name + "_" + from.name + with_vector + "(" + arguments + ");"};
  return function;
}

std::vector<Function> functions_of(const model::Robot& robot, const optimise::Optimised& from) {
  if (!takes_any_gravity(robot, dynamics_interface(from.name))) return {function_of(robot, from)};
  return {function_of(robot, from), under_usual_gravity(robot, from)};
}

Function base_parameters(const model::Robot& robot, const derive::dynamics::Regressor& regressor) {
  const Code code = base_parameters_code(robot, regressor, printer());
  const std::string count = std::to_string(10 * model::body_count(robot));
  Function function{
      "base_parameters",
      {"Of ten standard parameters of each link in its frame: mass, first moments x y z (kg m), "
       "inertia about the frame's",
       "origin xx yy zz xy yz xz."},
      {{"const double ", "standard", "[" + count + "]"}, geometry(robot), result_array(code.outputs.size())}};
  function.statements = temporaries(code);
  for (std::size_t i = 0; i < code.outputs.size(); ++i)
    function.statements.push_back("result[" + std::to_string(i) + "] = " + code.outputs[i].expression + ";");
  return function;
}

/// The parameters of the columns of a regressor with drives.
Function identifiable_parameters(const model::Robot& robot,
                                 const derive::dynamics::DriveRegressor& drive_regressor) {
  const Code code = identifiable_parameters_code(robot, drive_regressor.regressor, printer());
  const std::string standard = "[" + std::to_string(10 * model::body_count(robot)) + "]";
  const std::string drives = "[" + std::to_string(4 * derive::dynamics::drive_count(robot)) + "]";
  Function function{
      "identifiable_parameters",
      {"Columns' parameters in terms of ten standard parameters of each link, as base_parameters takes "
       "them, and four",
       "of each drive: rotor inertia, viscous friction, Coulomb friction, offset."},
      {{"const double ", "standard", standard},
       {"const double ", "drives", drives},
       geometry(robot),
       {"double ", "gravity"},
       result_array(code.outputs.size())}};
  for (const auto* lines : {&drive_regressor.left_out, &drive_regressor.dependences})
    for (const std::string& line : *lines) function.doc.push_back(line + ".");
  function.statements = temporaries(code);
  for (std::size_t i = 0; i < code.outputs.size(); ++i)
    function.statements.push_back("result[" + std::to_string(i) + "] = " + code.outputs[i].expression + ";");
  return function;
}

}  // namespace

Part dynamics(const model::Robot& robot, const std::vector<optimise::Optimised>& functions) {
  Part all;
  for (const optimise::Optimised& function : functions) {
    if (dynamics_interface(function.name).result == Result::derivatives)
      all += {render("c/dynamics_derivatives.h",
                     {{"name", robot.name}, {"dof", model::coordinate_count(robot)}})};
    all += written(robot, functions_of(robot, function));
  }
  return all;
}

Part regressor_with_drives(const model::Robot& robot, const derive::dynamics::DriveRegressor& regressor,
                           const optimise::Optimised& function) {
  Part part = names(robot, "identifiable_parameter", "Columns of the regressor with drives.",
                    regressor.regressor.names);
  part += written(robot, {identifiable_parameters(robot, regressor)});
  return part += written(robot, functions_of(robot, function));
}

Part total_mass(const model::Robot& robot) {
  const Code code = total_mass_code(robot, printer());
  Function function{"total_mass", {"Mass of all links, kg."}, {geometry(robot), inertia(robot)}, "double"};
  append(function.statements, temporaries(code));
  function.statements.push_back("return " + code.outputs.front().expression + ";");
  return written(robot, {function});
}

Part regressor(const model::Robot& robot, const derive::dynamics::Regressor& regressor,
               const optimise::Optimised& function) {
  Part part = names(robot, "base_parameter", "Columns of the regressor.", regressor.names);
  part += written(robot, {base_parameters(robot, regressor)});
  return part += written(robot, functions_of(robot, function));
}

}  // namespace qvgen::emit::c
