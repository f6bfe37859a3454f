// SPDX-License-Identifier: MIT
// Rows within limits of motors next to a centre, a row a lane: what motor_turns.h does for one, without a
// jump. In each block the numbers of turns are chosen one after the other, each as near as its level allows.
// The choice is the nearest representative if any other number of a level puts that level alone farther away
// than all levels of the block are now. Nearly all rows are so; the others are left to the search of
// motor_turns.h. Both give the same rows.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include <qvgen/inverse/motor_turns.h>
#include <qvgen/inverse/solutions.h>
#if defined(__GNUC__)
#include <qvgen/inverse/lane_scalar.h>
#else
#include <qvgen/inverse/two_numbers.h>
#endif

namespace qvgen::inverse {

template <class Map, class Lane>
class LanesWithinMotors {
  using Within = WithinMotors<Map>;
  template <int level>
  using Constant = std::integral_constant<int, level>;

 public:
  static constexpr int dof = Map::dof, bounded = Map::bounded;
  static constexpr int count = static_cast<int>(sizeof(Lane) / sizeof(double));
  using Truth = Mask<Lane>;

  /// A row a lane; of each a bit says whether it is inside, or has to be searched for.
  struct Rows {
    double motors[dof][count];
    double squares[count];
    unsigned inside, unsure;
  };

  explicit LanesWithinMotors(const Within& within) : within_(within) {
    for (int i = 0; i < bounded; ++i) {
      lower_[i] = Lane(within.lower_[i]);
      upper_[i] = Lane(within.upper_[i]);
      least_[i] = Lane(within.least_[i]);
      most_[i] = Lane(within.most_[i]);
      centre_[i] = Lane(within.centre_[i]);
    }
  }

  /// Finds the representatives nearest to the centre, and the squares of their distances.
  void take_nearest(const double (&values)[bounded][count], Rows& rows) const {
    Search search;
    for (int i = 0; i < bounded; ++i) search.values[i] = Lane::load(values[i]);
    search.inside = is_inside<-1>(search.values);
    Within::for_levels([&](auto level) {
      if (Within::is_alone(level)) take_only<level>(search);
    });
    rows.inside = bits(search.inside);
    rows.unsure = 0;
    if (rows.inside == 0) return;
    settle_from<0>(search);
    rows.inside = bits(search.inside);
    rows.unsure = bits(search.unsure) & rows.inside;
    Lane square = part<-1>(search.values);
    Within::for_levels([&](auto level) { square += part<level>(search.values); });
    square.store(rows.squares);
    for (int i = 0; i < bounded; ++i)
      if (Within::is_motor(i))
        smaller(upper_[i], larger(lower_[i], search.values[i])).store(rows.motors[Within::motor_at(i)]);
  }

 private:
  struct Search {
    Lane values[bounded];
    Truth inside = true, unsure = false;
  };
  /// Squares of a block: of the distance so far, and the least with another number of turns of one of its
  /// levels.
  struct Block {
    Lane square = 0.0, other = std::numeric_limits<double>::infinity();
  };
  /// The numbers of turns with which all values of a level are inside, the one of them that is chosen, by how
  /// far the level's motors are farther from the centre with any other one, at least.
  struct Piece {
    Lane least, most, number, farther;
    Truth outside;  ///< a value that the level does not move is
    [[nodiscard]] Truth empty() const { return outside | !(least <= most); }
  };

  template <int level>
  static void turn(const Lane& number, Lane (&values)[bounded]) {
    for (int i = Within::begin_of(level); i < bounded; ++i)
      if (const double motion = Map::turns.motion[level][i]; motion != 0) values[i] += number * motion;
  }
  [[nodiscard]] Truth holds(int place, const Lane& value) const {
    return (value >= least_[place]) & (value <= most_[place]);
  }
  template <int level>
  [[nodiscard]] Truth is_inside(const Lane (&values)[bounded]) const {
    Truth inside = true;
    for (int i = Within::begin_of(level); i < Within::begin_of(level + 1); ++i)
      inside = inside & holds(i, values[i]);
    return inside;
  }
  template <int level>
  [[nodiscard]] Lane part(const Lane (&values)[bounded]) const {
    Lane sum = 0.0;
    for (int i = Within::begin_of(level); i < Within::begin_of(level + 1); ++i)
      if (Within::is_motor(i)) sum += (values[i] - centre_[i]) * (values[i] - centre_[i]);
    return sum;
  }
  static Lane whole_above(const Lane& value) {
    const Lane whole = nearest_whole(value);
    return select(whole < value, whole + 1.0, whole);
  }

  template <int level>
  void take_only(Search& search) const {
    const TurnRange& range = within_.range(level);
    const Lane off = Lane(range.middle) - search.values[Within::begin_of(level)];
    turn<level>(nearest_whole(off * Lane(range.per_step)), search.values);
    search.inside = search.inside & is_inside<level>(search.values);
  }
  template <int level>
  Piece piece_of(const Lane (&values)[bounded]) const {
    Lane least = -tolerance::farthest_joint, most = tolerance::farthest_joint, wanted = 0.0;
    Truth outside = false;
    double square = 0;
    for (int i = Within::begin_of(level); i < Within::begin_of(level + 1); ++i) {
      const double motion = Map::turns.motion[level][i];
      if (motion != 0) {
        const Lane down = (least_[i] - values[i]) * (1 / motion), up = (most_[i] - values[i]) * (1 / motion);
        least = larger(motion > 0 ? down : up, least);
        most = smaller(motion > 0 ? up : down, most);
      } else {
        outside = outside | !holds(i, values[i]);
      }
      if (!Within::is_motor(i)) continue;
      if (motion != 0) wanted += motion * (centre_[i] - values[i]);
      square += motion * motion;
    }
    Piece piece{whole_above(least), -whole_above(-most), {}, {}, outside};
    const Lane nearest = square != 0 ? wanted * (1 / square) : Lane(0.0), whole = nearest_whole(nearest);
    piece.number = smaller(piece.most, larger(piece.least, whole));
    // The distance is a parabola over the number. Towards its least there is no other number if one has been
    // cut off.
    const Lane off = 2.0 * magnitude(nearest - piece.number);
    piece.farther = square * (1.0 + select(piece.number == whole, -off, off));
    return piece;
  }

  /// Settles the levels from one on, but for those that are alone.
  template <int level>
  void settle_from(Search& search) const {
    if constexpr (level < bounded) {
      if (level >= Map::turns.count) return;
      if (Within::is_alone(Constant<level>())) return settle_from<level + 1>(search);
      if (Map::turns.ends_block[level]) {
        const Piece piece = piece_of<level>(search.values);
        search.inside = search.inside & !piece.empty();
        turn<level>(piece.number, search.values);
      } else if (within_.range(level).has_one_place()) {
        take_only<level>(search);
      } else {
        Block block;
        return choose_from<level>(search, block);
      }
      settle_from<level + 1>(search);
    }
  }
  /// Chooses the numbers of a block from a level on, then those of the levels behind it.
  template <int level>
  void choose_from(Search& search, Block& block) const {
    const Piece piece = piece_of<level>(search.values);
    search.unsure = search.unsure | piece.empty();
    turn<level>(piece.number, search.values);
    block.square += part<level>(search.values);
    if constexpr (level + 1 < bounded)
      if (!Map::turns.ends_block[level]) {
        block.other = smaller(block.other, block.square + piece.farther);
        return choose_from<level + 1>(search, block);
      }
    search.unsure = search.unsure | (block.other < 1.000001 * block.square);  // with some room for rounding
    settle_from<level + 1>(search);
  }

  const Within& within_;
  Lane lower_[bounded], upper_[bounded], least_[bounded], most_[bounded], centre_[bounded];
};

/// As many rows as registers hold that the file is compiled for.
#if defined(__AVX2__) && defined(__GNUC__)
using RowsOfMotors = simd::Lanes<double, simd::Doubles<4>>;
#elif defined(__GNUC__)
using RowsOfMotors = simd::Lanes<double, simd::Doubles<2>>;
#else
using RowsOfMotors = TwoNumbers;
#endif

/// The rows of a set that have a representative inside, with the nearest one of each.
template <class Map, int capacity, class Lane = RowsOfMotors>
struct RowsInside {
  static constexpr int dof = Map::dof;
  static constexpr auto size = static_cast<std::size_t>(capacity);
  using Group = LanesWithinMotors<Map, Lane>;
  static constexpr int width = Group::count;

  int count = 0;
  bool is_cut = false;               ///< a search was given up
  std::array<int, size> kept;        ///< which rows they are
  std::array<double, size> squares;  ///< of their distances from the centre

  /// `motors_of` makes motors of a row.
  template <class MotorsOf>
  RowsInside(const Solutions<dof, capacity>& found, const WithinMotors<Map>& within,
             const MotorsOf& motors_of) {
    const Group group(within);
    double values[Map::bounded][width];
    for (int first = 0; first < found.size(); first += width) {
      const int most = std::min(width, found.size() - first);
      for (int lane = 0; lane < width; ++lane) {
        const auto of_row = Map::values(motors_of(found[first + std::min(lane, most - 1)].q));
        for (int i = 0; i < Map::bounded; ++i) values[i][lane] = of_row[i];
      }
      typename Group::Rows& rows = groups_[static_cast<std::size_t>(first / width)];
      group.take_nearest(values, rows);
      for (int lane = 0; lane < most; ++lane) {
        if ((rows.inside >> lane & 1U) == 0) continue;
        const auto at = static_cast<std::size_t>(count);
        squares[at] = rows.squares[lane];
        if ((rows.unsure >> lane & 1U) != 0) {
          Joints<dof> motors = motors_of(found[first + lane].q);
          if (!within.take_nearest(motors, squares[at], is_cut)) continue;
          for (int k = 0; k < dof; ++k) rows.motors[k][lane] = motors[k];
        }
        kept[at] = first + lane;
        ++count;
      }
    }
  }

  /// Writes the motors of the representative of a row that is kept.
  void copy_motors(std::size_t at, Joints<dof>& motors) const {
    const typename Group::Rows& rows = groups_[static_cast<std::size_t>(kept[at] / width)];
    for (int k = 0; k < dof; ++k) motors[k] = rows.motors[k][kept[at] % width];
  }

 private:
  std::array<typename Group::Rows, (capacity + width - 1) / width> groups_;
};

}  // namespace qvgen::inverse
