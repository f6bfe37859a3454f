/* SPDX-License-Identifier: MIT */
/* own_linkage_in_c: both assemblies of a four-bar close its loop, and its point moves. */
#include <math.h>
#include <qvgen_four_bar_loops.h>
#include <stddef.h>

int main(void) {
  const double crank[1] = {0.8};
  double q[2][3], gaps[2], jacobian[6][1];
  int status;
  if (four_bar_assemble(crank, NULL, NULL, 2, q, NULL, NULL, NULL, &status) != 2 || status != four_bar_solved) return 1;
  for (int i = 0; i < 2; ++i) {
    four_bar_loop_gaps(q[i], NULL, gaps);
    if (fabs(gaps[0]) > 1e-14 || fabs(gaps[1]) > 1e-14) return 2;
    four_bar_jacobian_of_point(q[i], NULL, jacobian);
    if (!(fabs(jacobian[0][0]) + fabs(jacobian[1][0]) > 0.01)) return 3;
  }
  return 0;
}
