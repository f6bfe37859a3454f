# SPDX-License-Identifier: MIT
"""Prints the C99 that runs functions of closed loops over rows: those that the robot's qvgen_ROBOT_loops.h declares.

    QVGEN_ROWS ptrdiff_t rows_rates(const qvgen_call* c) {
      for (ptrdiff_t k = 0; k < c->count; ++k) four_bar_rates(row(c, 0, k), c->geometry, result(c, 0, k, 3));
      return 0;
    }
"""

import math
import re

from ._loop_rows import TIP_MOTION, entry_of_loops, given_of, is_dynamics, with_base
from ._tables import sizes

PLAIN = """QVGEN_ROWS ptrdiff_t rows_{name}(const qvgen_call* c) {{
  for (ptrdiff_t k = 0; k < c->count; ++k) {call};
  return 0;
}}
"""

SET = """QVGEN_ROWS ptrdiff_t rows_{name}_in_c(const qvgen_call* c) {{
  if (c->capacity < 0) return {robot}_{name}_capacity;
  for (ptrdiff_t k = 0; k < c->count; ++k) {{
    int free_joints[c->capacity], meets[c->capacity];
    const ptrdiff_t at = k * c->capacity;
    int* count = (int*)c->results[3] + k;
    *count = {robot}_{name}({target}, c->flags[0] ? row(c, 1, k) : NULL, c->geometry, (int)c->capacity, result(c, 0, at, {dof}),
        (int*)c->results[1] + at, free_joints, meets, (int*)c->results[4] + k);
    for (int i = 0; i < *count; ++i) {{
      ((unsigned char*)c->results[2])[at + i] = (unsigned char)free_joints[i];
      ((unsigned char*)c->results[5])[at + i] = (unsigned char)meets[i];
    }}
  }}
  return 0;
}}
"""

FOLLOW = """QVGEN_ROWS ptrdiff_t rows_follow(const qvgen_call* c) {{
  double before[{dof}], found[{dof}];
  for (ptrdiff_t k = 0; k < c->count; ++k) {{
    if (!c->flags[1] || k == 0) memcpy(before, row(c, 1, k), sizeof before);
    const int is_closed = {robot}_follow(row(c, 0, k), before, c->geometry, found);
    ((unsigned char*)c->results[1])[k] = is_closed != 0;
    if (!is_closed) continue;
    memcpy(before, found, sizeof before);
    memcpy(result(c, 0, k, {dof}), found, sizeof found);
  }}
  return 0;
}}
"""

TIP = """QVGEN_ROWS ptrdiff_t rows_{name}(const qvgen_call* c) {{
  for (ptrdiff_t k = 0; k < c->count; ++k) {{
    double* pose = result(c, 0, k, 7);
    {robot}_{name}(row(c, 0, k), row(c, 0, k) + 7, row(c, 1, k), c->geometry, pose, pose + 4, result(c, 1, k, {size}), result(c, 2, k, 6));
  }}
  return 0;
}}
"""


def _plain(robot, name, numbers, floats):
    listed, constants, shape, _ = entry_of_loops(name, floats)
    taken = {"geometry": "c->geometry", "inertia": "c->inertia", "gravity": "c->numbers[0]"}
    rows = {each: f"row(c, {place}, k)" for place, each in enumerate(listed.split())}
    behind = [rows.pop("fall")] if "fall" in rows else []  # where it stands in C
    values = list(rows.values())
    if floats and is_dynamics(constants):  # the base, and the joints behind it
        values.insert(1, "row(c, 0, k) + 7")
    values = ", ".join([*values, *(taken[each] for each in constants.split()), *behind])
    if not shape:
        return PLAIN.format(name=name, call=f"*(double*)result(c, 0, k, 1) = {robot}_{name}({values})")
    to = f"result(c, 0, k, {math.prod(sizes(shape, numbers))})"
    results = f"{to}, (double*){to} + 4" if name.startswith("pose_of_") else to
    return PLAIN.format(name=name, call=f"{robot}_{name}({values}, {results})")


def loop_rows_in_c(robot, text, numbers):
    """C of all that the header `text` declares. `numbers`: counts of joints, by name."""
    names = dict.fromkeys(re.findall(rf"^(?:void|int|double) {robot}_(\w+)\(", text, re.MULTILINE))
    floats = "double base[7]" in text
    code = f'#include "qvgen_{robot}_loops.h"\n'
    for name in names:
        if given_of(name):
            target = "row(c, 0, k), row(c, 0, k) + 4" if given_of(name) == "pose" else "row(c, 0, k)"
            code += SET.format(robot=robot, name=name, dof=numbers["dof"], target=target)
        elif name == "follow":
            code += FOLLOW.format(robot=robot, dof=numbers["dof"])
        elif name.startswith(TIP_MOTION):
            code += TIP.format(robot=robot, name=name, size=6 * with_base(numbers)["moved_count"])
        else:
            code += _plain(robot, name, with_base(numbers), floats)
    return code
