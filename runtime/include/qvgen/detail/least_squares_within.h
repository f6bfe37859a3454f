// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Core>

/// Convex quadratic functions of a few variables, each between two bounds, by active sets: some variables are
/// held at a bound, Newton's step finds the best values of the others, and goes only as far as the first
/// bound that it meets. Where all of it can be gone, the held variable that most wants to leave its bound is
/// freed. Each full step ends lower than the one before, so no set of held variables comes twice, but for
/// rounding.
namespace qvgen::detail {

template <class Scalar, int n>
struct Bounds {
  Eigen::Matrix<Scalar, n, 1> lower, upper;

  [[nodiscard]] Scalar nearest(const Scalar& value, int i) const {
    return value < lower(i) ? lower(i) : value > upper(i) ? upper(i) : value;
  }
  [[nodiscard]] Eigen::Matrix<Scalar, n, 1> nearest(Eigen::Matrix<Scalar, n, 1> x) const {
    for (int i = 0; i < n; ++i) x(i) = nearest(x(i), i);
    return x;
  }
};

/// The function x^T curvature x / 2 - slope^T x, its curvature positive definite.
template <class Scalar, int n>
struct Quadratic {
  Eigen::Matrix<Scalar, n, n> curvature;
  Eigen::Matrix<Scalar, n, 1> slope;

  [[nodiscard]] Eigen::Matrix<Scalar, n, 1> gradient(const Eigen::Matrix<Scalar, n, 1>& x) const {
    return curvature * x - slope;
  }
  /// Returns how large an entry of the gradient can be by rounding alone.
  [[nodiscard]] Scalar noise(const Eigen::Matrix<Scalar, n, 1>& x, int i) const {
    Scalar sum = std::abs(slope(i));
    for (int j = 0; j < n; ++j) sum += std::abs(curvature(i, j) * x(j));
    return Scalar(4 * n) * std::numeric_limits<Scalar>::epsilon() * sum;
  }
};

/// Returns the step of the free variables to where their gradient vanishes, by Cholesky's factors; zero for
/// those held.
template <class Scalar, int n>
Eigen::Matrix<Scalar, n, 1> newton_step(const Eigen::Matrix<Scalar, n, n>& curvature,
                                        const Eigen::Matrix<Scalar, n, 1>& gradient,
                                        const std::array<bool, n>& held) {
  Eigen::Matrix<Scalar, n, n> factor = Eigen::Matrix<Scalar, n, n>::Identity();
  Eigen::Matrix<Scalar, n, 1> step = Eigen::Matrix<Scalar, n, 1>::Zero();
  const auto is_held = [&](int i) { return held[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < n; ++i) {
    if (is_held(i)) continue;
    Scalar rest = -gradient(i);
    for (int j = 0; j < i; ++j) {
      if (is_held(j)) continue;
      Scalar entry = curvature(i, j);
      for (int k = 0; k < j; ++k) entry -= factor(i, k) * factor(j, k);
      factor(i, j) = entry / factor(j, j);
      rest -= factor(i, j) * step(j);
    }
    Scalar square = curvature(i, i);
    for (int k = 0; k < i; ++k) square -= factor(i, k) * factor(i, k);
    factor(i, i) = std::sqrt(square);
    step(i) = rest / factor(i, i);
  }
  for (int i = n - 1; i >= 0; --i) {
    if (is_held(i)) continue;
    for (int j = i + 1; j < n; ++j)
      if (!is_held(j)) step(i) -= factor(j, i) * step(j);
    step(i) /= factor(i, i);
  }
  return step;
}

/// Goes along a step up to the first bound that it meets; returns the variable that met it, or n if none did.
template <class Scalar, int n>
int go_within(const Bounds<Scalar, n>& bounds, const Eigen::Matrix<Scalar, n, 1>& step,
              Eigen::Matrix<Scalar, n, 1>& x) {
  int first = n;
  Scalar share = Scalar(1);
  for (int i = 0; i < n; ++i) {
    const Scalar end = step(i) < Scalar(0) ? bounds.lower(i) : bounds.upper(i);
    if (step(i) == Scalar(0) || !(std::abs(end - x(i)) < share * std::abs(step(i)))) continue;
    share = std::abs(end - x(i)) / std::abs(step(i));
    first = i;
  }
  const Scalar end = first == n || step(first) > Scalar(0) ? Scalar(1) : Scalar(-1);
  x = bounds.nearest(x + share * step);
  if (first < n) x(first) = end > Scalar(0) ? bounds.upper(first) : bounds.lower(first);
  return first;
}

/// Returns the held variable whose function falls most on the way from its bound inwards; n if none does.
template <class Scalar, int n>
int to_be_freed(const Quadratic<Scalar, n>& function, const Bounds<Scalar, n>& bounds,
                const Eigen::Matrix<Scalar, n, 1>& x, const std::array<bool, n>& held) {
  const Eigen::Matrix<Scalar, n, 1> gradient = function.gradient(x);
  int freed = n;
  Scalar most = Scalar(0);
  for (int i = 0; i < n; ++i) {
    if (!held[static_cast<std::size_t>(i)] || !(bounds.lower(i) < bounds.upper(i))) continue;
    const Scalar fall = x(i) == bounds.lower(i) ? -gradient(i) : gradient(i);
    if (!(fall > function.noise(x, i)) || !(fall > most)) continue;
    most = fall;
    freed = i;
  }
  return freed;
}

/// Several times the steps that are needed: of 900,000 random systems of 2 to 7 variables none took more than
/// 16.
inline constexpr int steps_for_each_variable = 8;

/// Moves x, which is within bounds, to where the function is least there. Returns false if the steps did not
/// suffice; x is then within bounds, and the function no larger than it was.
template <class Scalar, int n>
bool minimise_within(const Quadratic<Scalar, n>& function, const Bounds<Scalar, n>& bounds,
                     Eigen::Matrix<Scalar, n, 1>& x) {
  std::array<bool, n> held{};
  for (int i = 0; i < n; ++i)
    held[static_cast<std::size_t>(i)] = x(i) == bounds.lower(i) || x(i) == bounds.upper(i);
  for (int step = 0; step < steps_for_each_variable * n; ++step) {
    const auto way = newton_step<Scalar, n>(function.curvature, function.gradient(x), held);
    if (!((way - way).array() == Scalar(0)).all()) return false;  // overflow
    const int met = go_within<Scalar, n>(bounds, way, x);
    if (met < n) {
      held[static_cast<std::size_t>(met)] = true;
      continue;
    }
    const int freed = to_be_freed<Scalar, n>(function, bounds, x, held);
    if (freed == n) return true;
    held[static_cast<std::size_t>(freed)] = false;
  }
  return false;
}

}  // namespace qvgen::detail
