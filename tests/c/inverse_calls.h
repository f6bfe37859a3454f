// SPDX-License-Identifier: MIT
#pragma once

#ifdef __cplusplus
extern "C" {
#else
#include <stddef.h>
#endif

struct rows {
  int capacity, status;
  double q[16][6];
  int branches[16];
};

struct seven_rows {
  int capacity, status;
  double q[16][7];
  int branches[16];
};

// pose: w x y z, then the position.
int jaco2_in_c(const double pose[7], const double* seed, struct rows* found);
int jaco2_within_in_c(const double pose[7], const double* seed, const double* lower, const double* upper,
                      struct rows* found);
int jaco2_near_in_c(const double pose[7], double* q, int* status);
int jaco2_with_room(const double pose[7], int rows, struct rows* found);
int seven_in_c(const double pose[7], double given, const double* seed, struct seven_rows* found);
int seven_within_in_c(const double pose[7], double given, const double* seed, struct seven_rows* found);
int seven_near_in_c(const double pose[7], double given, double* q, int* status);
// given: the rail, q7; limits may be NULL.
int inclined_in_c(const double position[3], const double up[3], const double given[2], const double* seed,
                  struct seven_rows* found);
int inclined_within_in_c(const double position[3], const double up[3], const double given[2],
                         const double* seed, const double* lower, const double* upper,
                         struct seven_rows* found);
int inclined_near_in_c(const double position[3], const double up[3], const double given[2], double* q,
                       int* status);
int inclined_near_within_in_c(const double position[3], const double up[3], const double given[2],
                              const double* lower, const double* upper, double* q, int* status);
int inclined_pose_in_c(const double pose[7], const double given[2], const double* seed,
                       struct seven_rows* found);

#ifdef __cplusplus
}
#endif
