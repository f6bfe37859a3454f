// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <qvgen/path/free.h>

/// The best motion that is found where a path leaves coordinates free (free.h). First the path as it was
/// asked for; then a coarse grid over all coordinates at once, and a finer one if that does not go all the
/// way. The best of these is improved: dynamic programming over narrow grids around it, three coordinates at
/// a time, each time half as wide, then small changes of each value. No step is kept that makes the motion
/// dearer or ends it earlier. What comes out is the best near to the best of the grid: another motion may
/// cost less.
namespace qvgen::path {

/// Bounds of what a search tries.
struct FreeBudget {
  double points = 400;      ///< of several coordinates together, at one sample; four times for a finer grid,
  double all_points = 4e6;  ///< and at all of them; but 27 at each
  double nodes = 5e8;       ///< that are remembered: 1 GB
  double edges = 4e8;       ///< above it one coordinate changes at a time from sample to sample
  int attempts = 2;         ///< grids, each finer than the one before
};

/// Sets how many values of each coordinate are tried, so that all of them together stay within the budget.
inline void set_counts(FreeSpace& space, double most) {
  const auto points = [&] {
    double product = 1;
    for (int i = 0; i < space.size; ++i) product *= space[i].count;
    return product;
  };
  for (int i = 0; i < space.size; ++i)
    if (!(space[i].upper > space[i].lower)) space[i].count = 1;
  while (points() > most) {
    int largest = 0;
    for (int i = 1; i < space.size; ++i)
      if (space[i].count >= space[largest].count) largest = i;
    int& count = space[largest].count;
    if (count == 1) return;
    count = count > 8 ? count - count / 8 : std::max(1, count - 2);
  }
}

template <int dof>
struct FreeTask {
  std::size_t samples = 0;
  FreeSpace space;
  FreeCosts costs;
  JointLimits<dof> limits;
  Joints<dof> preferred = Joints<dof>::Zero();
  FreeBudget budget;
};

template <int dof, int capacity, class Solve>
class FreeBest {
 public:
  using Search = FreeSearch<dof, capacity, Solve>;
  using Places = std::vector<FreePlace<dof>>;

  /// A motion, from the first sample on.
  struct Motion {
    Places places;
    double followed = -1;  ///< path coordinate up to which it is continuous; -1: not even the first sample
    double cost = std::numeric_limits<double>::infinity();  ///< if it goes all the way
  };

  FreeBest(const Solve& solve, const FreeTask<dof>& task, const JointKinds<dof>& revolute)
      : solve_(solve), task_(task), revolute_(revolute) {}

  Motion run() {
    best_ = searched(task_.space.fixed(), task_.costs.longest_way);
    FreeSpace space = task_.space;
    double longest = task_.costs.longest_way;
    for (int i = 0; i < task_.budget.attempts; ++i, longest *= 0.5) {
      set_counts(space, most_points(i));
      const bool is_alone = product(space) <= 1;
      if (!is_alone) keep(searched(space, longest));
      if (is_alone || is_whole(best_)) break;
      for (int k = 0; k < space.size; ++k) space[k].count = 2 * space[k].count - 1;
    }
    if (!best_.places.empty()) improve(steps_of(space));
    return best_;
  }

 private:
  static constexpr int levels = 4, rounds = 2, together = 3;

  [[nodiscard]] double most_points(int attempt) const {
    const auto samples = static_cast<double>(task_.samples);
    const double most = task_.budget.nodes / (samples * capacity);
    if (task_.space.size == 1) return most;
    return std::min({most, task_.budget.points * std::pow(4, attempt),
                     std::max(27.0, task_.budget.all_points / samples)});
  }
  static double product(const FreeSpace& space) {
    double points = 1;
    for (int i = 0; i < space.size; ++i) points *= space[i].count;
    return points;
  }
  [[nodiscard]] bool is_whole(const Motion& motion) const {
    return motion.followed >= static_cast<double>(task_.samples) - 1;
  }

  [[nodiscard]] FreeValues steps_of(const FreeSpace& space) const {
    FreeValues steps(space.size);
    for (int i = 0; i < space.size; ++i)
      steps[i] = space[i].count > 1 ? space[i].step() : 0.5 * (space[i].upper - space[i].lower);
    return steps;
  }

  [[nodiscard]] Search search_with(double longest) const {
    FreeCosts costs = task_.costs;
    costs.longest_way = longest;
    Search search(solve_, task_.space, task_.limits, revolute_, costs);
    search.preferred = task_.preferred;
    return search;
  }

  /// Finds the best motion on a grid over all coordinates.
  Motion searched(const FreeSpace& space, double longest) {
    FreeGrid grid(space);
    const double edges = static_cast<double>(task_.samples) * grid.points() * grid.moves() * capacity;
    if (edges > task_.budget.edges) grid = FreeGrid(space, 1);
    Search search = search_with(longest);
    return searched(search, grid, nullptr);
  }

  Motion searched(Search& search, const FreeGrid& grid, const FreePlace<dof>* around) {
    const auto points = static_cast<std::size_t>(grid.points()), width = points * capacity;
    nodes_.resize(2 * width);
    sizes_.resize(2 * points);
    values_.resize(2 * points);
    from_.resize(task_.samples * width);
    Motion motion;
    motion.places.resize(around == nullptr ? task_.samples : best_.places.size());
    const std::size_t reached = search.search(motion.places.size(), grid,
                                              {nodes_.data(), sizes_.data(), values_.data(), from_.data()},
                                              motion.places.data(), around);
    motion.places.resize(reached);
    finish(search, motion);
    return motion;
  }

  /// Brings whole turns in order, and follows the motion between the samples.
  void finish(const Search& search, Motion& motion) const {
    Places& places = motion.places;
    places.resize(search.settle_turns(places.size(), places.data()));
    if (places.empty()) return;
    motion.followed = search.follow(places.size(), places.data());
    motion.cost = search.cost(places.size(), places.data());
  }

  /// Keeps a motion that goes farther than the best one, or as far at less cost.
  bool keep(Motion motion) {
    const bool is_better = motion.followed > best_.followed ||
                           (motion.followed == best_.followed &&
                            motion.places.size() == best_.places.size() && motion.cost < best_.cost);
    if (is_better) best_ = std::move(motion);
    return is_better;
  }

  void improve(FreeValues steps) {
    Search search = search_with(task_.costs.longest_way);
    for (int level = 0; level < levels; ++level) {
      steps *= 0.5;
      for (int round = 0; round < rounds && narrow(search, steps); ++round) {
      }
    }
    Motion smooth = best_;
    search.smooth(smooth.places.size(), smooth.places.data(), 2 * steps);
    finish(search, smooth);
    keep(std::move(smooth));
  }

  /// Searches around the best motion; true if that has become better by some share.
  bool narrow(Search& search, const FreeValues& steps) {
    const double before = best_.cost;
    for (int first = 0; first < task_.space.size; first += together) {
      middle_.clear();
      for (const auto& place : best_.places) middle_.push_back(place.values);
      const FreeGrid grid(task_.space, middle_.data(), steps, first, together);
      const Places around = best_.places;
      keep(searched(search, grid, around.data()));
    }
    return best_.cost < 0.99 * before;
  }

  const Solve& solve_;
  const FreeTask<dof>& task_;
  JointKinds<dof> revolute_;
  Motion best_;
  std::vector<typename Search::Node> nodes_;
  std::vector<int> sizes_;
  std::vector<FreeValues> values_;
  std::vector<std::uint16_t> from_;
  std::vector<FreeValues> middle_;  ///< values of the best motion
};

}  // namespace qvgen::path
