// SPDX-License-Identifier: MIT
// Loops over rows for the functions of a robot's closed loops, which are in C++ only: rows of driven joints
// in, assemblies padded to equal size out. _loop_rows.py prints what calls these templates.
#pragma once

#include <type_traits>

#include <qvgen/assembly.h>

#include "rows_cxx.h"

namespace qvgen::python {

// One value of a result behind the other, a matrix by rows. They return the place behind the value.
inline double* put_value(double value, double* to) {
  *to = value;
  return to + 1;
}
inline double* put_value(const Pose<double>& pose, double* to) {
  const auto& r = pose.orientation;
  const auto& p = pose.position;
  const double numbers[7] = {r.w(), r.x(), r.y(), r.z(), p.x(), p.y(), p.z()};
  return std::copy(numbers, numbers + 7, to);
}
template <class Matrix>
double* put_value(const Eigen::MatrixBase<Matrix>& matrix, double* to) {
  for (int i = 0; i < matrix.rows(); ++i)
    for (int j = 0; j < matrix.cols(); ++j) *to++ = matrix(i, j);
  return to;
}

/// Writes the value `function(k)` of every row.
template <class Function>
std::ptrdiff_t value_rows(const qvgen_call* c, const Function& function) {
  auto* to = result<double>(c, 0, 0);
  for (std::ptrdiff_t k = 0; k < c->count; ++k) to = put_value(function(k), to);
  return 0;
}

/// Finds the assemblies of every row by `assemble(k, [seed])`. For a capacity below zero it finds none and
/// returns how many there are at most.
template <int dof, class Assemble>
std::ptrdiff_t assembly_rows(const qvgen_call* c, const Assemble& assemble) {
  if (c->capacity < 0) return std::decay_t<decltype(assemble(0))>::max_size;
  for (std::ptrdiff_t k = 0; k < c->count; ++k) {
    const auto found =
        c->flags[0] != 0 ? assemble(k, Joints<dof>(vector<Joints<dof>>(row<double>(c, 1, k)))) : assemble(k);
    put<dof>(c, k, found);
    for (int i = 0; i < found.size(); ++i)
      *result<unsigned char>(c, 5, k * c->capacity + i) = found.meets(found[i]) ? 1 : 0;
  }
  return 0;
}

/// Follows every row from a seed, by `follow(k, seed)`; on a path from the row before, as long as the loops
/// close.
template <int dof, class Follow>
std::ptrdiff_t followed_rows(const qvgen_call* c, const Follow& follow) {
  const bool path = c->flags[1] != 0;
  Joints<dof> before = Joints<dof>::Zero();
  for (std::ptrdiff_t k = 0; k < c->count; ++k) {
    if (!path || k == 0) before = vector<Joints<dof>>(row<double>(c, 1, k));
    const auto found = follow(k, before);
    *result<unsigned char>(c, 1, k) = found.closed ? 1 : 0;
    if (!found.closed) continue;
    before = found.q;
    std::copy(before.data(), before.data() + dof, result<double>(c, 0, k, dof));
  }
  return 0;
}

}  // namespace qvgen::python
