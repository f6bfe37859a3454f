/* SPDX-License-Identifier: MIT */
/* own_arms_in_c LENGTH: the length of the first link is that of the description. */
#include <math.h>
#include <qvgen_my_arm_inverse.h>
#include <stdlib.h>

int main(int count, char** arguments) {
  const double q[my_arm_dof] = {0, 0};
  const double length = count > 1 ? atof(arguments[1]) : 0;
  my_arm_pose pose;
  double jacobian[6][my_arm_dof];
  my_arm_forward_kinematics(q, &my_arm_default_geometry, &pose);
  my_arm_jacobian(q, &my_arm_default_geometry, jacobian);
  if (fabs(pose.position[0] - (length + 0.3)) > 1e-15) return 1;
  my_arm_solutions found;
  my_arm_inverse_kinematics_of_position(pose.position, q, &my_arm_default_geometry, my_arm_default_tolerance, &found);
  if (found.count < 1 || fabs(found.rows[0].q[0]) > 1e-7 || fabs(found.rows[0].q[1]) > 1e-7) return 3;
  return fabs(jacobian[1][0] - (length + 0.3)) > 1e-15 ? 2 : 0;
}
