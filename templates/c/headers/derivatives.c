// Places to which joint values carry the points, with the derivatives by each joint, in three coordinates.
#include <qvgen/inverse/point_matching.h>
#include <qvgen/inverse/reached.h>

static void reached_position(const PointMatching* task, const JointValues* values, Reached* result) {
  double x[3];
  memcpy(x, task->start[0], sizeof x);
  for (int i = task->joints; i-- > 0;) {
    const Screw* screw = &task->arm[i];
    double* column = result->jacobian.of[i].of;
    move_point(screw, values->of[i], x);
    if (screw->revolute) {
      difference(x, screw->point, column);
      cross(screw->axis, column, column);
    } else {
      memcpy(column, screw->axis, sizeof screw->axis);
    }
    for (int k = i + 1; screw->revolute && k < task->joints; ++k)
      turn_direction(screw, values->of[i], result->jacobian.of[k].of);
  }
  difference(task->goal[0], x, result->off.of);
  result->error = dot(result->off.of, result->off.of);
}

/// The columns of a rotation matrix.
typedef struct Frame {
  double of[3][3];
} Frame;

static void turn_by_frame(const Frame* frame, double x, double y, double z, double* result) {
  for (int k = 0; k < 3; ++k) result[k] = x * frame->of[0][k] + y * frame->of[1][k] + z * frame->of[2][k];
}

/// The frame after a turn about an axis of its own.
static void turn_frame(const double* a, Rotor turn, Frame* frame) {
  const Frame before = *frame;
  const double along = 1 - turn.cosine;
  const double side[3] = {turn.sine * a[0], turn.sine * a[1], turn.sine * a[2]};
  const double xy = along * a[0] * a[1], yz = along * a[1] * a[2], zx = along * a[2] * a[0];
  turn_by_frame(&before, turn.cosine + along * a[0] * a[0], xy + side[2], zx - side[1], frame->of[0]);
  turn_by_frame(&before, xy - side[2], turn.cosine + along * a[1] * a[1], yz + side[0], frame->of[1]);
  turn_by_frame(&before, zx + side[1], yz - side[0], turn.cosine + along * a[2] * a[2], frame->of[2]);
}

/// The directions from the first point to the others, and at right angles to both, against those of the
/// goals.
static void set_miss(const PointMatching* task, const Frame* frame, const double* x, double size,
                     Reached* result) {
  const double scale = 1 / size;
  double now[3][3], then[3][3], away[3], turn[3] = {0, 0, 0};
  for (int p = 0; p < 2; ++p) {
    double from[3], to[3], way[3];
    difference(task->start[p + 1], task->start[0], way);
    turn_by_frame(frame, way[0], way[1], way[2], from);
    difference(task->goal[p + 1], task->goal[0], to);
    for (int k = 0; k < 3; ++k) {
      now[p][k] = scale * from[k];
      then[p][k] = scale * to[k];
    }
  }
  cross(now[0], now[1], now[2]);
  cross(then[0], then[1], then[2]);
  difference(task->goal[0], x, away);
  double gap_square = 0;
  for (int p = 0; p < 3; ++p) {
    double side[3], gap[3];
    cross(now[p], then[p], side);
    difference(then[p], now[p], gap);
    gap_square += dot(gap, gap);
    for (int k = 0; k < 3; ++k) turn[k] += side[k];
  }
  for (int k = 0; k < 3; ++k) {
    result->off.of[k] = away[k];
    result->off.of[3 + k] = 0.5 * size * turn[k];
  }
  result->error = dot(away, away) + 0.5 * task->size_square * gap_square;
}

/// `place` is where the point `at` of the zero pose has come: from there to another point.
static void go_to(const Frame* frame, const double* to, double* at, double* place) {
  double way[3], turned[3];
  difference(to, at, way);
  turn_by_frame(frame, way[0], way[1], way[2], turned);
  for (int k = 0; k < 3; ++k) place[k] += turned[k];
  memcpy(at, to, sizeof way);
}

/// Frames from joint to joint.
static void reached_pose(const PointMatching* task, const JointValues* values, Reached* result) {
  Frame frame = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double at[3] = {0, 0, 0}, place[3] = {0, 0, 0}, axis[most_joints][3], point[most_joints][3];
  for (int i = 0; i < task->joints; ++i) {
    const Screw* screw = &task->arm[i];
    turn_by_frame(&frame, screw->axis[0], screw->axis[1], screw->axis[2], axis[i]);
    if (!screw->revolute) {
      for (int k = 0; k < 3; ++k) place[k] += values->of[i].cosine * axis[i][k];
      continue;
    }
    go_to(&frame, screw->point, at, place);
    memcpy(point[i], place, sizeof place);
    turn_frame(screw->axis, values->of[i], &frame);
  }
  go_to(&frame, task->start[0], at, place);
  const double size = sqrt(task->size_square);
  for (int i = 0; i < task->joints; ++i) {
    const bool revolute = task->arm[i].revolute;
    double way[3];
    memcpy(way, axis[i], sizeof way);
    if (revolute) {
      difference(place, point[i], way);
      cross(axis[i], way, way);
    }
    for (int k = 0; k < 3; ++k) {
      result->jacobian.of[i].of[k] = way[k];
      result->jacobian.of[i].of[3 + k] = revolute ? size * axis[i][k] : 0;
    }
  }
  set_miss(task, &frame, place, size, result);
}

/// Puts what joints that are not held do to a place into the first rows of columns.
static void put_motions(int joints, int coordinates, const Motions* motions, const Held* held, Columns* columns) {
  for (int i = 0; i < most_joints; ++i) {  // GCC 12 does not see that there are no more
    if (i >= joints || held->of[i]) continue;
    if (coordinates == most_coordinates)
      memcpy(columns->of[i].of, motions->of[i].of, sizeof motions->of[i].of);
    else
      memcpy(columns->of[i].of, motions->of[i].of, (size_t)coordinates * sizeof(double));
  }
}

/// Puts the place that joint values reach.
static void reach(const PointMatching* task, const JointValues* values, Reached* place) {
  if (task->points == 1)
    reached_position(task, values, place);
  else
    reached_pose(task, values, place);
}
