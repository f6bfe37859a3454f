// SPDX-License-Identifier: MIT
// All representatives of a row within limits of motors, made when they are asked for.
#pragma once

#include <cstddef>

#include <qvgen/inverse/motor_turns.h>

namespace qvgen::inverse {

/// The representatives of one row, made one after the other.
template <class Map>
class Representatives {
 public:
  static constexpr int dof = Map::dof, bounded = Map::bounded;
  using Values = typename WithinMotors<Map>::template Values<double>;

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
    for (int level = 0; level < Map::turns.count; ++level) ranges_[level] = within.range(level);
    open(values);
    next(motors);
  }

  /// Goes to the next one; false if there is none.
  bool next(Joints<dof>& motors) {
    while (level_ >= 0) {
      Level& level = levels_[level_];
      if (!level.has_number || (ranges_[level_].is_open && level.rows_before != rows_)) {
        --level_;
        continue;
      }
      const Values values = within_->turned_at(level_, level.tried.number, level.from);
      level.has_number = level.tried.next_outwards();
      if (level_ + 1 < Map::turns.count) {
        open(values);
        continue;
      }
      motors = within_->motors_of(values);
      ++rows_;
      return true;
    }
    return false;
  }

 private:
  /// A level whose numbers are tried outwards from the middle.
  struct Level {
    Values from;
    Outwards<double> tried;
    bool has_number;
    std::size_t rows_before;
  };

  void open(const Values& from) {
    Level& level = levels_[++level_];
    TurnPiece<double> piece = within_->piece_at(level_, from);
    piece.nearest = ranges_[level_].turns_from(from[Map::turns.pivot[level_]]);
    level.from = from;
    level.tried.start_outwards(piece);
    level.has_number = piece.inside;
    level.rows_before = rows_;
  }

  const WithinMotors<Map>* within_ = nullptr;
  int level_ = -1;
  std::size_t rows_ = 0;
  TurnRange ranges_[bounded];
  Level levels_[bounded];
};

}  // namespace qvgen::inverse
