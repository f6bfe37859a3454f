// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/branch_tracker.h>
#include <qvgen/inverse/elimination/solve.h>

#include "gathered.h"

namespace qvgen::inverse::elimination {

using Values = JointValues<double, joints>;
using Task = PointMatching<double, joints, 3>;

inline Values values_of(const JointPairs& pairs) {
  Values values;
  for (std::size_t j = 0; j < joints; ++j) values[j] = {pairs.cosine[j], pairs.sine[j]};
  return values;
}

inline JointPairs pairs_of(const Values& values) {
  JointPairs pairs;
  for (std::size_t j = 0; j < joints; ++j) {
    pairs.cosine[j] = values[j].cosine;
    pairs.sine[j] = values[j].sine;
  }
  return pairs;
}

/// The tool's point and two more, the arm's size away, at the zero pose and at the goal.
Task matching(const Setup& setup, const Pose<double>& pose);

/// The values that a preference has.
Values seed_of(const Setup& setup, const Preference<joints>& preference);

/// True if two solutions meet at joint values that reach the pose, or they are on a continuum.
bool is_singular(const Task& task, const Values& values);

/// True if an elimination has left nothing to be looked at more closely.
bool is_settled(const Setup& setup, const Pose<double>& pose, const Gathered& found);

/// Solves a pose at which the first elimination has left doubts. A second one often has none: most doubts are
/// of solutions that share the outer angle and nothing else. If it has, further eliminations, then poses
/// nearby; whatever they lead to is brought to the pose by Newton's steps, and solutions that a curve of
/// solutions joins are one.
class Careful {
 public:
  Careful(const Setup& setup, const Pose<double>& pose, double tolerance,
          const Preference<joints>& preference, const Pass& pass);

  void run(const Gathered& first);
  /// The rows, and whether each is on a continuum.
  struct Row {
    Values values;
    bool continuum;
    bool seen;            ///< the last pass has led to it, too
    bool beside = false;  ///< it has been led to twice, and beside it there is none
  };
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] const Row& row(int i) const { return rows_[i]; }
  [[nodiscard]] const Effort& effort() const { return effort_; }
  /// True if a solution may be missing.
  [[nodiscard]] bool is_unsure() const { return unsure_; }

 private:
  static constexpr int most_starts = 192;
  static constexpr Budget most = {8, 6000}, most_of_slides = {8, 1200};
  using Tracker = BranchTracker<double, joints, most_starts>;

  struct Agreement;
  struct Consensus;
  /// Result of a pass.
  struct Outcome {
    bool same;  ///< it has added no row
    bool doubtful, loud;
  };
  static constexpr int most_nearby = 6;

  void take_rows(const Gathered& found);
  void agree(const Gathered& first, const Gathered* second);
  void look_here(const Elimination& elimination, Gathered& gathered);
  Outcome settle_here(const Gathered& found);
  Outcome pass_nearby(const Elimination& elimination, const Pose<double>& pose);
  void agree_on_slides(const Gathered& first);
  void pass_of_slides(const Elimination& elimination, const Pose<double>& pose, bool exact,
                      Agreement& agreement);
  [[nodiscard]] Pose<double> nearby(int k) const;
  void settle(const Gathered& gathered);
  void settle(const JointPairs& start);
  void settle_nearby(Gathered& gathered);
  [[nodiscard]] bool was_looked_beside(const JointPairs& led_to, double near);
  [[nodiscard]] const Elimination* next_elimination();
  void eliminate(const Elimination& elimination, const Pose<double>& pose, Gathered& gathered) const;
  [[nodiscard]] bool is_singular(const Row& row) const;
  [[nodiscard]] bool leaves_doubt(const Gathered& found) const;
  [[nodiscard]] bool any_is_singular() const;
  [[nodiscard]] bool any_is_exactly_singular();
  struct Beside {
    bool reaches;
    Values values;
    Reached<double, joints, 3> there;
  };
  [[nodiscard]] Beside polished_beside(const Row& row, std::size_t joint, double by);
  [[nodiscard]] double miss_beside(const Row& row, std::size_t joint, double by);
  [[nodiscard]] bool three_meet_in(const Row& row, std::size_t idle_joint);
  [[nodiscard]] bool is_even() const;
  [[nodiscard]] bool leads_to(Values values, const Values& goal);
  [[nodiscard]] bool is_on_known_continuum(const Values& values);
  [[nodiscard]] bool are_one(const Row& a, const Row& b);
  void merge();
  [[nodiscard]] bool goes_on_beside(const Row& row, std::size_t joint, double by);
  void look_along_crossings();
  [[nodiscard]] bool goes_down_valley(Values& values);
  [[nodiscard]] bool goes_along_valley(const Reached<double, joints, 3>& floor, Values& values);
  void add_stray(const Values& values);
  [[nodiscard]] bool is_next_to_continuum(const Values& values);
  [[nodiscard]] bool has_row_near(const Values& values, double near) const;
  void search_valleys();
  [[nodiscard]] double way_to_search(const Row& row);
  [[nodiscard]] bool any_is_on_plain() const;
  [[nodiscard]] bool has_lonely_stray() const;
  [[nodiscard]] bool any_is_on_continuum() const;

  const Setup& setup_;
  const Pose<double>& pose_;
  Task task_;
  double tolerance_;
  Boundary boundary_;
  Values seed_;
  bool seeded_;
  const Pass& pass_;
  Tracker tracker_;
  Budget walks_{0, 10000};    ///< steps along continua
  Budget valleys_{0, 20000};  ///< steps along the floors of valleys
  int eliminations_ = 1;      ///< that have been asked for
  int further_ = 0;           ///< of the choices that were to be set up
  Elimination set_up_here_;
  int starts_ = 0;
  int size_ = 0;
  Row rows_[most_solutions];
  Effort effort_;
  static constexpr int most_strays = 8;
  int stray_count_ = 0;
  Values stray_[most_strays];           ///< starts that have ended short of the pose, next to a continuum
  bool is_searched_[most_strays] = {};  ///< a walk has come by
  bool full_ = false;                   ///< there was a start, but no room
  bool strays_ = false;                 ///< some start nearly reached the pose, but no steps led on
  bool lacks_strays_ = false;           ///< valleys may be missing among the strays
  bool unsure_ = false;
};

}  // namespace qvgen::inverse::elimination
