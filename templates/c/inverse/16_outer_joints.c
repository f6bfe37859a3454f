// Joints in front of an arm and behind it, whose values are given: outer_joints.h of the C++ library. They move the pose of the
// inner arm, which is the arm with these joints at zero, alone. The inner arm's `dof` joints begin at `first_inner` of the
// whole arm's `whole_dof`.

/// The given values, and what they do to the inner arm's pose.
typedef struct OuterJoints {
  double values[whole_dof];  // the inner arm's are not read
  Pose before, behind;
} OuterJoints;

/// A frame carried along by some joints.
static Pose carried_frame(const Arm* arm, int begin, int end, const double* values, Pose frame) {
  for (int i = end; i-- > begin;) frame = carried_by(&arm->of[i], values[i], frame);
  return frame;
}

/// `arm`: the whole arm at zero.
static void set_outer_joints(const Arm* arm, const double* values, OuterJoints* outer) {
  const Pose none = pose_from(no_turn, no_place);
  const Pose before = carried_frame(arm, 0, first_inner, values, none);
  const Pose behind = carried_frame(arm, first_inner + dof, whole_dof, values, none);
  const Pose back = inverse_pose(&arm->tool), ahead = pose_after(&back, &behind);
  const Pose at_tool = pose_after(&ahead, &arm->tool);
  memcpy(outer->values, values, sizeof outer->values);
  outer->before = inverse_pose(&before);
  outer->behind = inverse_pose(&at_tool);
}

/// The pose that the inner arm has to reach; what is no pose stays none.
static Pose inner_pose(const OuterJoints* outer, const double* orientation, const double* position) {
  const Pose pose = pose_from(orientation, position);
  return between_frames(&outer->before, &pose, &outer->behind);
}

/// A position as the inner arm's base sees it.
static void inner_place(const OuterJoints* outer, const double* position, double* place) {
  const Pose at = pose_from(no_turn, position), moved = pose_after(&outer->before, &at);
  memcpy(place, moved.position, sizeof moved.position);
}

/// A direction as the inner arm's base sees it.
static void inner_direction(const OuterJoints* outer, const double* direction, double* seen) {
  double meant[3];
  direction_meant(direction, meant);
  turn_vector(outer->before.orientation, meant, seen);
}

/// Values of the inner arm's joints.
static void inner_joints(const double* whole, double* inner) {
  for (int i = 0; i < dof; ++i) inner[i] = whole[first_inner + i];
}

/// Rows of the inner arm, in their first places, as rows of the whole arm. Returns how many there are.
static int whole_rows(const OuterJoints* outer, Solutions* found) {
  double inner[dof];
  for (int k = 0; k < found->count; ++k) {
    Solution* row = &found->rows[k];
    memcpy(inner, row->q, sizeof inner);
    memcpy(row->q, outer->values, sizeof row->q);
    for (int i = 0; i < dof; ++i) row->q[first_inner + i] = inner[i];
  }
  return found->count;
}
