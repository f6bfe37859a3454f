// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include <qvgen/path/motions.h>

/// The path covered by as few motions as possible, and the samples at which to go from one to the next so
/// that the ways between them, while the tool is elsewhere, are short in all: dynamic programming over
/// samples.
namespace qvgen::path {

/// A change from one motion to the next.
struct Change {
  int motion = -1;  ///< the motion that is followed from here on
  double s = 0;     ///< where it begins to be followed
  double way = 0;  ///< farthest way of a joint to get to it, rad or m; NaN where no sample is on both motions
};

/// Motions that cover the path one after the other.
struct Chain {
  static constexpr int most = 16;
  int count = 0;  ///< of motions; 0 if the path cannot be covered, or only by more than `most`
  std::array<Change, most> changes{};
  double way = std::numeric_limits<double>::infinity();  ///< sum of the ways
};

template <int capacity, class Coupling = Uncoupled>
class Cover {
 public:
  /// `first` and `last` are places for as many whole numbers as there are motions, `best` for as many chains.
  struct Room {
    int* first;
    int* last;
    Chain* best;
    Chain* next;
  };

  Cover(const Record<capacity>& record, const Motion* motions, std::size_t count, std::size_t samples,
        const Room& room, const Coupling& coupling = {})
      : record_(record),
        motions_(motions),
        count_(count),
        samples_(samples),
        room_(room),
        coupling_(coupling) {}

  /// Returns the shortest chain of the fewest motions.
  [[nodiscard]] Chain fewest() {
    const int needed = count_steps();
    Chain result;
    if (needed == 0 || needed > Chain::most) return result;
    for (std::size_t i = 0; i < count_; ++i) {
      room_.best[i] = Chain();
      if (room_.first[i] == 1 && room_.last[i] == needed) start(room_.best[i], static_cast<int>(i));
    }
    for (int stage = 2; stage <= needed; ++stage) change(stage, needed);
    for (std::size_t i = 0; i < count_; ++i)
      if (room_.best[i].count == needed && room_.last[i] == 1 && room_.best[i].way < result.way)
        result = room_.best[i];
    return result.count > 0 ? result : without_samples(needed);
  }

 private:
  static constexpr double touching = 1e-9;

  [[nodiscard]] double end() const { return static_cast<double>(samples_ - 1); }

  static void start(Chain& chain, int motion) {
    chain.count = 1;
    chain.way = 0;
    chain.changes[0] = {motion, 0, 0};
  }

  /// Sets how many motions are needed from the path's begin through each, and from each to its end; 0 if none
  /// suffice. Returns how many cover the path.
  int count_steps() {
    for (std::size_t i = 0; i < count_; ++i) {
      room_.first[i] = motions_[i].begin.s <= touching ? 1 : 0;
      room_.last[i] = motions_[i].end.s >= end() - touching ? 1 : 0;
    }
    for (int round = 1; round < Chain::most; ++round)
      for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t k = 0; k < count_; ++k) {
          if (!leads(i, k)) continue;
          if (room_.first[i] == round && room_.first[k] == 0) room_.first[k] = round + 1;
          if (room_.last[k] == round && room_.last[i] == 0) room_.last[i] = round + 1;
        }
    int needed = 0;
    for (std::size_t i = 0; i < count_; ++i)
      if (room_.first[i] > 0 && room_.last[i] == 1 && (needed == 0 || room_.first[i] < needed))
        needed = room_.first[i];
    return needed;
  }

  /// True if one can go from one motion to another that ends later.
  [[nodiscard]] bool leads(std::size_t from, std::size_t to) const {
    return motions_[from].end.s < motions_[to].end.s && motions_[from].begin.s <= motions_[to].begin.s &&
           motions_[to].begin.s <= motions_[from].end.s + touching;
  }

  /// All chains of so many motions from those of one less.
  void change(int stage, int needed) {
    for (std::size_t k = 0; k < count_; ++k) {
      room_.next[k] = Chain();
      if (room_.first[k] > stage || room_.last[k] != needed - stage + 1) continue;
      for (std::size_t i = 0; i < count_; ++i)
        if (room_.best[i].count == stage - 1 && leads(i, k)) extend(room_.best[i], i, k, room_.next[k]);
    }
    std::swap(room_.best, room_.next);
  }

  /// The chain by the shortest change at a sample of both motions, not before the change to the first one.
  void extend(const Chain& chain, std::size_t from, std::size_t to, Chain& best) const {
    const double begin = std::max(motions_[to].begin.s, chain.changes[index(chain.count - 1)].s);
    const double end = std::min(motions_[to].end.s, motions_[from].end.s);
    for (auto i = static_cast<std::size_t>(std::ceil(begin)); static_cast<double>(i) <= end; ++i) {
      Values a, b;
      if (!record_.at(i, motions_[from].track, a) || !record_.at(i, motions_[to].track, b)) continue;
      const Values joints = a + motions_[from].turns - b - motions_[to].turns;
      const double way = coupling_.shown_way(joints).cwiseAbs().maxCoeff();
      if (chain.way + way < best.way)
        append(chain, best, {static_cast<int>(to), static_cast<double>(i), way}, chain.way + way);
    }
  }

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static void append(const Chain& chain, Chain& best, const Change& change, double way) {
    best = chain;
    best.changes[index(best.count++)] = change;
    best.way = way;
  }

  /// A chain whose changes are in the middle of what two motions have in common, where no sample is.
  [[nodiscard]] Chain without_samples(int needed) const {
    Chain chain;
    for (std::size_t i = 0; i < count_ && chain.count == 0; ++i)
      if (room_.first[i] == 1 && room_.last[i] == needed) start(chain, static_cast<int>(i));
    for (int stage = 2; chain.count == stage - 1 && stage <= needed; ++stage) {
      const auto from = index(chain.changes[index(chain.count - 1)].motion);
      for (std::size_t to = 0; to < count_; ++to) {
        if (room_.last[to] != needed - chain.count || !leads(from, to)) continue;
        const double s = 0.5 * (motions_[to].begin.s + std::min(motions_[from].end.s, motions_[to].end.s));
        const double nan = std::numeric_limits<double>::quiet_NaN();
        append(Chain(chain), chain, {static_cast<int>(to), s, nan}, nan);
        break;
      }
    }
    return chain;
  }

  const Record<capacity>& record_;
  const Motion* motions_;
  std::size_t count_, samples_;
  Room room_;
  Coupling coupling_;
};

}  // namespace qvgen::path
