// All places of a platform on six rods for given lengths: places.h in six_rods/ of the C++ library says more.

/// The platform's frame as seen from the base.
typedef struct RodPlace {
  double turn[4], position[3];
  int path;
  bool meets;
} RodPlace;

typedef struct RodPlaces {
  RodPlace rows[capacity];
  int size, proven;
  bool complete;
} RodPlaces;

/// Ends of paths, and what is proven of them.
typedef struct RodSearch {
  const RodStart* start;
  int count;
  RodEquations equations;
  RodSquares squares;
  Curvature curvatures[7];
  RodPath path;
  StudyPoint ends[capacity];
  RodProof proofs[capacity];
  bool again[capacity];
} RodSearch;

static double cross_entry(const double* x, const double* w, int i) {
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  return x[1 + j] * w[k] - x[1 + k] * w[j];
}

/// Turns a vector by a quaternion of length one.
static void turned_place(const double* x, const double* v, double* result) {
  double half[3];
  for (int i = 0; i < 3; ++i) half[i] = cross_entry(x, v, i) + x[0] * v[i];
  for (int i = 0; i < 3; ++i) result[i] = v[i] + 2 * cross_entry(x, half, i);
}

/// Place of a point that is real but for rounding.
static RodPlace place_of_point(const RodStart* start, const StudyPoint* z, int path, bool meets) {
  RodPlace place;
  double norm = 0, y[4], centre[3];
  const double* x = place.turn;
  place.path = path;
  place.meets = meets;
  for (int i = 0; i < 4; ++i) norm += z->of[i].re * z->of[i].re;
  const double scale = 1 / sqrt(norm);
  for (int i = 0; i < 4; ++i) {
    place.turn[i] = z->of[i].re * scale;
    y[i] = z->of[4 + i].re * scale;
  }
  turned_place(place.turn, start->platform_centre, centre);
  for (int i = 0; i < 3; ++i) {
    const int j = 1 + (i + 1) % 3, k = 1 + (i + 2) % 3;
    const double between = x[0] * y[1 + i] - y[0] * x[1 + i] - (y[j] * x[k] - y[k] * x[j]);
    place.position[i] = start->base_centre[i] + start->unit * between - centre[i];
  }
  return place;
}

static double distance_of_ends(const double* a, const double* b) {
  const double off[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  return sqrt(square_in_order(off));
}

/// True if two lengths differ by more than the distances of their rods' ends.
static bool cannot_meet(const RodStart* start, const RodSquares* squares) {
  const double rounded = 1 + 1e-12;
  const RodEnds* ends = &start->ends;
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < i; ++k) {
      const double most = distance_of_ends(ends->base.of[i], ends->base.of[k]) + distance_of_ends(ends->platform.of[i], ends->platform.of[k]);
      const double a = sqrt(squares->of[i].re), b = sqrt(squares->of[k].re);
      if (fabs(a - b) > rounded * most + (rounded - 1) * (a + b)) return true;
    }
  return false;
}

static void follow_rods(RodSearch* search, const StudyPoint* points, double error, int steps) {
  for (int i = 0; i < search->count; ++i) {
    if (!search->again[i]) continue;
    search->ends[i] = points[i];
    search->proofs[i].proven = false;
    if (follow_path(&search->path, &search->ends[i], error, steps))
      prove_place(&search->equations, search->curvatures, &search->squares, &search->ends[i], &search->proofs[i]);
  }
}

static bool are_one_place(const RodSearch* search, int i, int k) {
  const RodProof *a = &search->proofs[i], *b = &search->proofs[k];
  return a->proven && b->proven && !are_different_places(a, b);
}

/// Notes the paths without proof, and those that have led to one place together.
static void note_doubtful(RodSearch* search) {
  for (int i = 0; i < search->count; ++i) search->again[i] = !search->proofs[i].proven;
  for (int i = 0; i < search->count; ++i)
    for (int k = 0; k < i; ++k)
      if (are_one_place(search, i, k)) search->again[i] = search->again[k] = true;
}

static bool is_known_place(const RodSearch* search, int i) {
  for (int k = 0; k < i; ++k)
    if (are_one_place(search, i, k)) return true;
  return false;
}

static bool are_near_places(const RodPlace* a, const RodPlace* b, double unit) {
  const double nearly = 1e-6;
  double cosine = 0, distance = 0;
  for (int i = 0; i < 4; ++i) cosine += a->turn[i] * b->turn[i];
  for (int i = 0; i < 3; ++i) distance = larger(fabs(a->position[i] - b->position[i]), distance);
  return 1 - fabs(cosine) < nearly * nearly && distance < nearly * unit;
}

/// Adds the end of a path without proof where it is real to half of the digits and solves the equations.
static void add_meeting_place(RodSearch* search, int i, RodPlaces* found) {
  const double nearly = 1e-6;
  const RodProof* proof = &search->proofs[i];
  if (proof->proven && (is_real_proof(proof) || is_not_real_proof(proof))) return;
  approach_end(&search->path, &search->ends[i]);
  if (!are_finite_complex(search->ends[i].of, 8)) return;
  StudyPoint z = scaled_point(&search->ends[i], largest_of_turn(&search->ends[i]));
  RodValues gaps;
  double imaginary = 0;
  for (int k = 0; k < 8; ++k) {
    imaginary = larger(fabs(z.of[k].im), imaginary);
    z.of[k].im = 0;
  }
  rod_gaps(&search->equations, &z, &search->squares, &gaps);
  if (!(imaginary < nearly) || !(largest_complex(gaps.of, 7) < nearly * nearly)) return;
  const RodPlace place = place_of_point(search->start, &z, i, true);
  for (int k = 0; k < found->size; ++k)
    if (are_near_places(&place, &found->rows[k], search->start->unit)) return;
  found->rows[found->size++] = place;
}

static void note_places(RodSearch* search, RodPlaces* found) {
  bool are_decided = true;
  for (int i = 0; i < search->count; ++i) {
    const RodProof* proof = &search->proofs[i];
    if (!proof->proven || is_known_place(search, i)) continue;
    ++found->proven;
    are_decided = are_decided && (is_real_proof(proof) || is_not_real_proof(proof));
    if (is_real_proof(proof)) found->rows[found->size++] = place_of_point(search->start, &proof->z, i, false);
  }
  found->complete = found->proven == search->count && are_decided;
  for (int i = 0; i < search->count && !found->complete; ++i) add_meeting_place(search, i, found);
}

/// Finds the places for real lengths, m; so many points at the start.
static void find_rod_places(const RodStart* start, const StudyPoint* points, int count, const double* lengths, RodPlaces* found) {
  RodSearch search;
  found->size = found->proven = 0;
  found->complete = true;
  for (int i = 0; i < 6; ++i) search.squares.of[i] = complex_number(lengths[i] / start->unit * (lengths[i] / start->unit), 0);
  if (cannot_meet(start, &search.squares)) return;
  search.start = start;
  search.count = count;
  rod_equations_of(&start->ends, &search.equations);
  rod_curvatures(&search.equations, &search.squares, search.curvatures);
  search.path.equations = &search.equations;
  search.path.patch = &start->patch;
  search.path.from = start->squares;
  for (int i = 0; i < 6; ++i) search.path.change.of[i] = complex_difference(search.squares.of[i], start->squares.of[i]);
  for (int i = 0; i < count; ++i) search.again[i] = true;
  follow_rods(&search, points, 1e-5, 300);
  note_doubtful(&search);
  follow_rods(&search, points, 1e-8, 600);
  note_doubtful(&search);
  follow_rods(&search, points, 1e-11, 1200);
  note_places(&search, found);
}
