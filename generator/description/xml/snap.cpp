// SPDX-License-Identifier: MIT
#include "description/xml/snap.h"

#include <algorithm>

#include <cln/integer.h>
#include <cln/real.h>
#include <fmt/format.h>

#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description::xml {
namespace {

using model::Expression;

Expression root(long radicand) { return Expression::make(Expression::Kind::root, {cln::cl_RA(radicand)}); }
Expression fraction(const Expression& numerator, long denominator) {
  return model::divide(numerator, cln::cl_RA(denominator));
}

/// Exact values that an entry of a unit vector may have been, not negative.
const std::vector<Expression>& known_entries() {
  static const std::vector<Expression> entries{
      Expression(),
      cln::cl_RA(1),
      cln::cl_RA(1) / 2,
      fraction(root(2), 2),
      fraction(root(3), 2),
      fraction(root(3), 3),
      fraction(model::add(root(6), root(2)), 4),
      fraction(model::subtract(root(6), root(2)), 4),
  };
  return entries;
}

/// Digits to which a value computed to tree::rounded_digits must agree to count as exact.
constexpr long tree_digits = 36;

cln::cl_RA tolerance(long exponent) { return cln::expt(cln::cl_RA(10), cln::cl_I(exponent)); }

std::string angle_text(const cln::cl_I& twelfths) {
  if (cln::zerop(twelfths)) return "0";
  return fmt::format("{} deg", cln::cl_I_to_long(15 * twelfths));
}

/// Writes a turn about a coordinate axis.
std::string turn_text(const model::Turn& turn) {
  const double half_turns = model::to_double(model::evaluate(turn.angle) / model::evaluate(Expression::pi()));
  std::size_t axis = 0;
  while (turn.axis.at(axis).is_literal_zero()) ++axis;
  return fmt::format("{} deg about {}", 180 * half_turns, "xyz"[axis]);
}

/// The vector divided by its length, exactly.
model::Vector3 normalised(const std::array<cln::cl_RA, 3>& v) {
  const cln::cl_RA squared = cln::square(v[0]) + cln::square(v[1]) + cln::square(v[2]);
  cln::cl_RA length;
  const bool rational = cln::sqrtp(squared, &length);
  const Expression divisor =
      rational ? Expression(length) : Expression::make(Expression::Kind::root, {squared});
  model::Vector3 result;
  for (std::size_t i = 0; i < 3; ++i)
    if (!cln::zerop(v.at(i))) result.at(i) = model::divide(v.at(i), divisor);
  return result;
}

/// v over its largest entry: (0.57735, 0.57735, 0.57735) is (1, 1, 1), with less to take a root of.
std::array<cln::cl_RA, 3> reduced(const std::vector<Decimal>& v) {
  cln::cl_RA largest = 0;
  for (const Decimal& entry : v) largest = cln::max(largest, cln::abs(entry.value));
  return {v[0].value / largest, v[1].value / largest, v[2].value / largest};
}

}  // namespace

bool Snap::is_meant(const Decimal& written, const cln::cl_R& exact, int least_places) const {
  const SnapOptions& options = options_;
  if (options.mode == SnapOptions::off) return false;
  const cln::cl_R difference = cln::abs(written.value - exact);
  if (options.mode == SnapOptions::within) return difference <= options.tolerance;
  return difference <= tolerance(-6) ||
         (written.places >= least_places && difference < written.units * tolerance(-written.places));
}

void Snap::note(const Decimal& written, const std::string& meant, const cln::cl_R& exact) const {
  const double change = model::to_double(exact - written.value);
  context_->note(written.place, fmt::format("{} is read as {}, {:.1e} more", written.text, meant, change),
                 "--snap off keeps it");
}

Expression Snap::angle(const Decimal& radians) const {
  const auto twelfths = meant_twelfths(radians);
  if (!twelfths || cln::zerop(radians.value)) return radians.value;
  note(radians, angle_text(*twelfths), *twelfths * model::evaluate(Expression::pi()) / 12);
  return model::multiply(cln::cl_RA(*twelfths) / 12, Expression::pi());
}

std::optional<cln::cl_I> Snap::meant_twelfths(const Decimal& radians) const {
  const cln::cl_R pi = model::evaluate(Expression::pi());
  const cln::cl_I twelfths = cln::round1(12 * radians.value / pi);
  // Two digits behind the point are enough for a right angle (1.57), not for others (0.26), and none for
  // zero.
  const bool right = cln::zerop(cln::mod(twelfths, 6));
  const int least_places = cln::zerop(twelfths) ? 1000 : right ? 2 : 3;
  if (!is_meant(radians, twelfths * pi / 12, least_places)) return std::nullopt;
  return twelfths;
}

std::optional<Expression> Snap::part_of_turn(const cln::cl_RA& radians, const Decimal& written) const {
  Decimal angle = written;
  angle.value = radians;
  auto twelfths = meant_twelfths(angle);
  if (!twelfths) {  // what is exact without any tolerance
    const cln::cl_R pi = model::evaluate(Expression::pi());
    twelfths = cln::round1(12 * radians / pi);
    if (cln::abs(radians - *twelfths * pi / 12) > tolerance(-tree_digits)) return std::nullopt;
  }
  return model::multiply(cln::cl_RA(*twelfths) / 12, Expression::pi());
}

void Snap::note_turns(const Decimal& written, const std::vector<model::Turn>& turns,
                      const std::array<std::array<cln::cl_R, 3>, 3>& rotation) const {
  cln::cl_R largest = 0;
  for (std::size_t column = 0; column < 3; ++column) {
    const model::Vector3 image = model::rotate(turns, model::unit_vector(column));
    for (std::size_t row = 0; row < 3; ++row)
      largest = cln::max(largest, cln::abs(model::evaluate(image.at(row)) - rotation.at(row).at(column)));
  }
  if (largest < tolerance(-tree_digits)) return;
  std::string text;
  for (const model::Turn& turn : turns) text += (text.empty() ? "" : ", ") + turn_text(turn);
  context_->note(written.place,
                 fmt::format("{} is read as {}, entries change by up to {:.1e}", written.text,
                             text.empty() ? "no turn" : text, model::to_double(largest)),
                 "--snap off keeps it");
}

Expression Snap::length(const Decimal& metres) const {
  const bool noise = cln::abs(metres.value) <= tolerance(-6);
  if (cln::zerop(metres.value) || !noise || options_.mode == SnapOptions::off) return metres.value;
  note(metres, "0", 0);
  return {};
}

model::Vector3 Snap::lengths(const std::vector<Decimal>& metres) const {
  return {length(metres[0]), length(metres[1]), length(metres[2])};
}

std::optional<model::Vector3> Snap::known_direction(const std::vector<Decimal>& vector) const {
  model::Vector3 result;
  cln::cl_R squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Decimal& entry = vector[i];
    Decimal size = entry;
    size.value = cln::abs(size.value);
    const auto& known = known_entries();
    const auto found = std::find_if(known.begin(), known.end(), [&](const Expression& candidate) {
      const cln::cl_R exact = model::evaluate(candidate);
      return size.value == exact || is_meant(size, exact, cln::zerop(exact) ? 1000 : 3);
    });
    if (found == known.end()) return std::nullopt;
    result.at(i) = cln::minusp(entry.value) ? model::negate(*found) : *found;
    squared = squared + cln::square(model::evaluate(*found));
  }
  if (!model::vanishes(squared - 1)) return std::nullopt;
  return result;
}

model::Vector3 Snap::unit(const std::vector<Decimal>& vector) const {
  const auto known = known_direction(vector);
  return known ? *known : normalised(reduced(vector));
}

model::Vector3 Snap::direction(const std::vector<Decimal>& vector) const {
  const auto ratios = reduced(vector);
  const bool simple = std::all_of(ratios.begin(), ratios.end(),
                                  [](const cln::cl_RA& r) { return cln::zerop(r) || cln::abs(r) == 1; });
  const auto known = simple ? std::nullopt : known_direction(vector);
  if (!known) return normalised(ratios);
  for (std::size_t i = 0; i < 3; ++i) {
    const cln::cl_R exact = model::evaluate(known->at(i));
    if (exact != cln::cl_R(vector[i].value)) note(vector[i], to_string(known->at(i)), exact);
  }
  return *known;
}

}  // namespace qvgen::description::xml

namespace qvgen::description {

std::optional<SnapOptions> parse_snap(const std::string& text) {
  if (text == "auto") return SnapOptions{};
  if (text == "off") return SnapOptions{SnapOptions::off, 0};
  Context context("", "", {});
  const auto number = xml::read_decimals(context, {"snap", text, {}});
  if (!number || number->size() != 1 || cln::minusp(number->front().value)) return std::nullopt;
  return SnapOptions{SnapOptions::within, number->front().value};
}

}  // namespace qvgen::description
