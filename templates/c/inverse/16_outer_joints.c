// Joints whose values are given in front of an arm, behind it, or between its own: outer_joints.h of the C++ library. Those in
// front and behind move the pose of the inner arm, which is the arm with these at zero, alone; those between are constants of its
// geometry. The inner arm's `dof` joints are those at `inner_places` of the whole arm's `whole_dof`; those before `first_inner`
// stand in front, those from `first_behind` on behind.

/// The given values, and what they do to the inner arm's pose.
typedef struct OuterJoints {
  double values[whole_dof];  // the inner arm's are zero
  Pose before, behind;
} OuterJoints;

/// A frame carried along by some joints.
static Pose carried_frame(const Arm* arm, int begin, int end, const double* values, Pose frame) {
  for (int i = end; i-- > begin;) frame = carried_by(&arm->of[i], values[i], frame);
  return frame;
}

/// `arm`: the whole arm at zero. A value that is no number makes what is asked for none.
static void set_outer_joints(const Arm* arm, const double* values, OuterJoints* outer) {
  const Pose none = pose_from(no_turn, no_place);
  const Pose before = carried_frame(arm, 0, first_inner, values, none);
  const Pose behind = carried_frame(arm, first_behind, whole_dof, values, none);
  const Pose back = inverse_pose(&arm->tool), ahead = pose_after(&back, &behind);
  const Pose at_tool = pose_after(&ahead, &arm->tool);
  memcpy(outer->values, values, sizeof outer->values);
  outer->before = inverse_pose(&before);
  for (int i = 0; i < whole_dof; ++i) outer->before.position[0] += 0.0 * values[i];
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
  for (int i = 0; i < dof; ++i) inner[i] = whole[inner_places[i]];
}

/// Rows of the inner arm, in their first places, as rows of the whole arm. Returns how many there are.
static int whole_rows(const OuterJoints* outer, Solutions* found) {
  double inner[dof];
  for (int k = 0; k < found->count; ++k) {
    Solution* row = &found->rows[k];
    memcpy(inner, row->q, sizeof inner);
    memcpy(row->q, outer->values, sizeof row->q);
    for (int i = 0; i < dof; ++i) row->q[inner_places[i]] = inner[i];
  }
  return found->count;
}
