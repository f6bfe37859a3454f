// SPDX-License-Identifier: MIT
// Rows of a set within limits of motors next to a centre: as many at a time as registers hold.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <qvgen/inverse/motor_turns.h>
#include <qvgen/inverse/solutions.h>
#if defined(__GNUC__)
#include <qvgen/inverse/lane_scalar.h>
#include <qvgen/simd/eigen.h>
#endif

namespace qvgen::inverse {

#if defined(__AVX2__) && defined(__GNUC__)
using RowsOfMotors = simd::Lanes<double, simd::Doubles<4>>;
#elif defined(__GNUC__)
using RowsOfMotors = simd::Lanes<double, simd::Doubles<2>>;
#else
using RowsOfMotors = double;
#endif

inline unsigned bits(bool truth) { return truth ? 1U : 0U; }
inline void load(const double* from, double& value) { value = *from; }
template <class Lane>
void load(const double* from, Lane& value) {
  value = Lane::load(from);
}
inline void store(double value, double* to) { *to = value; }
template <class Lane>
void store(const Lane& value, double* to) {
  value.store(to);
}

/// The rows of a set that have a representative inside, with the nearest one of each.
template <class Map, int capacity, class Lane = RowsOfMotors>
class RowsInside {
 public:
  static constexpr int dof = Map::dof;
  static constexpr auto size = static_cast<std::size_t>(capacity);
  static constexpr int width = static_cast<int>(sizeof(Lane) / sizeof(double));

  int count = 0;
  bool is_cut = false;                 ///< a search was given up
  std::array<int, size> kept;          ///< which rows they are
  std::array<double, size> squares{};  ///< of their distances from the centre

  /// `motors_of` makes motors of a row.
  template <class MotorsOf>
  RowsInside(const Solutions<dof, capacity>& found, const WithinMotors<Map>& within,
             const MotorsOf& motors_of) {
    for (int first = 0; first < found.size(); first += width) {
      const int most = std::min(width, found.size() - first);
      double numbers[dof][width];
      for (int lane = 0; lane < width; ++lane)
        for (int k = 0; k < dof; ++k) numbers[k][lane] = found[first + std::min(lane, most - 1)].q[k];
      Eigen::Matrix<Lane, dof, 1> rows;
      for (int k = 0; k < dof; ++k) load(numbers[k], rows[k]);
      Values values = Map::values(motors_of(rows));
      take(within, values, first, most);
    }
  }

  /// Writes the motors of the representative of a row that is kept.
  void copy_motors(std::size_t at, Joints<dof>& motors) const {
    const auto& group = motors_[static_cast<std::size_t>(kept[at] / width)];
    for (int k = 0; k < dof; ++k) motors[k] = group[k][kept[at] % width];
  }

 private:
  using Values = typename WithinMotors<Map>::template Values<Lane>;

  /// Keeps those of some rows that have a representative inside.
  void take(const WithinMotors<Map>& within, Values& values, int first, int most) {
    Lane square;
    Mask<Lane> is_given_up;
    const unsigned inside = bits(within.take_nearest(values, square, is_given_up));
    is_cut = is_cut || (bits(is_given_up) & ((1U << most) - 1)) != 0;
    if (inside == 0) return;
    auto& group = motors_[static_cast<std::size_t>(first / width)];
    within.put_motors(values, [&](int motor, const Lane& value) { store(value, group[motor]); });
    double squares_here[width];
    store(square, squares_here);
    for (int lane = 0; lane < most; ++lane) {
      if ((inside >> lane & 1U) == 0) continue;
      kept[static_cast<std::size_t>(count)] = first + lane;
      squares[static_cast<std::size_t>(count)] = squares_here[lane];
      ++count;
    }
  }

  std::array<double[dof][width], (capacity + width - 1) / width> motors_;
};

}  // namespace qvgen::inverse
