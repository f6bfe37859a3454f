// SPDX-License-Identifier: MIT
#include "model/motor_turns.h"

#include <algorithm>
#include <numeric>

#include <cln/integer.h>

namespace qvgen::model {
namespace {

using cln::cl_I;
using cln::cl_RA;
using Row = std::vector<cl_RA>;

/// row - n other with the whole n that leaves the least at a place.
void reduce(Row& row, const Row& other, std::size_t place) {
  const cl_I times = cln::round1(row[place] / other[place]);
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = row[i] - times * other[i];
}

/// Leaves one row of those from `first` on that is not zero at a place, and puts it first. Returns false if
/// all are zero there. Euclid's algorithm: each round at least halves the smallest entry or ends.
bool eliminate(std::vector<Row>& rows, std::size_t first, std::size_t place) {
  const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(first);
  const auto is_smaller = [&](const Row& a, const Row& b) {
    if (cln::zerop(a[place]) || cln::zerop(b[place])) return !cln::zerop(a[place]);
    return cln::abs(a[place]) < cln::abs(b[place]);
  };
  while (begin != rows.end()) {
    std::iter_swap(begin, std::min_element(begin, rows.end(), is_smaller));
    if (cln::zerop((*begin)[place])) return false;
    for (auto row = begin + 1; row != rows.end(); ++row) reduce(*row, *begin, place);
    if (std::all_of(begin + 1, rows.end(), [&](const Row& row) { return cln::zerop(row[place]); })) break;
  }
  if (begin == rows.end()) return false;
  if (cln::minusp((*begin)[place]))
    for (cl_RA& entry : *begin) entry = -entry;
  return true;
}

std::vector<LimitedValue> limited_values(const Robot& robot, std::size_t motors) {
  std::vector<LimitedValue> values;
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    if (!robot.joints[i].follows.empty() && robot.joints[i].limits) values.push_back({false, i});
  for (std::size_t i = 0; i < motors; ++i) values.push_back({true, i});
  return values;
}

/// One turn of a joint, by all values.
Row turn_of(std::size_t joint, const std::vector<LimitedValue>& values, const std::vector<Row>& inverse) {
  Row row;
  for (const LimitedValue& value : values)
    row.push_back(value.is_motor ? inverse[value.index][joint] : cl_RA(value.index == joint ? 1 : 0));
  return row;
}

std::vector<Row> turns_of_joints(const Robot& robot, const std::vector<LimitedValue>& values,
                                 const std::vector<Row>& inverse) {
  std::vector<Row> rows;
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint)
    if (robot.joints[joint].type == JointType::revolute) rows.push_back(turn_of(joint, values, inverse));
  return rows;
}

std::vector<MotorTurn> echelon(std::vector<Row> rows, std::size_t size) {
  std::vector<MotorTurn> basis;
  for (std::size_t place = 0; place < size; ++place) {
    const std::size_t first = basis.size();
    if (!eliminate(rows, first, place)) continue;
    for (MotorTurn& earlier : basis) reduce(earlier.motion, rows[first], place);
    basis.push_back({place, false, rows[first]});
  }
  return basis;
}

/// For each value the first one of its block; `size` for those that never move.
std::vector<std::size_t> blocks_of(const std::vector<MotorTurn>& basis, std::size_t size) {
  std::vector<std::size_t> block(size, size);
  const auto moves = [](const MotorTurn& turn, std::size_t i) { return !cln::zerop(turn.motion[i]); };
  for (const MotorTurn& turn : basis)
    for (std::size_t i = 0; i < size; ++i)
      if (moves(turn, i)) block[i] = i;
  for (std::size_t round = 0; round < basis.size(); ++round)
    for (const MotorTurn& turn : basis) {
      std::size_t least = size;
      for (std::size_t i = 0; i < size; ++i)
        if (moves(turn, i)) least = std::min(least, block[i]);
      for (std::size_t i = 0; i < size; ++i)
        if (moves(turn, i)) block[i] = least;
    }
  return block;
}

/// The order of values in which those of a block are neighbours; those that never move come first.
std::vector<std::size_t> order_by(const std::vector<std::size_t>& block) {
  std::vector<std::size_t> order(block.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return block[i] == block.size() ? 0 : block[i] + 1; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

template <class Entry>
std::vector<Entry> ordered(const std::vector<Entry>& entries, const std::vector<std::size_t>& order) {
  std::vector<Entry> result;
  for (const std::size_t i : order) result.push_back(entries[i]);
  return result;
}

}  // namespace

MotorTurns motor_turns(const Robot& robot, const std::vector<Row>& inverse) {
  const std::vector<LimitedValue> values = limited_values(robot, inverse.size());
  const std::vector<MotorTurn> basis = echelon(turns_of_joints(robot, values, inverse), values.size());
  const std::vector<std::size_t> block = blocks_of(basis, values.size()), order = order_by(block);
  MotorTurns result{ordered(values, order), {}};
  for (std::size_t place = 0; place < order.size(); ++place)
    for (const MotorTurn& turn : basis) {
      if (turn.pivot != order[place]) continue;
      if (!result.turns.empty())
        result.turns.back().ends_block = block[order[result.turns.back().pivot]] != block[turn.pivot];
      result.turns.push_back({place, true, ordered(turn.motion, order)});
    }
  return result;
}

}  // namespace qvgen::model
