// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <qvgen/assembly.h>

#include "binding_inverse.h"

/// Closed loops for Python: rows of driven joints in, assemblies padded to equal size out. Always in double.
namespace qvgen::python {

/// Makes qvgen.Assemblies of every row. `function(rows)` returns the assemblies of a row.
template <int dof, class Function>
py::object each_assembly(const std::vector<Rows<double>>& arguments, const Function& function) {
  using Found = decltype(function(std::declval<const double* const*>()));
  auto meets = result_array<bool>(py::none(), batch_of(arguments), {Found::max_size});
  bool* mark = meets.mutable_data();
  std::fill(mark, mark + meets.size(), false);
  const py::object solutions = each_solution<dof>(arguments, [&](const double* const* rows) {
    const Found found = function(rows);
    for (int i = 0; i < found.size(); ++i) mark[i] = found.meets(found[i]);
    mark += Found::max_size;
    return found;
  });
  return py::module_::import("qvgen").attr("Assemblies")(*solutions, meets);
}

/// Makes qvgen.Followed of every row: of the arguments' first, the driven joints, next to the second, a seed.
/// On a path the seed of a row is the row before it, as long as the loops close.
template <int dof, class Function>
py::object each_followed(const std::vector<Rows<double>>& arguments, bool path, const Function& function) {
  if (path && arguments[1].count() >= 0)
    throw py::value_error("on a path there is one seed, that of the first row");
  const py::ssize_t batch = batch_of(arguments);
  auto joints = result_array<double>(py::none(), batch, {dof});
  auto closed = result_array<bool>(py::none(), batch, {});
  double* q = joints.mutable_data();
  bool* is_closed = closed.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    Joints<dof> before = vector<Joints<dof>>(arguments[1][0]);
    for_each_row(arguments, batch, [&](py::ssize_t i, const double* const* row) {
      const auto found = function(row[0], path ? before : vector<Joints<dof>>(row[1]));
      is_closed[i] = found.closed;
      if (found.closed) before = found.q;
      const double none = std::numeric_limits<double>::quiet_NaN();
      write(found.closed ? found.q : Joints<dof>(Joints<dof>::Constant(none)), q + i * dof);
    });
  }
  return py::module_::import("qvgen").attr("Followed")(joints, closed);
}

}  // namespace qvgen::python
