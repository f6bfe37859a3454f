// SPDX-License-Identifier: MIT
#include "careful.h"

#include <qvgen/inverse/nearby.h>

#include "goal.h"

namespace qvgen::inverse::elimination {
namespace {

// Tolerances of rows: distances are roots of the sums of squares of cosines' and sines' differences.

/// A start that leads here has seen the row: steps end short of double roots by the root of half the digits.
constexpr double seen_row = 1e-3;
/// Rows no farther apart may be one, if what lies between them reaches the pose.
constexpr double far_rows = 1e-2;
/// So often values are taken down a valley before they are given up.
constexpr int most_turns_in_valleys = 2;
/// Lanes do not tell nearer rows apart: half the digits, with the rounding of an elimination.
constexpr double lane_rounding = 3e-7;
/// Steps in lanes end so near to a row: they are not as patient.
constexpr double lane_miss = 1e-5;
/// A miss, as a share of the size, of a start that nearly reached the pose: it may have missed a continuum.
constexpr double stray_miss = 1e-4;
/// How much an idle joint moves the tool at a row that is singular to rounding, as a share of the size.
constexpr double exactly_idle = 1e-12;
/// Likewise at a row where three solutions meet, which is known to a third of the digits.
constexpr double idle_of_three = 1e-10;
/// A step along a curve of solutions, which is brought back to the pose; so many are a whole turn of two
/// joints.
constexpr double longest_walk = 0.8;
constexpr int most_walks = 12;
/// A walk ends at the row, but for what a flat curve leaves.
constexpr double walk_ends = 1e-2;
/// Poses nearby are so much farther off than those of closed forms: eliminations carry fewer digits.
constexpr double farther = 30;

Triple<double> triple_of(const Vector3<double>& v) { return {v[0], v[1], v[2]}; }

Vector3<double> point_of(const Motion& motion, const Vector3<double>& x) {
  Vector3<double> result;
  for (int i = 0; i < 3; ++i)
    result[i] = motion.rotation[3 * i] * x[0] + motion.rotation[3 * i + 1] * x[1] +
                motion.rotation[3 * i + 2] * x[2] + motion.translation[i];
  return result;
}

}  // namespace

Task matching(const Setup& setup, const Pose<double>& pose) {
  const double size = setup.chain.size;
  Task task;
  task.size_square = size * size;
  for (std::size_t j = 0; j < joints; ++j) task.arm[j] = setup.description.axes[j];
  const Pose<double> goal = pose.normalised();
  for (int p = 0; p < 3; ++p) {
    const Vector3<double> point =
        p == 0 ? Vector3<double>(0, 0, 0) : Vector3<double>(size * Vector3<double>::Unit(p - 1));
    task.start[static_cast<std::size_t>(p)] = triple_of(point_of(setup.description.tool, point));
    task.goal[static_cast<std::size_t>(p)] = triple_of(goal * point);
  }
  return task;
}

bool is_singular(const Task& task, const Values& values) {
  using Newton = polishing::Newton<double, joints, 3>;
  return Newton::idle(Newton(task).reached(values)).least < joints;
}

Values seed_of(const Setup& setup, const Preference<joints>& preference) {
  Values seed;
  for (std::size_t j = 0; j < joints; ++j)
    seed[j] = setup.chain.slides[j] ? Rotor<double>{preference.slide[j], 0} : preference.turn[j];
  return seed;
}

bool is_settled(const Setup& setup, const Pose<double>& pose, const Gathered& found) {
  if (found.doubtful || found.rows > most_solutions) return false;
  if (!found.has_twins) return true;
  const Task task = matching(setup, pose);
  return std::none_of(found.row, found.row + found.rows,
                      [&](const JointPairs& row) { return is_singular(task, values_of(row)); });
}

Careful::Careful(const Setup& setup, const Pose<double>& pose, double tolerance,
                 const Preference<joints>& preference, const Pass& pass)
    : setup_(setup),
      pose_(pose),
      task_(matching(setup, pose)),
      tolerance_(tolerance),
      boundary_(Boundary::ends(tolerance)),
      seed_(seed_of(setup, preference)),
      seeded_(preference.seeded),
      pass_(pass),
      tracker_(setup.eliminations[0].pair == Pair::slides ? most_of_slides : most) {
  tracker_.never_hold_idle();  // valleys are searched
}

/// Those that are set up, then the further ones; null if enough have been asked for.
const Elimination* Careful::next_elimination() {
  if (eliminations_ == most_eliminations) return nullptr;
  if (eliminations_ < setup_.count) return &setup_.eliminations[eliminations_++];
  while (further_ < setup_.further.count) {
    const Choice& choice = setup_.further.choice[further_++];
    if (!elimination::eliminate(setup_.chain, choice.backwards, choice.shift, set_up_here_)) continue;
    ++eliminations_;
    return &set_up_here_;
  }
  return nullptr;
}

void Careful::eliminate(const Elimination& elimination, const Pose<double>& pose, Gathered& gathered) const {
  pass_.eliminate(setup_.chain, elimination, goal_of(setup_.chain, pose), tolerance_, gathered);
}

Pose<double> Careful::nearby(int k) const { return displaced(pose_, farther * setup_.chain.size, k).pose; }

void Careful::settle(const JointPairs& start) {
  full_ = full_ || size_ == most_solutions;
  effort_.used_up = effort_.used_up || starts_ == most_starts;
  if (starts_ == most_starts || size_ == most_solutions) return;
  const int label = starts_++;
  Values values = values_of(start);
  Branch<double> branch;
  branch.unsure = true;
  const auto settles = [&] {
    return tracker_.settle(label, task_, boundary_, seeded_ ? &seed_ : nullptr, values, branch);
  };
  bool found = settles();
  for (int turn = 0; turn < most_turns_in_valleys && !found; ++turn) {
    const bool missed = tracker_.state(label) == BranchState::missed && !has_row_near(values, seen_row);
    if (!missed || !goes_down_valley(values)) break;
    found = settles();
  }
  if (found) {
    if (!branch.continuum || !is_on_known_continuum(values))
      rows_[size_++] = {values, branch.continuum, true};
    return;
  }
  for (int i = 0; i < size_; ++i)
    if (distance_square(rows_[i].values, values) < seen_row * seen_row) rows_[i].seen = true;
  if (tracker_.state(label) != BranchState::missed) return;
  add_stray(values);
  const double error = polishing::Newton<double, joints, 3>(task_).reached(values).error;
  strays_ = strays_ || error < stray_miss * stray_miss * task_.size_square;
}

void Careful::settle(const Gathered& gathered) {
  for (int i = 0; i < gathered.rows; ++i)
    if (!was_looked_beside(gathered.row[i], lane_rounding)) settle(gathered.row[i]);
  for (int i = 0; i < gathered.starts; ++i) {
    const Start& start = gathered.start[i];
    if (!start.leads || !was_looked_beside(start.solution, lane_miss)) settle(start.values);
  }
}

/// True if a start converges to a row that starts have reached twice before: the second time it was looked
/// beside the row, so it leads to nothing else.
bool Careful::was_looked_beside(const JointPairs& led_to, double near) {
  const Values solution = values_of(led_to);
  for (int i = 0; i < size_; ++i) {
    Row& row = rows_[i];
    if (!(distance_square(row.values, solution) < near * near)) continue;
    if (row.beside) return row.seen = true;
    row.beside = true;
    return false;
  }
  return false;
}

/// From joint values that reach a pose nearby.
void Careful::settle_nearby(Gathered& gathered) {
  pass_.lead(setup_.chain, goal_of(setup_.chain, pose_), gathered.rows, gathered.row);
  settle(gathered);
}

/// True if a curve of solutions leads from one row to another: it is followed in steps, each brought back to
/// the pose.
bool Careful::leads_to(Values values, const Values& goal) {
  const double way = std::sqrt(distance_square(values, goal));
  const double share = std::max(tolerance_, default_tolerance);
  for (int left = std::min(most_walks, 1 + static_cast<int>(way / longest_walk)); left > 0; --left) {
    const Values before = values;
    for (std::size_t j = 0; j < joints; ++j) {
      values[j].cosine += (goal[j].cosine - values[j].cosine) / left;
      values[j].sine += (goal[j].sine - values[j].sine) / left;
    }
    Reached<double, joints, 3> there;
    if (!polish(task_, {share, 2}, values, there, walks_)) return false;
    if (distance_square(before, values) > 4 * longest_walk * longest_walk) return false;
  }
  return distance_square(values, goal) < walk_ends * walk_ends;
}

/// The nearest first: the way there is the shortest.
bool Careful::is_on_known_continuum(const Values& values) {
  const Row* order[most_solutions];
  int count = 0;
  for (int i = 0; i < size_; ++i)
    if (rows_[i].continuum) order[count++] = &rows_[i];
  std::sort(order, order + count, [&](const Row* a, const Row* b) {
    return distance_square(a->values, values) < distance_square(b->values, values);
  });
  return std::any_of(order, order + count, [&](const Row* row) { return leads_to(values, row->values); });
}

bool Careful::is_singular(const Row& row) const {
  return row.continuum || elimination::is_singular(task_, row.values);
}

/// Rows that are hardly told apart are certain only where none is singular.
bool Careful::leaves_doubt(const Gathered& found) const {
  return found.doubtful || (found.has_twins && any_is_singular());
}

bool Careful::any_is_singular() const {
  return std::any_of(rows_, rows_ + size_, [this](const Row& row) { return is_singular(row); });
}

/// True if a row is singular to rounding, and on no continuum, as between right angles. Others like it may
/// meet in one place of all polynomials, and be lost by every elimination: a pose nearby tells them apart.
bool Careful::any_is_exactly_singular() {
  using Newton = polishing::Newton<double, joints, 3>;
  return std::any_of(rows_, rows_ + size_, [&](const Row& row) {
    if (row.continuum) return false;
    const auto idle = Newton::idle(Newton(task_).reached(row.values));
    if (idle.least == joints) return false;
    const double share = idle.square / task_.size_square;
    return share < exactly_idle * exactly_idle ||
           (share < idle_of_three * idle_of_three && three_meet_in(row, idle.least));
  });
}

/// Solutions over the complex numbers come in pairs but for the real ones, of which those where two meet
/// count twice: whether their number leaves room for doubt.
bool Careful::is_even() const { return any_is_singular() || size_ % 2 == 0; }

/// True if what lies between two rows reaches the pose, too, to what rows may miss it by.
bool Careful::are_one(const Row& a, const Row& b) {
  if (distance_square(a.values, b.values) > far_rows * far_rows) return false;
  Values place = place_between(a.values, b.values);
  normalise(task_, place);
  const polishing::Newton<double, joints, 3> newton(task_);
  const auto idle = polishing::Newton<double, joints, 3>::idle(newton.reached(place));
  if (idle.least == joints) return false;
  Budget few{0, 6};
  Reached<double, joints, 3> there;
  const double share = std::max(tolerance_, default_tolerance);
  return polish(task_, {share}, place, there, few, idle.is);
}

/// Near a place where two solutions meet many joint values reach the pose to rounding: one of them stays.
void Careful::merge() {
  for (int i = 0; i < size_; ++i)
    for (int k = i + 1; k < size_; ++k) {
      if (!are_one(rows_[i], rows_[k])) continue;
      rows_[i].continuum = rows_[i].continuum || rows_[k].continuum;
      rows_[i].beside = rows_[i].beside || rows_[k].beside;
      rows_[k--] = rows_[--size_];
    }
}

void Careful::look_here(const Elimination& elimination, Gathered& gathered) {
  eliminate(elimination, pose_, gathered);
  ++effort_.passes;
}

void Careful::take_rows(const Gathered& found) {
  for (int i = 0; i < found.rows; ++i) rows_[size_++] = {values_of(found.row[i]), false, true};
}

void Careful::run(const Gathered& first) {
  if (setup_.eliminations[0].pair == Pair::slides) {
    settle(first);
    merge();
    agree_on_slides(first);
  } else {
    Gathered second;
    for (int i = 0; i < first.rows; ++i) second.add_row(first.row[i]);
    const Elimination* elimination = next_elimination();
    if (elimination != nullptr) look_here(*elimination, second);
    if (second.met == second.rows && elimination != nullptr && is_settled(setup_, pose_, second))
      return take_rows(second);
    settle(first);
    merge();
    agree(first, elimination != nullptr ? &second : nullptr);
  }
  look_along_crossings();
  const Effort& spent = tracker_.budget().spent;
  effort_.steps = spent.steps + walks_.spent.steps + valleys_.spent.steps;
  // Regular rows of that number are all that there can be.
  effort_.used_up = effort_.used_up || spent.used_up || (full_ && any_is_singular());
}

/// Settles the rows at the pose itself: says if the elimination has added nothing, and if it leaves no doubt.
Careful::Outcome Careful::settle_here(const Gathered& found) {
  const int before = size_;
  settle(found);
  merge();
  return {size_ == before, leaves_doubt(found), found.loud};
}

/// Eliminates at a pose nearby. Solutions that share an angle here, as they do between right angles, do not
/// share it there.
Careful::Outcome Careful::pass_nearby(const Elimination& elimination, const Pose<double>& pose) {
  Gathered found;
  eliminate(elimination, pose, found);
  const int before = size_;
  for (int i = 0; i < size_; ++i) rows_[i].seen = false;
  settle_nearby(found);
  merge();
  ++effort_.passes;
  // Poses near one at which two solutions meet may have none of them.
  const bool all_seen =
      std::all_of(rows_, rows_ + size_, [this](const Row& row) { return row.seen || is_singular(row); });
  return {size_ == before, leaves_doubt(found) || !all_seen, found.loud};
}

}  // namespace qvgen::inverse::elimination
