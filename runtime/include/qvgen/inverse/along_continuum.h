// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/continuum.h>
#include <qvgen/inverse/joint_limits.h>
#include <qvgen/inverse/straight.h>
#include <qvgen/inverse/whole_arm.h>

/// Within limits at and near singular poses.
///
/// The row that stands for a continuum may be outside while others of the continuum are inside. From the row
/// the continuum is followed, both ways, until all joints are inside or it ends or closes:
///
///     tangent    the most idle joint goes on, the others make up for it (Newton::following); scaled so that
///     the
///                fastest joint has speed 1
///     window     how far to go on, or back, for all joints to be inside if the continuum were straight: if
///     that is
///                near, go there, as often as it takes
///     step       else on by `longest`, since the continuum bends
///     correct    Newton's steps of the others, that joint held
///
/// Near a singular pose the pose says little of some joints, and a joint on its limit may be found outside,
/// by more than rounding. Where what is outside stays on its limit while the others are corrected, the pose
/// may still be reached, to rounding: that row is as good, and inside.
namespace qvgen::inverse {

template <int dof, int points>
class AlongContinuum {
 public:
  /// Budget for following one row in either direction.
  static constexpr Budget most{0, 400};

  AlongContinuum(const ArmAtZero<dof>& arm, const Pose<double>& pose, const JointLimits<dof>& limits)
      : task_(matching<points>(arm, pose)), limits_(limits) {}

  /// Moves a row of what may be a continuum to a place where all joints are inside, but for whole turns and
  /// rounding. Returns false, and leaves the row, if none has been found.
  bool bring_inside(Joints<dof>& q, bool is_marked, Effort& effort) {
    Budget ahead = most, back = most;
    Place start;
    bool found = press(q, near, ahead);
    if (!found && begin(q, is_marked, start, ahead)) {
      found = follow(1, start, q, ahead) || follow(-1, start, q, back);
      if (!found && are_two_free(start)) found = gather(q, effort);
    }
    effort.steps += ahead.spent.steps + back.spent.steps;
    return found;
  }

  /// Brings a row inside limits that it exceeds by rounding alone, at a pose that is not near a singular one.
  bool bring_back(Joints<dof>& q, Effort& effort) {
    Budget budget = most;
    const bool found = press(q, rounding, budget);
    effort.steps += budget.spent.steps;
    return found;
  }

  /// True if a row has been left of which others on its surface may be inside.
  [[nodiscard]] bool has_left_surface() const { return left_surface_; }

 private:
  static constexpr auto joints = static_cast<std::size_t>(dof);
  static constexpr double longest = 0.1;    ///< rad, or a share of the arm's size
  static constexpr double near = 1e-3;      ///< rad or m outside, from where a joint may be put on its limit
  static constexpr double rounding = 1e-7;  ///< rad or m outside where nothing is nearly singular
  /// Patience with the pose: the pose is off its continuum by rounding, and limits may move it by as much.
  static constexpr Patience patience{limit_tolerance, 3, 0.5};
  using Values = JointValues<double, joints>;
  using Newton = polishing::Newton<double, joints, static_cast<std::size_t>(points)>;
  using At = Reached<double, joints, static_cast<std::size_t>(points)>;
  using Way = polishing::Vector<double, joints>;

  /// Puts the joints that are outside on their limits and holds them there while the others are corrected.
  bool press(Joints<dof>& q, double most_outside, Budget& budget) {
    Joints<dof> pressed = q;
    Held<joints> held{};
    for (int round = 0; round < dof; ++round) {
      for (int i = 0; i < dof; ++i) {
        const double off = outside(i, pressed[i]);
        if (off == 0) continue;
        if (!(std::abs(off) <= most_outside)) return false;
        pressed[i] -= off;
        held[static_cast<std::size_t>(i)] = true;
      }
      Values values = values_of(pressed);
      At at;
      if (!polish(task_, patience, values, at, budget, held)) return false;
      pressed = joints_of(values);
      if (!is_inside(pressed)) continue;
      q = pressed;
      return true;
    }
    return false;
  }

  /// A place on the continuum, and where it goes on from there.
  struct Place {
    Values values;
    At at;
    Way way{};
    std::size_t lead = joints;  ///< the joint that the others follow
  };

  /// Finds where a row's continuum begins to lead. Returns false if it leads nowhere: a row that is not
  /// marked may be one of two solutions that nearly meet.
  bool begin(const Joints<dof>& q, bool is_marked, Place& start, Budget& budget) {
    start.values = values_of(q);
    if (!polish(task_, patience, start.values, start.at, budget) || !look(1, start)) return false;
    return is_marked || is_idle(start.at, start.way, tolerance::off_continuum);
  }

  /// True if the pose leaves two joints, not one: its rows are then a surface, of which the walk sees a line.
  [[nodiscard]] static bool are_two_free(const Place& place) {
    const auto idle = Newton::idle(place.at);
    return std::count(idle.is.begin(), idle.is.end(), true) > 1;
  }

  /// Searches a surface of rows: by turns onto it and back inside the limits, from the row and from the
  /// limits' middle. Where that leads nowhere there may still be something.
  bool gather(Joints<dof>& q, Effort& effort) {
    Joints<dof> middle = q;
    for (int i = 0; i < dof; ++i)
      if (std::isfinite(limits_.lower[i]) && std::isfinite(limits_.upper[i]))
        middle[i] = 0.5 * (limits_.lower[i] + limits_.upper[i]);
    for (const Joints<dof>& start : {middle, Joints<dof>(q)}) {
      Budget budget = most;
      const bool found = gather_from(start, q, budget);
      effort.steps += budget.spent.steps;
      if (found) return true;
    }
    left_surface_ = true;
    return false;
  }
  bool gather_from(Joints<dof> place, Joints<dof>& q, Budget& budget) {
    constexpr int most_turns = 40;
    for (int k = 0; k < most_turns; ++k) {
      for (int i = 0; i < dof; ++i) place[i] -= outside(i, place[i]);
      Values values = values_of(place);
      At at;
      if (!polish(task_, patience, values, at, budget)) return false;
      place = joints_of(values);
      if (!is_inside(place) && !press(place, near, budget)) continue;
      q = place;
      return true;
    }
    return false;
  }

  /// In one direction. A budget that is used up ends the walk.
  bool follow(double direction, const Place& start, Joints<dof>& q, Budget& budget) {
    Place place = start;
    for (double& each : place.way) each *= direction;
    for (double gone = 0; gone < 4 * whole_turn; gone += longest) {
      if (enter(place, q, budget)) return true;
      if (gone > 1 && distance_square(place.values, start.values) < longest * longest) return false;
      if (!go(longest, place, budget)) return false;
    }
    return false;
  }

  /// Goes to where all joints are inside, if that is near.
  bool enter(Place place, Joints<dof>& q, Budget& budget) {
    constexpr int most_steps = 6;
    for (int k = 0; k < most_steps; ++k) {
      Joints<dof> now = joints_of(place.values);
      if (is_inside(now) || press(now, near, budget)) {
        q = now;
        return true;
      }
      double from = -longest, to = longest;
      narrow(now, place.way, from, to);
      if (!(from <= to)) return false;
      const double nearest = std::min(std::max(0.0, from), to);
      if (!go(to - from < 1e-3 ? (from + to) / 2 : nearest, place, budget)) return false;
    }
    return false;
  }

  /// So far along the tangent, and back onto the continuum.
  bool go(double by, Place& place, Budget& budget) {
    for (std::size_t i = 0; i < joints; ++i) newton_.advance(i, by * place.way[i], place.values);
    Held<joints> held{};
    held[place.lead] = true;
    return polish(task_, patience, place.values, place.at, budget, held) && look(1, place);
  }

  /// Which way the continuum leads. Where two cross the walk goes on, by the joint that has led so far. False
  /// if nothing is idle.
  bool look(double direction, Place& place) const {
    const auto idle = Newton::idle(place.at);
    if (idle.least == joints) return false;
    Way way = tangent(place.at, idle.least, place.way, direction);
    const bool turns_off = place.lead != joints && alignment(way, place.way) < 0.7;
    if (turns_off) {
      const Way onward = tangent(place.at, place.lead, place.way, direction);
      if (is_idle(place.at, onward, tolerance::idle) &&
          alignment(onward, place.way) > alignment(way, place.way)) {
        place.way = onward;
        return true;
      }
    }
    place.way = way;
    place.lead = idle.least;
    return true;
  }

  /// Cosine of the angle between two ways.
  static double alignment(const Way& a, const Way& b) {
    double product = 0, square_a = 0, square_b = 0;
    for (std::size_t i = 0; i < joints; ++i) {
      product += a[i] * b[i];
      square_a += a[i] * a[i];
      square_b += b[i] * b[i];
    }
    return product / std::sqrt(square_a * square_b);
  }

  /// True if joints that go so move the points next to nothing, as a share of the size.
  [[nodiscard]] bool is_idle(const At& at, const Way& way, double next_to_nothing) const {
    double square = 0;
    for (std::size_t k = 0; k < rows_by_points(static_cast<std::size_t>(points)); ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < joints; ++i) sum += way[i] * at.jacobian[i][k];
      square += sum * sum;
    }
    return square <= next_to_nothing * next_to_nothing * task_.size_square;
  }

  /// The direction in which the walk goes on, the fastest joint with speed 1.
  [[nodiscard]] Way tangent(const At& at, std::size_t idle, const Way& before, double direction) const {
    Way way = newton_.following(at, idle, 1);
    double fastest = 0, along = 0;
    for (std::size_t i = 0; i < joints; ++i) {
      fastest = std::max(fastest, std::abs(way[i]) / unit(i));
      along += way[i] * before[i];
    }
    const double scale = (along == 0 ? direction : along < 0 ? -1 : 1) / fastest;
    for (double& each : way) each *= scale;
    return way;
  }

  /// Length of a slide's step where an angle's step is one radian.
  [[nodiscard]] double unit(std::size_t i) const {
    return task_.arm[i].revolute ? 1 : std::sqrt(task_.size_square);
  }

  /// How far a joint is above its limits, or below, negative; 0 inside.
  [[nodiscard]] double outside(int i, double q) const {
    const double lower = limits_.lower[i], upper = limits_.upper[i];
    if (!task_.arm[static_cast<std::size_t>(i)].revolute)
      return q > upper ? q - upper : q < lower ? q - lower : 0;
    if (!(upper - lower < whole_turn)) return 0;
    const double off = without_turns(q - 0.5 * (lower + upper)), half = 0.5 * (upper - lower);
    return off > half ? off - half : off < -half ? off + half : 0;
  }

  [[nodiscard]] bool is_inside(const Joints<dof>& q) const {
    for (int i = 0; i < dof; ++i)
      if (std::abs(outside(i, q[i])) > 0.9 * limit_tolerance) return false;
    return true;
  }

  /// How far to go along a tangent for all joints to be inside.
  void narrow(const Joints<dof>& q, const Way& way, double& from, double& to) const {
    for (int i = 0; i < dof; ++i) {
      const auto joint = static_cast<std::size_t>(i);
      double lower = limits_.lower[i] - q[i], upper = limits_.upper[i] - q[i];
      if (task_.arm[joint].revolute) {
        if (!(upper - lower < whole_turn)) continue;
        const double half = 0.5 * (upper - lower), middle = without_turns(0.5 * (lower + upper));
        lower = middle - half;
        upper = middle + half;
      }
      const double speed = way[joint];
      if (std::abs(speed) < 1e-9) {
        if (lower > near || upper < -near) to = -std::numeric_limits<double>::infinity();
        continue;
      }
      from = std::max(from, (speed > 0 ? lower : upper) / speed);
      to = std::min(to, (speed > 0 ? upper : lower) / speed);
    }
  }

  [[nodiscard]] Values values_of(const Joints<dof>& q) const {
    Values values;
    for (std::size_t i = 0; i < joints; ++i) {
      const double value = q[static_cast<int>(i)];
      values[i] =
          task_.arm[i].revolute ? Rotor<double>{std::cos(value), std::sin(value)} : Rotor<double>{value, 0};
    }
    return values;
  }
  [[nodiscard]] Joints<dof> joints_of(const Values& values) const {
    Joints<dof> q;
    for (std::size_t i = 0; i < joints; ++i)
      q[static_cast<int>(i)] =
          task_.arm[i].revolute ? output_angle(values[i].cosine, values[i].sine) : values[i].cosine;
    return q;
  }

  ArmMatching<dof, points> task_;
  Newton newton_{task_};
  JointLimits<dof> limits_;
  bool left_surface_ = false;
};

/// Moves the rows that are outside limits and that the pose leaves free, or nearly so, to where they are
/// inside. Where none is, but the pose leaves two joints free, the set is incomplete.
template <int points, int dof, int capacity, std::size_t count>
void bring_inside(const ArmAtZero<dof>& arm, const Pose<double>& pose, const JointLimits<dof>& limits,
                  const std::array<bool, count>& revolute, Solutions<dof, capacity>& found) {
  const Within<dof> within(limits, revolute, Joints<dof>::Zero());
  const Straight<dof> straight(arm);
  AlongContinuum<dof, points> along(arm, pose, limits);
  const bool is_near_singular = found.effort.passes > 0;
  bool is_any_inside = false;
  for (Solution<dof>& row : found) {
    Joints<dof> q = row.q;
    const bool is_free = is_near_singular || row.continuum || straight.holds(row.q);
    const bool is_inside = within.take(q) || (is_free ? along.bring_inside(row.q, row.continuum, found.effort)
                                                      : along.bring_back(row.q, found.effort));
    is_any_inside = is_any_inside || is_inside;
  }
  if (is_any_inside || !along.has_left_surface()) return;
  found.effort.used_up = true;
  found.status = Status::incomplete;
}

/// Brings the rows of an arm with a given joint inside the limits; the given joint keeps its value.
template <int points, int dof, int capacity, std::size_t count>
void bring_inside(const ArmAtZero<dof>& arm, const Pose<double>& pose, int given, double value,
                  const JointLimits<dof>& limits, const std::array<bool, count>& revolute,
                  Solutions<dof, capacity>& found) {
  JointLimits<dof - 1> others;
  std::array<bool, count - 1> kinds;
  for (int i = 0; i < dof - 1; ++i) {
    const int joint = i < given ? i : i + 1;
    others.lower[i] = limits.lower[joint];
    others.upper[i] = limits.upper[joint];
    kinds[static_cast<std::size_t>(i)] = revolute[static_cast<std::size_t>(joint)];
  }
  Solutions<dof - 1, capacity> rest;
  for (const Solution<dof>& row : found) {
    Joints<dof - 1> q;
    for (int i = 0; i < dof - 1; ++i) q[i] = row.q[i < given ? i : i + 1];
    append(rest, q, row.branch, row.continuum);
  }
  rest.effort = found.effort;
  bring_inside<points>(without_joint(arm, given, value), pose, others, kinds, rest);
  found.effort = rest.effort;
  if (rest.status == Status::incomplete) found.status = rest.status;
  for (int k = 0; k < found.size(); ++k)
    for (int i = 0; i < dof - 1; ++i) found[k].q[i < given ? i : i + 1] = rest[k].q[i];
}

/// Rows within limits, of all solutions: `choose(found)`. Where that leaves none, or the pose is near a
/// singular one, `bring(found)` moves what is free before.
template <int dof, int capacity, class Choose, class Bring>
auto chosen_within(Solutions<dof, capacity>&& found, const Choose& choose, const Bring& bring) {
  const bool is_regular = found.status == Status::solved && found.effort.passes == 0;
  if (!is_regular) bring(found);
  auto rows = choose(found);
  if (!rows.empty() || found.empty() || !is_regular) return rows;
  bring(found);
  rows = choose(found);
  return rows;
}

}  // namespace qvgen::inverse
