/* SPDX-License-Identifier: MIT */
/* C99 for a microcontroller: the tool goes along a line, joint values come from the inverse kinematics next to the joints of the
   step before. No heap, no operating system; the arm is described in my_arm.toml. */
#include <math.h>
#include <qvgen_my_arm_inverse.h>
#include <stdio.h>

/* Moves the tool to a position, metres, with the orientation of `pose`; 0 if the joints cannot follow without a jump. */
static int step_to(my_arm_pose* pose, const double* position, double* q) {
  my_arm_solutions found;
  int i;
  for (i = 0; i < 3; ++i) pose->position[i] = position[i];
  if (my_arm_inverse_kinematics_near(pose->orientation, pose->position, q, NULL, my_arm_default_tolerance, &found) < 1) return 0;
  for (i = 0; i < my_arm_dof; ++i) {
    if (fabs(found.rows[0].q[i] - q[i]) > 0.05) return 0;
    q[i] = found.rows[0].q[i]; /* here to the drives */
  }
  return 1;
}

int main(void) {
  double q[my_arm_dof] = {0.1, 0.2, 0.3, 0.1, 0.6, 0};
  double start[3];
  my_arm_pose pose, reached;
  int step, i;
  my_arm_forward_kinematics(q, NULL, &pose);
  for (i = 0; i < 3; ++i) start[i] = pose.position[i];
  for (step = 1; step <= 50; ++step) {
    const double position[3] = {start[0], start[1] + 0.002 * step, start[2]};
    if (!step_to(&pose, position, q)) {
      printf("stopped at step %d\n", step);
      return 1;
    }
  }
  my_arm_forward_kinematics(q, NULL, &reached);
  printf("50 steps, the tool is %.3f m further\n", reached.position[1] - start[1]);
  return fabs(reached.position[1] - start[1] - 0.1) < 1e-12 ? 0 : 1;
}
