// SPDX-License-Identifier: MIT
#include <Eigen/LU>

#include "closure.h"

namespace qvgen::inverse::certified {
namespace {

using Square = Eigen::Matrix<double, joints, joints>;

/// A row with what does not depend on the box around it. Y may be any matrix; this one is nearly the inverse
/// of the derivatives at the row.
class Row {
 public:
  Row(const Loop& loop, const double (&row)[joints]) : loop_(loop) {
    Interval x[joints];
    for (int i = 0; i < joints; ++i) x[i] = row_[i] = row[i];
    const Closure here = closure_at(loop, x);
    Square slope;
    for (int i = 0; i < joints; ++i)
      for (int k = 0; k < joints; ++k) slope(i, k) = here.slope[i][k].middle();
    inverse_ = slope.partialPivLu().inverse();
    for (int i = 0; i < joints; ++i)
      for (int k = 0; k < joints; ++k) step_[i] -= Interval(inverse_(i, k)) * here.value[k];
  }

  /// No number in here is too large for what follows.
  [[nodiscard]] bool is_moderate() const {
    constexpr double largest_value = 1e6, largest_entry = 1e12;
    bool fits = inverse_.allFinite() && inverse_.cwiseAbs().maxCoeff() < largest_entry;
    for (const double value : row_) fits = fits && std::abs(value) < largest_value;
    return fits;
  }

  /// How far Newton's step goes.
  [[nodiscard]] double step() const {
    double most = 0;
    for (const Interval& way : step_) most = std::max(most, way.magnitude());
    return most;
  }

  /// True if Krawczyk's operator takes the box of all joints within `radius` of the row into its inside,
  /// where nothing but the pose itself solves the equations: exactly one solution lies there. In `image`.
  [[nodiscard]] bool has_one_within(double radius, Enclosure& image) const {
    Interval x[joints], offset[joints];
    for (int i = 0; i < joints; ++i) {
      x[i] = around(row_[i], radius);
      offset[i] = x[i] - Interval(row_[i]);
    }
    const Closure all = closure_at(loop_, x);
    bool is_one = all.trace.lower > -1;
    for (int i = 0; i < joints && is_one; ++i) {
      Interval way = step_[i];
      for (int k = 0; k < joints; ++k) {
        Interval left = i == k ? 1.0 : 0.0;
        for (int j = 0; j < joints; ++j) left -= Interval(inverse_(i, j)) * all.slope[j][k];
        way += left * offset[k];
      }
      image.solution[i] = Interval(row_[i]) + way;
      is_one = is_strictly_inside(image.solution[i], x[i]);
    }
    return is_one;
  }

  /// Bound from above of how far a box reaches from the row.
  [[nodiscard]] double distance(const Enclosure& box) const {
    double most = 0;
    for (int i = 0; i < joints; ++i) most = std::max(most, (box.solution[i] - Interval(row_[i])).magnitude());
    return most;
  }

 private:
  const Loop& loop_;
  double row_[joints];
  Square inverse_;
  Interval step_[joints];  ///< -Y f(m)
};

/// The largest radius for which it is proven, to an eighth: from one for which it is.
double largest_alone(const Row& row, double radius) {
  constexpr double most = 1;
  Enclosure image;
  double good = radius, bad = most;
  for (double next = 16 * radius; next < most; next *= 16) {
    if (!row.has_one_within(next, image)) {
      bad = next;
      break;
    }
    good = next;
  }
  while (bad > 1.125 * good) {
    const double next = std::sqrt(good * bad);
    (row.has_one_within(next, image) ? good : bad) = next;
  }
  return good;
}

}  // namespace

RowProof prove_row(const Loop& loop, const double (&row)[joints], double farthest, Enclosure& enclosure) {
  RowProof proof;
  const Row start(loop, row);
  if (!start.is_moderate()) return proof;
  constexpr double smallest = 1e-15;
  double radius = std::max(2 * start.step(), smallest);
  while (radius <= farthest && !start.has_one_within(radius, enclosure)) radius *= 8;
  if (!(radius <= farthest)) return proof;
  proof.proven = true;
  proof.within = start.distance(enclosure);
  proof.alone_within = largest_alone(start, radius);
  return proof;
}

}  // namespace qvgen::inverse::certified
