/* SPDX-License-Identifier: MIT */
/* The functions of a robot at some places. WRITE: prints what they give, on the machine that builds; else
   compares with that, in expected.h, on a microcontroller. ROBOT is its name, its header is included by the
   command line. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define JOIN(robot, name) robot##_##name
#define NAME_OF(robot, name) JOIN(robot, name)
#define OF(name) NAME_OF(ROBOT, name)
#define DOF OF(dof)

#ifdef WRITE

static void take(const double* numbers, int count) {
  for (int i = 0; i < count; ++i) {
    uint64_t bits;
    memcpy(&bits, &numbers[i], sizeof bits);
    printf("0x%016llx,\n", (unsigned long long)bits);
  }
}
static int conclude(void) { return 0; }

#else

static const uint64_t expected[] = {
#include "expected.h"
};
static int taken = 0, differing = 0;
static double largest = 0;

/* Relative to the largest number of a result. */
static void take(const double* numbers, int count) {
  double scale = 1e-3;
  for (int i = 0; i < count; ++i) scale = fmax(scale, fabs(numbers[i]));
  for (int i = 0; i < count; ++i) {
    double number;
    memcpy(&number, &expected[taken++], sizeof number);
    const double difference = fabs(numbers[i] - number) / scale;
    if (!(difference <= largest)) largest = difference; /* NaN too */
    if (difference != 0) ++differing;
  }
}
static int conclude(void) {
  const int all = (int)(sizeof expected / sizeof *expected);
  const int good = taken == all && largest < 1e-14;
  printf("%d of %d numbers, %d not the same bits, largest difference %g: %s\n", taken, all, differing,
         largest, good ? "as expected" : "WRONG");
  return good ? 0 : 1;
}

#endif

static uint32_t state = 1;
static void fill(double* numbers, int count, double size) {
  for (int i = 0; i < count; ++i) {
    state = state * 1664525u + 1013904223u;
    numbers[i] = size * ((double)state / 2147483648.0 - 1.0);
  }
}

#ifdef HAS_INVERSE
static void take_rows(const OF(solutions) * found) {
  const double outcome[2] = {found->status, found->count};
  take(outcome, 2);
  for (int i = 0; i < found->count; ++i) take(found->rows[i].q, DOF);
}

/* Poses by sums, products and roots alone, which both machines round alike; some are out of reach. Every eighth has the
   orientation of the base, at which wrists are singular. */
static void invert(int round) {
  double q[4], p[3], seed[DOF];
  OF(solutions) found;
  fill(q, 4, 1);
  fill(p, 3, 0.6);
  fill(seed, DOF, 3);
  for (int i = 0; i < 4 && round % 8 == 0; ++i) q[i] = i == 0 ? 1 : 0;
  const double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (int i = 0; i < 4; ++i) q[i] /= length;
  OF(inverse_kinematics)(q, p, NULL, &OF(default_geometry), OF(default_tolerance), &found);
  take_rows(&found);
  OF(inverse_kinematics_within_limits)(q, p, seed, NULL, NULL, &OF(default_geometry), OF(default_tolerance), &found);
  take_rows(&found);
  if (found.count > 0) memcpy(seed, found.rows[found.count - 1].q, sizeof seed);
  seed[0] += 1e-3;
  OF(inverse_kinematics_near)(q, p, seed, &OF(default_geometry), OF(default_tolerance), &found);
  take_rows(&found);
}
#endif

int main(void) {
  for (int round = 0; round < 50; ++round) {
    double q[DOF], qd[DOF], qdd[DOF], row[DOF], twist[6], transform[4][4], jacobian[6][DOF];
    fill(q, DOF, 3);
    fill(qd, DOF, 2);
    fill(qdd, DOF, 2);
    OF(pose) pose;
    OF(forward_kinematics)(q, &OF(default_geometry), &pose);
    take(pose.orientation, 4);
    take(pose.position, 3);
    OF(homogeneous_transform)(q, &OF(default_geometry), transform);
    take(&transform[0][0], 16);
    OF(jacobian)(q, &OF(default_geometry), jacobian);
    take(&jacobian[0][0], 6 * DOF);
    OF(velocity)(q, qd, &OF(default_geometry), twist);
    take(twist, 6);
    OF(jacobian_dot_times_qd)(q, qd, &OF(default_geometry), twist);
    take(twist, 6);
    (void)qdd, (void)row;
#ifdef HAS_INVERSE
    invert(round);
#endif
#ifdef HAS_DYNAMICS
    double mass[DOF][DOF];
    OF(inverse_dynamics)(q, qd, qdd, &OF(default_geometry), &OF(default_inertia), 9.81, row);
    take(row, DOF);
    OF(forward_dynamics)(q, qd, qdd, &OF(default_geometry), &OF(default_inertia), 9.81, row);
    take(row, DOF);
    OF(mass_matrix)(q, &OF(default_geometry), &OF(default_inertia), mass);
    take(&mass[0][0], DOF * DOF);
#endif
  }
  return conclude();
}
