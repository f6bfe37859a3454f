// SPDX-License-Identifier: MIT
#include <algorithm>

#include "description/chain.h"
#include "description/frames.h"
#include "description/names.h"
#include "model/arithmetic.h"

namespace qvgen::description {
namespace {

using model::Displacement;
using model::Expression;

enum class Convention { standard, modified };

struct Row {
  Entry theta, d, a, alpha;
};

std::optional<Convention> read_convention(const Table& root) {
  if (root.require("convention", "convention = \"standard\" or \"modified\"") == nullptr) return std::nullopt;
  const auto text = root.text("convention");
  if (!text) return std::nullopt;
  if (*text == "standard") return Convention::standard;
  if (*text == "modified") return Convention::modified;
  const std::string near = nearest(*text, {"standard", "modified"});
  root.context().error(
      root.place_of("convention"), "unknown convention '" + *text + "'",
      near.empty() ? "write \"standard\" or \"modified\"" : "did you mean \"" + near + "\"?");
  return std::nullopt;
}

Row read_row(const Table& table, const std::string& variable) {
  const Scope moving{Role::geometry, variable};
  const Context& context = table.context();
  Row row{in_radians(context, entry_or_zero(table, "theta", moving)),
          in_metres(context, entry_or_zero(table, "d", moving)),
          in_metres(context, entry_or_zero(table, "a", {})),
          in_radians(context, entry_or_zero(table, "alpha", {}))};
  check_angle(table.context(), row.alpha);
  check_length(table.context(), row.d, "d");
  check_length(table.context(), row.a, "a");
  return row;
}

bool mentions(const Expression& e, const std::string& name) {
  const auto names = symbols(e);
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// theta or d of a moving row: the variable with its sign, and the constant rest.
struct Motion {
  long sign = 1;
  Expression rest;
};

std::optional<Motion> take_apart(const Expression& e, const std::string& variable) {
  Motion motion;
  std::vector<model::Term> rest;
  int count = 0;
  for (const model::Term& term : model::terms(e)) {
    if (term.value.kind() == Expression::Kind::symbol && term.value.name() == variable) {
      motion.sign = term.negative ? -1 : 1;
      ++count;
    } else {
      if (mentions(term.value, variable)) return std::nullopt;
      rest.push_back(term);
    }
  }
  if (count > 1) return std::nullopt;
  motion.rest = model::sum_of(rest);
  return motion;
}

/// The row without its motion, in two parts: rotation about and translation along the joint's z axis commute
/// with the motion, so a constant part of theta goes before it and one of d behind it.
struct Split {
  Displacement before, after;
};

Split split(Convention convention, const Row& row, const Expression& theta, const Expression& d) {
  const auto turn_z = coordinate_turn(2, theta);
  const auto turn_x = coordinate_turn(0, row.alpha.value);
  const Expression zero;
  if (convention == Convention::standard) {  // Rz(theta) Tz(d) Tx(a) Rx(alpha)
    return {{turn_z, {}}, {turn_x, model::Vector3{row.a.value, zero, d}}};
  }
  Split result{{turn_x, model::Vector3{row.a.value, zero, zero}},
               {{}, model::Vector3{zero, zero, d}}};  // Rx(alpha) Tx(a) Rz(theta) Tz(d)
  result.before.turns.insert(result.before.turns.end(), turn_z.begin(), turn_z.end());
  return result;
}

model::JointType type_of(const Table& table, const Row& row, const std::string& variable) {
  if (table.has("type")) return read_joint_type(table).value_or(model::JointType::revolute);
  if (!mentions(row.d.value, variable) || mentions(row.theta.value, variable))
    return model::JointType::revolute;
  return model::JointType::prismatic;
}

model::Joint read_moving_row(const Table& table, Convention convention, const FreeParameters& free) {
  model::Joint joint;
  joint.variable = read_variable(table);
  const Row row = read_row(table, joint.variable);
  joint.type = type_of(table, row, joint.variable);
  const bool turns = joint.type == model::JointType::revolute;
  const std::string key = turns ? "theta" : "d";
  const Entry& moving = turns ? row.theta : row.d;
  const Entry& fixed = turns ? row.d : row.theta;

  Motion motion;
  if (mentions(fixed.value, joint.variable) || (table.has(key) && !mentions(moving.value, joint.variable))) {
    table.context().error(table.has(key) ? moving.place : fixed.place,
                          "the variable '" + joint.variable + "' of this " +
                              (turns ? "revolute" : "prismatic") + " row must stand in '" + key + "' alone",
                          "write " + key + " = \"" + joint.variable + "\", with a constant added if need be");
  } else if (const auto parts = take_apart(moving.value, joint.variable)) {
    motion = *parts;
  } else {
    table.context().error(moving.place, "'" + key + "' is not the variable plus a constant",
                          "write " + key + " = \"" + joint.variable + " + constant\"");
  }
  const Expression theta = turns ? motion.rest : row.theta.value;
  check_angle(table.context(), {theta, row.theta.place, row.theta.has_unit});
  const Split parts = split(convention, row, theta, turns ? row.d.value : motion.rest);
  joint.before = parts.before;
  joint.axis = model::unit_vector(2, motion.sign);
  joint.after = parts.after;
  read_link(table, free, joint);
  return joint;
}

Displacement read_fixed_row(const Table& table, Convention convention) {
  table.allow_only({"theta", "d", "a", "alpha"});
  const Row row = read_row(table, "");
  check_angle(table.context(), row.theta);
  // A variable may have been forgotten: symbols.cpp looks at these once it knows what is declared.
  for (const Entry& entry : {row.theta, row.d})
    for (const std::string& name : symbols(entry.value))
      table.context().constants_in_place_of_variables.push_back({name, entry.place});
  const Split parts = split(convention, row, row.theta.value, row.d.value);
  return model::compose(parts.before, parts.after);
}

}  // namespace

// A row without a variable is a fixed displacement: before the next joint, so that link frames stay where the
// table has them, or the tool if no joint follows.
void read_dh_table(const Table& root, const FreeParameters& free, model::Robot& robot) {
  const Convention convention = read_convention(root).value_or(Convention::standard);
  Displacement pending;
  for (const Table& table : root.tables("dh")) {
    if (!table.has("variable") && !table.has("type")) {
      pending = model::compose(pending, read_fixed_row(table, convention));
      continue;
    }
    table.allow_only(joint_keys({"theta", "d", "a", "alpha"}));
    table.require("variable", "a name, e.g. variable = \"theta1\"; rows without type and variable are fixed");
    table.context().joint_places.push_back(table.place());
    model::Joint joint = read_moving_row(table, convention, free);
    joint.before = model::compose(pending, joint.before);
    pending = {};
    robot.joints.push_back(std::move(joint));
  }
  robot.tool = model::compose(pending, robot.tool);
}

}  // namespace qvgen::description
