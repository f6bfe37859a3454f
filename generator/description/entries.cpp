// SPDX-License-Identifier: MIT
#include "description/entries.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "description/parser.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

/// Metres. Beyond any arm, and its sixth power, as polynomials of inverse kinematics have it, is a double.
constexpr int longest = 1'000'000;

/// Column of the first character of a quoted text, so that a mistake inside it can be pointed at; nullopt for
/// multi-line and escaped texts, whose characters do not stand where they seem to.
std::optional<Place> text_begin(const Context& context, const toml::node& node, const std::string& value) {
  const std::string written = context.source.slice(node.source());
  if (written != "\"" + value + "\"" && written != "'" + value + "'") return std::nullopt;
  const Place place = begin_of(node.source());
  return Place{place.line, place.column + 1};
}

Place shifted(const std::optional<Place>& begin, std::size_t offset, Place otherwise) {
  return begin ? Place{begin->line, begin->column + static_cast<int>(offset)} : otherwise;
}

/// A float as it was written: its binary value is not what the description says.
std::string float_text(const Context& context, const toml::node& node) {
  std::string text = context.source.slice(node.source());
  std::erase(text, '_');
  return text;
}

void record_symbols(Context& context, const ParsedExpression& parsed, const Scope& scope,
                    const std::optional<Place>& begin, Place place) {
  const std::vector<std::string> left = symbols(parsed.value);  // x - x leaves nothing of x
  for (const auto& use : parsed.symbols) {
    if (use.name == scope.variable || !std::binary_search(left.begin(), left.end(), use.name)) continue;
    context.uses.push_back({use.name, shifted(begin, use.offset, place), scope.role});
  }
}

std::optional<Entry> read_text(Context& context, const toml::node& node, const std::string& text,
                               const std::optional<Place>& begin, const Scope& scope) {
  const Place place = begin_of(node.source());
  try {
    const ParsedExpression parsed = parse_expression(text);
    record_symbols(context, parsed, scope, begin, place);
    context.entries.push_back({parsed.value, place, parsed.has_unit});
    return context.entries.back();
  } catch (const ExpressionError& error) {
    context.has_broken_expression = true;
    context.error(shifted(begin, error.offset, place), error.message, error.hint);
    return std::nullopt;
  }
}

}  // namespace

std::optional<Entry> read_entry(Context& context, const toml::node& node, const Scope& scope,
                                const std::string& what) {
  const Place place = begin_of(node.source());
  if (const auto text = node.value_exact<std::string>()) {
    return read_text(context, node, *text, text_begin(context, node, *text), scope);
  }
  if (const auto integer = node.value_exact<std::int64_t>()) {
    return Entry{cln::cl_RA(static_cast<long>(*integer)), place, false};
  }
  if (const auto real = node.value_exact<double>()) {
    if (std::isfinite(*real)) return read_text(context, node, float_text(context, node), place, scope);
    context.error(place, what + " is not finite", "write a finite number");
    return std::nullopt;
  }
  report_type(context, node, what, "a number or an expression in quotes");
  return std::nullopt;
}

Entry entry_or_zero(const Table& table, const std::string& key, const Scope& scope) {
  const toml::node* node = table.find(key);
  if (node == nullptr) return {{}, table.place(), false};
  return read_entry(table.context(), *node, scope, "'" + key + "'")
      .value_or(Entry{{}, table.place_of(key), false});
}

std::optional<std::vector<Entry>> read_entries(const Table& table, const std::string& key, const Scope& scope,
                                               const std::vector<std::size_t>& lengths,
                                               const std::string& wanted) {
  const toml::node* node = table.find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    report_type(table.context(), *node, "'" + key + "'", wanted);
    return std::nullopt;
  }
  std::vector<Entry> result;
  for (const toml::node& element : *array) {
    result.push_back(read_entry(table.context(), element, scope, "an entry of '" + key + "'")
                         .value_or(Entry{{}, begin_of(element.source()), false}));
  }
  if (std::find(lengths.begin(), lengths.end(), result.size()) == lengths.end()) {
    const std::string count = std::to_string(result.size()) + (result.size() == 1 ? " entry" : " entries");
    table.context().error(table.place_of(key), "'" + key + "' has " + count, "write " + wanted);
    return std::nullopt;
  }
  return result;
}

namespace {

/// The terms without names times a number and a unit.
model::Expression scaled(const model::Expression& e, const cln::cl_RA& factor,
                         const model::Expression& unit) {
  std::vector<model::Term> terms = model::terms(e);
  for (model::Term& term : terms)
    if (symbols(term.value).empty()) term.value = model::multiply(model::multiply(factor, term.value), unit);
  return model::sum_of(terms);
}

}  // namespace

Entry in_metres(const Context& context, Entry entry) {
  if (context.units.length != 1 && !entry.has_unit)
    entry.value = scaled(entry.value, context.units.length, cln::cl_RA(1));
  return entry;
}

Entry in_radians(const Context& context, Entry entry) {
  if (context.units.degrees && !entry.has_unit)
    entry.value = scaled(entry.value, cln::cl_RA(1) / 180, model::Expression::pi());
  return entry;
}

model::Vector3 vector_or_zero(const Table& table, const std::string& key, const Scope& scope) {
  model::Vector3 result;
  const auto entries = read_entries(table, key, scope, {3}, "three entries [x, y, z]");
  for (std::size_t i = 0; entries && i < 3; ++i) {
    const Entry entry = in_metres(table.context(), (*entries)[i]);
    check_length(table.context(), entry, key);
    result.at(i) = entry.value;
  }
  return result;
}

void check_no_angle(Context& context, const Entry& entry, const std::string& key) {
  if (entry.has_unit)
    context.error(entry.place, "'" + key + "' has an angle, " + to_string(entry.value),
                  "lengths are in metres, without a unit");
}

namespace {

/// As people write it: 3927/2500 is 1.5708.
std::string decimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

}  // namespace

void check_length(Context& context, const Entry& entry, const std::string& key) {
  check_no_angle(context, entry, key);
  if (!model::symbols(entry.value).empty()) return;
  double length = 0;
  try {
    const auto value = model::evaluate(entry.value);
    if (cln::abs(value) <= longest) return;
    length = cln::double_approx(value);
  } catch (const model::EvaluationError&) {
    return;  // told where the expression is read
  }
  context.error(entry.place, "'" + key + "' has a length of " + decimal(length) + " metres",
                "lengths are in metres, at most " + std::to_string(longest));
}

namespace {

/// A number of radians next to a multiple of 15 degrees was rounded from it, most likely. It is used as it is
/// written.
void check_rounded(Context& context, const Entry& angle, const cln::cl_RA& radians) {
  constexpr double step = 0.26179938779914943654;  // pi/12
  constexpr double most = 1e-3;
  const double value = cln::double_approx(radians);
  const double count = std::round(value / step);
  const double off = std::abs(value - count * step);
  if (count == 0 || off > most || std::abs(value) > 7) return;
  const auto degrees = std::to_string(static_cast<int>(15 * count));
  context.warning(
      angle.place,
      "the angle " + decimal(value) + " is " + degrees + " degrees but for rounding, and kept as written",
      "write '" + degrees + " deg' if that is meant: the arm has a simpler structure then");
}

}  // namespace

void check_angle(Context& context, const Entry& angle) {
  if (angle.has_unit) return;
  const auto form = model::angle_form(angle.value);
  if (!form || !cln::zerop(form->half_turns)) return;
  if (!context.is_measured) check_rounded(context, angle, form->radians);
  const cln::cl_RA full_turn = cln::cl_RA(62832) / 10000;
  if (cln::abs(form->radians) <= full_turn) return;
  const std::string text = to_string(angle.value);
  context.warning(angle.place, "the angle " + text + " is more than a full turn in radians",
                  "write '" + text + " deg' for degrees, or angle_unit = \"deg\" for the whole file; '" +
                      text + " rad' if radians are meant");
}

}  // namespace qvgen::description
