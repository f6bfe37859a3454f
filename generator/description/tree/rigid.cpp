// SPDX-License-Identifier: MIT
#include "description/tree/rigid.h"

#include <algorithm>
#include <stdexcept>

#include <cln/float.h>
#include <cln/integer.h>

#include "exact/trigonometry.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description::tree {
namespace {

using exact::Number;
using model::Expression;
using model::Turn;
using Kind = Expression::Kind;

/// Sines and cosines need no table: an angle that is not a multiple of pi/12 has none that is exact.
std::optional<Number> number_of(const Expression& e) {
  std::vector<Number> operands;
  for (const Expression& operand : e.operands()) {
    const auto value = number_of(operand);
    if (!value) return std::nullopt;
    operands.push_back(*value);
  }
  Number result = e.kind() == Kind::product ? 1 : 0;
  switch (e.kind()) {
    case Kind::number:
      return e.number();
    case Kind::negate:
      return -operands[0];
    case Kind::sum:
      for (const Number& operand : operands) result = result + operand;
      return result;
    case Kind::product:
      for (const Number& operand : operands) result = result * operand;
      return result;
    case Kind::quotient:
      if (operands[1].is_zero()) return std::nullopt;
      return operands[0] / operands[1];
    case Kind::root:
      // Roots of long decimals are not worth their factors.
      if (!operands[0].is_rational() || cln::denominator(operands[0].rational()) > 1000 ||
          cln::numerator(operands[0].rational()) > 1000 || operands[0].sign() < 0)
        return std::nullopt;
      return Number::root(operands[0].rational());
    default:
      return std::nullopt;
  }
}

Expression expression_of(const Number& number) {
  Expression sum;
  for (const auto& [radicand, coefficient] : number.terms()) {
    const Expression root =
        radicand == 1 ? Expression(cln::cl_RA(1)) : Expression::make(Kind::root, {cln::cl_RA(radicand)});
    sum = model::add(sum, model::multiply(coefficient, root));
  }
  return sum;
}

template <typename Scalar>
struct Rotation {
  std::array<Scalar, 3> axis;
  Scalar cosine, sine;
};

std::optional<Rotation<Number>> exact_rotation(const Turn& turn) {
  const auto angle = model::angle_form(turn.angle);
  if (!angle || !cln::zerop(angle->radians)) return std::nullopt;
  const auto sine = exact::exact_sine(angle->half_turns);
  const auto cosine = exact::exact_sine(angle->half_turns + cln::cl_RA(1) / 2);
  if (!sine || !cosine) return std::nullopt;
  Rotation<Number> result{{}, *cosine, *sine};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto entry = number_of(turn.axis.at(i));
    if (!entry) return std::nullopt;
    result.axis.at(i) = *entry;
  }
  return result;
}

Rotation<cln::cl_R> rounded_rotation(const Turn& turn) {
  Rotation<cln::cl_R> result;
  for (std::size_t i = 0; i < 3; ++i) result.axis.at(i) = model::evaluate(turn.axis.at(i));
  result.cosine = model::evaluate(model::cosine(turn.angle));
  result.sine = model::evaluate(model::sine(turn.angle));
  return result;
}

/// Rodrigues' formula.
template <typename Scalar>
std::array<Scalar, 3> rotated(const Rotation<Scalar>& by, const std::array<Scalar, 3>& v) {
  const auto& a = by.axis;
  const Scalar along = (a[0] * v[0] + a[1] * v[1] + a[2] * v[2]) * (Scalar(1) - by.cosine);
  const std::array<Scalar, 3> cross{a[1] * v[2] - a[2] * v[1], a[2] * v[0] - a[0] * v[2],
                                    a[0] * v[1] - a[1] * v[0]};
  std::array<Scalar, 3> result;
  for (std::size_t i = 0; i < 3; ++i)
    result.at(i) = by.cosine * v.at(i) + along * a.at(i) + by.sine * cross.at(i);
  return result;
}

std::optional<model::Vector3> exactly_rotated(const std::vector<Turn>& turns, const model::Vector3& v) {
  std::array<Number, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto entry = number_of(v.at(i));
    if (!entry) return std::nullopt;
    result.at(i) = *entry;
  }
  for (auto turn = turns.rbegin(); turn != turns.rend(); ++turn) {
    const auto rotation = exact_rotation(*turn);
    if (!rotation) return std::nullopt;
    result = rotated(*rotation, result);
  }
  return model::Vector3{expression_of(result[0]), expression_of(result[1]), expression_of(result[2])};
}

using Rotations = std::vector<Rotation<cln::cl_R>>;

/// Sines and cosines take far longer than what is done with them.
Rotations rounded_rotations(const std::vector<Turn>& turns) {
  Rotations result;
  for (const Turn& turn : turns) result.push_back(rounded_rotation(turn));
  return result;
}

Vector rotated(const Rotations& by, Vector v) {
  for (auto rotation = by.rbegin(); rotation != by.rend(); ++rotation) v = rotated(*rotation, v);
  return v;
}

bool same_axis(const Turn& a, const Turn& b) {
  return std::equal(a.axis.begin(), a.axis.end(), b.axis.begin(), model::same);
}
bool opposite_axis(const Turn& a, const Turn& b) {
  return std::equal(
      a.axis.begin(), a.axis.end(), b.axis.begin(),
      [](const Expression& x, const Expression& y) { return model::same(x, model::negate(y)); });
}

bool is_full_turn(const Expression& angle) {
  const auto form = model::angle_form(angle);
  return form && cln::zerop(form->radians) && cln::denominator(form->half_turns / 2) == 1;
}

/// The sum with multiples of pi gathered, so that it can vanish.
Expression angle_sum(const Expression& a, const Expression& b) {
  const Expression sum = model::add(a, b);
  const auto form = model::angle_form(sum);
  if (!form) return sum;
  return model::add(form->radians, model::multiply(form->half_turns, Expression::pi()));
}

void append(std::vector<Turn>& turns, const Turn& turn) {
  const bool same = !turns.empty() && same_axis(turns.back(), turn);
  if (!same && (turns.empty() || !opposite_axis(turns.back(), turn))) {
    turns.push_back(turn);
    return;
  }
  turns.back().angle = angle_sum(turns.back().angle, same ? turn.angle : model::negate(turn.angle));
  if (is_full_turn(turns.back().angle)) turns.pop_back();
}

Matrix transposed(const Matrix& m) {
  Matrix result = m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result.at(i).at(j) = m.at(j).at(i);
  return result;
}

Matrix plus(const Matrix& a, const Matrix& b) {
  Matrix sum = a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) sum.at(i).at(j) = a.at(i).at(j) + b.at(i).at(j);
  return sum;
}

/// Tensor about a point at `from` the centre, minus that about the centre (Steiner).
Matrix point_mass(const cln::cl_R& mass, const Vector& from) {
  const cln::cl_R squared = cln::square(from[0]) + cln::square(from[1]) + cln::square(from[2]);
  Matrix result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result.at(i).at(j) = mass * ((i == j ? squared : cln::cl_R(0)) - from.at(i) * from.at(j));
  return result;
}

}  // namespace

cln::cl_RA rounded(const cln::cl_R& value) {
  if (const auto exact = model::rational_value(value)) return *exact;
  const cln::cl_RA unit = cln::expt(cln::cl_RA(10), cln::cl_I(-rounded_digits));
  return cln::round1(value / unit) * unit;
}

Vector values(const model::Vector3& v) {
  return {model::evaluate(v[0]), model::evaluate(v[1]), model::evaluate(v[2])};
}

model::Vector3 turned(const std::vector<Turn>& turns, const model::Vector3& v) {
  if (turns.empty() || model::is_literal_zero(v)) return v;
  if (const auto exact = exactly_rotated(turns, v)) return *exact;
  const Vector result = rotated(rounded_rotations(turns), values(v));
  return {rounded(result[0]), rounded(result[1]), rounded(result[2])};
}

model::Displacement folded(const model::Displacement& first, const model::Displacement& second) {
  model::Displacement result = first;
  for (const Turn& turn : second.turns) append(result.turns, turn);
  result.translation = model::add(first.translation, turned(first.turns, second.translation));
  return result;
}

model::Displacement inverse(const model::Displacement& displacement) {
  model::Displacement result;
  for (auto turn = displacement.turns.rbegin(); turn != displacement.turns.rend(); ++turn)
    result.turns.push_back({turn->axis, model::negate(turn->angle)});
  result.translation = turned(result.turns, model::subtract({}, displacement.translation));
  return result;
}

Body moved(const model::Displacement& frame, const Body& body) {
  Body result = body;
  const Rotations by = rounded_rotations(frame.turns);
  result.centre = rotated(by, body.centre);
  const Vector origin = values(frame.translation);
  for (std::size_t i = 0; i < 3; ++i) result.centre.at(i) = result.centre.at(i) + origin.at(i);
  // R I R^T: R applied to the rows of I, and again to those of the transpose.
  for (int side = 0; side < 2; ++side) {
    for (Vector& row : result.inertia) row = rotated(by, row);
    result.inertia = transposed(result.inertia);
  }
  return result;
}

Body scaled(Body body, const cln::cl_R& factor) {
  body.mass = body.mass * factor;
  for (Vector& row : body.inertia)
    for (cln::cl_R& entry : row) entry = entry * factor;
  return body;
}

Body joined(const Body& a, const Body& b) {
  Body result;
  result.mass = a.mass + b.mass;
  if (cln::zerop(result.mass)) {
    result.centre = a.centre;
    result.inertia = plus(a.inertia, b.inertia);
    return result;
  }
  for (std::size_t i = 0; i < 3; ++i)
    result.centre.at(i) = (a.mass * a.centre.at(i) + b.mass * b.centre.at(i)) / result.mass;
  for (const Body* body : {&a, &b}) {
    Vector from;
    for (std::size_t i = 0; i < 3; ++i) from.at(i) = body->centre.at(i) - result.centre.at(i);
    result.inertia = plus(result.inertia, plus(body->inertia, point_mass(body->mass, from)));
  }
  return result;
}

model::Inertia inertia_of(const Body& body) {
  const Matrix& i = body.inertia;
  return {rounded(body.mass),
          {rounded(body.centre[0]), rounded(body.centre[1]), rounded(body.centre[2])},
          {rounded(i[0][0]), rounded(i[1][1]), rounded(i[2][2]), rounded(i[0][1]), rounded(i[1][2]),
           rounded(i[0][2])}};
}

}  // namespace qvgen::description::tree
