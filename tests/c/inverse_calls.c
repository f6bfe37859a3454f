/* SPDX-License-Identifier: MIT */
/* Calls from C, for inverse_test.cpp: compiled as C99 with all warnings as errors. */
#include "inverse_calls.h"

#include "qvgen_inclined_seven_inverse.h"
#include "qvgen_jaco2_inverse.h"
#ifdef QVGEN_ALL_ARMS
#include "qvgen_seven_joints_inverse.h"
#endif

int jaco2_in_c(const double pose[7], const double* seed, struct rows* found) {
  found->capacity = jaco2_inverse_capacity;
  return jaco2_inverse_kinematics(pose, pose + 4, seed, NULL, 16, found->q, found->branches, &found->status);
}

int jaco2_within_in_c(const double pose[7], const double* seed, const double* lower, const double* upper,
                      struct rows* found) {
  return jaco2_inverse_kinematics_within(pose, pose + 4, seed, lower, upper, NULL, 16, found->q,
                                         found->branches, &found->status);
}

int jaco2_near_in_c(const double pose[7], double* q, int* status) {
  return jaco2_inverse_kinematics_near(pose, pose + 4, q, NULL, q, status);
}

int jaco2_with_room(const double pose[7], int rows, struct rows* found) {
  return jaco2_inverse_kinematics(pose, pose + 4, NULL, NULL, rows, found->q, NULL, &found->status);
}

#ifdef QVGEN_ALL_ARMS
int seven_in_c(const double pose[7], double given, const double* seed, struct seven_rows* found) {
  found->capacity = seven_joints_inverse_capacity_given_theta5;
  return seven_joints_inverse_kinematics_given_theta5(pose, pose + 4, given, seed, NULL, 16, found->q,
                                                      found->branches, &found->status);
}

int seven_within_in_c(const double pose[7], double given, const double* seed, struct seven_rows* found) {
  return seven_joints_inverse_kinematics_within_given_theta5(pose, pose + 4, given, seed, NULL, NULL, NULL,
                                                             16, found->q, found->branches, &found->status);
}

int seven_near_in_c(const double pose[7], double given, double* q, int* status) {
  return seven_joints_inverse_kinematics_near_given_theta5(pose, pose + 4, given, q, NULL, q, status);
}
#endif

int inclined_in_c(const double position[3], const double up[3], const double given[2], const double* seed,
                  struct seven_rows* found) {
  found->capacity = inclined_seven_inverse_capacity_given_rail_q7;
  return inclined_seven_inverse_kinematics_given_rail_q7_of_position_and_inclination(
      position, up, given, seed, NULL, 16, found->q, found->branches, &found->status);
}

int inclined_within_in_c(const double position[3], const double up[3], const double given[2],
                         const double* seed, const double* lower, const double* upper,
                         struct seven_rows* found) {
  return inclined_seven_inverse_kinematics_within_given_rail_q7_of_position_and_inclination(
      position, up, given, seed, lower, upper, NULL, 16, found->q, found->branches, &found->status);
}

int inclined_near_in_c(const double position[3], const double up[3], const double given[2], double* q,
                       int* status) {
  return inclined_seven_inverse_kinematics_near_given_rail_q7_of_position_and_inclination(position, up, given,
                                                                                          q, NULL, q, status);
}

int inclined_near_within_in_c(const double position[3], const double up[3], const double given[2],
                              const double* lower, const double* upper, double* q, int* status) {
  return inclined_seven_inverse_kinematics_near_within_given_rail_q7_of_position_and_inclination(
      position, up, given, q, lower, upper, NULL, q, status);
}

int inclined_pose_in_c(const double pose[7], const double given[2], const double* seed,
                       struct seven_rows* found) {
  return inclined_seven_inverse_kinematics_given_rail_q7(pose, pose + 4, given, seed, NULL, 16, found->q,
                                                         found->branches, &found->status);
}
