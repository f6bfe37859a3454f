// SPDX-License-Identifier: MIT
#pragma once

#ifdef __cplusplus
extern "C" {
#else
#include <stddef.h>
#endif

struct rows {
  int capacity, status;
  double q[8][6];
  int branches[8];
};

// pose: w x y z, then the position.
int puma560_in_c(const double pose[7], const double* seed, struct rows* found);
int puma560_within_in_c(const double pose[7], const double* seed, const double* lower, const double* upper,
                        struct rows* found);
int puma560_near_in_c(const double pose[7], double* q, int* status);
int ns_in_c(const double pose[7], const double* geometry, int rows, struct rows* found);
int planar_3r_in_c(const double pose[7], double given, const double* seed, double q[2][3], int* status);

#ifdef __cplusplus
}
#endif
