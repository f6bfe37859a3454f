// SPDX-License-Identifier: MIT
// Sets of solutions in C as the C++ library's type.
#pragma once

#include <type_traits>

#include <qvgen/inverse/solutions.h>

#include "fixed_sizes.h"

namespace qvgen::test {

template <class Set>
constexpr int capacity_of = static_cast<int>(std::extent_v<decltype(Set::rows)>);
template <class Set>
constexpr int dof_of = static_cast<int>(std::extent_v<decltype(Set::rows[0].q)>);

template <class Set>
Solutions<dof_of<Set>, capacity_of<Set>> in_cxx(const Set& set) {
  Solutions<dof_of<Set>, capacity_of<Set>> found;
  for (int k = 0; k < set.count; ++k) {
    Solution<dof_of<Set>>& row = found.append();
    std::copy_n(set.rows[k].q, dof_of<Set>, row.q.data());
    row.branch = set.rows[k].branch;
    row.continuum = set.rows[k].continuum != 0;
  }
  found.status = static_cast<Status>(set.status);
  found.effort = {set.effort.passes, set.effort.steps, set.effort.used_up != 0};
  return found;
}

}  // namespace qvgen::test
