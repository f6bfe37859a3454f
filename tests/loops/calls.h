/* SPDX-License-Identifier: MIT */
/* Results of the calls in calls.c, for the test that compares them with C++. */
#ifndef QVGEN_TESTS_LOOPS_CALLS_H
#define QVGEN_TESTS_LOOPS_CALLS_H

struct Called {
  int count, status, modes, closed;
  double rows[2][6], near[6], followed[6];
  int branches[2], meets[2];
  double gaps[3], rates[6][3], accelerations[6], drive, platform, platform_rates[3][3];
  double orientation[4], position[3], jacobian[6][3], forces[3], moved[3], masses[3][3];
  double loop_forces[3], held[3], loop_held[3];
};

#ifdef __cplusplus
extern "C"
#endif
    /* Returns the capacity of a set. */
    int
    call_all(const double* a, struct Called* to);

#endif
