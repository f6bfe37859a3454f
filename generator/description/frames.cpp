// SPDX-License-Identifier: MIT
#include "description/frames.h"

#include <cmath>

#include <cln/integer.h>
#include <fmt/format.h>

#include "description/xml/snap.h"
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

/// The entries as decimals, with as many digits as each needs; nothing where one is none.
std::optional<std::vector<xml::Decimal>> decimals_of(const model::Vector3& axis, Place place) {
  constexpr int most_places = 40;
  std::vector<xml::Decimal> decimals;
  for (const Expression& entry : axis) {
    const auto value = model::rational_value(model::evaluate(entry));
    if (!value) return std::nullopt;
    int places = 0;
    for (cln::cl_RA scaled = *value; cln::denominator(scaled) != 1; scaled = scaled * 10)
      if (++places > most_places) return std::nullopt;
    decimals.push_back({*value, places, 1, place, to_string(entry)});
  }
  return decimals;
}

/// True for a unit vector; one that was rounded to four digits or more is made one, exactly, as in a URDF.
bool make_unit(Context& context, Place place, model::Vector3& axis) {
  cln::cl_R squared = 0;
  for (const Expression& entry : axis) squared = squared + cln::square(model::evaluate(entry));
  if (model::vanishes(squared)) {
    context.error(place, "the axis has length zero", "give a direction, e.g. \"+z\"");
    return false;
  }
  if (model::vanishes(squared - 1)) return true;
  const auto decimals = decimals_of(axis, place);
  if (decimals && cln::abs(squared - 1) < cln::cl_RA(2) / 10000) {
    axis = xml::Snap(context).unit(*decimals);
    context.note(place,
                 "the axis has length " + fmt::format("{:.9g}", std::sqrt(model::to_double(squared))) +
                     " and is read as [" + to_string(axis[0]) + ", " + to_string(axis[1]) + ", " +
                     to_string(axis[2]) + "]",
                 "write it so if other digits are meant");
    return true;
  }
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
  if (!complete || !make_unit(context, place, axis)) return std::nullopt;
  return axis;
}

std::vector<model::Turn> read_rpy(const Table& table) {
  const auto angles = read_entries(table, "rpy", {}, {3}, "three angles [roll, pitch, yaw]");
  std::vector<model::Turn> turns;
  for (std::size_t i = 3; angles && i-- > 0;) {  // about the fixed axes x, y, z in turn: R = Rz Ry Rx
    const Entry angle = in_radians(table.context(), (*angles)[i]);
    check_angle(table.context(), angle);
    const auto turn = coordinate_turn(i, angle.value);
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
  if (angle) angle = in_radians(table.context(), *angle);
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
