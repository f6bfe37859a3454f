// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <qvgen/path/limits_on_track.h>
#include <qvgen/path/record.h>

/// Motions: tracks cut at the limits. A revolute joint may run along its track shifted by whole turns, so one
/// track may give several motions; those that begin and end together are one, with their number.
namespace qvgen::path {

/// A continuous motion of the joints that can be made no longer.
struct Motion {
  int track = -1;
  Values turns = Values::Zero();  ///< rad to add to the track's joints, whole turns
  double representatives = 1;     ///< choices of whole turns that begin and end at the same places
  End begin, end;                 ///< with the joints there, whole turns added
};

namespace motions {

/// A stretch of the path on which some joints are within limits.
struct Stretch {
  double from, to;
  const Event* entry;  ///< null at the track's own ends
  const Event* exit;
};

/// A list of stretches in rising order.
struct Stretches {
  static constexpr std::size_t most = 32;
  std::array<Stretch, most> rows{};
  std::size_t count = 0;
  bool is_full = false;

  void add(const Stretch& stretch) {
    is_full = is_full || count == most;
    if (count < most) rows[count++] = stretch;
  }
};

inline bool are_same(const Stretches& a, const Stretches& b) {
  if (a.count != b.count) return false;
  for (std::size_t i = 0; i < a.count; ++i)
    if (a.rows[i].from != b.rows[i].from || a.rows[i].to != b.rows[i].to) return false;
  return true;
}

inline Stretches common(const Stretches& a, const Stretches& b) {
  Stretches result;
  result.is_full = a.is_full || b.is_full;
  std::size_t i = 0, k = 0;
  while (i < a.count && k < b.count) {
    const Stretch &one = a.rows[i], &two = b.rows[k];
    const bool later = one.from<two.from, sooner = one.to> two.to;
    const Stretch both{later ? two.from : one.from, sooner ? two.to : one.to, later ? two.entry : one.entry,
                       sooner ? two.exit : one.exit};
    if (both.from <= both.to) result.add(both);
    sooner ? ++k : ++i;
  }
  return result;
}

}  // namespace motions

/// Cuts the tracks of a record at limits of values (coupling.h), as a rule the joints; `take` is called with
/// each Motion. Takes 100 kB of memory, where motors move the joints up to 2 MB.
template <int capacity, class Take, class Coupling = Uncoupled>
class MotionsOf {
 public:
  MotionsOf(const Record<capacity>& record, const JointLimits<Coupling::values>& limits,
            const JointKinds<6>& revolute, const Take& take, const Coupling& coupling = {})
      : record_(record), limits_(limits, revolute, coupling), take_(take) {}

  /// Returns false if there was no room for all that a track is cut into.
  bool run() {
    for (int track = 0; track < record_.tracks(); ++track) {
      number_ = track;
      track_ = &record_.track(track);
      lowest_ = coupling().lowest(track_->lowest, track_->highest);
      highest_ = coupling().highest(track_->lowest, track_->highest);
      motions::Stretches all;
      all.add({track_->begin.s, track_->end.s, nullptr, nullptr});
      visited_ = 0;
      choose(0, all, Shift::Zero(), 1);
    }
    return !is_full_;
  }

 private:
  using Shift = typename Coupling::Shift;
  static constexpr int most_edges = 8;        ///< shifts that leave one joint's range on the way
  static constexpr int most_choices = 20000;  ///< of whole turns of all joints, for one track
  static constexpr double margin = 2e-6;      ///< rad: nearer to a limit events decide
  static constexpr auto room = static_cast<std::size_t>(Coupling::most_choices);

  /// Whole turns that are added to the values of a block, and how many others are the same to its limits.
  struct Choice {
    Shift shift;
    double count;
  };
  struct Choices {
    std::array<Choice, room> rows;
    std::size_t count = 0;
    bool is_open = false;  ///< there are more without an end, for which these stand
  };
  [[nodiscard]] const Coupling& coupling() const { return limits_.coupling(); }

  /// Lists the stretches for each shift of a block, and goes on to the next one with each that is new.
  void choose(int number, const motions::Stretches& within, const Shift& turns, double representatives) {
    if (within.count == 0) return;
    if (number == coupling().blocks()) return give(within, coupling().joints(turns), representatives);
    const Block block = coupling().block(number);
    const Choices choices = choices_of(block);
    auto& stretches = room_[static_cast<std::size_t>(number)];
    for (std::size_t i = 0; i < choices.count; ++i) {
      if (++visited_ > most_choices) is_full_ = true;
      if (visited_ > most_choices) return;
      stretches[i] = within;
      for (int k = block.first; k < block.first + block.count; ++k)
        stretches[i] = motions::common(stretches[i], inside(k, choices.rows[i].shift[k]));
      is_full_ = is_full_ || stretches[i].is_full;
    }
    for (std::size_t i = 0; i < choices.count; ++i) {
      Choice all{choices.rows[i].shift, 0};
      if (!gather(block, choices, stretches, i, all)) continue;
      choose(number + 1, stretches[i], turns + all.shift, representatives * all.count);
    }
  }

  /// Adds up the choices with the same stretches, and takes the one whose values are nearest to zero; false
  /// if an earlier one has them too.
  template <class List>
  bool gather(const Block& block, const Choices& choices, const List& stretches, std::size_t i,
              Choice& all) const {
    for (std::size_t k = 0; k < i; ++k)
      if (motions::are_same(stretches[k], stretches[i])) return false;
    for (std::size_t k = i; k < choices.count; ++k) {
      const Choice& other = choices.rows[k];
      if (!motions::are_same(stretches[k], stretches[i])) continue;
      all.count += other.count;
      if (size_of(block, other.shift) < size_of(block, all.shift)) all.shift = other.shift;
    }
    if (choices.is_open) all.count = 1;
    return true;
  }

  double middle_of(int i) const { return 0.5 * (lowest_[i] + highest_[i]); }
  double size_of(const Block& block, const Shift& shift) const {
    double size = 0;
    for (int i = block.first; i < block.first + block.count; ++i) size += std::abs(middle_of(i) + shift[i]);
    return size;
  }

  /// Lists the shifts that bring a part of the track within limits.
  Choices choices_of(const Block& block) const {
    if (block.is_alone()) return choices_of_one(block.first);
    Choices choices;
    list(block, 0, Shift::Zero(), choices);
    return choices;
  }

  /// Lists those of a value that moves alone; those that bring all of the track in are one.
  Choices choices_of_one(int i) const {
    Choices choices;
    if (!limits_.turns(i) || !std::isfinite(limits_.lower(i))) {
      add(i, limits_.turns_inside(i, lowest_[i], highest_[i]), 1, choices);
      return choices;
    }
    const double lower = limits_.lower(i), upper = limits_.upper(i), turn = limits_.turn(i);
    const double first = std::ceil((lower - highest_[i]) / turn - 1e-9),
                 last = std::floor((upper - lowest_[i]) / turn + 1e-9),
                 first_in = std::ceil((lower + margin - lowest_[i]) / turn),
                 last_in = std::floor((upper - margin - highest_[i]) / turn);
    const bool some_in = first_in <= last_in;
    add_edge(i, first, some_in ? first_in - 1 : last, choices);
    if (!some_in) return choices;
    const double nearest = std::round(-middle_of(i) / turn);
    add(i, std::min(std::max(nearest, first_in), last_in), last_in - first_in + 1, choices);
    add_edge(i, last_in + 1, last, choices);
    return choices;
  }

  void add_edge(int i, double from, double to, Choices& choices) const {
    is_full_ = is_full_ || to - from >= most_edges;
    for (int k = 0; k < most_edges && from + k <= to; ++k) add(i, from + k, 1, choices);
  }
  void add(int i, double turns, double count, Choices& choices) const {
    Shift shift = Shift::Zero();
    shift[i] = limits_.turn(i) * turns;
    add({shift, count}, choices);
  }
  void add(const Choice& choice, Choices& choices) const {
    is_full_ = is_full_ || choices.count == room;
    if (choices.count < room) choices.rows[choices.count++] = choice;
  }

  /// Lists the shifts of values that move together: all numbers of each motion, one motion after the other.
  void list(const Block& block, int level, const Shift& shift, Choices& choices) const {
    if (level == block.levels) {
      if (may_be_inside(block, shift)) add({shift, 1}, choices);
      return;
    }
    const Numbers numbers = numbers_of(block, level, shift, choices);
    const Shift motion = coupling().motion(block.first_level + level);
    for (double number = numbers.from; number <= numbers.to && !is_full_; ++number)
      list(block, level + 1, shift + number * motion, choices);
  }

  bool may_be_inside(const Block& block, const Shift& shift) const {
    for (int i = block.first; i < block.first + block.count; ++i)
      if (lowest_[i] + shift[i] > limits_.upper(i) || highest_[i] + shift[i] < limits_.lower(i)) return false;
    return true;
  }

  struct Numbers {
    double from, to;
  };
  /// Returns the numbers of a motion with which the values that no later motion moves may be inside. Where
  /// they have no end, as many as differ to the others' limits stand for all.
  Numbers numbers_of(const Block& block, int level, const Shift& shift, Choices& choices) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Shift motion = coupling().motion(block.first_level + level);
    Numbers numbers{-infinity, infinity}, all_in{-infinity, infinity};
    const int pivot = pivot_of(block, level), end = pivot_of(block, level + 1);
    for (int i = pivot; i < end; ++i) {
      if (motion[i] == 0) continue;
      const double low = lowest_[i] + shift[i], high = highest_[i] + shift[i], up = 1 / motion[i];
      const double a = (limits_.lower(i) - high) * up, b = (limits_.upper(i) - low) * up,
                   c = (limits_.lower(i) - low) * up, d = (limits_.upper(i) - high) * up;
      numbers = {std::max(numbers.from, std::min(a, b)), std::min(numbers.to, std::max(a, b))};
      all_in = {std::max(all_in.from, std::min(c, d)), std::min(all_in.to, std::max(c, d))};
    }
    numbers = {std::ceil(numbers.from - 1e-9), std::floor(numbers.to + 1e-9)};
    if (std::isfinite(numbers.from) && std::isfinite(numbers.to)) return numbers;
    choices.is_open = true;
    const double count = repetition_of(block, level);
    if (std::isfinite(numbers.from)) return {numbers.from, std::ceil(all_in.from) + count};
    if (std::isfinite(numbers.to)) return {std::floor(all_in.to) - count, numbers.to};
    const double nearest = std::round(-(middle_of(pivot) + shift[pivot]) / motion[pivot]);
    return {nearest - std::floor(0.5 * count), nearest + std::floor(0.5 * count)};
  }

  /// Returns the first value that a motion moves; behind the last motion the end of the block.
  int pivot_of(const Block& block, int level) const {
    int pivot = level < block.levels ? block.first : block.first + block.count;
    while (level < block.levels && coupling().motion(block.first_level + level)[pivot] == 0) ++pivot;
    return pivot;
  }

  /// Returns after how many times a motion moves the limited values behind its own as later motions do.
  double repetition_of(const Block& block, int level) const {
    for (int count = 1; count <= most_repeated; ++count) {
      Shift rest = count * coupling().motion(block.first_level + level);
      for (int later = level + 1; later < block.levels; ++later) {
        const int pivot = pivot_of(block, later);
        const Shift motion = coupling().motion(block.first_level + later);
        if (limits_.has_limits(pivot)) rest -= std::round(rest[pivot] / motion[pivot]) * motion;
      }
      bool is_same = true;
      for (int i = pivot_of(block, level + 1); i < block.first + block.count; ++i)
        is_same = is_same && (!limits_.has_limits(i) || std::abs(rest[i]) < 1e-6);
      if (is_same) return count;
    }
    is_full_ = true;
    return most_repeated;
  }
  static constexpr int most_repeated = 64;

  /// Returns the stretches on which a value, shifted by turns, is within its limits.
  motions::Stretches inside(int limited, double turned) const {
    motions::Stretches result;
    const double lower = limits_.lower(limited), upper = limits_.upper(limited);
    const double start = coupling().of(track_->begin.q)[limited] + turned;
    bool is_inside = start >= lower && start <= upper;
    motions::Stretch open{track_->begin.s, 0, nullptr, nullptr};
    for (std::size_t i = 0; i < record_.events(); ++i) {
      const Event& event = record_.event(i);
      if (event.track != number_ || event.limited != limited || event.kind != Event::Kind::limit) continue;
      if (!(std::abs(event.value + turned - (event.is_upper ? upper : lower)) < 1e-6)) continue;
      const bool enters = event.is_upper != event.rises;
      if (enters && !is_inside) open = {event.s, 0, &event, nullptr};
      if (!enters && is_inside) result.add({open.from, event.s, open.entry, &event});
      is_inside = enters;
    }
    if (is_inside) result.add({open.from, track_->end.s, open.entry, nullptr});
    return result;
  }

  void give(const motions::Stretches& within, const Values& turns, double representatives) const {
    for (std::size_t i = 0; i < within.count; ++i) {
      const motions::Stretch& stretch = within.rows[i];
      Motion motion;
      motion.track = number_;
      motion.turns = turns;
      motion.representatives = representatives;
      motion.begin = stretch.entry ? end_at(*stretch.entry) : track_->begin;
      motion.end = stretch.exit ? end_at(*stretch.exit) : track_->end;
      motion.begin.q += turns;
      motion.end.q += turns;
      take_(motion);
    }
  }

  static End end_at(const Event& event) {
    End end;
    end.s = event.s;
    end.cause = Cause::limit;
    end.partner = event.limited;
    end.is_upper = event.is_upper;
    end.q = event.q;
    return end;
  }

  const Record<capacity>& record_;
  LimitsOnTrack<Coupling> limits_;
  const Take& take_;
  int number_ = 0;
  const Track* track_ = nullptr;
  Joints<Coupling::values> lowest_, highest_;  ///< bounds of the values on the track
  /// Stretches of the choices of each block.
  std::array<std::array<motions::Stretches, room>, static_cast<std::size_t>(Coupling::values)> room_;
  int visited_ = 0;
  mutable bool is_full_ = false;
};

}  // namespace qvgen::path
