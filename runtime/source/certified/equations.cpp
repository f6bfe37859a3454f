// SPDX-License-Identifier: MIT
#include "equations.h"

#include <Eigen/Cholesky>

namespace qvgen::inverse::certified {
namespace {

/// Factors of the coefficients of a function of up to three angles, or of its derivative by one of them.
struct Factors {
  Interval of[most_angles][3];
};

Factors factors_of(const Side& side, const SineCosine* at) {
  Factors factors;
  for (int i = 0; i < side.angles; ++i) {
    factors.of[i][0] = 1;
    factors.of[i][1] = at[i].cosine;
    factors.of[i][2] = at[i].sine;
  }
  return factors;
}

Factors derived(Factors factors, int by, const SineCosine& at) {
  factors.of[by][0] = 0;
  factors.of[by][1] = -at.sine;
  factors.of[by][2] = at.cosine;
  return factors;
}

/// From the last angle to the first, as Horner's rule goes.
Interval value_of(const Coefficients& coefficients, const Factors& factors, int angle, std::size_t first,
                  std::size_t stride) {
  if (angle < 0) return coefficients[first];
  Interval sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval& factor = factors.of[angle][i];
    if (factor.is_zero()) continue;
    sum += factor * value_of(coefficients, factors, angle - 1, first + i * stride, 3 * stride);
  }
  return sum;
}

}  // namespace

Equations::Equations(const Reduced& reduced) : reduced_(reduced) {
  for (const Side& side : reduced.side)
    for (int i = 0; i < side.angles; ++i) joint_[unknowns_++] = side.joint[i];
}

void Equations::add_side(const Side& side, int first, const SineCosine* at, double sign, bool with_slopes,
                         Values& result) const {
  const Factors factors = factors_of(side, at);
  for (int n = 0; n < reduced_.functions; ++n)
    result.value[n] += Interval(sign) * value_of(side.function[n], factors, side.angles - 1, 0, 1);
  for (int i = 0; with_slopes && i < side.angles; ++i) {
    const Factors by = derived(factors, i, at[i]);
    for (int n = 0; n < reduced_.functions; ++n)
      result.slope[n][first + i] = Interval(sign) * value_of(side.function[n], by, side.angles - 1, 0, 1);
  }
}

Equations::Values Equations::values(const Box& box, bool with_slopes) const {
  SineCosine at[most_unknown];
  for (int k = 0; k < unknowns_; ++k) at[k] = sine_cosine(box.angle[k]);
  Values result;
  add_side(reduced_.side[0], 0, at, 1, with_slopes, result);
  const int second = reduced_.side[0].angles;
  add_side(reduced_.side[1], second, at + second, -1, with_slopes, result);
  return result;
}

bool Equations::exclude(const Box& box) const {
  const Values all = values(box, false);
  for (int n = 0; n < reduced_.functions; ++n)
    if (all.value[n].lower > 0 || all.value[n].upper < 0) return true;
  return false;
}

/// Equations around the middle m of a box X: Y f(m) and I - Y F'(X), with a Y that is nearly the left inverse
/// of F'(m) which least squares give.
struct Equations::Centred {
  double middle[most_unknown];
  Interval step[most_unknown];  ///< -Y f(m)
  Interval rest[most_unknown][most_unknown];
  bool exists = false;

  Centred(const Equations& equations, const Box& box) {
    const int size = equations.unknowns_, functions = equations.reduced_.functions;
    Box at;
    for (int k = 0; k < size; ++k) at.angle[k] = middle[k] = box.angle[k].middle();
    const Values here = equations.values(at, true);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_functions, most_unknown> slope(functions,
                                                                                                 size);
    for (int n = 0; n < functions; ++n)
      for (int k = 0; k < size; ++k) slope(n, k) = here.slope[n][k].middle() / equations.reduced_.unit[n];
    using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_unknown, most_unknown>;
    const Square normal = slope.transpose() * slope;
    const Eigen::LDLT<Square> factors(normal);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_unknown, most_functions> left =
        factors.solve(slope.transpose());
    for (int n = 0; n < functions; ++n) left.col(n) /= equations.reduced_.unit[n];
    constexpr double largest = 1e12;
    exists = left.allFinite() && left.cwiseAbs().maxCoeff() < largest;
    if (!exists) return;
    const Values all = equations.values(box, true);
    for (int i = 0; i < size; ++i) {
      for (int n = 0; n < functions; ++n) step[i] -= Interval(left(i, n)) * here.value[n];
      for (int k = 0; k < size; ++k) {
        rest[i][k] = i == k ? 1.0 : 0.0;
        for (int n = 0; n < functions; ++n) rest[i][k] -= Interval(left(i, n)) * all.slope[n][k];
      }
    }
  }
};

bool Equations::narrow(Box& box) const {
  const Centred here(*this, box);
  if (!here.exists) return true;
  Box image = box;
  for (int i = 0; i < unknowns_; ++i) {
    Interval way = here.step[i];
    for (int k = 0; k < unknowns_; ++k) way += here.rest[i][k] * (box.angle[k] - Interval(here.middle[k]));
    const Interval zero = Interval(here.middle[i]) + way;
    if (are_apart(zero, box.angle[i])) return false;
    image.angle[i] = common(zero, box.angle[i]);
  }
  box = image;
  return true;
}

Region Equations::region_around(const double (&row)[joints]) const {
  Region region;
  for (int k = 0; k < unknowns_; ++k) region.centre[k] = row[joint_[k]];
  const auto is_one = [&](double radius) {
    Box box;
    for (int k = 0; k < unknowns_; ++k) box.angle[k] = around(region.centre[k], radius);
    const Centred here(*this, box);
    if (!here.exists) return false;
    for (int i = 0; i < unknowns_; ++i) {
      Interval sum;
      for (int k = 0; k < unknowns_; ++k) sum += Interval(here.rest[i][k].magnitude());
      if (!(sum.upper < 1)) return false;
    }
    return true;
  };
  constexpr double smallest = 1e-7;
  double bad = 1;
  for (double radius = bad; radius > smallest && region.radius == 0; radius /= 4)
    (is_one(radius) ? region.radius : bad) = radius;
  while (region.radius > 0 && bad > 1.125 * region.radius) {
    const double radius = std::sqrt(region.radius * bad);
    (is_one(radius) ? region.radius : bad) = radius;
  }
  return region;
}

}  // namespace qvgen::inverse::certified
