// SPDX-License-Identifier: MIT
// Every displacement is Rz(first) Tz(d) Tx(a) Rx(middle) Rz(last) Tz(s), with x along the common normal of
// the two z axes. Turns about and shifts along a joint's axis commute with its motion, so that the last two
// of one passage join the first two of the next: the chain becomes Z X Z(q1) X Z(q2) X ... Z. The two
// conventions cut this sequence at different places.
#include "canonical/dh_table.h"

#include <cln/float.h>

#include "canonical/passages.h"
#include "canonical/pi.h"
#include "exact/named_constant.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::canonical {
namespace {

using cln::cl_R;
using model::Displacement;
using model::Expression;

/// Rz(turn) Tz(shift), moved by a joint or not.
struct AlongZ {
  cl_R turn = 0;
  Length shift;
  std::optional<std::size_t> joint = {};
};

/// Tx(shift) Rx(turn).
struct AlongX {
  Length shift;
  cl_R turn = 0;
};

struct Sequence {
  std::vector<AlongZ> z{AlongZ{}};  ///< one more than x
  std::vector<AlongX> x;
};

/// Appends passages and joints to a sequence.
class Builder {
 public:
  /// `is_tool`: behind the last joint, whose angle then takes a turn that would be left over.
  void pass(const Placement& way, bool is_tool) {
    Euler angles = euler(way.rotation);
    const auto along = heading(way.translation);
    const bool is_free = angles.is_parallel && !along;
    if (angles.is_parallel) {
      const cl_R side = is_zero(angles.middle) ? 1 : -1;
      const cl_R first = along ? *along : is_tool ? cl_R(side * angles.last) : cl_R(-last().turn);
      angles.last = angles.last + -side * first;
      angles.first = first;
    }
    // The normal may point either way: the one with the smaller offset of the joint's angle is taken.
    const cl_R offset = wrapped(last().turn + angles.first);
    if (!(is_free && is_tool) && (cln::abs(offset) > pi() / 2 || offset == -pi() / 2)) {
      angles = {angles.first + pi(), -angles.middle, angles.last + pi(), angles.is_parallel};
    }
    const LengthVector offsets = about_z(-angles.first) * way.translation;
    if (angles.is_parallel)
      pass_parallel(angles, offsets);
    else
      pass_skew(angles, offsets);
  }

  void move(std::size_t joint) { last().joint = joint; }

  [[nodiscard]] const Sequence& sequence() const { return sequence_; }

 private:
  AlongZ& last() { return sequence_.z.back(); }

  /// Nothing between two parts along one axis makes them one, before the first joint.
  void add(const AlongX& normal, const AlongZ& next) {
    if (!last().joint && normal.shift.empty() && is_zero(normal.turn)) {
      turn_last(next.turn, next.shift);
      return;
    }
    sequence_.x.push_back(normal);
    sequence_.z.push_back(next);
  }

  /// The foot on the next axis is where the rest of the translation has no part across the normal:
  /// z' = (0, -sin, cos).
  void pass_skew(const Euler& angles, const LengthVector& offset) {
    const cl_R sine = cln::sin(angles.middle), cosine = cln::cos(angles.middle);
    const Length along_next = cl_R(-1) / sine * offset[1];
    turn_last(angles.first, offset[2] + (-cosine) * along_next);
    add({offset[0], angles.middle}, {angles.last, along_next});
  }

  /// Two rows where the direction of the normal is not known, as with symbols for both of its components.
  void pass_parallel(const Euler& angles, const LengthVector& offset) {
    turn_last(angles.first, offset[2]);
    if (offset[1].empty()) {
      add({offset[0], angles.middle}, {angles.last, {}});
      return;
    }
    add({offset[0], 0}, {pi() / 2, {}});
    // Rz(-pi/2) Rx(0 or pi) = Rx(0 or pi) Rz(-pi/2 or pi/2)
    const cl_R back = is_zero(angles.middle) ? cl_R(-pi() / 2) : cl_R(pi() / 2);
    add({offset[1], angles.middle}, {angles.last + back, {}});
  }

  void turn_last(const cl_R& angle, const Length& shift) {
    last().turn = last().turn + angle;
    last().shift = last().shift + shift;
  }

  static bool is_zero(const cl_R& angle) { return cln::zerop(wrapped(angle)); }

  Sequence sequence_;
};

Expression decimal(const cl_R& value) {
  return Expression(cln::rational(cln::cl_float(value, cln::float_format(25))));
}

/// In parts of pi where it is a rational part of it, else rational radians.
Expression angle_of(const cl_R& radians) {
  const cl_R angle = wrapped(radians);
  if (cln::zerop(angle)) return Expression();
  if (const auto part = exact::rational_near(angle / pi()))
    return model::multiply(Expression(*part), Expression::pi());
  if (const auto value = exact::rational_near(angle)) return Expression(*value);
  return decimal(angle);
}

/// Expressions in the description's symbols alone.
class Values {
 public:
  explicit Values(const Definitions& definitions) : definitions_(definitions) {}

  [[nodiscard]] Expression operator()(const Length& length) const {
    Expression sum;
    for (const auto& [factors, coefficient] : length) {
      const cl_R size = cln::abs(coefficient);
      const auto exact = exact::rational_near(size);
      Expression term = exact ? Expression(*exact) : decimal(size);
      for (const std::string& factor : factors) {
        const auto definition = definitions_.find(factor);
        term = model::multiply(
            term, definition == definitions_.end() ? Expression::symbol(factor) : definition->second);
      }
      sum = cln::minusp(coefficient) ? model::subtract(sum, term) : model::add(sum, term);
    }
    return sum;
  }

  void append(const AlongZ& z, Displacement& to) const {
    to = model::compose(to, {turns(2, angle_of(z.turn)), {Expression(), Expression(), (*this)(z.shift)}});
  }
  void append(const AlongX& x, Displacement& to) const {
    to = model::compose(to, {turns(0, angle_of(x.turn)), {(*this)(x.shift), Expression(), Expression()}});
  }

  [[nodiscard]] model::DhRow row(const AlongZ& z, const AlongX& x) const {
    return {z.joint, angle_of(z.turn), (*this)(z.shift), (*this)(x.shift), angle_of(x.turn)};
  }

 private:
  static std::vector<model::Turn> turns(std::size_t axis, const Expression& angle) {
    if (angle.is_literal_zero()) return {};
    return {{model::unit_vector(axis), angle}};
  }

  const Definitions& definitions_;
};

/// Moving parts and fixed ones between them; fixed ones before the first and behind the last joint are
/// frames.
model::DhTable cut(const Sequence& s, model::DhConvention convention, const Values& values) {
  model::DhTable table;
  table.convention = convention;
  const bool standard = convention == model::DhConvention::standard;
  std::size_t first = 0, last = s.z.size() - 1;
  while (!s.z[first].joint) ++first;
  while (!s.z[last].joint) --last;
  for (std::size_t i = 0; i < first; ++i) {
    values.append(s.z[i], table.base);
    if (standard || i + 1 < first) values.append(s.x[i], table.base);
  }
  for (std::size_t i = first; i <= last; ++i)
    table.rows.push_back(values.row(s.z[i], standard ? s.x[i] : i == 0 ? AlongX{} : s.x[i - 1]));
  if (!standard) values.append(s.x[last], table.tool);
  for (std::size_t i = last + 1; i < s.z.size(); ++i) {
    values.append(s.z[i], table.tool);
    if (i + 1 < s.z.size()) values.append(s.x[i], table.tool);
  }
  return table;
}

}  // namespace

std::optional<model::DhTable> dh_table(const model::Robot& robot, model::DhConvention convention) {
  if (robot.joints.empty() || has_symbolic_turns(robot)) return std::nullopt;
  Definitions definitions;
  const std::vector<Placement> ways = passages(robot, definitions);
  Builder builder;
  builder.pass(ways.front(), false);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    builder.move(i);
    builder.pass(ways[i + 1], i + 1 == robot.joints.size());
  }
  return cut(builder.sequence(), convention, Values(definitions));
}

}  // namespace qvgen::canonical
