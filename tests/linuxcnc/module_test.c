/* SPDX-License-Identifier: MIT */
/* A robot's component of LinuxCNC, called as the motion controller calls it: poses, ways back, tool lengths,
 * units, time. */
#define _POSIX_C_SOURCE 199309L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "hal.h"
#include "kinematics.h"
#include "rtapi_app.h"

extern int rtapi_app_main(void);
extern void rtapi_app_exit(void);

/* HAL, of three pins. */
enum { UNITS, LENGTH, OFFSET, PINS };
static double values[PINS];
static const char* names[PINS];
static int pins, ready;
int hal_init(const char* name) { return strlen(name) > 10 ? 7 : -1; }
int hal_exit(int component) { return component == 7 ? 0 : -1; }
int hal_ready(int component) {
  ready = component;
  return 0;
}
void* hal_malloc(long int size) { return calloc(1, (size_t)size); }
int hal_pin_float_newf(hal_pin_dir_t direction, hal_float_t** pin, int component, const char* format, ...) {
  if (direction != HAL_IN || component != 7 || pins == PINS) return -1;
  names[pins] = format;
  *pin = &values[pins++];
  return 0;
}

static int failures;
static void expect(int holds, const char* what, int i) {
  if (!holds && ++failures < 10) printf("round %d: %s\n", i, what);
}

static double between(double lower, double upper) { return lower + (upper - lower) * rand() / RAND_MAX; }

/* The matrix of c about z after b about y after a about x, degrees: the product as it stands. */
static void rotation(const EmcPose* at, double r[3][3]) {
  const double d = acos(-1) / 180, a = at->a * d, b = at->b * d, c = at->c * d;
  const double x[3][3] = {{1, 0, 0}, {0, cos(a), -sin(a)}, {0, sin(a), cos(a)}};
  const double y[3][3] = {{cos(b), 0, sin(b)}, {0, 1, 0}, {-sin(b), 0, cos(b)}};
  const double z[3][3] = {{cos(c), -sin(c), 0}, {sin(c), cos(c), 0}, {0, 0, 1}};
  double zy[3][3] = {{0}};
  memset(r, 0, 9 * sizeof(double));
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) zy[i][k] += z[i][j] * y[j][k];
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) r[i][k] += zy[i][j] * x[j][k];
}

/* The robot's own functions, from a library of its own. */
extern const int ROBOT(dof_is), ROBOT_REVOLUTE[];
extern void ROBOT(matrix)(const double* q, double result[4][4]);

/* DIRECTION: 0 for poses; else the sign of the tool's z axis in the direction that has the coordinates b and
 * c. */
static void orientation_is(const EmcPose* world, double wanted[4][4], int i) {
  double r[3][3];
  rotation(world, r);
  for (int k = 0; k < 3; ++k)
    for (int j = DIRECTION ? 2 : 0; j < 3; ++j)
      expect(fabs(r[k][j] - (DIRECTION ? DIRECTION : 1) * wanted[k][j]) < 1e-12, "the angles are others", i);
}

/* Of both ways to write a direction the one that is nearest to the coordinates before. */
static void coordinates_stay(const double joint[9], const EmcPose* there, int i) {
  EmcPose world = *there;
  world.b = -there->b;
  world.c = there->c + 900;
  kinematicsForward(joint, &world, NULL, NULL);
  expect(fabs(world.b + there->b) < 1e-9 && fabs(world.c - there->c - 900) < 1e-9, "coordinates jump", i);
}

/* Where the tool is vertical the coordinates lead, when it tilts, to joints next to those that were there. */
static void vertical_tool(double turn, int dof, int i) {
  double joint[9] = {10, 20, 30, turn, 0}, near[9];
  EmcPose world = {{0, 0, 0}, 0, 0, 0, 0, 0, 0};
  kinematicsForward(joint, &world, NULL, NULL);
  for (int tilt = -1; tilt <= 1; ++tilt) {
    EmcPose tilted = world;
    tilted.b += 0.01 * tilt;
    memcpy(near, joint, sizeof near);
    expect(kinematicsInverse(&tilted, near, NULL, NULL) == 0, "no way from a vertical tool", i);
    for (int k = 3; k < dof; ++k) expect(fabs(near[k] - joint[k]) < 0.02, "a turn at a vertical tool", i);
  }
}

/* GIVEN: joints that are coordinates u, v and w, "-1," if there are none. */
static void given_joints_are_coordinates(const double joint[9], int i) {
  const int given[] = {GIVEN};
  EmcPose world = {{0, 0, 0}, 0, 0, 0, -1, -1, -1};
  kinematicsForward(joint, &world, NULL, NULL);
  const double found[3] = {world.u, world.v, world.w};
  for (size_t k = 0; k < 3; ++k) {
    const int is_given = k < sizeof given / sizeof *given && given[k] >= 0;
    expect(found[k] == (is_given ? joint[given[k]] : -1), "a coordinate u, v or w", i);
  }
}

static void tip_is(const double joint[9], const double wanted[3], int i) {
  EmcPose world = {{0, 0, 0}, 0, 0, 0, 0, 0, 0};
  kinematicsForward(joint, &world, NULL, NULL);
  const double tip[3] = {world.tran.x, world.tran.y, world.tran.z};
  for (int k = 0; k < 3; ++k) expect(fabs(tip[k] - wanted[k]) < 1e-9, "the tool is elsewhere", i);
}

static void forward_is_the_robots(const double joint[9], int dof, int i) {
  EmcPose world = {{0, 0, 0}, 0, 0, 0, 0, 0, 0};
  double q[9], wanted[4][4], tip[3];
  for (int k = 0; k < dof; ++k) q[k] = joint[k] * (ROBOT_REVOLUTE[k] ? acos(-1) / 180 : 0.001);
  ROBOT(matrix)(q, wanted);
  expect(kinematicsForward(joint, &world, NULL, NULL) == 0, "forward fails", i);
  orientation_is(&world, wanted, i);
  if (DIRECTION) coordinates_stay(joint, &world, i);
  for (int k = 0; k < 3; ++k) tip[k] = 1000 * wanted[k][3];
  tip_is(joint, tip, i);
  values[LENGTH] = 120;
  for (int k = 0; k < 3; ++k) tip[k] += 120 * wanted[k][2];
  tip_is(joint, tip, i);
  values[OFFSET] = 30;
  for (int k = 0; k < 3; ++k) tip[k] += 30 * (wanted[k][2] + (k == 2));
  tip_is(joint, tip, i);
  values[LENGTH] = values[OFFSET] = 0;
}

/* The way back from joints half a degree away reaches the pose. It leads to the same joints, but where a
   singular pose is between these and the seed, which is rare. */
static void back_to(const double joint[9], int dof, int i, int* others) {
  EmcPose world = {{0, 0, 0}, 0, 0, 0, 0, 0, 0}, again;
  double near[9];
  values[LENGTH] = i % 3 ? 0 : 75;
  values[OFFSET] = i % 5 ? 0 : 40;
  kinematicsForward(joint, &world, NULL, NULL);
  for (int k = 0; k < dof; ++k) near[k] = joint[k] + between(-0.5, 0.5);
  expect(kinematicsInverse(&world, near, NULL, NULL) == 0, "no way back", i);
  double way = 0;
  for (int k = 0; k < dof; ++k) way = fmax(way, fabs(near[k] - joint[k]));
  *others += way > 1e-6;
  expect(way < 190, "joints turn wholly", i);
  again = world;
  kinematicsForward(near, &again, NULL, NULL);
  expect(hypot(hypot(again.tran.x - world.tran.x, again.tran.y - world.tran.y), again.tran.z - world.tran.z) <
             1e-7,
         "pose", i);
  values[LENGTH] = values[OFFSET] = 0;
}

/* Microseconds of a way back and a way forth, of the fastest of many rounds: others may use the processor,
 * too. */
static double time_of_a_cycle(double joint[9], EmcPose* world) {
  double best = 1e9;
  kinematicsForward(joint, world, NULL, NULL);
  for (int round = 0; round < 100; ++round) {
    struct timespec from, to;
    clock_gettime(CLOCK_MONOTONIC, &from);
    for (int i = 0; i < 200; ++i) {
      world->tran.z += i % 2 ? 0.1 : -0.1;
      failures += kinematicsInverse(world, joint, NULL, NULL) != 0 ||
                  kinematicsForward(joint, world, NULL, NULL) != 0;
    }
    clock_gettime(CLOCK_MONOTONIC, &to);
    best = fmin(best,
                ((double)(to.tv_sec - from.tv_sec) * 1e6 + (double)(to.tv_nsec - from.tv_nsec) * 1e-3) / 200);
  }
  return best;
}

int main(void) {
  expect(rtapi_app_main() == 0 && ready == 7 && pins == PINS && values[UNITS] == 1000, "HAL", 0);
  expect(values[LENGTH] == 0 && values[OFFSET] == 0, "a tool", 0);
  expect(strstr(names[UNITS], "_kins.units-per-metre") && strstr(names[LENGTH], "_kins.tool-length") &&
             strstr(names[OFFSET], "_kins.tool-offset"),
         "names of pins", 0);
  expect(kinematicsType() == KINEMATICS_BOTH && kinematicsSwitchable() == 0, "type", 0);
  const int dof = ROBOT(dof_is);
  int others = 0;
  for (int i = 0; i < 2000; ++i) {
    double joint[9];
    for (int k = 0; k < dof; ++k)
      joint[k] = between(20, 70) * (i % 2 ? 1 : -1) + (ROBOT_REVOLUTE[k] && i % 7 == 0 ? 360 : 0);
    forward_is_the_robots(joint, dof, i);
    given_joints_are_coordinates(joint, i);
    back_to(joint, dof, i, &others);
    if (DIRECTION) vertical_tool(between(-180, 180), dof, i);
  }
  expect(others <= 5, "other joints", others);
  EmcPose world = {{0, 0, 0}, 0, 0, 0, 0, 0, 0};
  double joint[9] = {10, 20, 30, 40, 50, 60}, before[9];
  kinematicsForward(joint, &world, NULL, NULL);
  memcpy(before, joint, sizeof joint);
  int slides = 0;
  for (int k = 0; k < dof; ++k) slides += !ROBOT_REVOLUTE[k];
  world.tran.x += 1e5;
  expect(slides || kinematicsInverse(&world, joint, NULL, NULL) != 0, "out of reach", 0);
  world.tran.x = NAN;
  expect(kinematicsInverse(&world, joint, NULL, NULL) != 0, "no number", 0);
  expect(memcmp(before, joint, sizeof joint) == 0, "joints of a failure", 0);
  const double microseconds = time_of_a_cycle(joint, &world);
  rtapi_app_exit();
  printf("%d failures, %.2f us a cycle\n", failures, microseconds);
  return failures != 0;
}
