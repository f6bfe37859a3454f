// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <qvgen/path/limits_on_track.h>
#include <qvgen/path/record.h>

/// Motions: tracks cut at the joint limits. A revolute joint may run along its track shifted by whole turns,
/// so one track may give several motions; those that begin and end together are one, with their number.
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

/// Cuts the tracks of a record at limits; `take` is called with each Motion. Takes 100 kB of memory.
template <int capacity, class Take>
class MotionsOf {
 public:
  MotionsOf(const Record<capacity>& record, const JointLimits<6>& limits, const JointKinds<6>& revolute,
            const Take& take)
      : record_(record), limits_(limits, revolute), take_(take) {}

  /// Returns false if there was no room for all that a track is cut into.
  bool run() {
    for (int track = 0; track < record_.tracks(); ++track) {
      number_ = track;
      track_ = &record_.track(track);
      motions::Stretches all;
      all.add({track_->begin.s, track_->end.s, nullptr, nullptr});
      visited_ = 0;
      choose(0, all, Values::Zero(), 1);
    }
    return !is_full_;
  }

 private:
  static constexpr int most_edges = 8;        ///< shifts that leave one joint's range on the way
  static constexpr int most_choices = 20000;  ///< of whole turns of all joints, for one track
  static constexpr double margin = 2e-6;      ///< rad: nearer to a limit events decide

  /// Whole turns that are added to a joint, and how many others are the same to its limits.
  struct Choice {
    double shift = 0;
    double count = 1;
  };
  struct Choices {
    std::array<Choice, 2 * most_edges + 1> rows;
    std::size_t count = 0;
  };

  /// Lists the stretches for each shift of a joint, and goes on to the next joint with each that is new.
  void choose(int joint, const motions::Stretches& within, const Values& turns, double representatives) {
    if (within.count == 0) return;
    if (joint == 6) return give(within, turns, representatives);
    const Choices choices = choices_of(joint);
    auto& stretches = room_[static_cast<std::size_t>(joint)];
    for (std::size_t i = 0; i < choices.count; ++i) {
      if (++visited_ > most_choices) is_full_ = true;
      if (visited_ > most_choices) return;
      stretches[i] = motions::common(within, inside(joint, choices.rows[i].shift));
      is_full_ = is_full_ || stretches[i].is_full;
    }
    for (std::size_t i = 0; i < choices.count; ++i) {
      Choice all{choices.rows[i].shift, 0};
      if (!gather(joint, choices, stretches, i, all)) continue;
      Values shifted = turns;
      shifted[joint] = whole_turn * all.shift;
      choose(joint + 1, stretches[i], shifted, representatives * all.count);
    }
  }

  /// Adds up the choices with the same stretches, and takes the one whose angles are nearest to zero; false
  /// if an earlier one has them too.
  template <class List>
  bool gather(int joint, const Choices& choices, const List& stretches, std::size_t i, Choice& all) const {
    for (std::size_t k = 0; k < i; ++k)
      if (motions::are_same(stretches[k], stretches[i])) return false;
    const double middle = middle_of(joint);
    for (std::size_t k = i; k < choices.count; ++k) {
      const Choice& other = choices.rows[k];
      if (!motions::are_same(stretches[k], stretches[i])) continue;
      all.count += other.count;
      if (std::abs(middle + whole_turn * other.shift) < std::abs(middle + whole_turn * all.shift))
        all.shift = other.shift;
    }
    return true;
  }

  double middle_of(int joint) const { return 0.5 * (track_->lowest[joint] + track_->highest[joint]); }

  /// Lists the shifts that bring a part of the track within limits; those that bring all of it in are one.
  Choices choices_of(int joint) const {
    Choices choices;
    if (!limits_.turns(joint) || !std::isfinite(limits_.lower(joint))) {
      choices.rows[choices.count++] = {0, 1};
      return choices;
    }
    const double lower = limits_.lower(joint), upper = limits_.upper(joint);
    const double first = std::ceil((lower - track_->highest[joint]) / whole_turn - 1e-9),
                 last = std::floor((upper - track_->lowest[joint]) / whole_turn + 1e-9),
                 first_in = std::ceil((lower + margin - track_->lowest[joint]) / whole_turn),
                 last_in = std::floor((upper - margin - track_->highest[joint]) / whole_turn);
    const bool some_in = first_in <= last_in;
    add_edge(first, some_in ? first_in - 1 : last, choices);
    if (!some_in) return choices;
    const double nearest = std::round(-middle_of(joint) / whole_turn);
    choices.rows[choices.count++] = {std::min(std::max(nearest, first_in), last_in), last_in - first_in + 1};
    add_edge(last_in + 1, last, choices);
    return choices;
  }

  void add_edge(double from, double to, Choices& choices) const {
    is_full_ = is_full_ || to - from >= most_edges;
    for (int i = 0; i < most_edges && from + i <= to; ++i) choices.rows[choices.count++] = {from + i, 1};
  }

  /// Returns the stretches on which a joint, shifted by so many turns, is within its limits.
  motions::Stretches inside(int joint, double shift) const {
    motions::Stretches result;
    const double turned = whole_turn * shift, lower = limits_.lower(joint), upper = limits_.upper(joint);
    const double start = track_->begin.q[joint] + turned;
    bool is_inside = start >= lower && start <= upper;
    motions::Stretch open{track_->begin.s, 0, nullptr, nullptr};
    for (std::size_t i = 0; i < record_.events(); ++i) {
      const Event& event = record_.event(i);
      if (event.track != number_ || event.joint != joint || event.kind != Event::Kind::limit) continue;
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
    end.partner = event.joint;
    end.is_upper = event.is_upper;
    end.q = event.q;
    return end;
  }

  const Record<capacity>& record_;
  LimitsOnTrack limits_;
  const Take& take_;
  int number_ = 0;
  const Track* track_ = nullptr;
  std::array<std::array<motions::Stretches, 2 * most_edges + 1>, 6> room_;  ///< of the joints' choices
  int visited_ = 0;
  mutable bool is_full_ = false;
};

}  // namespace qvgen::path
