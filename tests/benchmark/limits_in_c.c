/* SPDX-License-Identifier: MIT */
/* Inverse kinematics in C next to seeds and within limits, at random poses, for callgrind: limits_in_c.sh compiles this
   for one robot, QVGEN_ROBOT, and prints instructions a call. With the argument `hash` it prints a hash of all rows of each
   call instead: two versions of the generated code give the same rows, bit for bit, if their hashes are the same. With the name
   of a call it makes that one alone. */
#define QVGEN_TEXT_OF(name) #name
#define QVGEN_TEXT(name) QVGEN_TEXT_OF(name)
#define QVGEN_JOINED_OF(left, right) left##right
#define QVGEN_JOINED(left, right) QVGEN_JOINED_OF(left, right)
#define ARM(name) QVGEN_JOINED(QVGEN_ROBOT, name)
#define ARM_IN(name) QVGEN_JOINED(QVGEN_JOINED(QVGEN_ROBOT, _inverse_kinematics), name)
#include QVGEN_HEADER

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <valgrind/callgrind.h>

enum { dof = ARM(_dof), most_poses = 10000 };

typedef struct Query {
  double q[dof], way[dof];  /* joints, ways from these to seeds */
  ARM(_pose) pose;
} Query;

static Query queries[most_poses];
static ARM(_solutions) found;
static double lower[dof], upper[dof], wide_lower[dof], wide_upper[dof];
static uint64_t hash;
static long rows;

/* A number in (-1, 1), the same on all machines. */
static double number(void) {
  static uint64_t state = 42;
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (double)(int64_t)(state >> 11 << 11) / 9223372036854775808.0;
}

static void draw(int count) {
  for (int i = 0; i < dof; ++i) {
    const double from = ARM(_lower_limits)[i], to = ARM(_upper_limits)[i];
    const int has_limits = from > -HUGE_VAL && to < HUGE_VAL;
    lower[i] = has_limits ? from : -170 * 3.14159265358979323846 / 180;
    upper[i] = has_limits ? to : 170 * 3.14159265358979323846 / 180;
    wide_lower[i] = has_limits ? 2 * lower[i] : -2 * 3.14159265358979323846;
    wide_upper[i] = has_limits ? 2 * upper[i] : 2 * 3.14159265358979323846;
  }
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < dof; ++i) {
      queries[k].q[i] = 0.5 * (lower[i] + upper[i]) + 0.5 * number() * (upper[i] - lower[i]);
      queries[k].way[i] = number();
    }
    ARM(_forward_kinematics)(queries[k].q, &ARM(_default_geometry), &queries[k].pose);
  }
}

static void mix(uint64_t bits) { hash = (hash ^ bits) * 1099511628211u; }

static void add_rows(int is_hashed) {
  rows += found.count;
  if (!is_hashed) return;
  mix((uint64_t)found.status);
  mix((uint64_t)found.count);
  for (int k = 0; k < found.count; ++k) {
    for (int i = 0; i < dof; ++i) {
      uint64_t bits = 0;
      memcpy(&bits, &found.rows[k].q[i], sizeof bits);
      mix(bits);
    }
    mix((uint64_t)found.rows[k].branch);
  }
}

static void visit_all(const double* from, const double* to, int is_hashed) {
  ARM(_representatives) all;
  ARM(_start_representatives)(&found, from, to, &all);
  while (ARM(_next_representative)(&all)) {
    ++rows;
    for (int i = 0; is_hashed && i < dof; ++i) {
      uint64_t bits = 0;
      memcpy(&bits, &all.row.q[i], sizeof bits);
      mix(bits);
    }
  }
}

static const char* const calls[] = {"all", "seed", "limits", "wide", "near_3mrad", "near_0.1", "near_1", "near_3", "near_limits", "turns", "wide_turns"};

static void call(int which, const Query* a, int is_hashed) {
  static const double ways[] = {0, 0.1, 0.1, 0.1, 0.003, 0.1, 1, 3, 0.003, 0, 0};
  double seed[dof];
  const ARM(_geometry)* g = &ARM(_default_geometry);
  const double tolerance = ARM(_default_tolerance);
  const double* turn = a->pose.orientation;
  const double* place = a->pose.position;
  for (int i = 0; i < dof; ++i) seed[i] = a->q[i] + ways[which] * a->way[i];
  switch (which) {
    case 0: ARM_IN()(turn, place, NULL, g, tolerance, &found); break;
    case 1: ARM_IN()(turn, place, seed, g, tolerance, &found); break;
    case 2: ARM_IN(_within_limits)(turn, place, seed, lower, upper, g, tolerance, &found); break;
    case 3: ARM_IN(_within_limits)(turn, place, seed, wide_lower, wide_upper, g, tolerance, &found); break;
    case 8: ARM_IN(_near_within_limits)(turn, place, seed, lower, upper, g, tolerance, &found); break;
    case 9:
    case 10: ARM_IN()(turn, place, NULL, g, tolerance, &found); break;
    default: ARM_IN(_near)(turn, place, seed, g, tolerance, &found);
  }
  if (which < 9) add_rows(is_hashed);
  if (which == 9) visit_all(lower, upper, is_hashed);
  if (which == 10) visit_all(wide_lower, wide_upper, is_hashed);
}

int main(int count, char** arguments) {
  const int is_hashed = count > 2 && strcmp(arguments[2], "hash") == 0;
  const int poses = count > 1 ? atoi(arguments[1]) : 500;
  if (poses < 1 || poses > most_poses) return 2;
  draw(poses);
  for (size_t which = 0; which < sizeof calls / sizeof *calls; ++which) {
    char text[64];
    if (count > 2 && !is_hashed && strcmp(arguments[2], calls[which]) != 0) continue;
    rows = 0;
    hash = 14695981039346656037u;
    CALLGRIND_ZERO_STATS;
    for (int k = 0; k < poses; ++k) call((int)which, &queries[k], is_hashed);
    snprintf(text, sizeof text, "%s %d %ld", calls[which], poses, rows);
    CALLGRIND_DUMP_STATS_AT(text);
    if (is_hashed) printf("%s %s %016llx %ld\n", QVGEN_TEXT(QVGEN_ROBOT), calls[which], (unsigned long long)hash, rows);
  }
  return 0;
}
