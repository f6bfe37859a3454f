// Points that joint values carry, with derivatives, for arms with a quartic. Directions and points change in place.
#include <qvgen/inverse/least_squares.h>
#include <qvgen/inverse/point_matching.h>

/// Sum of the squared distances between the points and their goals.
static double miss(const PointMatching* task, const JointValues* values) {
  double sum = 0;
  for (int p = 0; p < task->points; ++p) {
    double x[3];
    memcpy(x, task->start[p], sizeof x);
    for (int i = task->joints; i-- > 0;) move_point(&task->arm[i], values->of[i], x);
    difference(task->goal[p], x, x);
    sum += dot(x, x);
  }
  return sum;
}

static void add_point(const PointMatching* task, int p, const JointValues* values, Columns* jacobian, Vector* off) {
  double columns[most_joints][3], x[3];
  memcpy(x, task->start[p], sizeof x);
  for (int i = task->joints; i-- > 0;) {
    const Screw* screw = &task->arm[i];
    move_point(screw, values->of[i], x);
    if (screw->revolute) {
      difference(x, screw->point, columns[i]);
      cross(screw->axis, columns[i], columns[i]);
    } else {
      memcpy(columns[i], screw->axis, sizeof screw->axis);
    }
    for (int k = i + 1; screw->revolute && k < task->joints; ++k)
      turn_direction(screw, values->of[i], columns[k]);
  }
  difference(task->goal[p], x, x);
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < task->joints; ++i) jacobian->of[i].of[3 * p + k] = columns[i][k];
    off->of[3 * p + k] = x[k];
  }
}

static void add_points(const PointMatching* task, const JointValues* values, Columns* jacobian, Vector* off) {
  for (int p = 0; p < task->points; ++p) add_point(task, p, values, jacobian, off);
}
