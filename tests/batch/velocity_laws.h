// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <qvgen/batch/rates.h>

#include "laws.h"

/// Laws of every batch form of the inverse velocity.
namespace qvgen::batch_laws {

/// The status of each configuration as a number, so that it stands in a row beside the others.
template <class T>
void put_status(const std::vector<VelocityStatus>& status, const Batch<T>& row) {
  for (std::size_t k = 0; k < row.count; ++k) row(0, k) = static_cast<T>(static_cast<int>(status[k]));
}

/// `form(q, twist, found, geometry, options, set)` has rates, status and residual of
/// `single(q, twist, options)`, of any count, and leaves out what it is given no place for.
template <class T, int dof, class Form, class Single, class Geometry>
void expect_single_rates(const Form& form, const Single& single, const Geometry& geometry) {
  constexpr auto joints = static_cast<std::size_t>(dof);
  InverseVelocityOptions<T> options;
  options.threshold = T(0.1);
  std::array<int, 3> seen{};
  const auto call = [&](auto& in, const Batch<T>& result, InstructionSet set) {
    std::vector<VelocityStatus> status(result.count);
    const Batch<T> residual{result.data + (joints + 1) * result.stride, result.count, result.stride};
    form(in[0], in[1], BatchOfRates<T>{result, {}, {}}, geometry, options, set);
    form(in[0], in[1], BatchOfRates<T>{result, {status.data(), result.count}, residual}, geometry, options,
         set);
    put_status(status, Batch<T>{result.data + joints * result.stride, result.count, result.stride});
  };
  const auto alone = [&](const std::vector<std::vector<T>>& in) {
    const auto value = single(Eigen::Map<const Eigen::Matrix<T, dof, 1>>(in[0].data()),
                              Eigen::Map<const Eigen::Matrix<T, 6, 1>>(in[1].data()), options);
    ++seen[static_cast<std::size_t>(value.status)];
    std::vector<T> rows;
    append<T, dof, 1>(rows, value.qd);
    rows.push_back(static_cast<T>(static_cast<int>(value.status)));
    rows.push_back(value.residual);
    return rows;
  };
  // An ulp of a sine is multiplied by the square of the condition, a tenth at worst, and once more in sums.
  expect_single_calls<T>({joints, 6}, call, alone, usual_bound * 1000);
  // Arms with few joints may be damped everywhere.
  EXPECT_GT(seen[static_cast<std::size_t>(VelocityStatus::solved)] +
                seen[static_cast<std::size_t>(VelocityStatus::damped)],
            0);
  EXPECT_GT(seen[static_cast<std::size_t>(VelocityStatus::invalid_input)], 0);
}

}  // namespace qvgen::batch_laws
