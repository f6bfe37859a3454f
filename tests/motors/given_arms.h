// SPDX-License-Identifier: MIT
// Random arms with joints given anywhere: write_given_arms.cpp writes them down and registers their
// functions, in C where it has them.
#pragma once

#include <array>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "asked_part.h"
#include "fixed_sizes.h"

namespace qvgen::test {

/// The functions of an arm. `at` are joints whose values those that are given have.
struct GivenArm {
  using Call = std::function<Rows(const Part& part, const VectorXd& at, const Asked& asked)>;
  std::string name;
  std::string description;  ///< a path
  Task task;
  std::vector<int> given;
  int dof;
  Eigen::Vector3d tool_axis;
  Call solve;
  Call near;  ///< next to a seed
};

inline void PrintTo(const GivenArm& arm, std::ostream* stream) { *stream << arm.name; }

std::vector<GivenArm>& given_arms();
std::size_t written_given_arms();  ///< with those that are refused
inline bool add_given_arm(GivenArm arm) {
  given_arms().push_back(std::move(arm));
  return true;
}

inline std::array<double, 4> wxyz(const Part& part) {
  const Eigen::Quaterniond& q = part.orientation;
  return {q.w(), q.x(), q.y(), q.z()};
}
inline const double* values_of(const VectorXd* values) {
  return values == nullptr ? nullptr : values->data();
}

/// The rows that a function in C has left in its set.
template <class Set, class Call>
Rows rows_in_c(const Call& call) {
  Set set;
  call(&set);
  Rows rows;
  rows.status = static_cast<Status>(set.status);
  for (int i = 0; i < set.count; ++i) {
    const auto& row = set.rows[i];
    rows.append(row.q, static_cast<int>(std::size(row.q)), row.branch, row.continuum != 0);
  }
  rows.size = rows.branches = rows.rows.size();
  return rows;
}

}  // namespace qvgen::test
