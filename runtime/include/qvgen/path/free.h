// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include <qvgen/inverse/solutions.h>
#include <qvgen/path/free_space.h>

/// A path that leaves coordinates free, a turn about a tool axis, a tolerance, a joint of seven: which values
/// to give them along the path. All solutions on a grid of values at every sample are the nodes of a graph;
/// the motion with the least cost is found by dynamic programming. It can be smoothed by small changes of the
/// values, and is followed between the samples, so that what is returned is continuous.
namespace qvgen::path {

/// Weights of what a motion costs.
struct FreeCosts {
  double travel = 1;     ///< squares of joints' ways between samples
  double turning = 0.1;  ///< squares of the free coordinates' changes
  double limits =
      0.02;  ///< nearness of limits: 1 where a joint is on one, falling with the square of the room
  double preferred = 0;    ///< squares of distances from the preferred joints
  double longest_way = 1;  ///< rad or m: a joint does not go farther from one sample to the next
};

/// One sample of a motion that was found.
template <int dof>
struct FreePlace {
  FreeValues values;  ///< of the free coordinates, continuous along the path
  int branch = -1;
  Joints<dof> q = Joints<dof>::Zero();
};

/// `solve(sample, values)` returns all solutions at a sample, from 0, fractions between, with values of the
/// free coordinates: qvgen::Solutions<dof, capacity>.
template <int dof, int capacity, class Solve>
class FreeSearch {
 public:
  using Kinds = JointKinds<dof>;
  using Place = FreePlace<dof>;

  /// A node of the graph. The caller has samples x points x capacity places for what they remember.
  struct Node {
    Joints<dof> q;
    double cost;
    int branch;
  };
  struct Room {
    Node* nodes;          ///< 2 x points x capacity
    int* sizes;           ///< 2 x points
    FreeValues* values;   ///< 2 x points
    std::uint16_t* from;  ///< samples x points x capacity
  };

  FreeSearch(const Solve& solve, const FreeSpace& space, const JointLimits<dof>& limits,
             const Kinds& revolute, const FreeCosts& costs = {})
      : solve_(solve), space_(space), limits_(limits), revolute_(revolute), costs_(costs) {}

  Joints<dof> preferred = Joints<dof>::Zero();

  /// Finds the best motion on a grid; returns how many samples from the first one it follows, all of them if
  /// it can. With places `around`, joints stay near to those.
  std::size_t search(std::size_t samples, const FreeGrid& grid, const Room& room, Place* places,
                     const Place* around = nullptr) {
    grid_ = &grid;
    room_ = room;
    around_ = around;
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

  /// Moves values to where the motion costs less, in sweeps along the path; the first changes are half of
  /// these steps.
  void smooth(std::size_t count, Place* places, const FreeValues& steps, int sweeps = 20) const {
    FreeValues change = 0.5 * steps;
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

  /// Returns what a motion costs: at the samples, and from one to the next.
  [[nodiscard]] double cost(std::size_t count, const Place* places) const {
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) {
      sum += cost_of(places[k].q);
      if (k > 0) sum += cost_between(places[k - 1], places[k]);
    }
    return sum;
  }

  /// Adds whole turns to the joints so that they go on without a jump and stay within limits; returns how
  /// many places do.
  std::size_t settle_turns(std::size_t count, Place* places) const {
    for (std::size_t k = 1; k < count; ++k) places[k].q = places[k - 1].q + way(places[k - 1].q, places[k].q);
    std::size_t inside = count;
    for (int i = 0; i < dof; ++i)
      if (revolute_[index(i)]) inside = std::min(inside, settle_joint(inside, places, i));
    return inside;
  }

  /// Way of each joint; within limits that leave it one representative there is no way around.
  [[nodiscard]] Joints<dof> way(const Joints<dof>& from, const Joints<dof>& to) const {
    Joints<dof> off = to - from;
    for (int i = 0; i < dof; ++i)
      if (goes_around(i)) off[i] = without_turns(off[i]);
    return off;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static_assert(FreeGrid::most_moves * capacity <= 65536, "where a node comes from fits in 16 bits");

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] int width() const { return grid_->points() * capacity; }
  [[nodiscard]] bool goes_around(int i) const {
    return revolute_[index(i)] && !(limits_.upper[i] - limits_.lower[i] < inverse::whole_turn);
  }

  /// Adds the whole turns to one joint that bring most of the places within limits, near to the middle.
  std::size_t settle_joint(std::size_t count, Place* places, int i) const {
    if (!goes_around(i) || !std::isfinite(limits_.upper[i] - limits_.lower[i])) return count;
    double low = infinity, high = -infinity;
    std::size_t inside = 0;
    for (; inside < count; ++inside) {
      const double lowest = std::min(low, places[inside].q[i]), highest = std::max(high, places[inside].q[i]);
      if (std::ceil(turns_to(limits_.lower[i], lowest)) > std::floor(turns_to(limits_.upper[i], highest)))
        break;
      low = lowest;
      high = highest;
    }
    const double wanted =
        std::round(turns_to(0.5 * (limits_.lower[i] + limits_.upper[i]), 0.5 * (low + high)));
    const double turns = std::clamp(wanted, std::ceil(turns_to(limits_.lower[i], low)),
                                    std::floor(turns_to(limits_.upper[i], high)));
    for (std::size_t k = 0; k < count; ++k) places[k].q[i] += turns * inverse::whole_turn;
    return inside;
  }
  static double turns_to(double limit, double q) { return (limit - q) / inverse::whole_turn; }

  /// Brings a joint's value to the representative nearest to the middle of its limits.
  [[nodiscard]] double centred(double q, int i) const {
    if (!revolute_[index(i)] || !std::isfinite(limits_.upper[i] - limits_.lower[i])) return q;
    const double middle = 0.5 * (limits_.lower[i] + limits_.upper[i]);
    return middle + without_turns(q - middle);
  }

  /// Brings a row within limits; false if it is outside.
  [[nodiscard]] bool bring_inside(Joints<dof>& q) const {
    for (int i = 0; i < dof; ++i) {
      q[i] = centred(q[i], i);
      if (!(q[i] >= limits_.lower[i] && q[i] <= limits_.upper[i])) return false;
    }
    return true;
  }

  /// Cost of a place by itself.
  [[nodiscard]] double cost_of(const Joints<dof>& q) const {
    double sum = costs_.preferred > 0 ? costs_.preferred * way(preferred, q).squaredNorm() : 0;
    for (int i = 0; i < dof; ++i) {
      const double half = 0.5 * (limits_.upper[i] - limits_.lower[i]);
      if (!std::isfinite(half) || half <= 0) continue;
      const double value = goes_around(i) ? centred(q[i], i) : q[i];
      const double room = std::min(value - limits_.lower[i], limits_.upper[i] - value) / half;
      sum += costs_.limits / (1 + 100 * room * room);
    }
    return sum;
  }

  /// Cost of joints' ways; infinite if one is longer than `longest`.
  [[nodiscard]] double cost_of_way(const Joints<dof>& a, const Joints<dof>& b, double longest) const {
    double sum = 0;
    for (int i = 0; i < dof; ++i) {
      double off = b[i] - a[i];
      if (goes_around(i)) off = without_turns(off);
      if (!(std::abs(off) <= longest)) return infinity;
      sum += off * off;
    }
    return costs_.travel * sum;
  }

  [[nodiscard]] double turning(const FreeValues& from, const FreeValues& to) const {
    return costs_.turning * space_.difference(to, from).squaredNorm();
  }

  [[nodiscard]] double cost_between(const Place& a, const Place& b) const {
    return cost_of_way(a.q, b.q, costs_.longest_way) + turning(a.values, b.values);
  }

  /// All nodes of a sample, each with the best way to it; returns the best of them, -1 without.
  int extend(std::size_t sample) {
    const std::size_t points = index(grid_->points()), side = sample % 2;
    int best = -1;
    Node* const here = room_.nodes + side * index(width());
    for (int point = 0; point < grid_->points(); ++point) {
      FreeValues& values = room_.values[side * points + index(point)];
      int& size = room_.sizes[side * points + index(point)] = 0;
      values = grid_->at(sample, point);
      const auto found = solve_(static_cast<double>(sample), values);
      if (sample > 0 && found.size() > 0) see_neighbours(sample, point, values);
      for (const auto& row : found) {
        const int place = point * capacity + size++;
        Node& node = here[place] = {row.q, infinity, row.branch};
        if (is_wanted(sample, node.q)) {
          if (sample == 0)
            node.cost = 0;
          else
            room_.from[sample * index(width()) + index(place)] = best_before(sample, node);
          node.cost += cost_of(node.q);
        }
        if (node.cost < infinity && (best < 0 || node.cost < here[best].cost)) best = place;
      }
    }
    return best;
  }

  /// Brings joints within limits; false if they are outside, or far from where they should be.
  bool is_wanted(std::size_t sample, Joints<dof>& q) const {
    if (!bring_inside(q)) return false;
    return around_ == nullptr || cost_of_way(around_[sample].q, q, costs_.longest_way) < infinity;
  }

  /// Finds the points from which one is reached, and what the change of values costs.
  void see_neighbours(std::size_t sample, int point, const FreeValues& values) {
    const FreeValues* const before = room_.values + (sample + 1) % 2 * index(grid_->points());
    others_ = grid_->neighbours(point, other_.data());
    for (int k = 0; k < others_; ++k) turning_[index(k)] = turning(before[other_[index(k)]], values);
  }

  /// Finds the node of the sample before from which one is reached with the least cost, and adds that.
  /// Returns which of the neighbours it is, and which of their rows.
  std::uint16_t best_before(std::size_t sample, Node& node) const {
    const Node* const before = room_.nodes + (sample + 1) % 2 * index(width());
    const int* const sizes = room_.sizes + (sample + 1) % 2 * index(grid_->points());
    int best = 0;
    for (int m = 0; m < others_; ++m) {
      const int other = other_[index(m)];
      for (int k = 0; k < sizes[other]; ++k) {
        const Node& from = before[other * capacity + k];
        if (!(from.cost + turning_[index(m)] < node.cost)) continue;
        const double cost = from.cost + turning_[index(m)] + cost_of_way(from.q, node.q, longest(from, node));
        if (!(cost < node.cost)) continue;
        node.cost = cost;
        best = m * capacity + k;
      }
    }
    return static_cast<std::uint16_t>(best);
  }

  /// Branches may exchange their numbers at singular poses.
  [[nodiscard]] double longest(const Node& a, const Node& b) const {
    return a.branch == b.branch ? costs_.longest_way : 0.5 * costs_.longest_way;
  }

  /// Writes the values and joints of the way to a node; joints are solved again, which spares keeping them.
  void trace_back(std::size_t reached, int node, Place* places) {
    for (std::size_t i = reached; i-- > 0;) {
      places[i].values = grid_->at(i, node / capacity);
      take_row(static_cast<double>(i), node, places[i]);
      const int from = i > 0 ? room_.from[i * index(width()) + index(node)] : 0;
      grid_->neighbours(node / capacity, other_.data());
      node = other_[index(from / capacity)] * capacity + from % capacity;
    }
    for (std::size_t i = 1; i < reached; ++i)
      places[i].values = places[i - 1].values + space_.difference(places[i].values, places[i - 1].values);
  }

  void take_row(double sample, int node, Place& place) const {
    const auto found = solve_(sample, place.values);
    place.q = found[node % capacity].q;
    place.branch = found[node % capacity].branch;
    static_cast<void>(bring_inside(place.q));
  }

  [[nodiscard]] double cost_at(std::size_t count, const Place* places, std::size_t k,
                               const Place& place) const {
    double sum = cost_of(place.q);
    if (k > 0) sum += cost_between(places[k - 1], place);
    if (k + 1 < count) sum += cost_between(place, places[k + 1]);
    return sum;
  }

  /// Tries other values at one sample: between its neighbours', and a little more and less of each.
  void improve(std::size_t count, Place* places, std::size_t k, const FreeValues& change) const {
    const FreeValues own = places[k].values;
    const FreeValues &before = places[k > 0 ? k - 1 : k].values,
                     &behind = places[k + 1 < count ? k + 1 : k].values;
    double least = cost_at(count, places, k, places[k]);
    take_better(count, places, k, 0.5 * (before + behind), least);
    for (int i = 0; i < space_.size; ++i)
      for (const double by : {-change[i], change[i]}) {
        FreeValues values = places[k].values;
        values[i] = own[i] + by;
        take_better(count, places, k, space_.nearest(values), least);
      }
  }

  void take_better(std::size_t count, Place* places, std::size_t k, const FreeValues& values,
                   double& least) const {
    Place other;
    if (!nearest_row(static_cast<double>(k), values, places[k], other)) return;
    const double cost = cost_at(count, places, k, other);
    if (!(cost < least)) return;
    least = cost;
    places[k] = other;
  }

  /// Finds the row next to a place, for another sample or other values; false if there is none that surely
  /// belongs to it.
  bool nearest_row(double sample, const FreeValues& values, const Place& place, Place& next) const {
    double first = infinity, second = infinity;
    for (const auto& row : solve_(sample, values)) {
      Joints<dof> q = row.q;
      if (!bring_inside(q)) continue;
      const Joints<dof> off = way(place.q, q);
      const double away = off.cwiseAbs().maxCoeff();
      second = std::min(second, std::max(first, away));
      if (!(away < first)) continue;
      first = away;
      next = {values, row.branch, place.q + off};
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
      const FreeValues values = a.values + to * (b.values - a.values);
      const bool is_there = nearest_row(start + to, values, here, next);
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
  FreeSpace space_;
  JointLimits<dof> limits_;
  Kinds revolute_;
  FreeCosts costs_;
  const FreeGrid* grid_ = nullptr;
  const Place* around_ = nullptr;
  Room room_{};
  std::array<int, FreeGrid::most_moves> other_;       ///< points from which the present one is reached
  std::array<double, FreeGrid::most_moves> turning_;  ///< what the change of values costs
  int others_ = 0;
};

}  // namespace qvgen::path
