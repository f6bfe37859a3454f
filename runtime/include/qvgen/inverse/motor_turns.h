// SPDX-License-Identifier: MIT
// Whole turns of joints as motions of the motors that move them.
//
// A joint at q may as well be at q + 2 pi k. If motors are coupled, such a turn moves several of them: with
// tilt = (ml + mr)/2 and roll = (ml - mr)/2 a turn of the tilt is one of both motors. So the representatives
// of a row form a lattice: the row plus whole multiples of a few motions. Generated code has these motions in
// echelon form: each leaves the values before its pivot where they are. So limits are looked at one after the
// other, and a branch of the search ends where a value is outside. Values that no motion moves together are
// in blocks, each with a search of its own: their costs add up and are not multiplied.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include <qvgen/inverse/tolerances.h>
#include <qvgen/inverse/turn_range.h>

namespace qvgen {

/// Motions of values with limits, rad or m, that turn joints by whole turns. A value is of a motor or of a
/// joint that has limits of its own.
template <int bounded>
struct MotorTurns {
  int count;                        ///< how many motions there are
  int pivot[bounded + 1];           ///< the first value that each moves, ascending; then `bounded`
  bool ends_block[bounded];         ///< the next motion moves no value of this one's block
  double motion[bounded][bounded];  ///< by values; the pivot moves up
};

namespace inverse {

/// The representatives of rows within limits of motors, and of joints that have limits of their own.
/// `Map` is generated: `turns`, `values`, `motor_of`, `own_lower`, `own_upper`. A level is a motion. Levels
/// as types (`Constant`) make loops over values straight code, with the zeros of the motions gone.
template <class Map>
class WithinMotors {
  template <class, class>
  friend class LanesWithinMotors;
  template <int level>
  using Constant = std::integral_constant<int, level>;

 public:
  static constexpr int dof = Map::dof, bounded = Map::bounded;
  using Values = Eigen::Matrix<double, bounded, 1>;
  /// The most numbers that a search in one block for the nearest representative of a row looks at.
  static constexpr int most_tries = 4096;

  WithinMotors(const JointLimits<dof>& limits, const Joints<dof>& centre) {
    for (int i = 0; i < bounded; ++i) set_limits(i, limits);
    look_from(centre);
  }
  /// Returns these limits next to another centre.
  [[nodiscard]] WithinMotors next_to(const Joints<dof>& centre) const {
    WithinMotors other = *this;
    other.look_from(centre);
    return other;
  }

  [[nodiscard]] const TurnRange& range(int level) const { return ranges_[level]; }
  template <class Level>
  static void turn(Level level, double number, Values& values) {
    for (int i = begin_of(level); i < bounded; ++i)
      if (const double motion = Map::turns.motion[level][i]; motion != 0) values[i] += number * motion;
  }
  template <class Level>
  static Values turned(Level level, double number, Values from) {
    turn(level, number, from);
    return from;
  }
  /// True if the values that no later motion moves, behind those of the level before, are inside.
  template <class Level>
  [[nodiscard]] bool is_inside(Level level, const Values& values) const {
    for (int i = begin_of(level); i < begin_of(level + 1); ++i)
      if (!holds(i, values[i])) return false;
    return true;
  }
  /// True if motors, which are then put on their limits, and joints with limits are inside.
  [[nodiscard]] bool take(Joints<dof>& motors) const {
    const Values values = Map::values(motors);
    for (int level = -1; level < Map::turns.count; ++level)
      if (!is_inside(level, values)) return false;
    motors = motors_of(values);
    return true;
  }
  /// Motors of values that are inside: on their limits where rounding has moved them outside.
  [[nodiscard]] Joints<dof> motors_of(const Values& values) const {
    Joints<dof> motors;
    for (int i = 0; i < bounded; ++i)
      if (is_motor(i)) motors[motor_at(i)] = std::min(std::max(values[i], lower_[i]), upper_[i]);
    return motors;
  }

  /// Puts the representative in place of a row that is inside and nearest to the centre, and sets the square
  /// of its distance. Returns false if there is none; `is_cut` is then set if the search was given up. Values
  /// that move alone are looked at first: most rows that are outside end there.
  bool take_nearest(Joints<dof>& motors, double& square, bool& is_cut) const {
    Values values = Map::values(motors);
    bool is_in = is_inside(Constant<-1>(), values);
    for_levels([&](auto level) { is_in = is_in && (!is_alone(level) || take_only(level, values)); });
    if (!is_in || !settle_from(Constant<0>(), values, is_cut)) return false;
    square = part(Constant<-1>(), values);
    for_levels([&](auto level) { square += part(level, values); });
    motors = motors_of(values);
    return true;
  }

 private:
  struct Search {
    Values best;
    double square = std::numeric_limits<double>::infinity();
    int tries = 0;
  };

  void look_from(const Joints<dof>& centre) {
    centre_ = Map::values(centre.unaryExpr(&sensible));
    for_levels([&](auto level) {
      const int pivot = begin_of(level);
      ranges_[level] =
          turn_range(Map::turns.motion[level][pivot], lower_[pivot], upper_[pivot], centre_[pivot]);
    });
  }
  /// A centre beyond which whole turns are lost in rounding is none, nor is what is no number.
  static double sensible(double centre) { return std::abs(centre) < tolerance::lost_centre ? centre : 0.0; }
  static constexpr int motor_at(int place) { return Map::motor_of[static_cast<std::size_t>(place)]; }
  static constexpr bool is_motor(int place) { return motor_at(place) >= 0; }
  /// Calls `visit(level)` for all levels.
  template <class Visit>
  static void for_levels(const Visit& visit) {
    visit_levels(visit, std::make_integer_sequence<int, bounded>());
  }
  template <class Visit, int... level>
  static void visit_levels(const Visit& visit, std::integer_sequence<int, level...> /*levels*/) {
    ((level < Map::turns.count ? visit(Constant<level>()) : void()), ...);
  }
  /// The first value that is settled by a level; those before the first pivot are by level -1.
  static int begin_of(int level) { return level < 0 ? 0 : Map::turns.pivot[level]; }

  /// True if a motion moves its pivot alone, and no other one does.
  template <class Level>
  static bool is_alone(Level level) {
    return Map::turns.ends_block[level] && begin_of(level + 1) - begin_of(level) == 1 &&
           (level == 0 || Map::turns.ends_block[level - 1]);
  }
  /// Limits that are not a range admit nothing: no value is between these.
  void set_limits(int place, const JointLimits<dof>& limits) {
    const auto at = static_cast<std::size_t>(place);
    const double lower = is_motor(place) ? limits.lower[motor_at(place)] : Map::own_lower[at];
    const double upper = is_motor(place) ? limits.upper[motor_at(place)] : Map::own_upper[at];
    const bool is_range =
        lower <= upper && lower < tolerance::farthest_joint && upper > -tolerance::farthest_joint;
    lower_[place] = is_range ? lower : tolerance::farthest_joint;
    upper_[place] = is_range ? upper : -tolerance::farthest_joint;
    least_[place] = lower_[place] - limit_tolerance;
    most_[place] = upper_[place] + limit_tolerance;
  }
  /// Share of a level's motors in the square of the distance from the centre.
  template <class Level>
  [[nodiscard]] double part(Level level, const Values& values) const {
    double sum = 0;
    for (int i = begin_of(level); i < begin_of(level + 1); ++i)
      if (is_motor(i)) sum += (values[i] - centre_[i]) * (values[i] - centre_[i]);
    return sum;
  }

  /// Settles the levels from one on, but for those that are alone.
  template <int level>
  bool settle_from(Constant<level> at, Values& values, bool& is_cut) const {
    if constexpr (level < bounded) {
      if (level >= Map::turns.count) return true;
      if (is_alone(at)) return settle_from(Constant<level + 1>(), values, is_cut);
      if (Map::turns.ends_block[level])
        return settle(at, values) && settle_from(Constant<level + 1>(), values, is_cut);
      if (ranges_[level].has_one_place())
        return take_only(at, values) && settle_from(Constant<level + 1>(), values, is_cut);
      return search(at, values, is_cut) && settle_behind(at, values, is_cut);
    }
    return true;
  }
  /// Settles the levels behind the block of one.
  template <int level>
  bool settle_behind(Constant<level> /*of*/, Values& values, bool& is_cut) const {
    if constexpr (level + 1 < bounded) {
      constexpr Constant<level + 1> next;
      return Map::turns.ends_block[level] ? settle_from(next, values, is_cut)
                                          : settle_behind(next, values, is_cut);
    }
    return true;
  }

  /// The numbers of turns with which all values of a level are inside, and the one, no whole number, at which
  /// they are nearest to the centre.
  struct Piece {
    double least, most, nearest;
    [[nodiscard]] bool empty() const { return !(least <= most); }
    [[nodiscard]] double nearest_inside() const {
      return std::min(std::max(nearest_whole(nearest), least), most);
    }
  };
  /// Values of a level move along a line, on which limits leave a piece and the distance has one least value.
  template <class Level>
  Piece piece_of(Level level, const Values& values) const {
    double least = -tolerance::farthest_joint, most = tolerance::farthest_joint, wanted = 0, square = 0;
    for (int i = begin_of(level); i < begin_of(level + 1); ++i) {
      const double motion = Map::turns.motion[level][i];
      if (motion != 0) {
        const double down = (least_[i] - values[i]) * (1 / motion);
        const double up = (most_[i] - values[i]) * (1 / motion);
        least = std::max(least, motion > 0 ? down : up);
        most = std::min(most, motion > 0 ? up : down);
      } else if (!holds(i, values[i])) {
        return {1, -1, 0};
      }
      if (!is_motor(i)) continue;
      wanted += motion * (centre_[i] - values[i]);
      square += motion * motion;
    }
    return {whole_above(least), -whole_above(-most), square != 0 ? wanted * (1 / square) : 0};
  }
  /// Settles the last level of a block: no number is tried. Returns false if nothing is inside.
  template <class Level>
  bool settle(Level level, Values& values) const {
    const Piece piece = piece_of(level, values);
    if (piece.empty()) return false;
    turn(level, piece.nearest_inside(), values);
    return true;
  }
  static double whole_above(double value) {
    const double whole = nearest_whole(value);
    return whole < value ? whole + 1 : whole;
  }
  [[nodiscard]] bool holds(int place, double value) const {
    return value >= least_[place] && value <= most_[place];
  }

  /// Takes the only number of a level that may be inside.
  template <class Level>
  bool take_only(Level level, Values& values) const {
    turn(level, ranges_[level].turns_from(values[begin_of(level)]), values);
    return is_inside(level, values);
  }
  /// Searches a block from a level on.
  template <class Level>
  bool search(Level level, Values& values, bool& is_cut) const {
    Search search;
    descend(level, values, 0, search);
    const bool is_found = search.square < std::numeric_limits<double>::infinity();
    if (is_found) values = search.best;
    is_cut = is_cut || (!is_found && search.tries >= most_tries);
    return is_found;
  }
  template <int at>
  void descend(Constant<at> level, Values from, double square, Search& search) const {
    if constexpr (at + 1 < bounded)
      if (!Map::turns.ends_block[at]) return try_numbers(level, from, square, search);
    if (settle(level, from)) keep(from, square + part(level, from), search);
  }
  /// Tries the numbers of a level that are inside, outwards from the nearest: what lies beyond one at which
  /// this level alone is as far as the best that was found is farther still.
  template <int at>
  void try_numbers(Constant<at> level, const Values& from, double square, Search& search) const {
    const Piece piece = piece_of(level, from);
    if (piece.empty()) return;
    const double start = piece.nearest_inside();
    const bool is_open = !(piece.most - piece.least < many_turns);
    const double farthest = is_open ? tried_turns : many_turns;
    const double most = std::min(piece.most, start + farthest);
    const double least = std::max(piece.least, start - farthest);
    double up = start, down = start - 1;
    while (search.tries < most_tries && (up <= most || down >= least)) {
      ++search.tries;
      const bool goes_up = down < least || (up <= most && up - piece.nearest <= piece.nearest - down);
      const Values values = turned(level, goes_up ? up : down, from);
      const double reached = square + part(level, values);
      if (reached < search.square) descend(Constant<at + 1>(), values, reached, search);
      if (goes_up)
        up = reached < search.square ? up + 1 : most + 1;
      else
        down = reached < search.square ? down - 1 : least - 1;
    }
  }
  static void keep(const Values& values, double square, Search& search) {
    if (!(square < search.square)) return;
    search.best = values;
    search.square = square;
  }

  double lower_[bounded], upper_[bounded];
  double least_[bounded], most_[bounded];  ///< with the tolerance of limits
  Values centre_;
  TurnRange ranges_[bounded];
};

}  // namespace inverse
}  // namespace qvgen
