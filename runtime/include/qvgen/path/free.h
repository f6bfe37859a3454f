// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <qvgen/inverse/nearest.h>
#include <qvgen/inverse/solutions.h>

/// A path that leaves one coordinate free, a turn about a tool axis or a joint of seven: which value to give
/// it along the path. All solutions on a grid of values at every sample are the nodes of a graph; the motion
/// with the least cost is found by dynamic programming, smoothed by small changes of the values, and followed
/// between the samples, so that what is returned is continuous.
namespace qvgen::path {

/// Values that the free coordinate may have, rad or m.
struct FreeRange {
  double lower = 0, upper = 0;
  bool is_circle = false;  ///< lower and upper are the same
  int count = 72;          ///< of values that are tried at each sample
  int farthest = 3;        ///< values that it may go on from one sample to the next

  [[nodiscard]] double step() const { return (upper - lower) / (is_circle ? count : std::max(1, count - 1)); }
  [[nodiscard]] double value(int i) const { return lower + i * step(); }
};

/// Weights of what a motion costs.
struct FreeCosts {
  double travel = 1;     ///< squares of joints' ways between samples
  double turning = 0.1;  ///< squares of the free coordinate's changes
  double limits =
      0.02;  ///< nearness of limits: 1 where a joint is on one, falling with the square of the room
  double preferred = 0;    ///< squares of distances from the preferred joints
  double longest_way = 1;  ///< rad or m: a joint does not go farther from one sample to the next
};

/// One sample of a motion that was found.
template <int dof>
struct FreePlace {
  double value = 0;  ///< of the free coordinate, continuous along the path
  int branch = -1;
  Joints<dof> q = Joints<dof>::Zero();
};

/// `solve(sample, value)` returns all solutions at a sample, from 0, fractions between, with a value of the
/// free coordinate: qvgen::Solutions<dof, capacity>.
template <int dof, int capacity, class Solve>
class FreeSearch {
 public:
  using Kinds = JointKinds<dof>;
  using Place = FreePlace<dof>;

  /// A node of the graph. The caller has samples x count x capacity places for what they remember.
  struct Node {
    Joints<dof> q;
    double cost;
    int branch;
  };
  struct Room {
    Node* nodes;         ///< 2 x count x capacity
    int* sizes;          ///< 2 x count
    std::int32_t* from;  ///< samples x count x capacity
  };

  FreeSearch(const Solve& solve, const FreeRange& range, const JointLimits<dof>& limits,
             const Kinds& revolute, const FreeCosts& costs = {})
      : solve_(solve), range_(range), limits_(limits), revolute_(revolute), costs_(costs) {}

  Joints<dof> preferred = Joints<dof>::Zero();

  /// Finds the best motion; returns how many samples from the first one it follows, all of them if it can.
  std::size_t search(std::size_t samples, const Room& room, Place* places) {
    room_ = room;
    std::size_t reached = 0;
    int best = -1;
    for (std::size_t i = 0; i < samples; ++i) {
      const int last = extend(i);
      if (last < 0) break;
      best = last;
      reached = i + 1;
    }
    if (reached > 0) trace_back(reached, best, places);
    return reached;
  }

  /// Moves values to where the motion costs less, in sweeps along the path.
  void smooth(std::size_t count, Place* places, int sweeps = 20) const {
    double change = 0.5 * range_.step();
    for (int sweep = 0; sweep < sweeps; ++sweep, change *= 0.8)
      for (std::size_t k = 0; k < count; ++k)
        improve(count, places, sweep % 2 == 0 ? k : count - 1 - k, change);
  }

  /// Follows the motion between the samples; returns the first place that a continuous motion does not reach,
  /// or the last sample.
  [[nodiscard]] double follow(std::size_t count, const Place* places) const {
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const double reached = follow_piece(static_cast<double>(i), places[i], places[i + 1]);
      if (reached < static_cast<double>(i + 1)) return reached;
    }
    return static_cast<double>(count - 1);
  }

  /// Way of each joint; within limits that leave it one representative there is no way around.
  [[nodiscard]] Joints<dof> way(const Joints<dof>& from, const Joints<dof>& to) const {
    Joints<dof> off = to - from;
    for (int i = 0; i < dof; ++i) {
      const bool turns = revolute_[static_cast<std::size_t>(i)];
      if (turns && !(limits_.upper[i] - limits_.lower[i] < inverse::whole_turn))
        off[i] = without_turns(off[i]);
    }
    return off;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] int width() const { return range_.count * capacity; }

  /// Brings a row within limits; false if it is outside.
  [[nodiscard]] bool bring_inside(Joints<dof>& q) const {
    for (int i = 0; i < dof; ++i) {
      if (revolute_[static_cast<std::size_t>(i)] && std::isfinite(limits_.upper[i] - limits_.lower[i])) {
        const double middle = 0.5 * (limits_.lower[i] + limits_.upper[i]);
        q[i] = middle + without_turns(q[i] - middle);
      }
      if (q[i] < limits_.lower[i] || q[i] > limits_.upper[i]) return false;
    }
    return true;
  }

  /// Cost of a place by itself.
  [[nodiscard]] double cost_of(const Joints<dof>& q) const {
    double sum = costs_.preferred > 0 ? costs_.preferred * way(preferred, q).squaredNorm() : 0;
    for (int i = 0; i < dof; ++i) {
      const double half = 0.5 * (limits_.upper[i] - limits_.lower[i]);
      if (!std::isfinite(half) || half <= 0) continue;
      const double room = std::min(q[i] - limits_.lower[i], limits_.upper[i] - q[i]) / half;
      sum += costs_.limits / (1 + 100 * room * room);
    }
    return sum;
  }

  [[nodiscard]] double cost_between(const Joints<dof>& a, const Joints<dof>& b, double turn) const {
    const Joints<dof> off = way(a, b);
    if (off.cwiseAbs().maxCoeff() > costs_.longest_way) return infinity;
    return costs_.travel * off.squaredNorm() + costs_.turning * turn * turn;
  }

  /// All nodes of a sample, each with the best way to it; returns the best of them, -1 without.
  int extend(std::size_t sample) {
    Node* const here = room_.nodes + (sample % 2) * index(width());
    int* const sizes = room_.sizes + (sample % 2) * index(range_.count);
    int best = -1;
    for (int value = 0; value < range_.count; ++value) {
      sizes[value] = 0;
      for (const auto& row : solve_(static_cast<double>(sample), range_.value(value))) {
        const int place = value * capacity + sizes[value]++;
        Node& node = here[place] = {row.q, 0, row.branch};
        const bool is_inside = bring_inside(node.q);
        const int from = sample == 0 ? 0 : is_inside ? best_before(sample, value, node) : -1;
        node.cost = is_inside && from >= 0 ? node.cost + cost_of(node.q) : infinity;
        room_.from[sample * index(width()) + index(place)] = from;
        if (node.cost < infinity && (best < 0 || node.cost < here[best].cost)) best = place;
      }
    }
    return best;
  }

  /// Finds the node of the sample before from which one is reached with the least cost, and adds that.
  int best_before(std::size_t sample, int value, Node& node) const {
    const Node* const before = room_.nodes + ((sample + 1) % 2) * index(width());
    const int* const sizes = room_.sizes + ((sample + 1) % 2) * index(range_.count);
    int best = -1;
    double least = infinity;
    for (int turn = -range_.farthest; turn <= range_.farthest; ++turn) {
      int other = value - turn;
      if (range_.is_circle) other = (other + range_.count) % range_.count;
      if (other < 0 || other >= range_.count) continue;
      for (int k = 0; k < sizes[other]; ++k) {
        const Node& from = before[other * capacity + k];
        if (from.branch != node.branch && !are_near(from.q, node.q)) continue;
        const double cost = from.cost + cost_between(from.q, node.q, turn * range_.step());
        if (cost < least) {
          least = cost;
          best = other * capacity + k;
        }
      }
    }
    node.cost = least;
    return best;
  }

  [[nodiscard]] bool are_near(const Joints<dof>& a, const Joints<dof>& b) const {
    return way(a, b).cwiseAbs().maxCoeff() < 0.5 * costs_.longest_way;
  }

  /// Writes the values and joints of the way to a node; joints are solved again, which spares keeping them.
  void trace_back(std::size_t reached, int node, Place* places) const {
    for (std::size_t i = reached; i-- > 0;) {
      places[i].value = range_.value(node / capacity);
      take_row(static_cast<double>(i), node, places[i]);
      node = room_.from[i * index(width()) + index(node)];
    }
    for (std::size_t i = 1; range_.is_circle && i < reached; ++i)
      places[i].value = places[i - 1].value + without_turns(places[i].value - places[i - 1].value);
  }

  void take_row(double sample, int node, Place& place) const {
    const auto found = solve_(sample, range_.value(node / capacity));
    place.q = found[node % capacity].q;
    place.branch = found[node % capacity].branch;
    static_cast<void>(bring_inside(place.q));
  }

  [[nodiscard]] double cost_at(std::size_t count, const Place* places, std::size_t k,
                               const Place& place) const {
    double sum = cost_of(place.q);
    if (k > 0) sum += cost_between(places[k - 1].q, place.q, place.value - places[k - 1].value);
    if (k + 1 < count) sum += cost_between(place.q, places[k + 1].q, places[k + 1].value - place.value);
    return sum;
  }

  /// Tries other values at one sample: between its neighbours', and a little more and less.
  void improve(std::size_t count, Place* places, std::size_t k, double change) const {
    const double before = places[k > 0 ? k - 1 : k].value, behind = places[k + 1 < count ? k + 1 : k].value;
    double least = cost_at(count, places, k, places[k]);
    const double own = places[k].value;
    for (const double value : {0.5 * (before + behind), own - change, own + change}) {
      Place other;
      if (!is_allowed(value) || !nearest_row(static_cast<double>(k), value, places[k], other)) continue;
      const double cost = cost_at(count, places, k, other);
      if (!(cost < least)) continue;
      least = cost;
      places[k] = other;
    }
  }

  [[nodiscard]] bool is_allowed(double value) const {
    return range_.is_circle || (value >= range_.lower && value <= range_.upper);
  }

  /// Finds the row next to a place, for another sample or value; false if there is none that surely belongs
  /// to it.
  bool nearest_row(double sample, double value, const Place& place, Place& next) const {
    double first = infinity, second = infinity;
    for (const auto& row : solve_(sample, value)) {
      Joints<dof> q = row.q;
      if (!bring_inside(q)) continue;
      const Joints<dof> off = way(place.q, q);
      const double away = off.cwiseAbs().maxCoeff();
      second = std::min(second, std::max(first, away));
      if (!(away < first)) continue;
      first = away;
      next = {value, row.branch, place.q + off};
    }
    return first <= 0.25 * second && first <= 0.5 * costs_.longest_way;
  }

  /// In steps that are halved until each belongs to the one before. Returns where the last one was.
  [[nodiscard]] double follow_piece(double start, const Place& a, const Place& b) const {
    constexpr double shortest = 1e-7, sure = 0.05;
    Place here = a;
    double u = 0;
    for (double step = 1; u < 1;) {
      const double to = std::min(1.0, u + step);
      Place next;
      const bool is_there = nearest_row(start + to, a.value + to * (b.value - a.value), here, next);
      if (is_there && way(here.q, next.q).cwiseAbs().maxCoeff() < sure) {
        here = next;
        u = to;
        step *= 2;
      } else if ((step *= 0.5) < shortest) {
        return start + u;
      }
    }
    return way(here.q, b.q).cwiseAbs().maxCoeff() < 1e-6 ? start + 1 : start + u * (1 - shortest);
  }

  const Solve& solve_;
  FreeRange range_;
  JointLimits<dof> limits_;
  Kinds revolute_;
  FreeCosts costs_;
  Room room_{};
};

}  // namespace qvgen::path
