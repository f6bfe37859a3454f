// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include <qvgen/batch/rates.h>

// Shared parts of batched inverse velocities: Jacobians are computed in lanes, what branches on their values
// one by one.
namespace qvgen::batch {

/// How many Jacobians stand between the two at a time: they stay in the cache.
inline constexpr std::size_t jacobians_at_once = 64;

template <class Scalar, int Rows>
Eigen::Matrix<Scalar, Rows, 1> column(const Batch<const Scalar>& batch, std::size_t k) {
  Eigen::Matrix<Scalar, Rows, 1> values;
  for (int i = 0; i < Rows; ++i) values(i) = batch(static_cast<std::size_t>(i), k);
  return values;
}

template <class Scalar, int dof>
void put(const InverseVelocity<Scalar, dof>& single, const BatchOfRates<Scalar>& found, std::size_t k) {
  for (int i = 0; i < dof; ++i) found.qd(static_cast<std::size_t>(i), k) = single.qd(i);
  if (found.status.data != nullptr) found.status(0, k) = single.status;
  if (found.residual.data != nullptr) found.residual(0, k) = single.residual;
}

template <class Scalar>
std::size_t shortest(const Batch<const Scalar>& q, const Batch<const Scalar>& twist,
                     const BatchOfRates<Scalar>& found) {
  std::size_t count = std::min({q.count, twist.count, found.qd.count});
  if (found.status.data != nullptr) count = std::min(count, found.status.count);
  if (found.residual.data != nullptr) count = std::min(count, found.residual.count);
  return count;
}

/// `jacobians(q, result)` fills in `Rows` rows for some configurations, `single(rows, twist)` solves for one.
template <int Rows, class Scalar, class Jacobians, class Single>
void joint_rates(const Batch<const Scalar>& q, const Batch<const Scalar>& twist,
                 const BatchOfRates<Scalar>& found, const Jacobians& jacobians, const Single& single) {
  const std::size_t count = shortest(q, twist, found);
  Scalar numbers[Rows * jacobians_at_once];
  for (std::size_t first = 0; first < count; first += jacobians_at_once) {
    const Batch<Scalar> part{numbers, std::min(count - first, jacobians_at_once), jacobians_at_once};
    jacobians(q.part(first, part.count), part);
    for (std::size_t k = 0; k < part.count; ++k)
      put(single(column<Scalar, Rows>(part, k), column<Scalar, 6>(twist, first + k)), found, first + k);
  }
}

}  // namespace qvgen::batch
