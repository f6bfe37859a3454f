// SPDX-License-Identifier: MIT
#include "derive/dynamics/column_relations.h"

#include <algorithm>
#include <set>
#include <utility>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

#include "dag/evaluate.h"
#include "exact/point.h"

namespace qvgen::derive::dynamics {
namespace {

using cln::cl_R;
using exact::Number;
using Vector = std::vector<cl_R>;

constexpr long digits = 80;
/// Rounding leaves far less, a column of its own far more.
const cln::cl_RA negligible = cln::expt(cln::cl_RA(10), -40);
/// Denominators of coefficients are small: halves, and those of the ratios of followers.
constexpr long largest_denominator = 1000;

/// Symbols of the geometry have the values of one point, those of the motion of another; some are given.
struct Leaves {
  const std::set<std::string>& of_geometry;
  const exact::ExactPoint& geometry;
  const exact::ExactPoint& motion;
  const std::map<std::string, Number>& given;

  [[nodiscard]] Number constant(const Number& value) const { return value; }
  [[nodiscard]] Number symbol(const std::string& name) const {
    const auto place = given.find(name);
    if (place != given.end()) return place->second;
    return (of_geometry.contains(name) ? geometry : motion).symbol(name);
  }
  [[nodiscard]] Number sine(const exact::Angle& angle) const {
    const auto [moving, still] = split(angle);
    return motion.sine(moving) * geometry.cosine(still) + motion.cosine(moving) * geometry.sine(still);
  }
  [[nodiscard]] Number cosine(const exact::Angle& angle) const {
    const auto [moving, still] = split(angle);
    return motion.cosine(moving) * geometry.cosine(still) - motion.sine(moving) * geometry.sine(still);
  }
  [[nodiscard]] Number root(const Number& value) const { return motion.root(value); }
  [[nodiscard]] Number arctangent(const Number& y, const Number& x) const { return motion.arctangent(y, x); }

 private:
  /// The part that moves, and that of the geometry.
  [[nodiscard]] std::pair<exact::Angle, exact::Angle> split(const exact::Angle& angle) const {
    std::pair<exact::Angle, exact::Angle> parts{{{}, angle.pi}, {}};
    for (const auto& term : angle.terms)
      (of_geometry.contains(term.first) ? parts.second : parts.first).terms.insert(term);
    return parts;
  }
};

/// No rational with a small denominator, so that a coefficient shows whether it contains gravity.
const cln::cl_RA gravity = cln::cl_RA(980'665'003) / 100'000'007;

/// The columns at so many random motions, one below the other.
std::vector<Vector> columns_at(const model::Robot& robot, const Formulation& formulation, std::size_t rows,
                               const exact::ExactPoint& geometry) {
  std::set<std::string> of_geometry;
  for (const model::Parameter& parameter : robot.geometry) of_geometry.insert(parameter.name);
  std::map<std::string, Number> constants{{gravity_symbol, Number(gravity)}};
  const auto values =
      dag::evaluate<Number>(formulation.constants, Leaves{of_geometry, geometry, geometry, constants});
  for (std::size_t i = 0; i < values.size(); ++i)
    constants[formulation.constants.outputs[i].name] = values[i];
  std::set<std::string> whole;
  for (const model::Joint& joint : robot.joints) whole.insert(joint.variable);
  std::vector<Vector> columns(formulation.function.outputs.size() / rows);
  const std::size_t motions = columns.size() / rows + 5;
  for (std::size_t m = 0; m < motions; ++m) {
    const exact::ExactPoint motion(100 + m, whole);
    const auto entries =
        dag::evaluate<Number>(formulation.function, Leaves{of_geometry, geometry, motion, constants});
    for (std::size_t i = 0; i < entries.size(); ++i)
      columns[i / rows].push_back(exact::to_float(entries[i], cln::float_format(digits)));
  }
  return columns;
}

bool is_negligible(const cl_R& value, const cl_R& beside) { return cln::abs(value) <= negligible * beside; }

cl_R largest(const Vector& v) {
  cl_R result = 0;
  for (const cl_R& entry : v) result = cln::max(result, cln::abs(entry));
  return result;
}

/// Columns that are kept, eliminated, and what they are made of.
class Elimination {
 public:
  /// The coefficients of the kept columns that give this one; nothing if it is independent, and kept.
  std::optional<std::map<std::size_t, cl_R>> take(std::size_t index, Vector column) {
    const cl_R size = largest(column);
    std::map<std::size_t, cl_R> made_of{{index, 1}};
    for (const Kept& kept : kept_) {
      const cl_R factor = column[kept.pivot] / kept.column[kept.pivot];
      if (cln::zerop(factor)) continue;
      for (std::size_t i = 0; i < column.size(); ++i) column[i] = column[i] - factor * kept.column[i];
      for (const auto& [other, share] : kept.made_of) made_of[other] = made_of[other] - factor * share;
    }
    std::size_t pivot = 0;
    for (std::size_t i = 1; i < column.size(); ++i)
      if (cln::abs(column[i]) > cln::abs(column[pivot])) pivot = i;
    if (!is_negligible(column[pivot], size)) {
      kept_.push_back({std::move(column), pivot, std::move(made_of)});
      return std::nullopt;
    }
    made_of.erase(index);
    for (auto& [other, share] : made_of) share = -share;
    return made_of;
  }

 private:
  struct Kept {
    Vector column;
    std::size_t pivot;
    std::map<std::size_t, cl_R> made_of;
  };
  std::vector<Kept> kept_;
};

std::optional<cln::cl_RA> rational_near(const cl_R& value) {
  for (long denominator = 1; denominator <= largest_denominator; ++denominator) {
    const cln::cl_I numerator = cln::round1(value * denominator);
    const cln::cl_RA candidate = numerator / cln::cl_RA(denominator);
    if (is_negligible(value - candidate, 1)) return candidate;
  }
  return std::nullopt;
}

std::optional<Coefficient> coefficient_of(const cl_R& value) {
  if (const auto rational = rational_near(value)) return Coefficient{*rational, false};
  if (const auto rational = rational_near(value / gravity)) return Coefficient{*rational, true};
  return std::nullopt;
}

using Relations = std::vector<std::optional<Relation>>;

Relations relations_at(const model::Robot& robot, const Formulation& formulation, std::size_t rows,
                       const std::vector<std::size_t>& order, std::uint64_t seed) {
  const exact::ExactPoint geometry(seed);
  const std::vector<Vector> columns = columns_at(robot, formulation, rows, geometry);
  Relations relations(columns.size());
  Elimination elimination;
  for (const std::size_t index : order) {
    const auto found = elimination.take(index, columns[index]);
    if (!found) continue;
    relations[index].emplace();
    for (const auto& [other, value] : *found)
      if (!is_negligible(value, 1)) relations[index]->emplace(other, coefficient_of(value));
  }
  return relations;
}

/// Forgets the coefficients that the other geometry has not.
void forget_what_differs(Relation& relation, const Relation& other) {
  for (const auto& entry : other) relation.try_emplace(entry.first);
  for (auto& [index, coefficient] : relation) {
    const auto place = other.find(index);
    if (place == other.end() || place->second != coefficient) coefficient.reset();
  }
}

}  // namespace

bool is_known(const Relation& relation) {
  return std::all_of(relation.begin(), relation.end(),
                     [](const auto& entry) { return entry.second.has_value(); });
}

std::vector<std::optional<Relation>> relations_of_columns(const model::Robot& robot,
                                                          const Formulation& formulation, std::size_t rows,
                                                          const std::vector<std::size_t>& order) {
  Relations relations = relations_at(robot, formulation, rows, order, 21);
  const Relations others = relations_at(robot, formulation, rows, order, 22);
  for (std::size_t k = 0; k < relations.size(); ++k)
    if (!relations[k] || !others[k])
      relations[k].reset();
    else
      forget_what_differs(*relations[k], *others[k]);
  return relations;
}

}  // namespace qvgen::derive::dynamics
