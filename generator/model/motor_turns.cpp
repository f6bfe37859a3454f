// SPDX-License-Identifier: MIT
#include "model/motor_turns.h"

#include <algorithm>

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

}  // namespace

std::vector<MotorTurn> motor_turns(const Robot& robot, const std::vector<Row>& inverse) {
  std::vector<Row> rows;
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    if (robot.joints[joint].type != JointType::revolute) continue;
    rows.emplace_back();
    for (const Row& motor : inverse) rows.back().push_back(motor[joint]);
  }
  std::vector<MotorTurn> basis;
  for (std::size_t motor = 0; motor < inverse.size(); ++motor) {
    const std::size_t first = basis.size();
    if (!eliminate(rows, first, motor)) continue;
    for (MotorTurn& earlier : basis) reduce(earlier.motion, rows[first], motor);
    basis.push_back({motor, rows[first]});
  }
  return basis;
}

}  // namespace qvgen::model
