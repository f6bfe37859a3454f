// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>
#include <qvgen/inverse/nearest.h>

/// Freedoms of a path: up to eight coordinates, each within a range, two of them within a disc if there
/// is a tolerance cone. All of it but for whole circles is convex: values that go evenly from one sample to
/// the next stay inside. A grid has points of it at every sample: everywhere, or around the values of a
/// motion.
namespace qvgen::path {

inline constexpr int most_free = 8;

/// A value of each free coordinate, rad or m.
using FreeValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_free, 1>;

/// Values that one free coordinate may have, rad or m.
struct FreeRange {
  double lower = 0, upper = 0;
  bool is_circle = false;  ///< lower and upper are the same
  int count = 72;          ///< of values that are tried at each sample
  int farthest = 3;        ///< values that it may go on from one sample to the next

  [[nodiscard]] double step() const { return (upper - lower) / (is_circle ? count : std::max(1, count - 1)); }
  [[nodiscard]] bool contains(double value) const { return is_circle || (value >= lower && value <= upper); }
  [[nodiscard]] double nearest(double value) const {
    return is_circle ? value : std::clamp(value, lower, upper);
  }
  /// Returns one of the values that are tried. Zero, where the path is as it was asked for, is one of them if
  /// it is within the range.
  [[nodiscard]] double value(int i) const {
    if (count == 1) return nearest(0);
    const bool has_zero = contains(0) && step() > 0;
    return has_zero && i == std::lround(-lower / step()) ? 0 : lower + i * step();
  }
};

/// All coordinates that are free.
struct FreeSpace {
  std::array<FreeRange, most_free> ranges{};
  int size = 1;
  int cone = -1;          ///< first of the two coordinates that stay within a disc; -1 for none
  double half_angle = 0;  ///< radius of the disc, rad

  [[nodiscard]] const FreeRange& operator[](int i) const { return ranges[static_cast<std::size_t>(i)]; }
  [[nodiscard]] FreeRange& operator[](int i) { return ranges[static_cast<std::size_t>(i)]; }

  [[nodiscard]] bool contains(const FreeValues& values) const {
    for (int i = 0; i < size; ++i)
      if (!(*this)[i].contains(values[i])) return false;
    return cone < 0 || tilt(values) <= half_angle;
  }

  /// Returns the values themselves if they are inside, else some on the boundary.
  [[nodiscard]] FreeValues nearest(FreeValues values) const {
    for (int i = 0; i < size; ++i) values[i] = (*this)[i].nearest(values[i]);
    if (cone >= 0 && tilt(values) > half_angle)
      values.segment<2>(cone) *= half_angle / tilt(values) * (1 - 1e-15);
    return values;
  }

  /// Difference of values: on circles the one within half a turn.
  [[nodiscard]] FreeValues difference(const FreeValues& to, const FreeValues& from) const {
    FreeValues off = to - from;
    for (int i = 0; i < size; ++i)
      if ((*this)[i].is_circle) off[i] = without_turns(off[i]);
    return off;
  }

  /// Sets all counts to one: the path as it was asked for.
  [[nodiscard]] FreeSpace fixed() const {
    FreeSpace point = *this;
    for (int i = 0; i < size; ++i) point[i].count = 1;
    return point;
  }

 private:
  [[nodiscard]] double tilt(const FreeValues& values) const {
    return std::hypot(values[cone], values[cone + 1]);
  }
};

/// Points of the free space at each sample, and from which point one goes on to which.
class FreeGrid {
 public:
  static constexpr int most_moves = 512;

  /// The values of all ranges; `together` coordinates change at most from one sample to the next, 1 or 2.
  explicit FreeGrid(const FreeSpace& space, int together = 2) : space_(space) {
    for (int i = 0; i < space.size; ++i) {
      counts_[index(i)] = space[i].count;
      farthest_[index(i)] = std::min(space[i].farthest, space[i].count - 1);
      wraps_[index(i)] = space[i].is_circle && space[i].count > 2 * space[i].farthest;
    }
    set_moves(together);
  }

  /// Values around those of a motion at each sample: of the coordinates from `first` on, up to `width` of
  /// them, one step less, the same, and one more.
  FreeGrid(const FreeSpace& space, const FreeValues* middle, const FreeValues& steps, int first, int width)
      : space_(space), middle_(middle), steps_(steps) {
    counts_.fill(1);
    for (int i = first; i < std::min(space.size, first + width); ++i) {
      counts_[index(i)] = 3;
      farthest_[index(i)] = 2;
    }
    set_moves(2);
  }

  [[nodiscard]] const FreeSpace& space() const { return space_; }
  [[nodiscard]] int points() const { return stride(space_.size); }
  [[nodiscard]] int moves() const { return move_count_; }

  [[nodiscard]] FreeValues at(std::size_t sample, int point) const {
    FreeValues values(space_.size);
    for (int i = 0; i < space_.size; ++i)
      values[i] = middle_ == nullptr
                      ? space_[i].value(digit(point, i))
                      : middle_[sample][i] + (digit(point, i) - counts_[index(i)] / 2) * steps_[i];
    return space_.nearest(values);
  }

  /// Writes the points from which one is reached, at most `most_moves`; returns how many. It is the first.
  int neighbours(int point, int* others) const {
    int count = 0;
    for (int k = 0; k < move_count_; ++k) {
      const Move& move = moves_[index(k)];
      const int there = moved(point, move.first, move.by);
      const int other = there < 0 || move.second < 0 ? there : moved(there, move.second, move.by_second);
      if (other >= 0) others[count++] = other;
    }
    return count;
  }

 private:
  struct Move {
    int first = 0, by = 0;
    int second = -1, by_second = 0;
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] int stride(int i) const {
    int product = 1;
    for (int k = 0; k < i; ++k) product *= counts_[index(k)];
    return product;
  }
  [[nodiscard]] int digit(int point, int i) const { return point / strides_[index(i)] % counts_[index(i)]; }

  /// The point with one coordinate moved; -1 if it is outside.
  [[nodiscard]] int moved(int point, int i, int by) const {
    const int count = counts_[index(i)], old = digit(point, i);
    int now = old + by;
    if (wraps_[index(i)]) now = (now + count) % count;
    return now < 0 || now >= count ? -1 : point + (now - old) * strides_[index(i)];
  }

  void set_moves(int together) {
    for (int i = 0; i < space_.size; ++i) strides_[index(i)] = stride(i);
    add({});
    for (int i = 0; i < space_.size; ++i) for_each_step(i, [&](int by) { add({i, by}); });
    for (int i = 0; together > 1 && i < space_.size; ++i)
      for (int k = i + 1; k < space_.size; ++k)
        for_each_step(i, [&](int by) { for_each_step(k, [&](int other) { add({i, by, k, other}); }); });
  }
  template <class Take>
  void for_each_step(int i, const Take& take) const {
    for (int by = -farthest_[index(i)]; by <= farthest_[index(i)]; ++by)
      if (by != 0) take(by);
  }
  void add(const Move& move) {
    if (move_count_ < most_moves) moves_[index(move_count_++)] = move;
  }

  FreeSpace space_;
  const FreeValues* middle_ = nullptr;
  FreeValues steps_;
  std::array<int, most_free> counts_{}, farthest_{}, strides_{};
  std::array<bool, most_free> wraps_{};
  std::array<Move, most_moves> moves_{};
  int move_count_ = 0;
};

}  // namespace qvgen::path
