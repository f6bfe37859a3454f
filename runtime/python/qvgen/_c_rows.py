# SPDX-License-Identifier: MIT
"""Prints the C99 that runs a robot's functions over rows, one exported function for each: see rows.h.

    QVGEN_ROWS ptrdiff_t rows_jacobian(const qvgen_call* c) {
      for (ptrdiff_t k = 0; k < c->count; ++k) puma560_jacobian(row(c, 0, k), c->geometry, result(c, 0, k, 36));
      return 0;
    }
"""

import math

from ._tables import AFTER_INERTIA, TASKS, VELOCITY, WITH_GRAVITY, entry_of, parts_of, sizes

HEAD = """/* SPDX-License-Identifier: MIT */
#include <limits.h>
#include <math.h>
#include <string.h>
{includes}
#include "rows.h"
typedef {number} number;
static const number* row(const qvgen_call* c, int which, ptrdiff_t k) {{
  return (const number*)c->rows[which] + k * c->steps[which];
}}
static void* result(const qvgen_call* c, int which, ptrdiff_t k, ptrdiff_t size) {{
  return (number*)c->results[which] + k * size;
}}
"""

PLAIN = """QVGEN_ROWS ptrdiff_t rows_{name}(const qvgen_call* c) {{
  for (ptrdiff_t k = 0; k < c->count; ++k) {call};
  return 0;
}}
"""

VELOCITIES = """QVGEN_ROWS ptrdiff_t rows_{name}(const qvgen_call* c) {{
  const {robot}_damping damping = {{(number)c->numbers[0], (number)c->numbers[1], (number)c->numbers[2]}};
  for (ptrdiff_t k = 0; k < c->count; ++k) {{
    {robot}_rates found;
    (void){robot}_{name}(row(c, 0, k), row(c, 1, k), {limits}c->geometry, &damping, &found);
    memcpy(result(c, 0, k, {dof}), found.qd, sizeof found.qd);
    ((int*)c->results[1])[k] = found.status;
    *(number*)result(c, 2, k, 1) = found.residual;
    *(number*)result(c, 3, k, 1) = found.factor;
    ((unsigned char*)c->results[4])[k] = found.limited != 0;
  }}
  return 0;
}}
"""

SOLUTIONS = """typedef void (*solver)(const qvgen_call*, ptrdiff_t, const double*, {robot}_solutions*);
static void put(const qvgen_call* c, ptrdiff_t at, const {robot}_solution* from) {{
  memcpy((double*)c->results[0] + at * {dof}, from->q, sizeof from->q);
  ((int*)c->results[1])[at] = from->branch;
  ((unsigned char*)c->results[2])[at] = from->continuum != 0;
}}
/* Writes every representative within limits, or counts them where there is no room. */
static double representatives(const qvgen_call* c, ptrdiff_t k, const {robot}_solutions* found) {{
  double count = 0;
  {robot}_representatives all;
  {robot}_start_representatives(found, c->lower, c->upper, &all);
  while ({robot}_next_representative(&all)) {{
    double turns = 1;
    if (c->capacity > 0) {{
      put(c, k * c->capacity + (ptrdiff_t)count, &all.row);
    }} else {{
      {counting}
    }}
    count += turns;
  }}
  return count;
}}
static ptrdiff_t all_rows(const qvgen_call* c, int seed_at, solver solve) {{
  double most = 0;
  for (ptrdiff_t k = 0; k < c->count; ++k) {{
    {robot}_solutions found;
    const double* seed = c->flags[0] ? row(c, seed_at, k) : NULL;
    solve(c, k, seed, &found);
    double count = found.count;
    if (seed == NULL && c->lower != NULL) {{
      const int is_free = found.count > 0 && (found.status != {robot}_solved || found.effort.passes > 0);
      {representing}
    }} else {{
      for (int n = 0; n < found.count; ++n) put(c, k * c->capacity + n, &found.rows[n]);
    }}
    ((int*)c->results[3])[k] = count < INT_MAX ? (int)count : INT_MAX;
    ((int*)c->results[4])[k] = found.status;
    if (count > most) most = count;
  }}
  return most < 9e18 ? (ptrdiff_t)most : (ptrdiff_t)9e18;
}}
static ptrdiff_t near_rows(const qvgen_call* c, int seed_at, solver solve) {{
  double before[{dof}];
  if (c->flags[1]) memcpy(before, row(c, seed_at, 0), sizeof before);
  for (ptrdiff_t k = 0; k < c->count; ++k) {{
    {robot}_solutions found;
    solve(c, k, c->flags[1] ? before : row(c, seed_at, k), &found);
    ((int*)c->results[1])[k] = found.status;
    if (found.count == 0) continue;
    memcpy(before, found.rows[0].q, sizeof before);
    memcpy(result(c, 0, k, {dof}), before, sizeof before);
  }}
  return 0;
}}
"""

# Next to a seed C moves what is free to where all joints are inside, at regular poses only by rounding.
REPRESENTING_JOINTS = """static const double zero[{dof}] = {{0}};
      if (is_free) solve(c, k, zero, &found);
      count = representatives(c, k, &found);
      if (!is_free && found.count > 0 && count == 0) {{
        solve(c, k, zero, &found);
        count = representatives(c, k, &found);
      }}"""
# A free joint may have values inside, which nothing has looked for.
REPRESENTING_MOTORS = """count = representatives(c, k, &found);
      if (found.count > 0 && count == 0) found.status = is_free ? {robot}_incomplete : {robot}_unreachable;"""

# The whole row at once: each joint goes to its last turn.
TURNS_OF_JOINTS = """for (int i = 0; i < {dof}; ++i) {{
        all.number[i] = all.below[i] + all.above[i];
        turns *= all.number[i] + 1;
      }}"""
# Turns move several motors: one after the other. What has more is not counted to its end, and has no room anyway.
TURNS_OF_MOTORS = "if (count >= 1e7) return 1e19;"

SOLVER = """static void solve_{label}(const qvgen_call* c, ptrdiff_t k, const double* seed, {robot}_solutions* found) {{
  const double* t = row(c, 0, k);
  {given}if ({within_if}c->lower != NULL)
    (void){robot}_{within}({target}, seed, c->lower, c->upper, c->geometry, c->numbers[0], found);
  else
    (void){robot}_{plain}({target}, seed, c->geometry, c->numbers[0], found);
}}
QVGEN_ROWS ptrdiff_t rows_{label}(const qvgen_call* c) {{ return {rows}_rows(c, {seed_at}, solve_{label}); }}
"""


def label_of(name, task):
    """The name of an exported function of inverse kinematics for one kind of target."""
    return f"{name}__{task}"


def c_name(name, task):
    """As C calls the function for that kind of target."""
    return name if task == "pose" else f"{name}_of_{task}"


def _plain(header, name, entry):
    arguments, shape, _, dynamics = entry
    robot, floats = header.robot, header.is_floating and dynamics
    rows = {each: f"row(c, {place}, k)" for place, each in enumerate(arguments.split())}
    behind = [rows.pop(each) for each in AFTER_INERTIA if each in rows]
    values = list(rows.values())
    if floats:  # the base, and the joints behind it
        values.insert(1, "row(c, 0, k) + 7")
    values.append("c->geometry")
    if dynamics:
        values.append("c->inertia")
    if name in WITH_GRAVITY:
        values.append("(number)c->numbers[0]")
    call = f"{robot}_{name}({', '.join(values + behind)}"
    if not shape:
        return PLAIN.format(name=name, call=f"*(number*)result(c, 0, k, 1) = {call})")
    size = sum(math.prod(sizes(part, header.numbers)) for _, part in parts_of(for_base(shape, floats)))
    return PLAIN.format(name=name, call=f"{call}, result(c, 0, k, {size}))")


def for_base(shape, floats):
    """The shape of a result where velocities begin with the base's."""
    return shape.replace("dof", "velocity_size") if floats else shape


def _solver(header, name, task):
    plain = c_name(name, task)
    declared = header.functions[plain].count("double given_")
    target = [*TASKS[task][2].values(), *(f"given[{i}]" for i in range(declared))]
    near = name.startswith("inverse_kinematics_near")
    return SOLVER.format(
        label=label_of(name, task), robot=header.robot, plain=plain, within=plain + "_within_limits", target=", ".join(target),
        given="const double* given = row(c, 1, k);\n  " if declared else "", seed_at=2 if declared else 1,
        within_if="" if near else "seed != NULL && ", rows="near" if near else "all")


def c_rows(header, includes, targets, number):
    """C of all that a robot's C has; of float without inverse kinematics."""
    robot, dof = header.robot, header.numbers["dof"]
    text = HEAD.format(includes="".join(f'#include "{each}"\n' for each in includes), number=number)
    for name in header.functions:
        if name in VELOCITY:
            text += VELOCITIES.format(name=name, robot=robot, dof=dof, limits="" if VELOCITY[name][1] is None else "c->lower, c->upper, ")
        elif entry_of(name):
            text += _plain(header, name, entry_of(name))
    if "total_mass" in header.functions:
        text += PLAIN.format(name="total_mass", call=f"*(number*)result(c, 0, k, 1) = {robot}_total_mass(c->geometry, c->inertia)")
    if number == "double" and targets:
        moves_motors = header.turns_move_motors
        counting = TURNS_OF_MOTORS if moves_motors else TURNS_OF_JOINTS.format(dof=dof)
        representing = (REPRESENTING_MOTORS if moves_motors else REPRESENTING_JOINTS).format(robot=robot, dof=dof)
        text += SOLUTIONS.format(robot=robot, dof=dof, counting=counting, representing=representing)
        text += "".join(_solver(header, name, task) for name, taken in targets.items() for task in taken)
    return text
