// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <qvgen/inverse_velocity_within.h>

#include "binding.h"

/// Joint rates for Python: rows of joints and twists in, qvgen.JointRates out.
namespace qvgen::python {

template <class Scalar>
InverseVelocityOptions<Scalar> velocity_options(double threshold, double damping, double scale) {
  return {static_cast<Scalar>(threshold), static_cast<Scalar>(damping), static_cast<Scalar>(scale)};
}

/// "description": the greatest velocities; else a pair of rows.
template <class Scalar, int dof, class Greatest>
RateLimits<Scalar, dof> rate_limits_of(const py::object& given, const Greatest& greatest) {
  using Rates = Eigen::Matrix<Scalar, dof, 1>;
  if (py::isinstance<py::str>(given) && given.cast<std::string>() == "description") {
    const Rates rates =
        Eigen::Map<const Eigen::Matrix<double, dof, 1>>(greatest.data()).template cast<Scalar>();
    return RateLimits<Scalar, dof>::symmetric(rates);
  }
  if (!py::isinstance<py::sequence>(given) || py::isinstance<py::str>(given) || py::len(given) != 2)
    throw py::value_error("limits: neither \"description\", nor a pair (lower, upper)");
  const auto row = [&](int which, const char* name) -> Rates {
    const Rows<Scalar> rows(given[py::int_(which)], {dof}, name);
    if (rows.count() >= 0) throw py::value_error(std::string(name) + " are the same for all rows: one row");
    return vector<Rates>(rows[0]);
  };
  return {row(0, "lower limits"), row(1, "upper limits")};
}

template <class Scalar, int dof>
Scalar factor_of(const ScaledVelocity<Scalar, dof>& rates) {
  return rates.factor;
}
template <class Rates>
auto factor_of(const Rates& rates) {
  using Scalar = std::decay_t<decltype(rates.residual)>;
  return rates.status == VelocityStatus::invalid_input ? Scalar(0) : Scalar(1);
}
template <class Scalar, int dof>
bool is_limited(const VelocityWithin<Scalar, dof>& rates) {
  return rates.limited;
}
template <class Rates>
bool is_limited(const Rates& rates) {
  return rates.status != VelocityStatus::invalid_input && factor_of(rates) < 1;
}

/// solve(q, twist) for every row.
template <int dof, class Scalar, class Solve>
py::object rates_of(const py::object& q, const py::object& twist, const Solve& solve) {
  const std::vector<Rows<Scalar>> arguments{Rows<Scalar>(q, {dof}, "q"), Rows<Scalar>(twist, {6}, "twist")};
  const py::ssize_t batch = batch_of(arguments);
  const py::object none = py::none();
  auto rates = result_array<Scalar>(none, batch, {dof});
  auto residuals = result_array<Scalar>(none, batch, {});
  auto factors = result_array<Scalar>(none, batch, {});
  auto status = result_array<int>(none, batch, {});
  auto limited = result_array<bool>(none, batch, {});
  Scalar *qd = rates.mutable_data(), *residual = residuals.mutable_data(), *factor = factors.mutable_data();
  int* outcome = status.mutable_data();
  bool* is_in_the_way = limited.mutable_data();
  {
    const py::gil_scoped_release unlocked;
    for_each_row(arguments, batch, [&](py::ssize_t i, const Scalar* const* row) {
      const auto found =
          solve(vector<Eigen::Matrix<Scalar, dof, 1>>(row[0]), vector<Eigen::Matrix<Scalar, 6, 1>>(row[1]));
      write(found.qd, qd + i * dof);
      residual[i] = found.residual;
      factor[i] = factor_of(found);
      outcome[i] = static_cast<int>(found.status);
      is_in_the_way[i] = is_limited(found);
    });
  }
  return py::module_::import("qvgen").attr("JointRates")(rates, status, residuals, factors, limited);
}

}  // namespace qvgen::python
