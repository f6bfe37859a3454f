// SPDX-License-Identifier: MIT
// Whole turns of joints as motions of the motors that move them.
//
// A joint at q may as well be at q + 2 pi k. If motors are coupled, such a turn moves several of them: with
// tilt = (ml + mr)/2 and roll = (ml - mr)/2 a turn of the tilt is one of both motors. So the representatives
// of a row form a lattice: the row plus whole multiples of a few motions. Generated code has these motions in
// echelon form: each leaves the motors before its pivot where they are. So limits of motors are looked at one
// after the other, and a branch of the search ends where one is outside.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <qvgen/inverse/within.h>

namespace qvgen {

/// Motions of motors, rad or m, that turn joints by whole turns; the pivots ascend.
template <int dof>
struct MotorTurns {
  int count;                ///< how many there are
  int pivot[dof];           ///< the first motor that each moves, by a positive angle or length
  double motion[dof][dof];  ///< each by motors
};

namespace inverse {

/// Numbers of whole turns of one motion, the one nearest to a centre first, then alternately above and below.
class TurnNumbers {
 public:
  /// Values that are tried where limits leave more than `most_values`, or no end.
  static constexpr double tried = 16, most_values = 4096;

  TurnNumbers() = default;
  /// For the value `from` of a motor that a turn moves by `step`, with bounds and a centre of the motor.
  TurnNumbers(double from, double step, double lower, double upper, double centre) {
    double least = std::ceil((lower - limit_tolerance - from) / step);
    double most = std::floor((upper + limit_tolerance - from) / step);
    if (!(least <= most)) return;
    nearest_ = std::min(std::max(std::nearbyint((centre - from) / step), least), most);
    is_open = !(most - least < most_values);
    if (is_open) {
      least = std::max(least, nearest_ - tried);
      most = std::min(most, nearest_ + tried);
    }
    below_ = static_cast<int>(nearest_ - least);
    above_ = static_cast<int>(most - nearest_);
    count = below_ + above_ + 1;
  }

  int count = 0;
  bool is_open = false;  ///< there are more, of which the nearest that is inside stands for all

  [[nodiscard]] double operator[](int index) const { return nearest_ + turns_at(index); }
  /// How far a number is from the nearest one.
  [[nodiscard]] int distance(int index) const { return std::abs(turns_at(index)); }

 private:
  [[nodiscard]] int turns_at(int index) const {
    const int fewer = std::min(below_, above_);
    if (index > 2 * fewer) return above_ > below_ ? index - fewer : fewer - index;
    return index % 2 == 1 ? (index + 1) / 2 : -index / 2;
  }

  int below_ = 0, above_ = 0;
  double nearest_ = 0;
};

/// The representatives of rows within limits of motors, and of joints that have limits of their own.
/// `Map` is generated: `turns`, `joints`, `joint_lower`, `joint_upper`.
template <class Map>
class WithinMotors {
 public:
  static constexpr int dof = Map::dof;
  /// The most values that a search for the nearest representative of a row looks at.
  static constexpr int most_tries = 20000;

  WithinMotors(const JointLimits<dof>& limits, const Joints<dof>& centre) : limits_(limits), centre_(centre) {
    for (int i = 0; i < dof; ++i)
      if (!std::isfinite(centre_[i])) centre_[i] = 0;
  }

  [[nodiscard]] TurnNumbers numbers(int level, const Joints<dof>& from) const {
    const int motor = Map::turns.pivot[level];
    return {from[motor], Map::turns.motion[level][motor], limits_.lower[motor], limits_.upper[motor],
            centre_[motor]};
  }
  static Joints<dof> turned(int level, double number, Joints<dof> from) {
    for (int i = Map::turns.pivot[level]; i < dof; ++i) from[i] += number * Map::turns.motion[level][i];
    return from;
  }
  /// True if the motors that no later motion moves, behind those of the level before, are inside.
  [[nodiscard]] bool is_inside(int level, const Joints<dof>& motors) const {
    for (int i = begin_of(level); i < begin_of(level + 1); ++i)
      if (!(motors[i] >= limits_.lower[i] - limit_tolerance &&
            motors[i] <= limits_.upper[i] + limit_tolerance))
        return false;
    return true;
  }
  /// Puts motors on their limits that rounding has moved outside. Returns false if a joint is outside of its
  /// own.
  [[nodiscard]] bool conclude(Joints<dof>& motors) const {
    motors = motors.cwiseMax(limits_.lower).cwiseMin(limits_.upper);
    const Joints<dof> joints = Map::joints(motors);
    for (int i = 0; i < dof; ++i)
      if (!(joints[i] >= Map::joint_lower[i] - limit_tolerance &&
            joints[i] <= Map::joint_upper[i] + limit_tolerance))
        return false;
    return true;
  }

  /// Puts the representative in place of a row that is inside and nearest to the centre, and sets the square
  /// of its distance. Returns false if there is none.
  bool take_nearest(Joints<dof>& motors, double& square) const {
    Search search;
    if (is_inside(-1, motors)) descend(0, motors, part(-1, motors), search);
    if (!(search.square < std::numeric_limits<double>::infinity())) return false;
    motors = search.best;
    square = search.square;
    return true;
  }

 private:
  struct Search {
    Joints<dof> best;
    double square = std::numeric_limits<double>::infinity();
    int tries = 0;
  };

  /// The first motor that is settled by a level; those before the first pivot are by level -1.
  static int begin_of(int level) {
    return level < 0 ? 0 : level < Map::turns.count ? Map::turns.pivot[level] : dof;
  }
  /// Share of a level's motors in the square of the distance from the centre.
  [[nodiscard]] double part(int level, const Joints<dof>& motors) const {
    double sum = 0;
    for (int i = begin_of(level); i < begin_of(level + 1); ++i)
      sum += (motors[i] - centre_[i]) * (motors[i] - centre_[i]);
    return sum;
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as there are joints
  void descend(int level, const Joints<dof>& from, double square, Search& search) const {
    if (level == Map::turns.count) {
      Joints<dof> motors = from;
      if (square < search.square && conclude(motors)) {
        search.best = motors;
        search.square = square;
      }
      return;
    }
    const TurnNumbers all = numbers(level, from);
    const double step = Map::turns.motion[level][Map::turns.pivot[level]];
    for (int index = 0; index < all.count && search.tries < most_tries; ++index) {
      const double away = (all.distance(index) - 0.5) * step;
      if (away > 0 && square + away * away >= search.square) return;
      ++search.tries;
      const Joints<dof> motors = turned(level, all[index], from);
      if (is_inside(level, motors)) descend(level + 1, motors, square + part(level, motors), search);
    }
  }

  JointLimits<dof> limits_;
  Joints<dof> centre_;
};

/// The representatives of one row, made one after the other.
template <class Map>
class Representatives {
 public:
  static constexpr int dof = Map::dof;

  void start(const WithinMotors<Map>& within, const Joints<dof>& motors) {
    level_ = within.is_inside(-1, motors) ? 0 : -1;
    is_first_ = true;
    if (level_ == 0) open(within, motors);
  }

  /// Goes to the next one; false if there is none.
  bool next(const WithinMotors<Map>& within, Joints<dof>& motors) {
    if (Map::turns.count == 0)
      return std::exchange(is_first_, false) && level_ == 0 && take(within, from_[0], motors);
    while (level_ >= 0) {
      TurnNumbers& all = numbers_[level_];
      if (index_[level_] >= all.count || (all.is_open && has_one_[level_])) {
        --level_;
        continue;
      }
      const Joints<dof> turned = within.turned(level_, all[index_[level_]++], from_[level_]);
      if (!within.is_inside(level_, turned)) continue;
      if (level_ + 1 < Map::turns.count) {
        ++level_;
        open(within, turned);
      } else if (take(within, turned, motors)) {
        std::fill(has_one_, has_one_ + dof, true);
        return true;
      }
    }
    return false;
  }

 private:
  void open(const WithinMotors<Map>& within, const Joints<dof>& from) {
    from_[level_] = from;
    index_[level_] = 0;
    has_one_[level_] = false;
    if (level_ < Map::turns.count) numbers_[level_] = within.numbers(level_, from);
  }
  static bool take(const WithinMotors<Map>& within, const Joints<dof>& from, Joints<dof>& motors) {
    motors = from;
    return within.conclude(motors);
  }

  int level_ = -1;
  bool is_first_ = false;
  Joints<dof> from_[dof];
  TurnNumbers numbers_[dof];
  int index_[dof] = {};
  bool has_one_[dof] = {};
};

}  // namespace inverse
}  // namespace qvgen
