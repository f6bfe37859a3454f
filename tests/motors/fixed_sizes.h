// SPDX-License-Identifier: MIT
// Copies between vectors of any length and the fixed sizes of compiled arms: plain loops, of which little is
// instantiated.
#pragma once

#include <algorithm>

#include <qvgen/inverse/joint_limits.h>

#include "arms.h"

namespace qvgen::test {

template <int dof>
Joints<dof> fixed(const VectorXd& values) {
  Joints<dof> copy;
  std::copy_n(values.data(), dof, copy.data());
  return copy;
}

template <int dof>
JointLimits<dof> fixed(const Bounds& limits) {
  return {fixed<dof>(limits.lower), fixed<dof>(limits.upper)};
}

template <int dof>
void append(Rows& rows, const Solution<dof>& row) {
  rows.append(row.q.data(), dof, row.branch, row.continuum);
}

/// Rows of a set, but for those that would be too many.
template <class Found>
void append_all(Rows& rows, const Found& found) {
  for (const auto& row : found) {
    if (rows.rows.size() == Rows::most_kept) break;
    append(rows, row);
  }
}

/// A set that has one row a solution.
template <class Found>
Rows rows_of(const Found& found) {
  Rows rows;
  rows.status = found.status;
  append_all(rows, found);
  rows.size = rows.branches = rows.rows.size();
  return rows;
}

/// A set of all representatives.
template <class Found>
Rows representatives_of(const Found& found) {
  Rows rows;
  rows.status = found.status;
  rows.branches = static_cast<std::size_t>(found.branches());
  rows.size = found.size();
  append_all(rows, found);
  return rows;
}

}  // namespace qvgen::test
