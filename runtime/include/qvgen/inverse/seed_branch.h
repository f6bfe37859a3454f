// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <qvgen/inverse/budget.h>
#include <qvgen/inverse/continuum.h>
#include <qvgen/inverse/seed.h>
#include <qvgen/inverse/wrist.h>

/// One solution: the branch of a seed. Of every equation's solutions the one whose joints are nearer to the
/// seed's is followed; where rounding would decide, Newton steps from there and from the seed itself do.
namespace qvgen::inverse {

/// Squared distance of a joint's value from the seed's: of an angle that of the pairs, near zero its square.
inline double apart(const Rotor<double>& value, const Rotor<double>& seed) {
  const double x = value.cosine - seed.cosine;
  const double y = value.sine - seed.sine;
  return x * x + y * y;
}
inline double apart(double slide, double seed) { return (slide - seed) * (slide - seed); }
inline double apart(const WristAngles<double>& angles, const WristAngles<double>& seed) {
  const double first = without_turns(angles.first - seed.first);
  const double middle = without_turns(angles.middle - seed.middle);
  const double last = without_turns(angles.last - seed.last);
  return first * first + middle * middle + last * last;
}

/// The choices between two solutions of an equation on the way along a branch.
struct Forks {
  static constexpr int most = 6;
  unsigned flipped = 0;  ///< bit i: at the i-th the farther one is taken
  int count = 0;
  double left[most] =
      {};  ///< squared distance from the seed of what was not taken, infinite if it is nothing
  int label = 0;

  /// True if two solutions meet, but for rounding: both in doubt, and as far from the seed to half the
  /// digits.
  static bool are_one(const Branch<double>& other, double other_apart, const Branch<double>& branch,
                      double apart) {
    const double difference = other_apart - apart;
    return other.unsure && branch.unsure && difference * difference <= tolerance::forks_meet * apart;
  }

  /// True if the farther of two solutions is to be taken.
  bool takes_other(const Branch<double>& other, double other_apart, const Branch<double>& branch,
                   double apart) {
    const bool is_nearer = other.exists && (!branch.exists || other_apart < apart);
    const bool is_other = is_nearer != ((flipped >> count & 1U) != 0);
    const bool has_rest =
        (is_other ? branch.exists : other.exists) && !are_one(other, other_apart, branch, apart);
    left[count++] = has_rest ? (is_other ? apart : other_apart) : std::numeric_limits<double>::infinity();
    label = 2 * label + (is_other ? 1 : 0);
    return is_other;
  }

  /// Bits of the forks at which another choice may lead nearer to the seed than `least`, a squared distance.
  [[nodiscard]] unsigned open(double least) const {
    constexpr double margin = 20 * 20;
    unsigned bits = 0;
    for (int i = 0; i < count; ++i)
      if (left[i] < margin * least) bits |= 1U << i;
    return bits;
  }
};

template <class Work>
void take_nearer(const Work& other, double other_apart, Work& work, double apart, Forks& forks) {
  if (forks.takes_other(other.branch, other_apart, work.branch, apart)) work = other;
}

/// Picks the root of a quartic that is nearest to the seed.
template <class Work>
struct NearestRoot {
  Work work;
  int index = 0;

  explicit NearestRoot(const Work& above) : work(above) { work.branch.exists = false; }
  void add(const Work& each, double its_apart, int its_index) {
    if (!each.branch.exists || (work.branch.exists && !(its_apart < apart_))) return;
    work = each;
    apart_ = its_apart;
    index = its_index;
  }

 private:
  double apart_ = 0;
};

/// Squared distance of a row from the seed; infinite if there is none.
template <int dof>
double apart(const Solutions<dof, 1>& found, const Preference<dof>& seed, const bool* revolute) {
  if (found.empty()) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (int i = 0; i < dof; ++i) {
    const double q = found[0].q[i];
    const double off = revolute[i] ? without_turns(q - seed.angle[i]) : q - seed.slide[i];
    sum += off * off;
  }
  return sum;
}

/// The nearest solution to the seed. `follow(forks, found)` is one way along the equations, each solution the
/// nearer one but where the forks say otherwise; returns whether rounding has decided nothing, as this does
/// of all ways. If what it comes to is as far from the seed as another choice would have been, or is nothing,
/// the others are followed too: where two solutions meet the nearer value of one joint may lead the others
/// far away.
template <int dof, class Follow>
bool follow_forks(const Preference<dof>& seed, const bool* revolute, const Follow& follow,
                  Solutions<dof, 1>& found) {
  Forks taken;
  bool is_sure = follow(taken, found);
  double least = apart(found, seed, revolute);
  unsigned open = taken.open(least);
  int count = taken.count;
  for (unsigned flipped = 1; flipped < 1U << count && open != 0; ++flipped) {
    if ((flipped & ~open) != 0) continue;
    Forks other;
    other.flipped = flipped;
    Solutions<dof, 1> row;
    is_sure = follow(other, row) && is_sure;
    // The first way may have ended before forks to which this one comes.
    open |= other.open(least);
    count = std::max(count, other.count);
    const double its_apart = apart(row, seed, revolute);
    if (!(its_apart < least)) continue;
    least = its_apart;
    found = row;
  }
  return is_sure;
}

/// From where Newton's steps start.
enum class Start {
  form,  ///< from where the equations lead
  held,  ///< from there, with what is idle put back to where the seed has it, and held
  seed   ///< from the seed
};

/// Polishes the one branch's joints. What the pose costs is counted.
template <typename Scalar, std::size_t joints>
class SeedTracker {
 public:
  using Values = JointValues<Scalar, joints>;

  [[nodiscard]] Budget& budget() { return budget_; }
  void start_from(Start start) { start_ = start; }

  /// False if no steps lead to the pose.
  template <std::size_t points>
  bool settle(int /*label*/, const PointMatching<Scalar, joints, points>& task, const Boundary& boundary,
              const Values* seed, Values& values, Branch<Scalar>& branch) {
    if (!branch.exists || (!branch.unsure && start_ != Start::form)) return false;
    if (!branch.unsure) {
      normalise(task, values);
      return true;
    }
    const Idling<Scalar, joints, points> idling(task, budget_);
    Reached<Scalar, joints, points> reached;
    const Patience patience{boundary.miss};
    if (start_ == Start::seed) {
      values = *seed;
      if (moves_without_idle(task, patience, values, reached)) {
        branch.continuum = branch.continuum || idling.is_continuum(values, reached);
        return true;
      }
      values = *seed;
    }
    if (!leads_to_goal(idling, task, patience, values, reached)) return false;
    if (start_ == Start::held && !holds(task, patience, *seed, values, reached)) return false;
    branch.continuum = branch.continuum || idling.is_continuum(values, reached);
    return true;
  }

 private:
  template <std::size_t points>
  bool leads_to_goal(const Idling<Scalar, joints, points>& idling,
                     const PointMatching<Scalar, joints, points>& task, const Patience& patience,
                     Values& values, Reached<Scalar, joints, points>& reached) {
    const auto is_known = [](const Values&) { return false; };
    return polish(task, patience, values, reached, budget_) ||
           idling.leave_double_root(patience, is_known, values, reached);
  }

  /// True if Newton from the seed converges with the idle joints held.
  template <std::size_t points>
  bool moves_without_idle(const PointMatching<Scalar, joints, points>& task, const Patience& patience,
                          Values& values, Reached<Scalar, joints, points>& reached) {
    using Newton = polishing::Newton<Scalar, joints, points>;
    if (!budget_.step()) return false;
    const auto idle = Newton::idle(Newton(task).reached(values));
    return idle.least != joints && polish(task, patience, values, reached, budget_, idle.is);
  }

  /// True if the joints that are idle can be where the seed has them.
  template <std::size_t points>
  bool holds(const PointMatching<Scalar, joints, points>& task, const Patience& patience, const Values& seed,
             Values& values, Reached<Scalar, joints, points>& reached) {
    const auto idle = polishing::Newton<Scalar, joints, points>::idle(reached);
    if (idle.least == joints) return false;
    for (std::size_t i = 0; i < joints; ++i)
      if (idle.is[i]) values[i] = seed[i];
    return polish(task, patience, values, reached, budget_, idle.is);
  }

  Start start_ = Start::form;
  Budget budget_ = near_effort;
};

/// True if a row of the equations alone, which leave free joints where the seed has them, is so near to the
/// seed that no other needs to be asked for: 10 mrad.
template <int dof>
bool is_by_seed(const Solutions<dof, 1>& found, const Preference<dof>& seed, const bool* revolute) {
  return apart(found, seed, revolute) < tolerance::by_seed;
}

/// True if a row that Newton's steps have found is so near to the seed that no other is needed. The steps may
/// have moved it along a continuum, so it has to be within 2 mrad.
template <int dof>
bool is_next_to(const Solutions<dof, 1>& found, const Preference<dof>& seed, const bool* revolute) {
  return is_by_seed(found, seed, revolute) &&
         (!found[0].continuum || apart(found, seed, revolute) < tolerance::by_seed_on_continuum);
}

/// Follows the seed's branch near a singular pose by `follow(start, goal, tracker, forks, found)`. Of several
/// starts the one counts that comes nearest to the seed: what is nearly free is held at the seed or, if the
/// other joints cannot follow, where the equations put it.
template <int dof, class Target, class Tracker, class Follow>
void follow_forks_carefully(Target goal, Tracker tracker, const bool* revolute, const Follow& follow,
                            Solutions<dof, 1>& found) {
  const Preference<dof>& seed = *goal.preference;
  for (const Boundary& boundary : {Boundary::chosen(goal.tolerance), Boundary::ends(goal.tolerance)}) {
    goal.boundary = boundary;
    const Target begin = goal;
    for (const Start start : {Start::form, Start::held}) {
      if (!tracker.budget().pass()) break;
      tracker.start_from(start);
      const auto one = [&](Forks& forks, Solutions<dof, 1>& row) {
        follow(begin, goal, tracker, forks, row);
        return true;
      };
      Solutions<dof, 1> row;
      follow_forks(seed, revolute, one, row);
      if (apart(row, seed, revolute) < apart(found, seed, revolute)) found = row;
      if (is_next_to(found, seed, revolute)) break;
    }
    if (!found.empty()) break;
  }
  found.effort = tracker.budget().spent;
  // One solution is all that was asked for.
  if (!found.empty()) found.effort.used_up = false;
}

/// The first of all solutions, which stand by their distance from the seed, or why there is none.
template <int dof, int capacity>
void take_nearest(const Solutions<dof, capacity>& all, Solutions<dof, 1>& found) {
  found.effort.passes += all.effort.passes;
  found.effort.steps += all.effort.steps;
  found.effort.used_up = all.empty() && all.effort.used_up;
  if (!all.empty()) found.append() = all[0];
  found.conclude();
  if (all.empty()) found.status = all.status;
}

/// Whole turns added until each angle is within half a turn of the seed's.
template <int dof, std::size_t count>
void unwind(Solutions<dof, 1>& found, const Eigen::Matrix<double, dof, 1>& seed,
            const std::array<bool, count>& revolute) {
  for (Solution<dof>& row : found)
    for (int i = 0; i < dof; ++i)
      if (revolute[static_cast<std::size_t>(i)]) row.q[i] = seed[i] + without_turns(row.q[i] - seed[i]);
}

/// Returns the row of all solutions that is nearest to the seed, with the seed's whole turns, if
/// `follow_forks` leads to it, too; else none. Joints in pairs, for vectors of two.
template <int dof, int capacity, std::size_t count>
Solutions<dof, 1> nearest_of_all(const Solutions<dof, capacity>& all,
                                 const Eigen::Matrix<double, dof, 1>& seed,
                                 const std::array<bool, count>& revolute) {
  using Row = Eigen::Array<double, (dof + 1) / 2 * 2, 1>;
  Row per_turn = Row::Zero(), off = Row::Zero();
  for (int i = 0; i < dof; ++i)
    per_turn[i] = revolute[static_cast<std::size_t>(i)] ? 1 / constant::whole_turn : 0;
  Solutions<dof, 1> nearest;
  const Solution<dof>* best = nullptr;
  double least = tolerance::nearest_by_forks;
  for (const Solution<dof>& row : all) {
    off.template head<dof>() = row.q.array() - seed.array();
    const double square = (off - constant::whole_turn * nearest_whole(off * per_turn)).square().sum();
    best = square < least ? &row : best;
    least = square < least ? square : least;
  }
  if (best == nullptr) return nearest;
  nearest.append() = *best;
  nearest.conclude();
  unwind(nearest, seed, revolute);
  return nearest;
}

/// True if a row is within limits as it stands, but for rounding; true if there is no row.
template <int dof>
bool is_near_within(const Solutions<dof, 1>& nearest, const JointLimits<dof>& limits) {
  return nearest.empty() || ((nearest[0].q.array() >= limits.lower.array()).all() &&
                             (nearest[0].q.array() <= limits.upper.array()).all());
}

/// Puts a row that is outside limits by rounding on them, and drops one that is outside by more.
template <int dof>
void keep_near_within(const JointLimits<dof>& limits, Solutions<dof, 1>& nearest) {
  if (nearest.empty()) return;
  const Joints<dof> q = nearest[0].q;
  nearest[0].q = q.cwiseMax(limits.lower).cwiseMin(limits.upper);
  const bool is_inside = (limits.lower.array() <= limits.upper.array()).all() &&
                         (nearest[0].q - q).cwiseAbs().maxCoeff() <= limit_tolerance;
  if (is_inside) return;
  nearest.clear();
  nearest.status = Status::unreachable;
}

}  // namespace qvgen::inverse
