// SPDX-License-Identifier: MIT
#include "derive/kinematics/orientation.h"

#include <algorithm>

#include "derive/kinematics/turns.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

/// A cut of the turns into factors: the number of turns in each, one or three (an Euler triple).
using Partition = std::vector<std::size_t>;

std::vector<Partition> partitions(const std::vector<Turn>& turns, std::size_t from) {
  if (from >= turns.size()) return {{}};
  std::vector<Partition> result;
  for (const std::size_t length : {std::size_t{3}, std::size_t{1}}) {
    if (length == 3 && !is_euler_triple(turns, from)) continue;
    for (Partition& rest : partitions(turns, from + length)) {
      rest.insert(rest.begin(), length);
      result.push_back(std::move(rest));
    }
  }
  return result;
}

std::vector<Quaternion> factors(const TurnSequence& sequence, const Partition& partition) {
  std::vector<Quaternion> result;
  std::size_t at = 0;
  for (const std::size_t length : partition) {
    const auto& turns = sequence.turns;
    result.push_back(length == 3 ? euler_triple(turns[at], turns[at + 1], turns[at + 2])
                                 : rotation(turns[at].axis, turns[at].angle));
    at += length;
  }
  result.push_back(sequence.home);
  return result;
}

Quaternion multiply(Program& program, const std::vector<Quaternion>& all, bool from_left) {
  std::vector<Quaternion> named;
  for (const Quaternion& q : all) named.push_back(program.let(q));
  Quaternion product = from_left ? named.front() : named.back();
  for (std::size_t i = 1; i < named.size(); ++i)
    product = program.let(from_left ? product * named[i] : named[named.size() - 1 - i] * product);
  return product;
}

std::string name_of(const Partition& partition) {
  std::string name = "orientation ";
  for (const std::size_t length : partition) name += length == 3 ? "3" : "1";
  return name;
}

/// Each direction that some turn has, once.
std::vector<Vector> directions(const std::vector<Turn>& turns) {
  std::vector<Vector> result;
  for (const Turn& turn : turns) {
    const auto same = [&](const Vector& known) { return parallel(known, turn.axis) != 0; };
    if (std::none_of(result.begin(), result.end(), same)) result.push_back(turn.axis);
  }
  return result;
}

/// More perpendicular turns than this give more terms than other forms have.
constexpr std::size_t most_perpendicular_turns = 3;

std::vector<OrientationForm> angle_sum_forms(const TurnSequence& sequence) {
  std::vector<OrientationForm> forms;
  for (const Vector& axis : directions(sequence.turns)) {
    const auto product = angle_sum_product(sequence.turns, axis, most_perpendicular_turns);
    if (!product) continue;
    const Quaternion home = sequence.home;
    forms.push_back({"angle sums about direction " + std::to_string(forms.size() + 1),
                     [=](Program& program) { return program.let(program.let(*product) * home); }});
  }
  return forms;
}

Matrix3 column_turned(const Turn& turn, const Matrix3& m) {
  Matrix3 result;
  for (int j = 0; j < 3; ++j) {
    const Vector v = turned(turn, {m[0][j], m[1][j], m[2][j]});
    result[0][j] = v.x;
    result[1][j] = v.y;
    result[2][j] = v.z;
  }
  return result;
}

/// m R = (R^T m^T)^T: the rows turn by the opposite angle.
Matrix3 row_turned(const Matrix3& m, const Turn& turn) {
  return transpose(column_turned({turn.axis, -turn.angle}, transpose(m)));
}

using Turns = std::vector<Turn>;

Matrix3 from_left(Program& program, const Turns& turns, Matrix3 m) {
  for (const Turn& turn : turns) m = program.let(row_turned(m, turn));
  return m;
}

Matrix3 from_right(Program& program, const Turns& turns, Matrix3 m) {
  for (std::size_t i = turns.size(); i-- > 0;) m = program.let(column_turned(turns[i], m));
  return m;
}

/// The turns before the split from the left, the others from the right, then one product of matrices.
Matrix3 split_product(Program& program, const TurnSequence& sequence, std::size_t split) {
  const Turns left(sequence.turns.begin(), sequence.turns.begin() + static_cast<std::ptrdiff_t>(split));
  const Turns right(sequence.turns.begin() + static_cast<std::ptrdiff_t>(split), sequence.turns.end());
  const Matrix3 identity = to_matrix(Quaternion{});
  const Matrix3 home = to_matrix(sequence.home);
  if (left.empty()) return from_right(program, right, home);
  const Matrix3 arm = from_left(program, left, identity);
  if (right.empty()) return program.let(arm * home);
  return program.let(arm * from_right(program, right, home));
}

Matrix3 with_cross_column(Program& program, Matrix3 m, int column) {
  const auto at = [&](int j) { return Vector{m[0][j], m[1][j], m[2][j]}; };
  const Vector v = program.let(cross(at((column + 1) % 3), at((column + 2) % 3)));
  m[0][column] = v.x;
  m[1][column] = v.y;
  m[2][column] = v.z;
  return m;
}

}  // namespace

std::vector<OrientationForm> orientation_forms(const ZeroReferenceChain& chain) {
  const TurnSequence sequence = turn_sequence(chain);
  std::vector<OrientationForm> forms;
  for (const Partition& partition : partitions(sequence.turns, 0)) {
    const std::vector<Quaternion> all = factors(sequence, partition);
    for (const bool from_left : {true, false}) {
      if (!from_left && all.size() <= 2) continue;
      forms.push_back({name_of(partition) + (from_left ? " from the left" : " from the right"),
                       [=](Program& program) { return multiply(program, all, from_left); }});
    }
  }
  for (OrientationForm& form : angle_sum_forms(sequence)) forms.push_back(std::move(form));
  return forms;
}

std::vector<MatrixForm> matrix_forms(const ZeroReferenceChain& chain) {
  const TurnSequence sequence = turn_sequence(chain);
  std::vector<MatrixForm> forms;
  for (std::size_t split = 0; split <= sequence.turns.size(); ++split) {
    const std::string name = "matrix split at " + std::to_string(split);
    forms.push_back({name, [=](Program& program) { return split_product(program, sequence, split); }});
    if (sequence.turns.size() < 2) continue;
    for (int column = 0; column < 3; ++column)
      forms.push_back({name + ", cross column " + std::to_string(column + 1), [=](Program& program) {
                         return with_cross_column(program, split_product(program, sequence, split), column);
                       }});
  }
  return forms;
}

Quaternion written_out_orientation(const ZeroReferenceChain& chain) {
  const TurnSequence sequence = turn_sequence(chain);
  Quaternion product;
  for (const Quaternion& factor : factors(sequence, partitions(sequence.turns, 0).front()))
    product = product * factor;
  return {product.w.expand(), product.x.expand(), product.y.expand(), product.z.expand()};
}

}  // namespace qvgen::derive
