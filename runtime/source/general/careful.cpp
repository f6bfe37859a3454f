// SPDX-License-Identifier: MIT
#include "careful.h"

#include <qvgen/inverse/quartic/care.h>

#include "goal.h"

namespace qvgen::inverse::general {
namespace {

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

Values seed_of(const Setup& setup, const Preference<joints>& preference) {
  Values seed;
  for (std::size_t j = 0; j < joints; ++j)
    seed[j] = setup.chain.slides[j] ? Rotor<double>{preference.slide[j], 0} : preference.turn[j];
  return seed;
}

Careful::Careful(const Setup& setup, const Pose<double>& pose, double tolerance,
                 const Preference<joints>& preference, Pass pass)
    : setup_(setup),
      pose_(pose),
      task_(matching(setup, pose)),
      tolerance_(tolerance),
      boundary_(Boundary::ends(tolerance)),
      seed_(seed_of(setup, preference)),
      seeded_(preference.seeded),
      pass_(pass) {}

/// Those that are set up, then the further ones; null if enough have been asked for.
const Elimination* Careful::next_elimination() {
  if (eliminations_ == most_eliminations) return nullptr;
  if (eliminations_ < setup_.count) return &setup_.eliminations[eliminations_++];
  while (further_ < setup_.further.count) {
    const Choice& choice = setup_.further.choice[further_++];
    if (!general::eliminate(setup_.chain, choice.backwards, choice.shift, set_up_here_)) continue;
    ++eliminations_;
    return &set_up_here_;
  }
  return nullptr;
}

void Careful::eliminate(const Elimination& elimination, const Pose<double>& pose, Gathered& gathered) const {
  pass_(setup_.chain, elimination, goal_of(setup_.chain, pose), tolerance_, gathered);
}

void Careful::settle(const JointPairs& start) {
  if (starts_ == most_starts || size_ == most_solutions) {
    effort_.used_up = true;
    return;
  }
  Values values = values_of(start);
  Branch<double> branch;
  branch.unsure = true;
  if (tracker_.settle(starts_++, task_, boundary_, seeded_ ? &seed_ : nullptr, values, branch))
    rows_[size_++] = {values, branch.continuum};
}

void Careful::settle(const Gathered& gathered) {
  for (int i = 0; i < gathered.rows; ++i) settle(gathered.row[i]);
  for (int i = 0; i < gathered.starts; ++i) settle(gathered.start[i]);
}

/// Whether two solutions meet in a row, or it is on a continuum.
bool Careful::is_singular(const Row& row) const {
  using Newton = polishing::Newton<double, joints, 3>;
  return row.continuum || Newton::idle(Newton(task_).reached(row.values)).least < joints;
}

bool Careful::any_is_singular() const {
  return std::any_of(rows_, rows_ + size_, [this](const Row& row) { return is_singular(row); });
}

/// Solutions over the complex numbers come in pairs but for the real ones, of which those where two meet
/// count twice: whether their number leaves room for doubt.
bool Careful::is_even() const { return any_is_singular() || size_ % 2 == 0; }

/// Whether what lies between two rows reaches the pose, too, to what rows may miss it by.
bool Careful::are_one(const Row& a, const Row& b) {
  constexpr double far = 1e-2;
  if (distance_square(a.values, b.values) > far * far) return false;
  Values middle;
  for (std::size_t j = 0; j < joints; ++j) {
    middle[j].cosine = (a.values[j].cosine + b.values[j].cosine) / 2;
    middle[j].sine = (a.values[j].sine + b.values[j].sine) / 2;
  }
  normalise(task_, middle);
  const polishing::Newton<double, joints, 3> newton(task_);
  const auto idle = polishing::Newton<double, joints, 3>::idle(newton.reached(middle));
  if (idle.least == joints) return false;
  Budget few{0, 6};
  Reached<double, joints, 3> there;
  const double share = std::max(tolerance_, default_tolerance);
  return polish(task_, {share}, middle, there, few, idle.is);
}

/// Near a place where two solutions meet many joint values reach the pose to rounding: one of them stays.
void Careful::merge() {
  for (int i = 0; i < size_; ++i)
    for (int k = i + 1; k < size_; ++k) {
      if (!are_one(rows_[i], rows_[k])) continue;
      rows_[i].continuum = rows_[i].continuum || rows_[k].continuum;
      rows_[k--] = rows_[--size_];
    }
}

void Careful::run(Gathered& first) {
  settle(first);
  merge();
  bool all_loud = first.loud;
  bool any_loud = first.loud;
  bool agreed = false;
  while (const Elimination* elimination = next_elimination()) {
    Gathered more;
    eliminate(*elimination, pose_, more);
    const int before = size_;
    settle(more);
    merge();
    all_loud = all_loud && more.loud;
    any_loud = any_loud || more.loud;
    ++effort_.passes;
    agreed = size_ == before;
    if (agreed && !more.doubtful && is_even()) break;
  }
  // Two eliminations may lose the same solutions.
  const bool few = setup_.count + setup_.further.count < 3;
  for (int k = 0; k < 6 && (size_ == 0 || !is_even() || (few && k < 3)); ++k) {
    constexpr double far = 30;  // times what `displaced` takes for a little
    Gathered near;
    eliminate(setup_.eliminations[0], quartic::displaced(pose_, far * setup_.chain.size, k).pose, near);
    const int before = size_;
    settle(near);
    merge();
    ++effort_.passes;
    if (few) agreed = size_ == before;
  }
  const Effort& spent = tracker_.budget().spent;
  effort_.steps = spent.steps;
  effort_.used_up = effort_.used_up || spent.used_up;
  // Trusted is what the last elimination has added nothing to, but where solutions meet only one of three.
  unsure_ = !agreed || all_loud || !is_even() || (few && any_is_singular());
  // Next to nothing at all outer angles are polynomials of poses in reach.
  const bool slides = setup_.eliminations[0].pair == Pair::slides;
  unsure_ = unsure_ || (slides && any_loud && (size_ == 0 || any_is_singular()));
}

}  // namespace qvgen::inverse::general
