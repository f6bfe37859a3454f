/* SPDX-License-Identifier: MIT */
/* Calls from C, for inverse_test.cpp: compiled as C99 with all warnings as errors. */
#include "inverse_calls.h"

#include "qvgen_ns_inverse.h"
#include "qvgen_planar_3r_inverse.h"
#include "qvgen_puma560_inverse.h"

int puma560_in_c(const double pose[7], const double* seed, struct rows* found) {
  found->capacity = puma560_inverse_capacity;
  return puma560_inverse_kinematics(pose, pose + 4, seed, NULL, 8, found->q, found->branches, &found->status);
}

int puma560_within_in_c(const double pose[7], const double* seed, const double* lower, const double* upper,
                        struct rows* found) {
  return puma560_inverse_kinematics_within(pose, pose + 4, seed, lower, upper, NULL, 8, found->q,
                                           found->branches, &found->status);
}

int puma560_near_in_c(const double pose[7], double* q, int* status) {
  return puma560_inverse_kinematics_near(pose, pose + 4, q, NULL, q, status);
}

int ns_in_c(const double pose[7], const double* geometry, int rows, struct rows* found) {
  return ns_inverse_kinematics(pose, pose + 4, NULL, geometry, rows, found->q, NULL, &found->status);
}

int planar_3r_in_c(const double pose[7], double given, const double* seed, double q[2][3], int* status) {
  return planar_3r_inverse_kinematics_given_theta3(pose, pose + 4, given, seed, NULL, 2, q, NULL, status);
}
