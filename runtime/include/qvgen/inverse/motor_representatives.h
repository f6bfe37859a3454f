// SPDX-License-Identifier: MIT
// All representatives of a row within limits of motors, made when they are asked for.
#pragma once

#include <algorithm>

#include <qvgen/inverse/motor_turns.h>
#include <qvgen/inverse/turn_numbers.h>

namespace qvgen::inverse {

/// The representatives of one row, made one after the other.
template <class Map>
class Representatives {
 public:
  static constexpr int dof = Map::dof, bounded = Map::bounded;
  using Values = typename WithinMotors<Map>::Values;

  /// Puts the first representative in place of a row, if there is one.
  void start(const WithinMotors<Map>& within, Joints<dof>& motors) {
    within_ = &within;
    const Values values = Map::values(motors);
    level_ = -1;
    if (!within.is_inside(-1, values)) return;
    if (Map::turns.count == 0) {
      motors = within.motors_of(values);
      return;
    }
    open(values);
    next(motors);
  }

  /// Goes to the next one; false if there is none.
  bool next(Joints<dof>& motors) {
    while (level_ >= 0) {
      const TurnRange& range = within_->range(level_);
      double number = 0;
      if ((range.is_open && has_one_[level_]) || !numbers_[level_].next(range, number)) {
        --level_;
        continue;
      }
      const Values values = within_->turned(level_, number, from_[level_]);
      if (!within_->is_inside(level_, values)) continue;
      if (level_ + 1 < Map::turns.count) {
        open(values);
        continue;
      }
      motors = within_->motors_of(values);
      std::fill(has_one_, has_one_ + bounded, true);
      return true;
    }
    return false;
  }

 private:
  void open(const Values& from) {
    ++level_;
    from_[level_] = from;
    has_one_[level_] = false;
    numbers_[level_] = {from[Map::turns.pivot[level_]], within_->range(level_)};
  }

  const WithinMotors<Map>* within_ = nullptr;
  int level_ = -1;
  Values from_[bounded];
  TurnNumbers numbers_[bounded];
  bool has_one_[bounded] = {};
};

}  // namespace qvgen::inverse
