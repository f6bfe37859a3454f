// SPDX-License-Identifier: MIT
#include <cmath>

#include <qvgen/inverse/certified/complete.h>

#include "goals.h"
#include "node.h"
#include "reduction.h"

namespace qvgen::inverse::certified {
namespace {

using Values = std::array<double, joints>;

constexpr double whole_turn = 0x1.921fb54442d18p+2;

/// A part of the stretch, and the joints of all motions at its ends.
struct Part {
  int first, last;  ///< ways
  double from, to;  ///< on the first one, on the last one
  std::vector<Values> begin, end;

  [[nodiscard]] double start() const { return first + from; }
  [[nodiscard]] double goal() const { return last + to; }
};

TubeEnd end_of(double u, const Values& q) {
  TubeEnd end{u, {}};
  std::copy(q.begin(), q.end(), end.q);
  return end;
}

/// Returns the middle of joint values, and how far they are from it at most.
Centre centre_of(const std::array<Interval, joints>& range) {
  Centre centre{};
  for (std::size_t k = 0; k < joints; ++k) {
    centre.q[k] = range[k].middle();
    centre.within = std::max(centre.within, (range[k] - Interval(centre.q[k])).magnitude());
  }
  return centre;
}

double width_of(const Loop& loop) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    most = std::max(most, loop.goal_place[i].width());
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, loop.goal.at[i][k].width());
  }
  return most;
}

class Search {
 public:
  Search(const Arm& arm, const Stretch& stretch, const MotionTable& motions, const OtherSolver& solver,
         const CompleteEffort& effort, Completeness& result)
      : arm_(arm), stretch_(stretch), motions_(motions), solver_(solver), effort_(effort), result_(result) {}

  void run() {
    Part all{0, stretch_.count - 1, stretch_.from, stretch_.to, {}, {}};
    for (int i = 0; i < motions_.count; ++i) {
      all.begin.push_back(sample(i, 0));
      all.end.push_back(sample(i, stretch_.count));
    }
    const Loop loop = loop_of(all);
    choice_ = best_choice(loop, centres_of(all));
    if (choice_ < 0) return add_gap(all);
    const Equations equations(reduced(loop, choice_));
    prove(all, {all_angles(equations.unknowns())}, effort_.parts);
  }

 private:
  static constexpr double shortest = 1e-7;  ///< of a part of one way

  [[nodiscard]] Values sample(int motion, int place) const {
    Values q;
    std::copy(motions_.q[motion][place], motions_.q[motion][place] + joints, q.begin());
    return q;
  }

  /// The loop whose goal is all poses of a part.
  [[nodiscard]] Loop loop_of(const Part& part) const {
    Loop all = Goals(arm_, stretch_.ways[part.first]).to(part.from, part.last == part.first ? part.to : 1);
    for (int i = part.first + 1; i <= part.last; ++i) {
      const Loop next = Goals(arm_, stretch_.ways[i]).to(0, i == part.last ? part.to : 1);
      include_goal(all, next.goal, next.goal_place);
    }
    return all;
  }

  /// Proves a motion way by way, and encloses its joints; false if some of it is not proven.
  bool enclose(const Part& part, std::size_t motion, std::array<Interval, joints>& range) const {
    constexpr int most_tried = 60;
    for (int i = part.first; i <= part.last; ++i) {
      const bool starts = i == part.first, ends = i == part.last;
      const Values from = starts ? part.begin[motion] : sample(static_cast<int>(motion), i),
                   to = ends ? part.end[motion] : sample(static_cast<int>(motion), i + 1);
      const TubeProof tube = prove_tube(arm_, stretch_.ways[i], end_of(starts ? part.from : 0, from),
                                        end_of(ends ? part.to : 1, to), most_tried);
      if (!tube.is_proven()) return false;
      for (std::size_t k = 0; k < joints; ++k)
        range[k] = starts ? tube.range[k] : hull(range[k], tube.range[k]);
    }
    return true;
  }

  /// Those motions that are proven on a part.
  [[nodiscard]] std::vector<Centre> centres_of(const Part& part) const {
    std::vector<Centre> centres;
    for (std::size_t i = 0; i < part.begin.size(); ++i) add_centre(part, i, centres);
    return centres;
  }
  void add_centre(const Part& part, std::size_t motion, std::vector<Centre>& centres) const {
    std::array<Interval, joints> range;
    if (enclose(part, motion, range)) centres.push_back(centre_of(range));
  }

  /// Regions of the motions that have one which holds all of their joints.
  static std::vector<Region> regions_of(const Equations& equations, const std::vector<Centre>& centres) {
    std::vector<Region> regions;
    for (const Centre& centre : centres) {
      const Region region = equations.region_around(centre.q);
      if (region.radius > centre.within) regions.push_back(region);
    }
    return regions;
  }

  /// Regions of those motions that are next to some box.
  [[nodiscard]] std::vector<Region> regions_next_to(const std::vector<Box>& boxes, const Part& part,
                                                    const Equations& equations) const {
    std::vector<Centre> centres;
    for (std::size_t i = 0; i < part.begin.size(); ++i) {
      const auto is_near = [&](const Box& box) {
        return is_next_to(box, equations, part.begin[i]) || is_next_to(box, equations, part.end[i]);
      };
      if (std::any_of(boxes.begin(), boxes.end(), is_near)) add_centre(part, i, centres);
    }
    return regions_of(equations, centres);
  }
  static bool is_next_to(const Box& box, const Equations& equations, const Values& q) {
    constexpr double near = 0.2;
    for (int k = 0; k < equations.unknowns(); ++k) {
      const double off = q[static_cast<std::size_t>(equations.joint(k))] - box.angle[k].middle();
      if (std::abs(std::remainder(off, whole_turn)) > 0.5 * box.angle[k].width() + near) return false;
    }
    return true;
  }

  /// The reduction with the most and largest regions; -1 if there is none.
  [[nodiscard]] int best_choice(const Loop& loop, const std::vector<Centre>& centres) const {
    int best = -1;
    double most = -1;
    for (int choice = 0; choice < choices(loop); ++choice) {
      const Equations equations(reduced(loop, choice));
      if (equations.unknowns() == 0) continue;
      double sum = 0;
      for (const Region& region : regions_of(equations, centres)) sum += 1 + region.radius;
      if (sum > most) {
        most = sum;
        best = choice;
      }
    }
    return best;
  }

  /// Proves a part, of which those boxes are open; ends when so many parts in all have been looked at.
  void prove(const Part& part, const std::vector<Box>& boxes, long most) {
    if (result_.has_other) return add_gap(part);
    const Loop loop = loop_of(part);
    const Equations equations(reduced(loop, choice_));
    const double narrowest = effort_.share * width_of(loop);
    ++result_.parts;
    const std::vector<Box> left = uncovered(equations, regions_next_to(boxes, part, equations), boxes,
                                            std::max(narrowest, 1e-7), effort_.boxes, result_.boxes);
    if (left.empty()) return;
    if (find_other(part) || result_.boxes >= effort_.boxes || result_.parts + 1 >= most) return add_gap(part);
    divide(part, left, most);
  }

  void divide(const Part& part, const std::vector<Box>& boxes, long most) {
    Part first = part, second = part;
    if (part.first < part.last) {
      const int middle = (part.first + part.last + 1) / 2;
      first.last = middle - 1;
      first.to = 1;
      second.first = middle;
      second.from = 0;
      for (std::size_t i = 0; i < part.begin.size(); ++i)
        first.end[i] = second.begin[i] = sample(static_cast<int>(i), middle);
    } else {
      const double middle = 0.5 * (part.from + part.to);
      if (part.to - part.from < shortest) return add_gap(part);
      first.to = second.from = middle;
      Goals goals(arm_, stretch_.ways[part.first]);
      const Loop& loop = goals.at(middle);
      for (std::size_t i = 0; i < part.begin.size(); ++i)
        first.end[i] = second.begin[i] = solved(loop, part.begin[i], part.end[i]);
    }
    prove(first, boxes, (result_.parts + most) / 2);
    prove(second, boxes, most);
  }

  /// Joints between two, at the pose in the middle if Newton finds it.
  static Values solved(const Loop& loop, const Values& from, const Values& to) {
    double q[joints];
    for (std::size_t k = 0; k < joints; ++k) q[k] = 0.5 * (from[k] + to[k]);
    settle(loop, q);
    Values result;
    std::copy(q, q + joints, result.begin());
    return result;
  }

  /// Looks for a solution in the middle of a short part that is on none of the motions.
  bool find_other(const Part& part) {
    if (part.first < part.last || solver_.solve == nullptr) return false;
    const double s = 0.5 * (part.start() + part.goal());
    double rows[most_rows][joints];
    const int count = solver_.solve(solver_.context, s, rows);
    for (int i = 0; i < count; ++i) {
      if (is_on_a_motion(part, rows[i])) continue;
      result_.has_other = true;
      result_.other = s;
      std::copy(rows[i], rows[i] + joints, result_.other_q);
      return true;
    }
    return false;
  }

  /// True if joints are near to a motion's, farther from its ends than these are from each other.
  bool is_on_a_motion(const Part& part, const double (&q)[joints]) const {
    for (std::size_t i = 0; i < part.begin.size(); ++i) {
      double way = 1e-4, off = 0;
      for (std::size_t k = 0; k < joints; ++k) {
        const double middle = 0.5 * (part.begin[i][k] + part.end[i][k]);
        way = std::max(way, std::abs(part.end[i][k] - part.begin[i][k]));
        const double away = q[k] - middle;
        off = std::max(off, std::abs(arm_.joints[k].revolute ? std::remainder(away, whole_turn) : away));
      }
      if (off <= way) return true;
    }
    return false;
  }

  /// Neighbours are one; the last gap takes what there is no room for.
  void add_gap(const Part& part) {
    auto& gaps = result_.gaps;
    const bool joins = result_.gap_count > 0 &&
                       (gaps[result_.gap_count - 1].to == part.start() || result_.gap_count == gaps.size());
    if (joins)
      gaps[result_.gap_count - 1].to = part.goal();
    else
      gaps[result_.gap_count++] = {part.start(), part.goal()};
  }

  const Arm& arm_;
  const Stretch& stretch_;
  const MotionTable& motions_;
  const OtherSolver& solver_;
  CompleteEffort effort_;
  Completeness& result_;
  int choice_ = -1;
};

bool is_moderate(const Arm& arm, const Stretch& stretch) {
  for (int i = 0; i < stretch.count; ++i)
    if (!is_moderate(arm, stretch.ways[i])) return false;
  return stretch.count > 0;
}

}  // namespace

Completeness prove_complete(const Arm& arm, const Stretch& stretch, const MotionTable& motions,
                            const OtherSolver& solver, const CompleteEffort& effort) {
  Completeness result;
  if (motions.count <= most_rows && is_moderate(arm, stretch))
    Search(arm, stretch, motions, solver, effort, result).run();
  else
    result.gaps[result.gap_count++] = {stretch.from, stretch.count - 1 + stretch.to};
  return result;
}

}  // namespace qvgen::inverse::certified
