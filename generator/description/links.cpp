// SPDX-License-Identifier: MIT
#include "description/links.h"

#include <algorithm>

#include "description/followers.h"
#include "description/frames.h"
#include "description/names.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

using model::Expression;

bool is_free(const Table& table, const std::string& key) {
  const toml::node* node = table.find(key);
  return node != nullptr && node->value_exact<std::string>() == "free";
}

bool read_free(const Table& root, const std::string& key) {
  if (!root.has(key)) return false;
  if (is_free(root, key)) return true;
  root.context().error(root.place_of(key), "'" + key + "' of the whole robot can only be \"free\"",
                       "write " + key + " = \"free\", or give numbers in each joint");
  return false;
}

/// A symbol that the reader names, e.g. I3xy for the product of inertia of link 3.
Expression free_symbol(const Table& table, const std::string& name) {
  table.context().uses.push_back({name, table.place(), Role::inertia, true});
  return Expression::symbol(name);
}

std::string link_number(const Context& context) { return std::to_string(context.joint_places.size()); }

/// A number of inertia or drive, never an angle.
Expression read_number(const Table& table, const std::string& key) {
  const Entry entry = entry_or_zero(table, key, {Role::inertia});
  check_no_angle(table.context(), entry, key);
  return entry.value;
}

void read_masses(const Table& table, bool free, model::Inertia& inertia) {
  const std::string link = link_number(table.context());
  const auto becomes_symbol = [&](const std::string& key) {
    return is_free(table, key) || (free && !table.has(key));
  };
  inertia.mass = becomes_symbol("mass") ? free_symbol(table, "m" + link) : read_number(table, "mass");
  if (!becomes_symbol("centre_of_mass")) {
    inertia.centre_of_mass = vector_or_zero(table, "centre_of_mass", {Role::inertia});
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    inertia.centre_of_mass.at(i) = free_symbol(table, "c" + link + "xyz"[i]);
  }
}

void read_tensor(const Table& table, bool free, model::Inertia& inertia) {
  if (is_free(table, "inertia") || (free && !table.has("inertia"))) {
    static constexpr std::array names{"xx", "yy", "zz", "xy", "yz", "xz"};
    for (std::size_t i = 0; i < names.size(); ++i) {
      inertia.inertia.at(i) = free_symbol(table, "I" + link_number(table.context()) + names.at(i));
    }
    return;
  }
  const auto entries = read_entries(table, "inertia", {Role::inertia}, {3, 6},
                                    "[xx, yy, zz], [xx, yy, zz, xy, yz, xz] or \"free\"");
  for (std::size_t i = 0; entries && i < entries->size(); ++i) inertia.inertia.at(i) = (*entries)[i].value;
}

Expression read_drive_entry(const Table& table, const std::string& key, bool free,
                            const std::string& symbol) {
  const bool becomes_symbol = is_free(table, key) || (free && !table.has(key));
  return becomes_symbol ? free_symbol(table, symbol) : read_number(table, key);
}

/// `number` ends the names of free parameters.
void read_drive(const Table& table, bool free, const std::string& number, model::Drive& drive) {
  drive.rotor_inertia = read_drive_entry(table, "rotor_inertia", free, "Ia" + number);
  drive.viscous_friction = read_drive_entry(table, "viscous_friction", free, "Fv" + number);
  drive.coulomb_friction = read_drive_entry(table, "coulomb_friction", free, "Fc" + number);
}

std::optional<model::Limits> read_limits(const Table& table, model::JointType type) {
  const auto entries = read_entries(table, "limits", {Role::constant}, {2}, "two entries [lower, upper]");
  if (!entries) return std::nullopt;
  const bool turns = type == model::JointType::revolute;
  const auto in_si = turns ? in_radians : in_metres;
  const Entry lower = in_si(table.context(), entries->front()),
              upper = in_si(table.context(), entries->back());
  if (turns) {
    check_angle(table.context(), lower);
    check_angle(table.context(), upper);
  } else {
    check_no_angle(table.context(), lower, "limits");
    check_no_angle(table.context(), upper, "limits");
  }
  if (!symbols(lower.value).empty() || !symbols(upper.value).empty()) return std::nullopt;
  const cln::cl_R range = model::evaluate(upper.value) - model::evaluate(lower.value);
  if (model::vanishes(range) || cln::minusp(range)) {
    table.context().error(table.place_of("limits"),
                          "the limits are reversed: the lower is not below the upper",
                          "write [lower, upper]");
  }
  return model::Limits{lower.value, upper.value};
}

/// A constant above 0, of velocity_limit or effort_limit.
std::optional<Expression> read_greatest(const Table& table, const std::string& key) {
  if (!table.has(key)) return std::nullopt;
  const Entry entry = entry_or_zero(table, key, {Role::constant});
  const bool is_angle = key == "velocity_limit";  // "180 deg" is one a second
  if (!is_angle) check_no_angle(table.context(), entry, key);
  if (!symbols(entry.value).empty()) return std::nullopt;
  try {
    if (cln::plusp(model::evaluate(entry.value))) return entry.value;
  } catch (const model::EvaluationError&) {
    return std::nullopt;  // told where the expression is read
  }
  table.context().error(entry.place, "'" + key + "' is not above 0",
                        is_angle ? "write rad/s or m/s" : "write Nm or N");
  return std::nullopt;
}

}  // namespace

FreeParameters read_free_parameters(const Table& root) {
  return {read_free(root, "inertia"), read_free(root, "drives")};
}

std::optional<model::Inertia> read_floating_base(const Table& root, const FreeParameters& free) {
  const auto table = root.table("floating_base");
  if (!table) return std::nullopt;
  table->allow_only({"mass", "centre_of_mass", "inertia"});
  for (const char* key : {"base", "home"})
    if (root.has(key))
      root.context().error(root.key_place(key), "[" + std::string(key) + "] beside [floating_base]",
                           "the pose of a base that floats is an argument of the functions");
  root.context().base_place = table->place();
  model::Inertia inertia;
  read_masses(*table, free.inertia, inertia);
  read_tensor(*table, free.inertia, inertia);
  return inertia;
}

std::vector<std::string> joint_keys(const std::vector<std::string>& more) {
  std::vector<std::string> keys{
      "type",           "variable",         "limits",           "mass",    "centre_of_mass", "inertia",
      "rotor_inertia",  "viscous_friction", "coulomb_friction", "follows", "ratio",          "offset",
      "velocity_limit", "effort_limit"};
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

std::optional<model::JointType> read_joint_type(const Table& table,
                                                const std::vector<std::string>& other_types) {
  const auto text = table.text("type");
  if (!text) return std::nullopt;
  if (*text == "revolute") return model::JointType::revolute;
  if (*text == "prismatic") return model::JointType::prismatic;
  std::vector<std::string> types{"revolute", "prismatic"};
  types.insert(types.end(), other_types.begin(), other_types.end());
  const std::string near = nearest(*text, types);
  table.context().error(
      table.place_of("type"), "unknown joint type '" + *text + "'",
      near.empty() ? "write \"revolute\" or \"prismatic\"" : "did you mean \"" + near + "\"?");
  return std::nullopt;
}

void add_variable(Context& context, const std::string& name, Place place) {
  const NameProblem problem = check_identifier(name);
  if (!problem.message.empty()) context.error(place, problem.message, problem.hint);
  context.variables.push_back({name, place});
}

std::string read_variable(const Table& table) {
  Context& context = table.context();
  std::string name = table.text("variable").value_or("");
  if (table.has("variable") && table.find("variable")->is_string())
    add_variable(context, name, table.place_of("variable"));
  else
    context.variables.push_back({name, table.place_of("variable")});
  return name;
}

void read_link(const Table& table, const FreeParameters& free, model::Joint& joint) {
  joint.limits = read_limits(table, joint.type);
  joint.greatest_velocity = read_greatest(table, "velocity_limit");
  joint.greatest_effort = read_greatest(table, "effort_limit");
  read_masses(table, free.inertia, joint.inertia);
  read_tensor(table, free.inertia, joint.inertia);
  // Motors have the drives of a joint that follows several.
  read_drive(table, free.drives && !follows_sum(table), link_number(table.context()), joint.drive);
  read_follower(table, joint.type);
}

void read_motors(const Table& root, const FreeParameters& free, model::Robot& robot) {
  for (const Table& table : root.tables("motor")) {
    table.allow_only({"type", "variable", "limits", "velocity_limit", "effort_limit", "rotor_inertia",
                      "viscous_friction", "coulomb_friction"});
    table.require("variable", "variable = \"m1\", the name of its value");
    model::Motor motor;
    motor.type = read_joint_type(table).value_or(model::JointType::revolute);
    motor.variable = read_variable(table);
    motor.limits = read_limits(table, motor.type);
    motor.greatest_velocity = read_greatest(table, "velocity_limit");
    motor.greatest_effort = read_greatest(table, "effort_limit");
    read_drive(table, free.drives, "_" + motor.variable, motor.drive);
    table.context().motor_places.push_back(table.place());
    robot.motors.push_back(std::move(motor));
  }
}

}  // namespace qvgen::description
