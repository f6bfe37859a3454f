// SPDX-License-Identifier: MIT
#include "derive/dynamics/rotation_sequence.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include <cln/integer.h>

#include "exact/constant_angle.h"
#include "exact/trigonometry.h"

namespace qvgen::derive::dynamics {
namespace {

using exact::Angle;
using exact::Number;
using Kind = model::Expression::Kind;

Angle quarter_turns(long count) { return {{}, cln::cl_RA(count) / 2}; }

ElementaryRotation turn(std::size_t axis, long quarters) { return {axis, quarter_turns(quarters)}; }

Angle negative(const Angle& angle) { return cln::cl_RA(-1) * angle; }

/// The angle as a multiple of pi/2 in 0..3, if it is one.
std::optional<long> quarters(const Angle& angle) {
  const cln::cl_RA count = angle.pi * 2;
  if (!angle.terms.empty() || cln::denominator(count) != 1) return std::nullopt;
  return cln::cl_I_to_long(cln::mod(cln::numerator(count), 4));
}

bool is(const ElementaryRotation& turn, long wanted) { return quarters(turn.angle) == wanted; }

std::optional<std::pair<std::size_t, long>> signed_axis(const model::Vector3& axis) {
  std::optional<std::pair<std::size_t, long>> result;
  for (std::size_t i = 0; i < 3; ++i) {
    if (axis[i].is_literal_zero()) continue;
    if (result || axis[i].kind() != Kind::number || cln::abs(axis[i].number()) != 1) return std::nullopt;
    result = {i, cln::plusp(axis[i].number()) ? 1 : -1};
  }
  return result;
}

[[noreturn]] void refuse_axis(const std::string& what) {
  throw std::domain_error(
      "dynamics: " + what +
      " in the direction of an axis is not exact; write the axis as \"+z\" after turns that "
      "lead there");
}

Number root_of(const Number& value) {
  if (value.is_rational()) return Number::root(value.rational());
  refuse_axis("the root of " + to_string(value));
}

Number power(const Number& base, long exponent) {
  Number result = 1;
  for (long i = 0; i < std::labs(exponent); ++i) result = result * base;
  return exponent < 0 ? result.inverse() : result;
}

/// The exact value of a constant; std::domain_error if it has none in the field of square roots.
Number number_of(const model::Expression& expression) {
  const auto operand = [&](std::size_t i) { return number_of(expression.operands()[i]); };
  const auto combined = [&](Number result, const auto& combine) {
    for (const auto& part : expression.operands()) result = combine(result, number_of(part));
    return result;
  };
  const auto angle = [&] { return to_angle(expression.operands()[0]); };
  const auto sine = [&](const Angle& of) {
    const auto value = of.terms.empty() ? exact::exact_sine(of.pi) : std::nullopt;
    if (!value) refuse_axis(to_string(expression));
    return *value;
  };
  switch (expression.kind()) {
    case Kind::number:
      return expression.number();
    case Kind::negate:
      return -operand(0);
    case Kind::sum:
      return combined(0, [](const Number& a, const Number& b) { return a + b; });
    case Kind::product:
      return combined(1, [](const Number& a, const Number& b) { return a * b; });
    case Kind::quotient:
      return operand(0) / operand(1);
    case Kind::power:
      return power(operand(0), expression.exponent());
    case Kind::root:
      return root_of(operand(0));
    case Kind::sine:
      return sine(angle());
    case Kind::cosine:
      return sine(angle() + quarter_turns(1));
    default:
      refuse_axis(to_string(expression));
  }
}

/// The angle of which these are cosine and sine: a part of a turn if it is a quarter, else a constant angle.
Angle angle_of(const Number& cosine, const Number& sine) {
  for (long k = 0; k < 4; ++k)
    if (*exact::exact_sine(quarter_turns(k + 1).pi) == cosine &&
        *exact::exact_sine(quarter_turns(k).pi) == sine)
      return quarter_turns(k);
  return {{{exact::constant_angle({cosine, sine}), 1}}, 0};
}

/// z(phi) x(alpha) takes +z to (sin phi sin alpha, -cos phi sin alpha, cos alpha).
RotationSequence from_z_to_oblique(const model::Vector3& axis) {
  const Number x = number_of(axis[0]), y = number_of(axis[1]), z = number_of(axis[2]);
  const Number sine = root_of(Number(1) - z * z);
  return {{2, angle_of(-y / sine, x / sine)}, {0, angle_of(z, sine)}};
}

using Matrix = std::array<std::array<Number, 3>, 3>;

/// Multiplies a rotation matrix by a turn from the right.
void turn_columns(Matrix& m, std::size_t axis, const exact::CosineSine& by) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  for (auto& row : m) {
    const Number a = row[i], b = row[j];
    row[i] = a * by.cosine + b * by.sine;
    row[j] = b * by.cosine - a * by.sine;
  }
}

bool drop_identity(RotationSequence& sequence) {
  const auto place =
      std::find_if(sequence.begin(), sequence.end(), [](const ElementaryRotation& t) { return is(t, 0); });
  if (place == sequence.end()) return false;
  sequence.erase(place);
  return true;
}

bool merge_neighbours(RotationSequence& sequence) {
  for (std::size_t i = 0; i + 1 < sequence.size(); ++i) {
    if (sequence[i].axis != sequence[i + 1].axis) continue;
    sequence[i].angle = sequence[i].angle + sequence[i + 1].angle;
    sequence.erase(sequence.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    return true;
  }
  return false;
}

/// A half turn about a passes a turn about b by changing its sign, so that the turns about a on both sides
/// meet.
bool pass_half_turn(RotationSequence& sequence) {
  for (std::size_t i = 0; i + 2 < sequence.size(); ++i) {
    if (is(sequence[i + 2], 2)) {
      sequence[i].angle = sequence[i].angle + sequence[i + 2].angle;
      sequence[i + 1].angle = negative(sequence[i + 1].angle);
      sequence.erase(sequence.begin() + static_cast<std::ptrdiff_t>(i) + 2);
      return true;
    }
    if (is(sequence[i], 2)) {
      sequence[i + 2].angle = sequence[i + 2].angle + sequence[i].angle;
      sequence[i + 1].angle = negative(sequence[i + 1].angle);
      sequence.erase(sequence.begin() + static_cast<std::ptrdiff_t>(i));
      return true;
    }
    if (is(sequence[i + 1], 2)) {
      sequence[i + 2].angle = sequence[i + 2].angle + negative(sequence[i].angle);
      sequence.erase(sequence.begin() + static_cast<std::ptrdiff_t>(i));
      return true;
    }
  }
  return false;
}

/// x(+-pi/2) z(gamma) x(-+pi/2) is a rotation by gamma about -+y, z(pi/2) x(..) z(-pi/2); with equal signs a
/// half turn about x remains.
bool turn_between_quarters(RotationSequence& sequence) {
  for (std::size_t i = 0; i + 2 < sequence.size(); ++i) {
    const auto first = quarters(sequence[i].angle);
    const auto last = quarters(sequence[i + 2].angle);
    if (sequence[i].axis != 0 || !first || !last || *first % 2 == 0 || *last % 2 == 0) continue;
    const Angle gamma = sequence[i + 1].angle;
    // x(pi/2) z(g) x(-pi/2) turns about x(pi/2) z = -y by g.
    RotationSequence about_y = {turn(2, 1), {0, *first == 1 ? negative(gamma) : gamma}, turn(2, -1)};
    if (*first == *last) about_y.push_back(turn(0, 2));
    sequence.erase(sequence.begin() + static_cast<std::ptrdiff_t>(i),
                   sequence.begin() + static_cast<std::ptrdiff_t>(i) + 3);
    sequence.insert(sequence.begin() + static_cast<std::ptrdiff_t>(i), about_y.begin(), about_y.end());
    return true;
  }
  return false;
}

}  // namespace

RotationSequence from_z_to(const model::Vector3& axis) {
  const auto known = signed_axis(axis);
  if (!known) return from_z_to_oblique(axis);
  const auto [index, sign] = *known;
  if (index == 0) return {turn(2, sign), turn(0, 1)};
  if (index == 1) return {turn(0, -sign)};
  return sign > 0 ? RotationSequence{} : RotationSequence{turn(0, 2)};
}

RotationSequence to_sequence(const std::vector<model::Turn>& turns) {
  RotationSequence sequence;
  for (const model::Turn& t : turns) {
    const RotationSequence frame = from_z_to(t.axis);
    sequence = sequence * frame * RotationSequence{{2, to_angle(t.angle)}} * inverse(frame);
  }
  return sequence;
}

RotationSequence inverse(const RotationSequence& sequence) {
  RotationSequence result(sequence.rbegin(), sequence.rend());
  for (ElementaryRotation& t : result) t.angle = negative(t.angle);
  return result;
}

RotationSequence operator*(RotationSequence a, const RotationSequence& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

RotationSequence reduced(RotationSequence sequence) {
  while (drop_identity(sequence) || merge_neighbours(sequence) || pass_half_turn(sequence) ||
         turn_between_quarters(sequence)) {
  }
  return sequence;
}

RotationSequence recomposed(const RotationSequence& sequence) {
  const bool begins_with_x = !sequence.empty() && sequence.front().axis == 0;
  if (sequence.size() < (begins_with_x ? 3U : 4U))
    return sequence;  // the axes alternate: it is z x z or less
  Matrix m{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const ElementaryRotation& t : sequence) {
    const auto known = exact::value_of(t.angle);
    if (!known) return sequence;
    turn_columns(m, t.axis, *known);
  }
  const Number square = Number(1) - m[2][2] * m[2][2];
  if (!square.is_rational()) return sequence;
  if (square.is_zero()) return {{2, angle_of(m[0][0], m[1][0])}, {0, angle_of(m[2][2], 0)}};
  const Number sine = Number::root(square.rational());
  return {{2, angle_of(-m[1][2] / sine, m[0][2] / sine)},
          {0, angle_of(m[2][2], sine)},
          {2, angle_of(m[2][1] / sine, m[2][0] / sine)}};
}

exact::Angle to_angle(const model::Expression& expression) {
  const auto& operands = expression.operands();
  const auto refuse = [&]() -> Angle {
    throw std::domain_error("dynamics: angle " + to_string(expression) + " is not linear");
  };
  const auto number = [](const model::Expression& e) -> std::optional<cln::cl_RA> {
    if (e.kind() == Kind::number) return e.number();
    if (e.kind() == Kind::negate && e.operands()[0].kind() == Kind::number) return -e.operands()[0].number();
    return std::nullopt;
  };
  switch (expression.kind()) {
    case Kind::number:
      return cln::zerop(expression.number()) ? Angle{} : refuse();
    case Kind::pi:
      return {{}, 1};
    case Kind::symbol:
      return {{{expression.name(), 1}}, 0};
    case Kind::negate:
      return negative(to_angle(operands[0]));
    case Kind::sum: {
      Angle sum;
      for (const auto& operand : operands) sum = sum + to_angle(operand);
      return sum;
    }
    case Kind::product: {
      if (operands.size() != 2) return refuse();
      if (const auto factor = number(operands[0])) return *factor * to_angle(operands[1]);
      if (const auto factor = number(operands[1])) return *factor * to_angle(operands[0]);
      return refuse();
    }
    case Kind::quotient: {
      const auto divisor = number(operands[1]);
      return divisor ? (1 / *divisor) * to_angle(operands[0]) : refuse();
    }
    default:
      return refuse();
  }
}

}  // namespace qvgen::derive::dynamics
