// Tips in the world, where loops are closed and the base floats: tip_motion.h of the C++ library. A limb's functions have the base's
// frame for their world. These add the base's own motion.

/// Pose of the base as its seven numbers are, w x y z and metres.
static Pose pose_of_base(const double* base) {
  Pose pose;
  memcpy(pose.orientation.of, base, sizeof pose.orientation.of);
  memcpy(pose.position, base + 4, sizeof pose.position);
  return pose;
}

/// Writes a column of a Jacobian in the world, from velocities in the base's frame.
static void put_in_world(const Pose* base, const double* linear, const double* angular, int column, double (*jacobian)[moved_size]) {
  double turned[3];
  turn_vector(base->orientation, linear, turned);
  for (int i = 0; i < 3; ++i) jacobian[i][column] = turned[i];
  turn_vector(base->orientation, angular, turned);
  for (int i = 0; i < 3; ++i) jacobian[3 + i][column] = turned[i];
}

/// Jacobian of a tip in the world, from its position and its Jacobian by the driven joints in the base's frame.
static void jacobian_in_world(const Pose* base, const double* tip, double (*by_driven)[driven_count], double (*jacobian)[moved_size]) {
  for (int k = 0; k < 3; ++k) {
    const double none[3] = {0, 0, 0};
    double axis[3] = {0, 0, 0}, across[3];
    axis[k] = 1;
    cross(axis, tip, across);
    put_in_world(base, axis, none, k, jacobian);
    put_in_world(base, across, axis, 3 + k, jacobian);
  }
  for (int k = 0; k < driven_count; ++k) {
    double linear[3], angular[3];
    for (int i = 0; i < 3; ++i) {
      linear[i] = by_driven[i][k];
      angular[i] = by_driven[3 + i][k];
    }
    put_in_world(base, linear, angular, base_motions + k, jacobian);
  }
}

/// Turns a tip's acceleration in the base's frame into that in the world, in its place. `moving`: velocity of the base in its own
/// frame. `tip` and `velocity`: where the tip is in the base's frame, and how it moves there.
static void bias_in_world(const Pose* base, const double* moving, const double* tip, const double* velocity, double* bias) {
  const double* w = moving + 3;
  double carried[3], across[3], inwards[3], sideways[3], turning[3], linear[3], angular[3];
  cross(w, moving, carried);
  cross(w, tip, across);
  cross(w, across, inwards);
  cross(w, velocity, sideways);
  cross(w, velocity + 3, turning);
  for (int i = 0; i < 3; ++i) {
    linear[i] = bias[i] + carried[i] + inwards[i] + 2 * sideways[i];
    angular[i] = bias[3 + i] + turning[i];
  }
  turn_vector(base->orientation, linear, bias);
  turn_vector(base->orientation, angular, bias + 3);
}
