// Poses, and which are valid and in reach: pose.h and reach_test.h of the C++ library.

/// w, x, y, z; Hamilton's product.
typedef struct Quaternion {
  double of[4];
} Quaternion;

typedef struct Pose {
  Quaternion orientation;
  double position[3];
} Pose;

/// How far |q|^2 of a valid pose may be from 1.
static const double unit_tolerance = digits(tolerance_most_excess);

/// Half a unit of the last digit of numbers with 3 to 6 digits behind the point, numbers that went through float
/// included; else 0.
static double half_last_digit(const double* numbers, int count) {
  static const double units[7] = {1, 10, 100, 1000, 10000, 100000, 1000000};
  for (int n = 0; n < 7; ++n) {
    bool are_whole = true;
    for (int i = 0; i < count; ++i) {
      const double scaled = numbers[i] * units[n];
      are_whole = are_whole && fabs(scaled - round(scaled)) <= 0x1p-24 * fabs(scaled);
    }
    if (are_whole) return n < 3 ? 0 : 0.5 / units[n];
  }
  return 0;
}

/// True if numbers have not the length one, and rounding to their digits explains it.
static bool is_unit_by_digits(const double* numbers, int count) {
  double square = 0, sum = 0;
  for (int i = 0; i < count; ++i) {
    square += numbers[i] * numbers[i];
    sum += fabs(numbers[i]);
  }
  const double excess = fabs(square - 1);
  if (excess <= unit_tolerance || !(sum < HUGE_VAL)) return false;
  const double off = half_last_digit(numbers, count);
  return off > 0 && excess <= 2 * off * sum + (double)count * off * off;
}

static const double no_place[3] = {0, 0, 0};

static const double no_turn[4] = {1, 0, 0, 0};

// Sums in the order of the C++ library's vector registers, so that rounding is the same.

static Quaternion turn_after(Quaternion later, Quaternion earlier) {
  const double aw = later.of[0], ax = later.of[1], ay = later.of[2], az = later.of[3];
  const double bw = earlier.of[0], bx = earlier.of[1], by = earlier.of[2], bz = earlier.of[3];
  const Quaternion result = {
      {(aw * bw - ay * by) - (az * bz + ax * bx), (aw * bx + ay * bz) - (az * by - ax * bw),
       (aw * by + ay * bw) + (az * bx - ax * bz), (aw * bz - ay * bx) + (az * bw + ax * by)}};
  return result;
}

static double quaternion_length(Quaternion q) {
  return sqrt((q.of[1] * q.of[1] + q.of[3] * q.of[3]) + (q.of[2] * q.of[2] + q.of[0] * q.of[0]));
}

static double projection(const double* a, const double* b) {
  return a[0] * b[0] + (a[1] * b[1] + a[2] * b[2]);
}

static Quaternion unit_quaternion(Quaternion q) {
  const double length = quaternion_length(q);
  for (int i = 0; i < 4; ++i) q.of[i] /= length;
  return q;
}

/// The pose of w, x, y, z and a position; a quaternion with few digits is brought to length one.
static Pose pose_from(const double* orientation, const double* position) {
  Pose pose;
  memcpy(pose.orientation.of, orientation, sizeof pose.orientation.of);
  if (is_unit_by_digits(orientation, 4)) pose.orientation = unit_quaternion(pose.orientation);
  memcpy(pose.position, position, sizeof pose.position);
  return pose;
}

static void turn_vector(Quaternion q, const double* v, double* result) {
  const double* axis = q.of + 1;
  double twice[3], across[3];
  cross(axis, v, twice);
  for (int k = 0; k < 3; ++k) twice[k] += twice[k];
  cross(axis, twice, across);
  for (int k = 0; k < 3; ++k) result[k] = v[k] + q.of[0] * twice[k] + across[k];
}

/// By an angle (rad) about a unit vector.
static Quaternion turn_about(const double* axis, double angle) {
  const double sine = sin(0.5 * angle);
  const Quaternion turn = {{cos(0.5 * angle), sine * axis[0], sine * axis[1], sine * axis[2]}};
  return turn;
}

static Pose pose_after(const Pose* later, const Pose* earlier) {
  Pose result;
  result.orientation = turn_after(later->orientation, earlier->orientation);
  turn_vector(later->orientation, earlier->position, result.position);
  for (int k = 0; k < 3; ++k) result.position[k] += later->position[k];
  return result;
}

static Pose inverse_pose(const Pose* pose) {
  Pose result = *pose;
  for (int i = 1; i < 4; ++i) result.orientation.of[i] = -pose->orientation.of[i];
  turn_vector(result.orientation, pose->position, result.position);
  for (int k = 0; k < 3; ++k) result.position[k] = -result.position[k];
  return result;
}

static Pose with_unit_quaternion(const Pose* pose) {
  Pose result = *pose;
  result.orientation = unit_quaternion(pose->orientation);
  return result;
}

/// How far the square of a pose's quaternion is from 1.
static inline double unit_excess(const Pose* pose) {
  const double* q = pose->orientation.of;
  return ((q[1] * q[1] + q[2] * q[2]) + (q[3] * q[3] + q[0] * q[0])) - 1;
}

/// 1 / |q| of a valid pose's quaternion from |q|^2 - 1.
static inline double unit_scale(double excess) { return 1 + excess * (-0.5 + 0.375 * excess); }

/// 1 / |q|^2, the same way.
static inline double square_scale(double excess) { return 1 + excess * (excess - 1); }

/// Answer that a pose alone allows, before any branch is followed: branches have to tell; not a rotation, not finite,
/// or too large to be squared.
typedef enum ReachTest { reach_test_open, reach_test_unreachable, reach_test_invalid } ReachTest;

/// By the pose's quaternion, and by the distance that the arm's tool cannot exceed.
static ReachTest reach_test_of(const Pose* pose, double excess, double farthest, double tolerance) {
  const double* p = pose->position;
  const double distance = (p[1] * p[1] + p[2] * p[2]) + p[0] * p[0];
  const double square = farthest * farthest;
  if (!(fabs(excess) <= unit_tolerance)) return reach_test_invalid;
  if (distance <= square * (1 + tolerance_reach_rounding) + tolerance_reach_per_tolerance * square * tolerance) return reach_test_open;
  return distance < HUGE_VAL ? reach_test_unreachable : reach_test_invalid;
}

static bool are_finite(const double* numbers, int count) {
  for (int i = 0; i < count; ++i)
    if (!(fabs(numbers[i]) < HUGE_VAL)) return false;
  return true;
}

/// Why a pose whose reach_test is not open has no solutions.
static int status_beyond(const Pose* pose) {
  return fabs(unit_excess(pose)) <= unit_tolerance && are_finite(pose->position, 3) ? status_unreachable
                                                                                    : status_invalid;
}

/// before * pose * behind, the pose's quaternion brought to length one first. What is no pose stays none.
static Pose between_frames(const Pose* before, const Pose* pose, const Pose* behind) {
  if (!(fabs(unit_excess(pose)) <= unit_tolerance)) return *pose;
  const Pose unit = with_unit_quaternion(pose);
  const Pose first = pose_after(before, &unit);
  return pose_after(&first, behind);
}

/// The shortest turn that brings a unit vector to the direction of another, whose length the quaternion takes
/// over: one that is no unit vector by more than rounding makes no valid pose.
static Quaternion shortest_turn(const double* from, const double* to) {
  const double length = sqrt(projection(to, to));
  double cosine = projection(from, to);
  double start[3];
  memcpy(start, from, sizeof start);
  Quaternion first = {{1, 0, 0, 0}};
  if (cosine < -0.5 * length) {
    // By half a turn about a direction across first.
    const bool leans = fabs(from[0]) > tolerance_leaning * fabs(from[2]) || fabs(from[1]) > tolerance_leaning * fabs(from[2]);
    const double a = leans ? -from[1] : 0, b = leans ? from[0] : -from[2], c = leans ? 0 : from[1];
    const double scale = 1 / sqrt(a * a + b * b + c * c);
    set_triple(first.of + 1, scale * a, scale * b, scale * c);
    first.of[0] = 0;
    for (int k = 0; k < 3; ++k) start[k] = -from[k];
    cosine = -cosine;
  }
  double normal[3];
  cross(start, to, normal);
  Quaternion twice = {{length + cosine, normal[0], normal[1], normal[2]}};
  const double scale = length / quaternion_length(twice);
  for (int i = 0; i < 4; ++i) twice.of[i] *= scale;
  return turn_after(twice, first);
}

/// A direction with length one if its digits explain why it has not, else as it is.
static void direction_meant(const double* direction, double* meant) {
  memcpy(meant, direction, 3 * sizeof *meant);
  if (!is_unit_by_digits(direction, 3)) return;
  const double length = sqrt(projection(direction, direction));
  for (int k = 0; k < 3; ++k) meant[k] /= length;
}

/// The pose with a given direction of a tool's axis that turns a tool at `at` least.
static Pose directed_pose(const double* position, const double* direction, const double* tool_axis,
                          Quaternion at) {
  double now[3], meant[3];
  direction_meant(direction, meant);
  turn_vector(at, tool_axis, now);
  Pose pose;
  pose.orientation = turn_after(shortest_turn(now, meant), at);
  memcpy(pose.position, position, sizeof pose.position);
  return pose;
}
