/* SPDX-License-Identifier: MIT */
/* Calls every function of a mechanism's header for C. */
#include "calls.h"

#include <stddef.h>

#include <qvgen_delta_assembly.h>

int call_all(const double* a, struct Called* to) {
  int status = 0;
  to->count = delta_assemble(a, NULL, NULL, 2, to->rows, to->branches, NULL, to->meets, &status);
  to->status = status;
  if (to->count == 0) return delta_assemble_capacity;
  const double* q = to->rows[0];
  double outputs[3] = {q[3], q[4], q[5]};
  to->modes = delta_assemble_from_outputs(outputs, q, NULL, 1, &to->near, NULL, NULL, NULL, &status);
  to->closed = delta_follow(a, q, NULL, to->followed);
  delta_loop_gaps(q, NULL, to->gaps);
  delta_rates(q, NULL, to->rates);
  delta_accelerations(q, q, a, NULL, to->accelerations);
  to->drive = delta_drive_measure(q, NULL);
  to->platform = delta_platform_measure(q, NULL);
  delta_platform_rates(q, NULL, to->platform_rates);
  delta_pose_of_tool(q, NULL, to->orientation, to->position);
  delta_jacobian_of_tool(q, NULL, to->jacobian);
  delta_driven_inverse_dynamics(q, a, a, NULL, NULL, 9.8, to->forces);
  delta_driven_forward_dynamics(q, a, to->forces, NULL, NULL, 9.8, to->moved);
  delta_driven_mass_matrix(q, NULL, NULL, to->masses);
  delta_loop_forces(q, a, a, NULL, NULL, 9.8, to->loop_forces);
  delta_motor_forces_of_tool(q, q, NULL, to->held);
  delta_loop_forces_of_tool(q, q, NULL, to->loop_held);
  return delta_assemble_capacity;
}
