// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <qvgen/inverse/nearest.h>
#include <qvgen/path/jet.h>

/// Bounds of the joints' forces on a stretch of a path, for the fastest motion along it (time.h).
///
/// Along joints q(s) the forces of a motion with u = s'' and w = s'^2 are a u + b w + c, where a = M q',
/// b = M q'' + C(q, q') q' and c is gravity, and friction. On a stretch of length h each of a, b and c
/// differs from the straight line between its values at both ends by e = h^2 / 8 of its largest second
/// derivative at most, which jets (jet.h) bound on the whole stretch. With w linear in s and u even, the
/// straight part is a quadratic polynomial, within its Bernstein coefficients; the rest is within e_a |u| +
/// e_b w + e_c. So a limit holds on the whole stretch if some inequalities alpha u + beta w <= gamma hold at
/// its start. They leave a margin that shrinks with h^2. All gammas are above zero if standing still is
/// within the limits.
///
/// Viscous friction grows with sqrt(w), which is below its tangents: (w / r + r) / 2 for any r > 0. Where it
/// helps, in braking, it is not counted on.
namespace qvgen::path {

/// Largest forces of all joints, N m or N, infinite for none; and their friction.
template <int forces>
struct ForceLimits {
  using Vector = Eigen::Matrix<double, forces, 1>;
  Vector most = Vector::Constant(std::numeric_limits<double>::infinity());
  Vector viscous = Vector::Zero();  ///< N m s/rad or N s/m
  Vector coulomb = Vector::Zero();  ///< N m or N
};

/// Parts of the forces where joints pass q with the slope q': the mass matrix, C(q, q') q', and gravity.
template <class Scalar, int forces>
struct ForceParts {
  Eigen::Matrix<Scalar, forces, forces> mass;
  Eigen::Matrix<Scalar, forces, 1> coriolis, gravity;
};

/// a, b and c at one place, or bounds of their errors.
template <int forces>
struct ForceTerms {
  using Vector = Eigen::Matrix<double, forces, 1>;
  Vector by_u = Vector::Zero(), by_w = Vector::Zero(), rest = Vector::Zero();
};

/// Bounds of the forces on one stretch.
template <int forces>
struct ForceBounds {
  using Vector = Eigen::Matrix<double, forces, 1>;
  ForceTerms<forces> start, end, error;
  Vector slope_low = Vector::Zero(), slope_high = Vector::Zero();  ///< of q'
  double tangent = 1;                                              ///< r: s' at which friction is exact
};

/// One inequality alpha u + beta w <= gamma.
struct ForceLine {
  double alpha, beta, gamma;
};

/// Lines of one stretch: three coefficients, both signs of the force and of u.
template <int forces>
inline constexpr int force_lines = 12 * forces;

namespace force {

/// Part of the limits that is kept for rounding.
inline constexpr double kept = 1e-9;

/// Friction of one joint in the direction `sign` is at most by_w w + rest.
struct FrictionBound {
  double by_w, rest;
};
template <int forces>
FrictionBound friction_bound(const ForceBounds<forces>& bounds, const ForceLimits<forces>& limits, int k,
                             double sign) {
  const double high = sign > 0 ? bounds.slope_high[k] : -bounds.slope_low[k];
  const double low = sign > 0 ? bounds.slope_low[k] : -bounds.slope_high[k];
  const double coulomb = high > 0 ? limits.coulomb[k] : low < 0 ? -limits.coulomb[k] : 0;
  const double slope = limits.viscous[k] * std::max(0.0, high);
  return {slope / (2 * bounds.tangent), coulomb + slope * bounds.tangent / 2};
}

}  // namespace force

/// Calls with each line of a stretch of length h, and the joint that it is about.
template <int forces, class Take>
void for_each_line(const ForceBounds<forces>& bounds, const ForceLimits<forces>& limits, double h,
                   const Take& take) {
  const auto &a = bounds.start, &z = bounds.end, &error = bounds.error;
  for (int k = 0; k < forces; ++k) {
    const double by_u[3] = {a.by_u[k], 0.5 * (a.by_u[k] + z.by_u[k]) + h * a.by_w[k],
                            z.by_u[k] + 2 * h * z.by_w[k]};
    const double by_w[3] = {a.by_w[k], 0.5 * (a.by_w[k] + z.by_w[k]), z.by_w[k]};
    const double rest[3] = {a.rest[k], 0.5 * (a.rest[k] + z.rest[k]), z.rest[k]};
    for (const double sign : {1.0, -1.0}) {
      const auto friction = force::friction_bound(bounds, limits, k, sign);
      const double more = error.by_w[k] + friction.by_w;
      for (int i = 0; i < 3; ++i)
        for (const double way : {1.0, -1.0})
          take(k, ForceLine{
                      sign * by_u[i] + way * error.by_u[k] + more * i * h, sign * by_w[i] + more,
                      (1 - force::kept) * limits.most[k] - sign * rest[i] - error.rest[k] - friction.rest});
    }
  }
}

/// A stretch of a cubic spline: joints, slopes and second derivatives at both ends.
template <int dof>
struct SplineStretch {
  Joints<dof> q[2], slope[2], bend[2];
  double length;
};

/// A joint that stays where it is; none if the index is below zero.
struct HeldValue {
  int joint = -1;
  double value = 0;
};

namespace force {

/// Returns the values of all joints, from those that move.
template <int forces, class Scalar, int dof, class Call>
Eigen::Matrix<Scalar, forces, 1> of_all(const HeldValue& held, const Scalar& value, const Call& moving) {
  Eigen::Matrix<Scalar, forces, 1> all;
  for (int i = 0, k = 0; i < forces; ++i) all[i] = i == held.joint ? value : moving(k++);
  static_assert(dof == forces || dof == forces - 1);
  return all;
}

template <class Scalar, int forces>
Eigen::Matrix<Scalar, forces, 1> product(const Eigen::Matrix<Scalar, forces, forces>& mass,
                                         const Eigen::Matrix<Scalar, forces, 1>& vector) {
  Eigen::Matrix<Scalar, forces, 1> all;
  for (int i = 0; i < forces; ++i) {
    all[i] = mass(i, 0) * vector[0];
    for (int j = 1; j < forces; ++j) all[i] += mass(i, j) * vector[j];
  }
  return all;
}

inline Interval range(std::initializer_list<double> numbers) {
  const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
  return {inverse::certified::outward::below(*low), inverse::certified::outward::above(*high)};
}

template <int forces, class Dynamics, int dof>
ForceTerms<forces> terms_at(const Dynamics& dynamics, const SplineStretch<dof>& on, int end) {
  const HeldValue held = dynamics.held;
  const auto all = [&](double value, const Joints<dof>& moving) {
    return of_all<forces, double, dof>(held, value, [&](int k) { return moving[k]; });
  };
  const auto slope = all(0, on.slope[end]);
  const auto parts = dynamics.template parts<double>(all(held.value, on.q[end]), slope);
  return {product(parts.mass, slope), product(parts.mass, all(0, on.bend[end])) + parts.coriolis,
          parts.gravity};
}

/// The largest magnitudes of second derivatives, times a factor.
template <int forces>
Eigen::Matrix<double, forces, 1> bends(const Eigen::Matrix<Jet, forces, 1>& jets, double factor) {
  Eigen::Matrix<double, forces, 1> all;
  for (int k = 0; k < forces; ++k) all[k] = factor * jets[k].bend.magnitude();
  return all;
}

}  // namespace force

/// Returns bounds of the forces on a stretch. `dynamics` has `forces`, `held` and `parts<Scalar>(q, slope)`.
template <class Dynamics, int dof>
ForceBounds<Dynamics::forces> force_bounds(const Dynamics& dynamics, const SplineStretch<dof>& on) {
  constexpr int forces = Dynamics::forces;
  using Jets = Eigen::Matrix<Jet, forces, 1>;
  const double h = on.length;
  const Joints<dof> middle = on.slope[0] + 0.5 * h * on.bend[0];
  const auto all = [&](double value, const auto& jet) {
    return force::of_all<forces, Jet, dof>(dynamics.held, Jet(value), jet);
  };
  const auto slope = [&](int k) { return force::range({on.slope[0][k], middle[k], on.slope[1][k]}); };
  const auto bend = [&](int k) { return force::range({on.bend[0][k], on.bend[1][k]}); };
  const auto third = [&](int k) { return (Interval(on.bend[1][k]) - Interval(on.bend[0][k])) / Interval(h); };
  const Jets q = all(dynamics.held.value, [&](int k) {
    return Jet(force::range({on.q[0][k], on.q[0][k] + h / 3 * on.slope[0][k],
                             on.q[1][k] - h / 3 * on.slope[1][k], on.q[1][k]}),
               slope(k), bend(k));
  });
  const Jets first = all(0, [&](int k) { return Jet(slope(k), bend(k), third(k)); });
  const Jets second = all(0, [&](int k) { return Jet(bend(k), third(k), 0.0); });
  const ForceParts<Jet, forces> parts = dynamics.template parts<Jet>(q, first);
  const double factor = h * h / 8;
  ForceBounds<forces> bounds;
  bounds.start = force::terms_at<forces>(dynamics, on, 0);
  bounds.end = force::terms_at<forces>(dynamics, on, 1);
  Jets by_w = force::product(parts.mass, second);
  for (int k = 0; k < forces; ++k) by_w[k] += parts.coriolis[k];
  bounds.error = {force::bends<forces>(force::product(parts.mass, first), factor),
                  force::bends<forces>(by_w, factor), force::bends<forces>(parts.gravity, factor)};
  for (int k = 0; k < forces; ++k) {
    bounds.slope_low[k] = first[k].value.lower;
    bounds.slope_high[k] = first[k].value.upper;
  }
  return bounds;
}

}  // namespace qvgen::path
