// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/LU>

#include "closure.h"

/// Krawczyk's operator for boxes around one row: see proof.h.
namespace qvgen::inverse::certified {

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

  [[nodiscard]] bool has_one_within(double radius, Enclosure& image) const {
    return has_one_within({radius, radius, radius, radius, radius, radius}, image);
  }

  /// True if Krawczyk's operator takes the box of all joints within `radius` of the row into its inside,
  /// where nothing but the pose itself solves the equations: exactly one solution lies there, in `image`. Of
  /// a loop whose goal is a set of poses this holds for each of them.
  [[nodiscard]] bool has_one_within(const double (&radius)[joints], Enclosure& image) const {
    Interval x[joints], offset[joints];
    for (int i = 0; i < joints; ++i) {
      x[i] = around(row_[i], radius[i]);
      offset[i] = x[i] - Interval(row_[i]);
    }
    const Closure all = closure_at(loop_, x);
    bool is_one = all.trace.lower > -1;
    for (int i = 0; i < joints; ++i) {
      Interval way = step_[i];
      for (int k = 0; k < joints; ++k) {
        Interval left = i == k ? 1.0 : 0.0;
        for (int j = 0; j < joints; ++j) left -= Interval(inverse_(i, j)) * all.slope[j][k];
        way += left * offset[k];
      }
      image.solution[i] = Interval(row_[i]) + way;
      is_one = is_one && is_strictly_inside(image.solution[i], x[i]);
    }
    return is_one;
  }

  /// Newton's step of a joint, about.
  [[nodiscard]] double step(int joint) const { return step_[joint].middle(); }
  /// Bound from above of how far Newton's step of a joint goes.
  [[nodiscard]] double reach(int joint) const { return step_[joint].magnitude(); }

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

}  // namespace qvgen::inverse::certified
