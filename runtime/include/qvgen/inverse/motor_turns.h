// SPDX-License-Identifier: MIT
// Whole turns of joints as motions of the motors that move them.
//
// A joint at q may as well be at q + 2 pi k. If motors are coupled, such a turn moves several of them: with
// tilt = (ml + mr)/2 and roll = (ml - mr)/2 a turn of the tilt is one of both motors. So the representatives
// of a row form a lattice: the row plus whole multiples of a few motions. Generated code has these motions in
// echelon form: each leaves the values before its pivot where they are. So limits are looked at one after the
// other, and a branch of the search ends where a value is outside. Values that no motion moves together are
// in blocks, each with a search of its own: their costs add up and are not multiplied.
//
// The search serves one row or several side by side, a row a lane: `Lane` is a double or a vector of them.
// A lane takes the steps that a row alone would take, and waits while others go on.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

#include <qvgen/inverse/tolerances.h>
#include <qvgen/inverse/turn_piece.h>

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
  template <int level>
  using Constant = std::integral_constant<int, level>;

 public:
  static constexpr int dof = Map::dof, bounded = Map::bounded;
  /// Values with limits of a row, or of several side by side.
  template <class Lane>
  using Values = Eigen::Matrix<Lane, bounded, 1>;
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

  /// Returns the limits of the first value that a level moves.
  [[nodiscard]] TurnRange range(int level) const {
    const int pivot = begin_of(level);
    return turn_range(Map::turns.motion[level][pivot], lower_[pivot], upper_[pivot], centre_[pivot]);
  }
  /// Returns values after turns of a level; `turn` moves them in place.
  template <class Level, class Lane>
  static Values<Lane> turned(Level level, const Lane& number, const Values<Lane>& from) {
    Values<Lane> values;
    for (int i = 0; i < bounded; ++i) values[i] = from[i];
    turn(level, number, values);
    return values;
  }
  template <class Level, class Lane>
  static void turn(Level level, const Lane& number, Values<Lane>& values) {
    for (int i = begin_of(level); i < bounded; ++i)
      if (const double motion = Map::turns.motion[level][i]; motion != 0)
        values[i] = values[i] + number * motion;
  }
  /// Returns them where the level is known at run time alone.
  static Values<double> turned_at(int level, double number, const Values<double>& from) {
    Values<double> values;
    for_levels([&](auto each) {
      if (each == level) values = turned(each, number, from);
    });
    return values;
  }
  /// Returns the numbers with which the values of such a level are inside.
  [[nodiscard]] TurnPiece<double> piece_at(int level, const Values<double>& values) const {
    TurnPiece<double> piece;
    for_levels([&](auto each) {
      if (each == level) piece = piece_of(each, values);
    });
    return piece;
  }
  /// True if the values that no later motion moves, behind those of the level before, are inside.
  template <class Level, class Lane>
  [[nodiscard]] Mask<Lane> is_inside(Level level, const Values<Lane>& values) const {
    Mask<Lane> inside = true;
    for (int i = begin_of(level); i < begin_of(level + 1); ++i) inside = inside & holds(i, values[i]);
    return inside;
  }
  /// True if motors, which are then put on their limits, and joints with limits are inside.
  [[nodiscard]] bool take(Joints<dof>& motors) const {
    const Values<double> values = Map::values(motors);
    for (int level = -1; level < Map::turns.count; ++level)
      if (!is_inside(level, values)) return false;
    motors = motors_of(values);
    return true;
  }
  /// Motors of values that are inside: on their limits where rounding has moved them outside.
  [[nodiscard]] Joints<dof> motors_of(const Values<double>& values) const {
    Joints<dof> motors;
    put_motors(values, [&motors](int motor, double value) { motors[motor] = value; });
    return motors;
  }
  /// Calls `put(motor, value)` for all motors of values that are inside, on their limits as above.
  template <class Lane, class Put>
  void put_motors(const Values<Lane>& values, const Put& put) const {
    for (int i = 0; i < bounded; ++i)
      if (is_motor(i)) put(motor_at(i), smaller(Lane(upper_[i]), larger(Lane(lower_[i]), values[i])));
  }

  /// Puts the representatives in place of rows that are inside and nearest to the centre, and sets the
  /// squares of their distances. Returns which rows have one; of the others `is_cut` says where the search
  /// was given up. Values that move alone are looked at first: most rows that are outside end there.
  template <class Lane>
  Mask<Lane> take_nearest(Values<Lane>& values, Lane& square, Mask<Lane>& is_cut) const {
    Mask<Lane> inside = is_inside(Constant<-1>(), values);
    for_levels([&](auto level) {
      if (is_alone(level)) inside = inside & take_only(level, values);
    });
    is_cut = false;
    if (!any(inside)) return inside;
    settle_from(Constant<0>(), values, inside, is_cut);
    Lane sum = part(Constant<-1>(), values);
    for_levels([&](auto level) { sum = sum + part(level, values); });
    square = sum;
    return inside;
  }

 private:
  /// A centre beyond which whole turns are lost in rounding is none, nor is what is no number.
  void look_from(const Joints<dof>& centre) {
    Joints<dof> sensible;
    for (int i = 0; i < dof; ++i)
      sensible[i] = std::abs(centre[i]) < tolerance::lost_centre ? centre[i] : 0.0;
    centre_ = Map::values(sensible);
    for_levels([&](auto level) { middle_[level] = range(level).middle; });
  }
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
  template <class Lane>
  [[nodiscard]] Mask<Lane> holds(int place, const Lane& value) const {
    return (value >= Lane(least_[place])) & (value <= Lane(most_[place]));
  }
  /// Share of a level's motors in the square of the distance from the centre.
  template <class Level, class Lane>
  [[nodiscard]] Lane part(Level level, const Values<Lane>& values) const {
    Lane sum = 0.0;
    for (int i = begin_of(level); i < begin_of(level + 1); ++i)
      if (is_motor(i)) sum = sum + (values[i] - centre_[i]) * (values[i] - centre_[i]);
    return sum;
  }
  /// Takes the only number of a level that may be inside; true where it is.
  template <class Level, class Lane>
  Mask<Lane> take_only(Level level, Values<Lane>& values) const {
    const int pivot = begin_of(level);
    const double per_step = 1 / Map::turns.motion[level][pivot];
    turn(level, Lane(nearest_whole((middle_[level] - values[pivot]) * per_step)), values);
    return is_inside(level, values);
  }

  /// Values of a level move along a line, on which limits leave a piece and the distance has one least value.
  template <class Level, class Lane>
  TurnPiece<Lane> piece_of(Level level, const Values<Lane>& values) const {
    TurnPiece<Lane> piece;
    Lane wanted = 0.0;
    for (int i = begin_of(level); i < begin_of(level + 1); ++i) {
      const double motion = Map::turns.motion[level][i];
      if (motion != 0) piece.cut_line(least_[i] - values[i], most_[i] - values[i], 1 / motion);
      if (motion == 0) piece.inside = piece.inside & holds(i, values[i]);
      if (motion != 0 && is_motor(i)) wanted = wanted + motion * (centre_[i] - values[i]);
    }
    if (const double square = square_of(level); square != 0) piece.nearest = wanted * (1 / square);
    piece.keep_whole_numbers();
    return piece;
  }
  /// Square of the way that a level's motors go in a turn.
  template <class Level>
  static double square_of(Level level) {
    double square = 0;
    for (int i = begin_of(level); i < begin_of(level + 1); ++i)
      if (is_motor(i)) square += Map::turns.motion[level][i] * Map::turns.motion[level][i];
    return square;
  }

  /// Settles the levels from one on, but for those that are alone.
  template <int level, class Lane>
  void settle_from(Constant<level> at, Values<Lane>& values, Mask<Lane>& inside, Mask<Lane>& is_cut) const {
    if constexpr (level < bounded) {
      constexpr Constant<level + 1> next;
      if (level >= Map::turns.count) return;
      if (is_alone(at)) return settle_from(next, values, inside, is_cut);
      if (Map::turns.ends_block[level]) {
        inside = inside & settle(at, values);
      } else if (range(level).has_one_place()) {
        inside = inside & take_only(at, values);
      } else {
        search(at, values, inside, is_cut);
        return settle_behind(at, values, inside, is_cut);
      }
      settle_from(next, values, inside, is_cut);
    }
  }
  /// Settles the levels behind the block of one.
  template <int level, class Lane>
  void settle_behind(Constant<level> /*of*/, Values<Lane>& values, Mask<Lane>& inside,
                     Mask<Lane>& is_cut) const {
    if constexpr (level + 1 < bounded) {
      constexpr Constant<level + 1> next;
      if (Map::turns.ends_block[level]) return settle_from(next, values, inside, is_cut);
      settle_behind(next, values, inside, is_cut);
    }
  }
  /// Settles the last level of a block: no number is tried. Returns where something is inside.
  template <class Level, class Lane>
  Mask<Lane> settle(Level level, Values<Lane>& values) const {
    const TurnPiece<Lane> piece = piece_of(level, values);
    turn(level, piece.nearest_inside(), values);
    return piece.inside;
  }

  /// Numbers of the levels of a block, those that are looked at and the best.
  template <int first_level, class Lane>
  struct Search {
    static constexpr int first = first_level;
    Lane numbers[bounded], best[bounded];
    Lane square = std::numeric_limits<double>::infinity(), tries = 0.0;
  };
  /// Searches a block from a level on.
  template <int level, class Lane>
  [[gnu::flatten]] void search(Constant<level> at, Values<Lane>& values, Mask<Lane>& inside,
                               Mask<Lane>& is_cut) const {
    Search<level, Lane> search;
    for (int k = level; k < bounded; ++k) search.best[k] = 0.0;
    descend(at, values, Lane(0.0), inside, search);
    const Mask<Lane> is_found = search.square < Lane(std::numeric_limits<double>::infinity());
    is_cut = is_cut | (inside & (!is_found) & (search.tries >= Lane(most_tries)));
    inside = inside & is_found;
    take_best(at, search, values);
  }
  template <int level, class Found, class Lane>
  static void take_best(Constant<level> at, const Found& found, Values<Lane>& values) {
    turn(at, found.best[level], values);
    if constexpr (level + 1 < bounded)
      if (!Map::turns.ends_block[level]) take_best(Constant<level + 1>(), found, values);
  }
  /// Looks at what lies behind values: at all numbers of a level, at the best one of a block's last level.
  template <int at, class Lane, class Found>
  void descend(Constant<at> level, const Values<Lane>& from, const Lane& square, const Mask<Lane>& active,
               Found& search) const {
    if constexpr (at + 1 < bounded)
      if (!Map::turns.ends_block[at]) return try_numbers(level, from, square, active, search);
    const TurnPiece<Lane> piece = piece_of(level, from);
    search.numbers[at] = piece.nearest_inside();
    const Lane reached = square + part(level, turned(level, search.numbers[at], from));
    const Mask<Lane> is_best = active & piece.inside & (reached < search.square);
    search.square = select(is_best, reached, search.square);
    for (int k = Found::first; k <= at; ++k)
      search.best[k] = select(is_best, search.numbers[k], search.best[k]);
  }
  /// Tries the numbers of a level that are inside, as long as this level alone is not as far as the best that
  /// was found: mostly one.
  template <int at, class Lane, class Found>
  void try_numbers(Constant<at> level, const Values<Lane>& from, const Lane& square, Mask<Lane> active,
                   Found& search) const {
    const TurnPiece<Lane> piece = piece_of(level, from);
    Outwards<Lane> tried;
    tried.start_outwards(piece);
    active = active & piece.inside & (search.tries < Lane(most_tries));
    try_number(level, from, square, tried, active, search);
    if (any(active)) try_others(level, from, square, tried, active, search);
  }
  /// Tries one number, and goes to the next where there is one to be tried.
  template <int at, class Lane, class Found>
  void try_number(Constant<at> level, const Values<Lane>& from, const Lane& square, Outwards<Lane>& tried,
                  Mask<Lane>& active, Found& search) const {
    search.numbers[at] = tried.number;
    search.tries = search.tries + select(active, Lane(1.0), Lane(0.0));
    const Values<Lane> values = turned(level, tried.number, from);
    const Lane reached = square + part(level, values),
               least = reached - tried.square_beyond_least(square_of(level));
    descend(Constant<at + 1>(), values, reached, active & (reached < search.square), search);
    active = active & tried.next_outwards() & (search.tries < Lane(most_tries));
    active = active & may_be_best(Lane(least + tried.square_beyond_least(square_of(level))), search.square);
  }
  template <int at, class Lane, class Found>
  [[gnu::noinline]] void try_others(Constant<at> level, const Values<Lane>& from, const Lane& square,
                                    Outwards<Lane> tried, Mask<Lane> active, Found& search) const {
    while (any(active)) try_number(level, from, square, tried, active, search);
  }

  double lower_[bounded], upper_[bounded];
  double least_[bounded], most_[bounded];  ///< with the tolerance of limits
  Values<double> centre_;
  double middle_[bounded];  ///< by levels: what the pivot is turned next to
};

}  // namespace inverse
}  // namespace qvgen
