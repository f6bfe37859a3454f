// SPDX-License-Identifier: MIT
#include "description/frames.h"

#include <cmath>

#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

using model::Expression;

std::optional<model::Vector3> named_axis(Context& context, const toml::node& node, const std::string& name) {
  const bool has_sign = !name.empty() && (name.front() == '+' || name.front() == '-');
  const std::string letter = name.substr(has_sign ? 1 : 0);
  const std::size_t index = std::string("xyz").find(letter);
  if (letter.size() == 1 && index != std::string::npos) {
    return model::unit_vector(index, name.front() == '-' ? -1 : 1);
  }
  context.error(begin_of(node.source()), "'" + name + "' is no axis",
                "write \"+x\", \"-x\", \"+y\", \"-y\", \"+z\" or \"-z\", or three entries [x, y, z]");
  return std::nullopt;
}

/// The root of a sum of squares, exact where the sum is.
std::string length_text(const cln::cl_R& squared) {
  const auto exact = model::rational_value(squared);
  if (!exact) return std::to_string(std::sqrt(model::to_double(squared)));
  const auto root =
      model::rational_value(model::evaluate(Expression::make(Expression::Kind::root, {*exact})));
  return root ? to_string(Expression(*root)) : "sqrt(" + to_string(Expression(*exact)) + ")";
}

bool check_unit_length(Context& context, Place place, const model::Vector3& axis) {
  cln::cl_R squared = 0;
  for (const Expression& entry : axis) squared = squared + cln::square(model::evaluate(entry));
  if (model::vanishes(squared)) {
    context.error(place, "the axis has length zero", "give a direction, e.g. \"+z\"");
    return false;
  }
  if (model::vanishes(squared - 1)) return true;
  const std::string length = length_text(squared);
  context.error(place, "the axis is not a unit vector: its length is " + length,
                "divide its entries by " + length);
  return false;
}

std::optional<model::Vector3> listed_axis(Context& context, const toml::array& array) {
  const Place place = begin_of(array.source());
  if (array.size() != 3) {
    context.error(place, "the axis has " + std::to_string(array.size()) + " entries",
                  "write three entries [x, y, z], or \"+x\" ... \"-z\"");
    return std::nullopt;
  }
  model::Vector3 axis;
  bool complete = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto entry = read_entry(context, array[i], {Role::constant}, "an entry of the axis");
    complete = complete && entry && symbols(entry->value).empty();
    if (entry) axis.at(i) = entry->value;
  }
  if (!complete || !check_unit_length(context, place, axis)) return std::nullopt;
  return axis;
}

std::vector<model::Turn> read_rpy(const Table& table) {
  const auto angles = read_entries(table, "rpy", {}, {3}, "three angles [roll, pitch, yaw]");
  std::vector<model::Turn> turns;
  for (std::size_t i = 3; angles && i-- > 0;) {  // about the fixed axes x, y, z in turn: R = Rz Ry Rx
    check_angle(table.context(), (*angles)[i]);
    const auto turn = coordinate_turn(i, (*angles)[i].value);
    turns.insert(turns.end(), turn.begin(), turn.end());
  }
  return turns;
}

std::optional<model::Turn> read_turn(const Table& table) {
  table.allow_only({"axis", "angle"});
  const toml::node* axis_node = table.require("axis", "axis = \"+z\"");
  const toml::node* angle_node = table.require("angle", "angle = \"90 deg\"");
  std::optional<model::Vector3> axis;
  std::optional<Entry> angle;
  if (axis_node != nullptr) axis = read_axis(table.context(), *axis_node);
  if (angle_node != nullptr) angle = read_entry(table.context(), *angle_node, {}, "'angle'");
  if (angle) check_angle(table.context(), *angle);
  if (!axis || !angle || angle->value.is_literal_zero()) return std::nullopt;
  return model::Turn{*axis, angle->value};
}

}  // namespace

std::optional<model::Vector3> read_axis(Context& context, const toml::node& node) {
  if (const auto name = node.value_exact<std::string>()) return named_axis(context, node, *name);
  if (const toml::array* array = node.as_array()) return listed_axis(context, *array);
  report_type(context, node, "'axis'", "\"+x\" ... \"-z\", or three entries [x, y, z]");
  return std::nullopt;
}

std::vector<model::Turn> coordinate_turn(std::size_t axis, const Expression& angle) {
  if (angle.is_literal_zero()) return {};
  return {{model::unit_vector(axis), angle}};
}

std::vector<model::Turn> read_turns(const Table& table) {
  if (table.has("rpy") && table.has("turns")) {
    table.context().error(table.key_place("turns"), "both 'rpy' and 'turns' are given", "keep one of them");
  }
  if (table.has("rpy")) return read_rpy(table);
  std::vector<model::Turn> turns;
  for (const Table& element : table.tables("turns")) {
    if (const auto turn = read_turn(element)) turns.push_back(*turn);
  }
  return turns;
}

model::Displacement read_frame(const Table& root, const std::string& key) {
  const auto table = root.table(key);
  if (!table) return {};
  table->allow_only({"translation", "rpy", "turns"});
  return {read_turns(*table), vector_or_zero(*table, "translation", {})};
}

}  // namespace qvgen::description
