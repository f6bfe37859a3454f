// SPDX-License-Identifier: MIT
#include "emit/cpp/batch_forms.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "emit/cpp/dynamics_code.h"
#include "emit/cpp/scalars.h"

namespace qvgen::emit {
namespace {

using nlohmann::json;
using Inputs = std::vector<BatchForm::Input>;

const BatchForm::Input q{"q", "dof"};
const BatchForm::Input qd{"qd", "dof"};
const BatchForm::Input point{"point", "3"};

const std::string pose = "w x y z of the unit quaternion, then the position, m";
const std::string transform = "the rotation matrix column by column, then the position, m";
const std::string columns = "its 6 x dof entries column by column";

/// Forms of kinematics, Jacobians and errors of the geometry.
const std::vector<BatchForm>& known_forms() {
  static const std::vector<BatchForm> forms{
      {"forward_kinematics", "forward_kinematics", "kinematics", {q}, "7", pose},
      {"homogeneous_transform", "homogeneous_transform", "kinematics", {q}, "12", transform},
      {"jacobian", "jacobian", "jacobian", {q}, "6 * dof", columns},
      {"forward_kinematics_and_jacobian",
       "forward_kinematics_and_jacobian",
       "jacobian",
       {q},
       "12 + 6 * dof",
       transform + ", then the Jacobian's entries column by column",
       {"transform", "jacobian"}},
      {"geometry_jacobian",
       "geometry_jacobian",
       "geometry_jacobian",
       {q},
       "6 * geometry_error_count",
       "its 6 x geometry_error_count entries column by column"},
      {"tool_jacobian", "tool_jacobian", "jacobian", {q}, "6 * dof", columns},
      {"jacobian_at", "jacobian_at", "jacobian", {q, point}, "6 * dof", columns},
      {"velocity", "velocity", "jacobian", {q, qd}, "6", "linear part first"},
      {"jacobian_dot", "jacobian_dot", "jacobian", {q, qd}, "6 * dof", columns},
      {"jacobian_dot_times_qd", "jacobian_dot_times_qd", "jacobian", {q, qd}, "6", "linear part first"},
      {"singularity_measures",
       "singularity_measures",
       "jacobian",
       {q},
       "singularity_count",
       "as `singularity_names` has them"}};
  return forms;
}

void set_result(BatchForm& form, Result result) {
  const auto set = [&](const char* rows, const char* meaning) {
    form.rows = rows;
    form.meaning = meaning;
  };
  constexpr const char* entries = "all entries column by column";
  switch (result) {
    case Result::scalar:
      return set("1", "the value");
    case Result::vector:
      return set("dof", "one for each joint");
    case Result::symmetric_matrix:
    case Result::matrix:
      return set("dof * dof", entries);
    case Result::regressor:
      return set("dof * base_parameter_count", entries);
    case Result::drive_regressor:
      return set("dof * identifiable_parameter_count", entries);
    case Result::derivatives:
      form.members = {"torque", "by_position", "by_rate"};
      return set("dof + 2 * dof * dof",
                 "the forces, then their derivatives by q, then those by qd, column by column");
    case Result::momentum_matrix:
      return set("6 * dof", entries);
    case Result::point:
      return set("3", "x y z, m");
    case Result::point_derivatives:
      return set("3 * dof", "its 3 x dof entries column by column");
  }
}

using Parts = std::tuple<std::string, std::string, std::string>;

/// The part that a function of dynamics stands in, the function that gives it its angles, and that one's
/// part.
Parts parts_of(const DynamicsInterface& interface) {
  if (interface.result == Result::regressor) return {"regressor", "regressor_angles", "regressor"};
  if (interface.result == Result::drive_regressor)
    return {"regressor_with_drives", "drive_regressor_angles", "regressor_with_drives"};
  if (interface.result == Result::derivatives) return {"dynamics_derivatives", "dynamics_angles", "dynamics"};
  if (interface.result == Result::point || interface.result == Result::point_derivatives)
    return {"mass", "mass_angles", "mass"};
  if (interface.gravity == Gravity::vector) return {"dynamics_loads", "load_angles", "dynamics_loads"};
  return {"dynamics", "dynamics_angles", "dynamics"};
}

BatchForm dynamics_form(const std::string& name, const DynamicsInterface& interface) {
  BatchForm form;
  form.name = name;
  form.function = interface.overloads.empty() ? name : interface.overloads;
  std::tie(form.header, form.angles, form.angles_header) = parts_of(interface);
  for (const std::string& argument : interface.arguments) form.inputs.push_back({argument, "dof"});
  if (interface.wrench) form.inputs.push_back({"wrench", "6"});
  if (interface.gravity == Gravity::magnitude) form.gravity = "NonDeduced<Scalar>";
  if (interface.gravity == Gravity::vector) form.gravity = "const NonDeduced<Eigen::Matrix<Scalar, 3, 1>>&";
  set_result(form, interface.result);
  return form;
}

std::string with_velocities(std::string text) {
  for (std::size_t at = text.find("dof"); at != std::string::npos; at = text.find("dof", at + 1))
    text.replace(at, 3, "velocity_size");
  return text;
}

/// Velocities, accelerations and forces begin with the base's; where it is stands before the joints.
BatchForm with_floating_base(BatchForm form) {
  form.base_floats = true;
  for (BatchForm::Input& input : form.inputs)
    if (input.name != "q") input.rows = with_velocities(input.rows);
  form.inputs.insert(form.inputs.begin(), {"base", "7"});
  form.rows = with_velocities(form.rows);
  form.meaning =
      form.meaning == "one for each joint" ? "as velocities have them" : with_velocities(form.meaning);
  if (!form.gravity.empty()) form.gravity = "const NonDeduced<FreeFall<Scalar>>&";
  return form;
}

/// Returns the type that each instance of the template takes for gravity.
json instances(const BatchForm& form) {
  json list = scalars();
  for (json& instance : list) {
    const std::string scalar = instance["scalar"];
    std::string gravity =
        form.header == "dynamics_loads" ? "const Eigen::Matrix<" + scalar + ", 3, 1>&" : scalar;
    if (form.base_floats) gravity = "const FreeFall<" + scalar + ">&";
    instance["gravity_instance"] = gravity;
  }
  return list;
}

/// Arguments of the single call in lanes, up to the sines and cosines or the geometry.
std::string lane_arguments(const BatchForm& form) {
  std::string list;
  for (const BatchForm::Input& input : form.inputs)
    if (!form.base_floats || input.name != "q")
      list += input.name == "base" ? "qvgen::batch::configuration_of<Lane, dof>(base_, q_), "
                                   : input.name + "_, ";
  return list + (form.base_floats && !form.gravity.empty() ? "gravity.template cast<Lane>(), " : "");
}

json values(const BatchForm& form) {
  const bool has_gravity = !form.gravity.empty();
  json inputs = json::array();
  for (const BatchForm::Input& input : form.inputs)
    inputs.push_back({{"input", input.name}, {"input_rows", input.rows}});
  json members = json::array();
  for (const std::string& member : form.members) members.push_back({{"member", "." + member}});
  if (members.empty()) members.push_back({{"member", ""}});
  json dynamics = json::array();
  if (!form.angles.empty())
    dynamics.push_back({{"angles_function", form.angles}, {"constants_type", constants_type(form.name)}});
  // A magnitude has a default, as single calls have it.
  const bool has_default = form.header != "dynamics_loads";
  return {
      {"entry", form.name},
      {"function", form.function},
      {"inputs", inputs},
      {"rows", form.rows},
      {"meaning", form.meaning},
      {"members", members},
      {"lane_arguments", lane_arguments(form)},
      {"gravity_of_constants", has_gravity && !form.base_floats},
      {"is_dynamics", dynamics},
      {"is_kinematics", form.angles.empty()},
      {"gravity", has_gravity ? json::array({{{"gravity_type", form.gravity},
                                              {"gravity_default", has_default ? " = Scalar(9.80665)" : ""}}})
                              : json::array()},
      {"default", has_default ? " = {}" : ""},
      {"scalars", instances(form)}};
}

}  // namespace

std::optional<BatchForm> batch_form(const std::string& name, bool base_floats) {
  const auto& known = known_forms();
  const auto found =
      std::find_if(known.begin(), known.end(), [&](const BatchForm& form) { return form.name == name; });
  if (found != known.end()) return *found;
  if (!is_dynamics_function(name)) return std::nullopt;
  const BatchForm form = dynamics_form(name, dynamics_interface(name));
  return base_floats ? with_floating_base(form) : form;
}

json batch_values(const std::string& robot, const std::vector<BatchForm>& forms) {
  std::set<std::string> parts;
  bool has_dynamics = false;
  json functions = json::array();
  for (const BatchForm& form : forms) {
    parts.insert(form.header);
    if (!form.angles_header.empty()) parts.insert(form.angles_header);
    has_dynamics = has_dynamics || !form.angles.empty();
    functions.push_back(values(form));
  }
  json headers = json::array();
  for (const std::string& part : parts) headers.push_back({{"part", part}});
  const bool base_floats =
      std::any_of(forms.begin(), forms.end(), [](const auto& form) { return form.base_floats; });
  return {{"name", robot},
          {"functions", functions},
          {"headers", headers},
          {"has_dynamics", has_dynamics},
          {"base_floats", base_floats}};
}

}  // namespace qvgen::emit
