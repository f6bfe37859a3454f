// Which branches of arms with a quartic have led to which solution: quartic/visited.h of the C++ library.

/// Branches that have led to a solution; that came near one and have none; that have been left to a pass that
/// chooses; that have come near a continuum, and to no solution of their own on it; that near one have come to
/// the solution of another branch alone; whose wrist cannot follow to what has been chosen.
typedef enum Mark { has_settled, has_missed, is_left, has_strayed, has_shared, has_turned_back, marks } Mark;

/// State of each branch, and the solutions so far.
typedef struct Visited {
  int branches;
  bool marked[marks][most_branches];
  Known known;
  Budget budget;
  bool again;  // branches that have led to a solution are followed again, to others
  bool before[marks][most_branches];
} Visited;

/// Begins or ends a pass in which branches that have led to a solution are followed again, to others. It changes no
/// branch's marks.
static void follow_again(Visited* visited, bool again) {
  if (again)
    memcpy(visited->before, visited->marked, sizeof visited->marked);
  else
    memcpy(visited->marked, visited->before, sizeof visited->marked);
  visited->again = again;
}

static void start_visits(Visited* visited, int branches, int passes, int steps) {
  const Budget budget = {passes, steps, false, {0, 0, 0}};
  visited->budget = budget;
  memset(visited->marked, 0, sizeof visited->marked);
  visited->branches = branches;
  visited->known.count = 0;
  visited->again = false;
}

/// True if a branch that is not settled is marked so.
static bool is_open(const Visited* visited, Mark mark) {
  for (int i = 0; i < visited->branches; ++i)
    if (visited->marked[mark][i] && !visited->marked[has_settled][i]) return true;
  return false;
}

/// Leaves those that share a solution at that.
static void settle_shared(Visited* visited) {
  for (int i = 0; i < visited->branches; ++i)
    visited->marked[has_settled][i] = visited->marked[has_settled][i] || visited->marked[has_shared][i];
}

static bool visit_is_settled(const Visited* visited, int label) {
  return visited->marked[has_settled][label] && !visited->again;
}

/// Takes back the last solution: a wrist cannot follow there.
static void reopen_visit(Visited* visited, int label, bool continuum) {
  visited->marked[has_settled][label] = false;
  visited->marked[has_missed][label] = true;
  if (continuum && !visited->marked[has_shared][label]) visited->marked[has_turned_back][label] = true;
  --visited->known.count;
}

static bool is_visited(Visited* visited, const PointMatching* task, const JointValues* values) {
  for (int k = 0; k < visited->known.count; ++k) {
    const JointValues* other = &visited->known.of[k];
    const double square = distance_square(task->joints, other, values);
    if (square < tolerance_same_rows * DBL_EPSILON) return true;
    if (square < tolerance_may_be_joined && points_are_joined(task, other, values, &visited->budget)) return true;
  }
  return false;
}

/// Polishes where a branch has led; true if that is a solution and a new one, to half the digits. On a
/// continuum the place is to be one that a pass has chosen, or the one next to the seed, if there is one.
static bool settle_visit(Visited* visited, int label, const PointMatching* task, const Boundary* boundary,
                         const JointValues* seed, JointValues* values, Branch* branch) {
  Budget* budget = &visited->budget;
  if (visited->again && (!branch->exists || is_known(&visited->known, task->joints, values))) return false;
  bool reached = branch->exists && polish_points(task, boundary->miss, values, budget, &nothing_held);
  const bool strays = branch->exists && !reached && is_nearly_continuum(task, values, budget);
  if (strays) reached = move_on(task, values, budget);
  visited->marked[has_strayed][label] = visited->marked[has_strayed][label] || strays;
  visited->marked[has_missed][label] = visited->marked[has_missed][label] || !reached;
  if (!reached) return false;
  bool* left = &visited->marked[is_left][label];
  if (is_continuum_of_points(task, values, budget)) {
    *left = !branch->continuum && !boundary->take;
    if (*left) return false;
    branch->continuum = true;
    JointValues at;
    if (seed != NULL) {
      at = *seed;
      if (polish_points(task, 0, &at, budget, &nothing_held) && !is_visited(visited, task, &at) &&
          is_continuum_of_points(task, &at, budget))
        *values = at;
    }
  }
  const bool known = is_visited(visited, task, values);
  // Near a continuum two branches may have been led to the one solution and left another; and so may a choice
  // lead.
  bool* shared = &visited->marked[has_shared][label];
  const bool astray = strays || *left || *shared;
  *shared = *shared || (known && !astray && !visited->marked[has_turned_back][label] &&
                        is_next_to_continuum(task, values, budget));
  visited->marked[has_settled][label] = !(known && (astray || *shared));
  if (known) return false;
  if (visited->known.count == visited->branches) {
    // A row is lost; but where branches are followed again each has a row of its own then.
    if (!visited->again) budget->spent.used_up = true;
    return false;
  }
  remember(&visited->known, values);
  return true;
}

/// A pose moved and turned a little, another way for every k: the fractional parts of multiples of square
/// roots of primes are spread evenly. Returns how far the joint whose value is given is to be held from that
/// value.
static double displaced(const Pose* pose, double size, int k, Pose* moved) {
  static const double roots[7] = {constant_root_of_2, constant_root_of_3, constant_root_of_5,
                                  constant_root_of_7, constant_root_of_11,    constant_root_of_13,
                                  constant_root_of_17};
  double by[7];
  for (int i = 0; i < 7; ++i) {
    const double multiple = (double)(k + 1) * roots[i];
    by[i] = tolerance_nearby * (2 * (multiple - floor(multiple)) - 1);
  }
  const Quaternion turn = {{1, by[3], by[4], by[5]}};
  moved->orientation = unit_quaternion(turn_after(turn, pose->orientation));
  for (int i = 0; i < 3; ++i) moved->position[i] = pose->position[i] + size * by[i];
  return by[6];
}
