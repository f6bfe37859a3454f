// Which branches have led to which solution near singular poses: continuum.h and branch_tracker.h of the C++ library.

/// Solutions so far, by the values of the joints that decide.
typedef struct Known {
  int count;
  JointValues of[most_branches];
} Known;

static bool is_known(const Known* known, int joints, const JointValues* values) {
  for (int k = 0; k < known->count; ++k)
    if (are_same(joints, &known->of[k], values)) return true;
  return false;
}

/// Adds a solution. There is room: whoever adds one has looked.
static void remember(Known* known, const JointValues* values) {
  if (known->count < most_branches) known->of[known->count++] = *values;
}

static const Known nothing_known = {0, {{{{0, 0}}}}};

/// Brings values to the goals with what is idle held where the start has it. Where two singularities are next to
/// each other steps of all joints move one joint to and fro that hardly does anything, in place of another that is
/// as free. Returns whether the values reach the goals; keeps them if they are nearer.
static bool polish_with_idle_held(const PointMatching* task, Patience until, const JointValues* start,
                                  JointValues* values, Reached* at, Budget* budget) {
  if (!(at->error < tolerance_held_miss * task->size_square)) return false;
  const Dependent idle = idle_joints(task->joints, task->points, at);
  if (idle.least == task->joints) return false;
  Patience hasty = until;
  hasty.idle_steps = 1;
  JointValues held = *start;
  Reached there;
  const bool reaches = polish(task, hasty, &held, &there, budget, &idle.is);
  if (there.error < at->error) {
    *values = held;
    *at = there;
  }
  return reaches;
}

/// Leaves a place at which steps end short of the goals. Two solutions may meet there, or would meet beyond the
/// boundary of reach: to first order nothing leads on. To second order a step to either side along the idle joint
/// tells, and from there steps lead to the solutions if there are any. Returns whether they do; one that is known
/// already is not enough.
static bool leave_double_root(const PointMatching* task, Patience until, const Known* known, JointValues* values,
                              Reached* at, Budget* budget) {
  const double share = at->error / task->size_square;
  if (!(share < tolerance_double_root_miss)) return false;
  const Dependent idle = idle_joints(task->joints, task->points, at);
  if (idle.least == task->joints) return false;
  const double aside = length_of_arc(task, idle.least, sqrt(sqrt(share)));
  const JointValues meeting = *values;
  const Reached there_at = *at;
  bool found = false;
  for (int side = 1; side >= -1; side -= 2) {
    JointValues beside = meeting;
    Reached there;
    move_along(task, &there_at, idle.least, (double)side * aside, &beside);
    if (!may_step(budget)) return found;
    reach(task, &beside, &there);
    if (!(there.error < there_at.error) || !polish(task, until, &beside, &there, budget, &nothing_held))
      continue;
    *values = beside;
    *at = there;
    found = true;
    if (!is_known(known, task->joints, values)) return true;
  }
  return found;
}

/// State of a branch so far: no pass has followed it to its end; no Newton steps lead from its end to the pose; a wrist
/// cannot follow to what has been chosen on a continuum; it has led to a solution.
typedef enum BranchState { unseen, missed, turned_back, settled } BranchState;

/// The branches' states, and the solutions so far: the closed form may come to one from two branches, and
/// polishing brings two together where they are one.
typedef struct Tracker {
  int branches;
  BranchState states[most_branches];
  Known known;
  Budget budget;
  bool again;   // branches that have led to a solution are followed again, to others
  bool closed;  // but not those of which nothing is polished
} Tracker;

static void start_tracker(Tracker* tracker, int branches, int passes, int steps, bool persists) {
  const Budget budget = {passes, steps, persists, {0, 0, 0}};
  tracker->branches = branches;
  for (int i = 0; i < branches; ++i) tracker->states[i] = unseen;
  tracker->known = nothing_known;
  tracker->budget = budget;
  tracker->again = tracker->closed = false;
}

static bool any_branch_is(const Tracker* tracker, BranchState state) {
  for (int i = 0; i < tracker->branches; ++i)
    if (tracker->states[i] == state) return true;
  return false;
}

static bool all_settled(const Tracker* tracker) {
  for (int i = 0; i < tracker->branches; ++i)
    if (tracker->states[i] != settled) return false;
  return true;
}

static bool is_settled(const Tracker* tracker, int label) {
  return tracker->states[label] == settled && (!tracker->again || tracker->closed);
}

/// True if there is room for one more row. If there is none a row is lost, and the set is incomplete; but
/// where branches are followed again each has a row of its own then.
static bool has_room(Tracker* tracker) {
  const bool is_full = tracker->known.count == tracker->branches;
  if (is_full && !tracker->again) tracker->budget.spent.used_up = true;
  return !is_full;
}

/// A solution of which nothing is polished.
static void close_branch(Tracker* tracker, int label) {
  tracker->states[label] = settled;
  tracker->closed = true;
}

/// Takes back the last solution: a wrist cannot follow there.
static void reopen_branch(Tracker* tracker, int label, bool continuum) {
  tracker->states[label] = continuum ? turned_back : missed;
  --tracker->known.count;
}

static bool is_joined_to_known(Tracker* tracker, const PointMatching* task, const JointValues* values,
                               const Reached* at) {
  for (int k = 0; k < tracker->known.count; ++k) {
    const JointValues* other = &tracker->known.of[k];
    if (distance_square(task->joints, other, values) < tolerance_may_be_joined &&
        are_joined(task, values, at, other, &tracker->budget))
      return true;
  }
  return false;
}

/// Newton steps from where a branch has led. Where two solutions meet they may come to the one that another
/// branch has found, or stand still: then to the side of the other.
static bool lead_to_goal(Tracker* tracker, Patience until, const PointMatching* task, JointValues* values,
                         Reached* reached) {
  Budget* budget = &tracker->budget;
  const JointValues start = *values;
  const bool reaches = polish(task, until, values, reached, budget, &nothing_held);
  if (reaches &&
      !(is_known(&tracker->known, task->joints, values) && !are_same(task->joints, &start, values)))
    return true;
  if (!reaches)
    return polish_with_idle_held(task, until, &start, values, reached, budget) ||
           leave_double_root(task, until, &tracker->known, values, reached, budget);
  JointValues beside = start;
  if (!may_step(budget)) return true;
  normalise(task, &beside);
  Reached there;
  reach(task, &beside, &there);
  if (leave_double_root(task, until, &tracker->known, &beside, &there, budget) &&
      !is_known(&tracker->known, task->joints, &beside)) {
    *values = beside;
    *reached = there;
  }
  return true;
}

/// The place on the continuum to which Newton steps from the seed lead, if no branch has come there yet.
static void take_place_near_seed(Tracker* tracker, const PointMatching* task, const JointValues* seed,
                                 JointValues* values) {
  JointValues at = *seed;
  Reached there;
  if (!polish(task, patience(0), &at, &there, &tracker->budget, &nothing_held) ||
      is_known(&tracker->known, task->joints, &at) || is_joined_to_known(tracker, task, &at, &there) ||
      !is_continuum(task, &at, &there, &tracker->budget))
    return;
  *values = at;
}

/// Polishes where a branch has led; true if that is a solution and a new one, to half the digits. On a
/// continuum the place is the one next to the seed, if there is one.
static bool settle_branch(Tracker* tracker, int label, const PointMatching* task, const Boundary* boundary,
                          const JointValues* seed, JointValues* values, Branch* branch) {
  BranchState* state = &tracker->states[label];
  Known* known = &tracker->known;
  if (!branch->exists || (tracker->again && is_known(known, task->joints, values))) return false;
  if (!branch->unsure) {
    // Closed forms are to be trusted, as elsewhere. Another branch may have been led there.
    normalise(task, values);
    *state = settled;
    if (is_known(known, task->joints, values) || !has_room(tracker)) return false;
    remember(known, values);
    return true;
  }
  Reached reached;
  const JointValues start = *values;
  const bool leads = lead_to_goal(tracker, patience(boundary->miss), task, values, &reached);
  const bool same = leads && is_known(known, task->joints, values);
  // A branch that reached another branch's solution from elsewhere may have left its own, which a choice finds.
  if (!leads || (tracker->budget.persists && same && !are_same(task->joints, &start, values))) {
    if (*state == unseen) *state = missed;
    return false;
  }
  *state = settled;
  if (same || is_joined_to_known(tracker, task, values, &reached) || !has_room(tracker)) return false;
  if (branch->continuum || is_continuum(task, values, &reached, &tracker->budget)) {
    branch->continuum = true;
    if (seed != NULL) take_place_near_seed(tracker, task, seed, values);
  }
  remember(known, values);
  return true;
}

/// From where Newton's steps start: from where the equations lead; from there, with what is idle put back to
/// where the seed has it, and held; from the seed.
typedef enum Start { from_form, from_held, from_seed } Start;

/// Polishes the one branch's joints.
typedef struct SeedTracker {
  Start start;
  Budget budget;
} SeedTracker;

static SeedTracker new_seed_tracker(void) {
  const SeedTracker tracker = {from_form, {6, 60, false, {0, 0, 0}}};
  return tracker;
}

/// True if Newton from the seed converges with the idle joints held.
static bool moves_without_idle(SeedTracker* tracker, const PointMatching* task, Patience until,
                               JointValues* values, Reached* reached) {
  if (!may_step(&tracker->budget)) return false;
  Reached at;
  reach(task, values, &at);
  const Dependent idle = idle_joints(task->joints, task->points, &at);
  return idle.least != task->joints && polish(task, until, values, reached, &tracker->budget, &idle.is);
}

/// True if the joints that are idle can be where the seed has them.
static bool holds(SeedTracker* tracker, const PointMatching* task, Patience until, const JointValues* seed,
                  JointValues* values, Reached* reached) {
  const Dependent idle = idle_joints(task->joints, task->points, reached);
  if (idle.least == task->joints) return false;
  for (int i = 0; i < task->joints; ++i)
    if (idle.is.of[i]) values->of[i] = seed->of[i];
  return polish(task, until, values, reached, &tracker->budget, &idle.is);
}

/// False if no steps lead to the pose.
static bool settle_near_seed(SeedTracker* tracker, const PointMatching* task, const Boundary* boundary,
                             const JointValues* seed, JointValues* values, Branch* branch) {
  if (!branch->exists || (!branch->unsure && tracker->start != from_form)) return false;
  if (!branch->unsure) {
    normalise(task, values);
    return true;
  }
  Budget* budget = &tracker->budget;
  Reached reached;
  memset(&reached, 0, sizeof reached);
  const Patience until = patience(boundary->miss);
  if (tracker->start == from_seed) {
    *values = *seed;
    if (moves_without_idle(tracker, task, until, values, &reached)) {
      branch->continuum = branch->continuum || is_continuum(task, values, &reached, budget);
      return true;
    }
    *values = *seed;
  }
  if (!polish(task, until, values, &reached, budget, &nothing_held) &&
      !leave_double_root(task, until, &nothing_known, values, &reached, budget))
    return false;
  if (tracker->start == from_held && !holds(tracker, task, until, seed, values, &reached)) return false;
  branch->continuum = branch->continuum || is_continuum(task, values, &reached, budget);
  return true;
}
