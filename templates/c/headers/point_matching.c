// Newton's task, whose sizes are its first fields: C knows them when it runs.
#include <qvgen/inverse/joint_values.h>
#include <qvgen/inverse/screw.h>

/// Joints that are to carry points to their goals: one point is a position, three a
/// whole pose, the second and third in two directions at right angles from the first, the arm's size away.
typedef struct PointMatching {
  int joints, points;
  Screw arm[most_joints];
  double start[3][3], goal[3][3];
  double size_square;
} PointMatching;
