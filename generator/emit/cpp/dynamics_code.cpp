// SPDX-License-Identifier: MIT
#include "emit/cpp/dynamics_code.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "derive/dynamics/drive_parameters.h"
#include "emit/ast/angle.h"
#include "emit/ast/literal.h"
#include "emit/cpp/angles.h"
#include "emit/cpp/compact.h"
#include "emit/leaves.h"
#include "emit/math/dynamics_choices.h"
#include "emit/template_values.h"
#include "model/coordinates.h"
#include "model/followers.h"
#include "passes/constants.h"
#include "verify/counts_json.h"

namespace qvgen::emit {
namespace {

using nlohmann::json;
using optimise::Optimised;

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

using Known = std::map<std::string, ast::Expression>;

/// Constants as the code has them: numbers in place, the others by their place in the set-up function's
/// array.
struct Constants {
  Known value;
  dag::Function stored;
};

Constants constants_of(const Optimised& function) {
  Constants result;
  result.stored.graph = function.constants.graph;
  for (const dag::Output& output : function.constants.outputs) {
    if (function.constants.graph.is_constant(output.value)) {
      result.value[output.name] = ast::real(literal(function.constants.graph.value_of(output.value)));
    } else {
      result.value[output.name] = ast::entry("k", result.stored.outputs.size());
      result.stored.outputs.push_back(output);
    }
  }
  return result;
}

ast::Leaves leaves_of(const model::Robot& robot, const std::vector<dag::Angle>& angles,
                      const Known& constants) {
  Known known = constants;
  const std::vector<std::string> variables = model::variables(robot);
  const std::size_t base = model::base_motions(robot);
  for (std::size_t k = 0; k < base; ++k) {
    const std::string motion = model::base_coordinate(k);
    known[derive::dynamics::velocity_of(motion)] = ast::entry("qd", k);
    known[derive::dynamics::acceleration_of(motion)] = ast::entry("qdd", k);
    known[derive::dynamics::force_of(motion)] = ast::entry("torque", k);
  }
  for (std::size_t k = 0; base > 0 && k < 4; ++k)
    known[derive::dynamics::gravity_component(k)] = ast::entry("seen_gravity", k);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const std::string& variable = variables[i];
    const ast::Expression rate = ast::entry("qd", base + i);
    known[derive::dynamics::velocity_of(variable)] = rate;
    known[derive::dynamics::acceleration_of(variable)] = ast::entry("qdd", base + i);
    known[derive::dynamics::force_of(variable)] = ast::entry("torque", base + i);
    known[derive::dynamics::direction_of(variable)] = ast::call(ast::Expression::Kind::direction, "", {rate});
  }
  for (std::size_t k = 0; k < 6; ++k) known[derive::dynamics::wrench_component(k)] = ast::entry("wrench", k);
  return robot_leaves(robot, angles, [known](const std::string& name) { return known.at(name); });
}

/// Leaves where sines and cosines are of constant angles.
ast::Leaves constant_leaves(const model::Robot& robot, const Known& known) {
  const auto symbol =
      robot_leaves(robot, {}, [known](const std::string& name) { return known.at(name); }).symbol;
  const auto called = [symbol](const char* function) {
    return [symbol, function](const dag::Angle& angle) {
      return ast::call(ast::Expression::Kind::named, function, {ast::angle_value(angle, symbol)});
    };
  };
  return {symbol, called("sin"), called("cos")};
}

ast::Leaves set_up_leaves(const model::Robot& robot) {
  Known known{{derive::dynamics::gravity_symbol, ast::name("gravity")}};
  for (std::size_t k = 0; k < 3; ++k)
    known[derive::dynamics::gravity_component(k)] = ast::entry("gravity", k);
  const ast::Expression inertia = ast::name("inertia", {"Inertia"}, ast::Reach::reference);
  for (const model::Parameter& parameter : robot.inertia_parameters)
    known[parameter.name] = ast::member(inertia, parameter.name);
  return constant_leaves(robot, known);
}

}  // namespace

std::string constants_type(const std::string& function) {
  std::string type;
  bool begins = true;
  for (const char c : function) {
    if (c != '_') type += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = c == '_';
  }
  return type + "Constants";
}

std::vector<dag::Angle> angles_of(const std::vector<Optimised>& functions) {
  std::vector<std::vector<dag::Angle>> lists;
  for (const Optimised& function : functions) lists.push_back(angles_of(function.function));
  return merged(lists);
}

namespace {

/// How gravity is given, with `scalar` for its type; the magnitude has a default.
json gravity_values(Gravity gravity, const std::string& scalar) {
  if (gravity == Gravity::none)
    return {
        {"gravity_declared", ""}, {"gravity_parameter", ""}, {"gravity_argument", ""}, {"gravity_type", ""}};
  const bool magnitude = gravity == Gravity::magnitude;
  const std::string type =
      magnitude ? "NonDeduced<Scalar> gravity" : "const NonDeduced<Eigen::Matrix<Scalar, 3, 1>>& gravity";
  return {{"gravity_declared", ", " + type + (magnitude ? " = Scalar(9.80665)" : "")},
          {"gravity_parameter", ",\n    [[maybe_unused]] " + type},
          {"gravity_argument", ", gravity"},
          {"gravity_type", magnitude ? ", " + scalar : ", const Eigen::Matrix<" + scalar + ", 3, 1>&"}};
}

json wrench_values(bool wrench, const std::string& scalar) {
  if (!wrench)
    return {{"wrench_parameter", ""}, {"wrench_unused", ""}, {"wrench_argument", ""}, {"wrench_type", ""}};
  return {{"wrench_parameter", ", const NonDeduced<Wrench<Scalar>>& wrench"},
          {"wrench_unused", ", [[maybe_unused]] const Wrench<Scalar>& wrench"},
          {"wrench_argument", ", wrench"},
          {"wrench_type", ", const Wrench<" + scalar + ">&"}};
}

/// A base that floats turns in gravity, which is no constant of its functions.
json gravity_at_base_values(Gravity gravity, const std::string& scalar) {
  json values = gravity_values(Gravity::none, scalar);
  values.update(wrench_values(false, scalar));
  values["load_default"] = "";
  if (gravity == Gravity::none) return values;
  values["load_default"] = " = Scalar(9.80665)";
  values["wrench_parameter"] = ", const NonDeduced<FreeFall<Scalar>>& gravity";
  values["wrench_unused"] = ", [[maybe_unused]] const GravityAtBase<Scalar>& seen_gravity";
  values["wrench_argument"] = ", gravity.seen_from(at.base)";
  values["wrench_type"] = ", const FreeFall<" + scalar + ">&";
  return values;
}

json load_values(const model::Robot& robot, const DynamicsInterface& interface, const std::string& scalar) {
  if (robot.floating_base) return gravity_at_base_values(interface.gravity, scalar);
  json values = gravity_values(interface.gravity, scalar);
  values.update(wrench_values(interface.wrench, scalar));
  values["load_default"] = "";
  return values;
}

/// A function's arguments besides loads: as declared, as its body has them, as they are handed on, and their
/// types.
struct Arguments {
  std::string declared, unused, handed_on, types;

  void add(const std::string& type, const std::string& name, const std::string& inner_type,
           const std::string& inner_name, const std::string& value) {
    const std::string comma = declared.empty() ? "" : ", ";
    declared += comma + type + " " + name;
    unused += comma + "[[maybe_unused]] " + inner_type + " " + inner_name;
    handed_on += comma + value;
    types += comma + type;
  }
};

Arguments arguments_of(const model::Robot& robot, const DynamicsInterface& interface,
                       const std::string& scalar) {
  const std::string joints = "const JointVector<" + scalar + ">&";
  const std::string velocity = "const Velocity<" + scalar + ">&";
  Arguments result;
  for (const std::string& name : interface.arguments)
    if (!robot.floating_base)
      result.add(joints, name, joints, name, name);
    else if (name == "q")
      result.add("const Configuration<" + scalar + ">&", "at", joints, name, "at.q");
    else
      result.add(velocity, name, velocity, name, name);
  return result;
}

/// How a function's body gets sines and cosines: as pointers to two arrays, so that both overloads call one
/// compiled body, where bytes count; else as the struct that holds them, into which compilers see.
json angle_arguments(bool in_few_bytes) {
  if (in_few_bytes)
    return {{"angle_parameters", "[[maybe_unused]] const Scalar* s, [[maybe_unused]] const Scalar* c"},
            {"angle_arguments", "std::data(angles.sine), std::data(angles.cosine)"}};
  return {{"angle_parameters", "[[maybe_unused]] const Angles& angles"}, {"angle_arguments", "angles"}};
}

}  // namespace

std::string dynamics_doc(const model::Robot& robot, const Optimised& function,
                         const DynamicsInterface& interface) {
  std::string text = "/// " + replaced(interface.summary, "\n", "\n/// ") + "\n///\n/// " +
                     verify::describe(function.counts);
  text += ". Set-up: " + verify::describe(function.constant_counts.value()) +
          ".\n/// Equal to the plain Newton-Euler recursion at " + std::to_string(function.certified_points) +
          " random exact points, tolerance zero.";
  const std::string unit = function.choices ? symbolic_unit_text(robot, *function.choices) : "";
  if (!unit.empty()) text += "\n/// The unit of length is " + unit + ", which must not be zero.";
  if (function.largest_error > 0)
    text += "\n/// Largest rounding error found " +
            json(std::round(function.largest_error * 100) / 100).dump() + " ulp of the largest component.";
  return text;
}

DynamicsCode dynamics_code(const model::Robot& robot, const Optimised& function,
                           const std::vector<dag::Angle>& angles, const ast::Printer& language,
                           int longest_inline) {
  const Constants constants = constants_of(function);
  return {
      straight_code(constants.stored, set_up_leaves(robot), language),
      straight_code(function.function, leaves_of(robot, angles, constants.value), language, longest_inline)};
}

namespace {

template <class Value>
std::vector<Value> in_order(const std::vector<Value>& values, const std::vector<std::size_t>& order) {
  std::vector<Value> result;
  for (const std::size_t i : order) result.push_back(values[i]);
  return result;
}

/// True for forces and matrices, which come from the tips; accelerations come from the base.
bool begins_at_tips(const DynamicsInterface& interface) {
  const Result result = interface.result;
  const auto& given = interface.arguments;
  return (result == Result::vector && std::find(given.begin(), given.end(), "torque") == given.end()) ||
         result == Result::symmetric_matrix || result == Result::matrix || result == Result::derivatives;
}

Body compact_dynamics(const model::Robot& robot, Optimised function, const DynamicsInterface& interface,
                      std::vector<std::string> places, const std::vector<dag::Angle>& angles) {
  if (begins_at_tips(interface)) {
    const std::vector<std::size_t> order = from_tips_to_base(places);
    function.function.outputs = in_order(function.function.outputs, order);
    places = in_order(places, order);
  }
  return compact_body_of(dynamics_code(robot, function, angles, plain_cpp(), compact_inline).code, places);
}

}  // namespace

json dynamics_values(const model::Robot& robot, const Optimised& function, const DynamicsInterface& interface,
                     const std::vector<dag::Angle>& angles, const std::string& scalar) {
  const auto [set_up, code] = dynamics_code(robot, function, angles);
  const std::vector<std::string> places =
      places_of(interface.result, model::coordinate_count(robot), code.outputs.size());
  const bool in_few_bytes = bytes_count(robot, code);
  const std::vector<std::string> named = sine_cosine_declarations(robot, function.function, angles);
  const Body body =
      in_few_bytes ? compact_dynamics(robot, function, interface, places, angles) : body_of(code, places);
  const Arguments arguments = arguments_of(robot, interface, scalar);
  const bool floats = robot.floating_base.has_value();
  json values{{"entry", function.name},
              {"function", interface.overloads.empty() ? function.name : interface.overloads},
              {"doc", dynamics_doc(robot, function, interface)},
              {"type", type_of(interface.result, scalar, floats)},
              {"floats", floats},
              {"in_few_bytes", in_few_bytes},
              {"parameters", arguments.declared},
              {"unused_parameters", arguments.unused},
              {"types", arguments.types},
              {"arguments", arguments.handed_on},
              {"default", interface.gravity == Gravity::vector ? "" : " = {}"},
              {"constants", constants_type(function.name)},
              {"constant_count", set_up.outputs.size()},
              {"set_up", values_of(set_up.temporaries)},
              {"stored", values_of(set_up.outputs)},
              {"named_angles", lines_of(in_few_bytes ? compact_angles(named) : named)},
              {"declarations", lines_of(body.declarations)},
              {"statements", lines_of(body.statements)}};
  values.update(load_values(robot, interface, scalar));
  values.update(angle_arguments(in_few_bytes));
  return values;
}

Code base_parameters_code(const model::Robot& robot, const derive::dynamics::Regressor& regressor,
                          const ast::Printer& language) {
  Known known;
  for (std::size_t i = 0; i < 10 * model::body_count(robot); ++i)
    known[derive::dynamics::standard_parameter(i)] = ast::entry("standard", i);
  return straight_code(regressor.base_parameters, constant_leaves(robot, known), language);
}

Code identifiable_parameters_code(const model::Robot& robot, const derive::dynamics::Regressor& regressor,
                                  const ast::Printer& language) {
  Known known{{derive::dynamics::gravity_symbol, ast::name("gravity")}};
  for (std::size_t i = 0; i < 10 * model::body_count(robot); ++i)
    known[derive::dynamics::standard_parameter(i)] = ast::entry("standard", i);
  for (std::size_t i = 0;
       i < derive::dynamics::drive_parameters.size() * derive::dynamics::drive_count(robot); ++i)
    known[derive::dynamics::drive_parameter(i)] = ast::entry("drives", i);
  return straight_code(regressor.base_parameters, constant_leaves(robot, known), language);
}

namespace {

/// A parameter for each output, with its name.
/// Declarations without a semicolon, and whole statements, each with the parameter's name unless bytes count.
Body base_parameter_body(const model::Robot& robot, const Code& code, const std::vector<std::string>& names) {
  std::vector<std::string> places;
  for (std::size_t i = 0; i < names.size(); ++i) places.push_back("result[" + std::to_string(i) + "]");
  if (bytes_count(robot, code)) {
    Body body = compact_body_of(code, places);
    for (std::string& statement : body.statements) statement += ";";
    return body;
  }
  Body body;
  for (const auto& [name, expression] : code.temporaries)
    body.declarations.push_back("const Scalar " + name + " = " + expression);
  for (std::size_t i = 0; i < names.size(); ++i)
    body.statements.push_back(places[i] + " = " + code.outputs[i].expression + ";  // " + names[i]);
  return body;
}

std::vector<std::string> dependent_doc(const std::vector<std::string>& dependences) {
  std::vector<std::string> lines{
      "Columns, from 0, that are combinations of others by factors with lengths or angles",
      "A least squares that needs independent columns leaves them out"};
  lines.insert(lines.end(), dependences.begin(), dependences.end());
  return lines;
}

json named_parameters(const Code& code, const derive::dynamics::Regressor& regressor) {
  json parameters = json::array();
  for (std::size_t i = 0; i < code.outputs.size(); ++i)
    parameters.push_back({{"index", i},
                          {"parameter", regressor.names[i]},
                          {"expression", code.outputs[i].expression},
                          {"last", i + 1 == code.outputs.size()}});
  return parameters;
}

}  // namespace

json identifiable_parameter_values(const model::Robot& robot,
                                   const derive::dynamics::DriveRegressor& drive_regressor) {
  const derive::dynamics::Regressor& regressor = drive_regressor.regressor;
  const Code code = identifiable_parameters_code(robot, regressor);
  std::vector<std::string> motors;
  for (const model::Motor& motor : robot.motors) motors.push_back(motor.variable);
  return {{"drive_count", derive::dynamics::drive_count(robot)},
          {"has_motors", !motors.empty()},
          {"motors", motors.empty() ? "" : fmt::format(", then of the motors {}", fmt::join(motors, ", "))},
          {"identifiable_parameters", named_parameters(code, regressor)},
          {"identifiable_count", code.outputs.size()},
          {"parameter_set_up", values_of(code.temporaries)},
          {"left_out", lines_of(drive_regressor.left_out)},
          {"dependent_doc", lines_of(dependent_doc(drive_regressor.dependences))},
          {"dependent_count", drive_regressor.dependent.size()},
          {"dependent", fmt::format("{}", fmt::join(drive_regressor.dependent, ", "))}};
}

Code total_mass_code(const model::Robot& robot, const ast::Printer& language) {
  dag::Function function;
  derive::dynamics::Scalar mass;
  if (robot.floating_base) mass = derive::dynamics::to_scalar(robot.floating_base->mass, function.graph);
  for (const model::Joint& joint : robot.joints)
    mass = mass + derive::dynamics::to_scalar(joint.inertia.mass, function.graph);
  function.outputs.push_back({"mass", mass.in(function.graph)});
  return straight_code(passes::fold_constants(function), set_up_leaves(robot), language);
}

json base_parameter_values(const model::Robot& robot, const derive::dynamics::Regressor& regressor) {
  const Code code = base_parameters_code(robot, regressor);
  const bool by_dof = !model::has_followers(robot) && !robot.floating_base;
  const Body body = base_parameter_body(robot, code, regressor.names);
  return {{"links", by_dof ? "dof" : std::to_string(model::body_count(robot))},
          {"parameters_of_base", named_parameters(code, regressor)},
          {"base_declarations", lines_of(body.declarations)},
          {"base_statements", lines_of(body.statements)},
          {"base_count", code.outputs.size()}};
}

}  // namespace qvgen::emit
