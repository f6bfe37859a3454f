# SPDX-License-Identifier: MIT
"""Makes the Python functions of a module's closed loops: assemblies, rates and dynamics of the driven joints.

Everything is computed in float64: in C, or in C++ what C has not.
"""

import numpy as np

from ._call import Rows, result
from ._functions import made
from ._inverse import solution_arrays
from ._loop_rows import ARGUMENTS, ON_FLOATING_BASE, TIP_MOTION, WRENCH_ON_FLOATING_BASE, argument_of, entry_of_loops, given_of, is_dynamics, with_base
from ._tables import sizes

USUAL_TOLERANCE = 1e-13
DEFAULTS = {"geometry": None, "inertia": None, "gravity": 9.80665}
MEANINGS = {"geometry": "values of constants of the description, by name",
            "inertia": "inertial parameters of the description, by name",
            "gravity": "acceleration of free fall along the world's -z, m/s^2"}

SET_DOC = """All assemblies of the loops: joint positions at which they close.

{given}: ({size},) or (n, {size}), {meaning}
seed: (dof,) or (n, dof): rows are sorted by their distance from it, and angles are next to it by whole turns
geometry: values of constants of the description, by name
tolerance: how far beyond the boundary of reach, as a share of the mechanism's size, the loops still close
Returns qvgen.Assemblies: q (max, dof), count (), status (), branch (max,), continuum (max,), meets (max,), with a batch
axis in front of each if an argument has one."""

FOLLOW_DOC = """The assembly next to a seed, by Newton's steps: it leads to one assembly, also where there is no closed form.

a: (driven_count,) or (n, driven_count), positions of the driven joints, rad or m
seed: (dof,) or (n, dof), an assembly nearby
path: the rows follow each other: `seed`, a single row, is the first one's, then the row before is the seed
geometry: values of constants of the description, by name
Returns qvgen.Followed: q (dof,), NaN where the loops do not close, and closed (), with a batch axis in front of each if an
argument has one."""

TIP_DOC = """The tip {tip} in the world, by the base and the driven joints: where it is and how it moves.

q: ({q},) or (n, {q}), {of_q}
ad: ({ad},) or (n, {ad}), {of_ad}
geometry: values of constants of the description, by name
Returns qvgen.TipMotion: pose (7,), jacobian (6, {ad}) and bias (6,), with a batch axis in front of each if an argument has
one. The tip's velocity is jacobian @ ad, its acceleration jacobian @ add + bias."""


def _numbers(robot):
    return with_base({**robot.loops.numbers, "dof": robot.header.numbers["dof"]})


def _doc(line, arguments, meanings, constants, shape):
    rows = [(each, *meanings[each]) for each in arguments]
    comma = "" if "," in shape or not shape else ","
    return "\n".join([line, "", *(f"{each}: ({size},) or (n, {size}), {meaning}" for each, size, meaning in rows),
                      *(f"{each}: {MEANINGS[each]}" for each in constants),
                      f"Returns float64 of the shape ({shape}{comma}), a batch axis in front if an argument has",
                      "one; in `out`, which may not overlap an argument, if it is given."])


def _plain(robot, name):
    """A function that gives an array for each row."""
    floats = robot.loops.base_floats
    listed, taken, shape, line = entry_of_loops(name, floats)
    arguments, constants, numbers = listed.split(), taken.split(), _numbers(robot)
    on_base = ON_FLOATING_BASE if is_dynamics(constants) else {"wrench": WRENCH_ON_FLOATING_BASE}
    meanings = ARGUMENTS | (on_base if floats else {})
    rows = [(each, sizes(meanings[each][0], numbers)) for each in arguments]
    row = sizes(shape, numbers)

    def call(given, geometry, inertia, gravity, out):
        at = Rows(np.float64)
        for value, (argument, size) in zip(given, rows):
            at.add(value, size, argument)
        at.constants("geometry", robot.geometry, geometry)
        at.constants("inertia", robot.inertia, inertia)
        at.call.numbers[0] = gravity
        to = result(out, at.shape(*row), np.float64)
        at.run(robot.function(f"rows_{name}", np.float64), to)
        return to

    values = ", ".join(each if each in constants else repr(DEFAULTS[each]) for each in DEFAULTS)
    parameters = [*arguments, "*", *((each, DEFAULTS[each]) for each in constants), ("out", None)]
    return made(name, parameters, f"({', '.join(arguments)},), {values}, out", _doc(line, arguments, meanings, constants, shape), call)


def _set(robot, name):
    """A function that gives all assemblies for each row."""
    given, numbers = given_of(name), _numbers(robot)
    size, meaning = argument_of(given)

    def call(value, seed, geometry, tolerance):
        from . import Assemblies
        in_c = f"rows_{name}_in_c"  # which has the usual tolerance alone
        symbol = in_c if tolerance == USUAL_TOLERANCE and robot.has_in_c(in_c) else f"rows_{name}"
        function = robot.function(symbol, np.float64)
        at = Rows(np.float64)
        at.add(value, sizes(size, numbers), given)
        if seed is not None:
            at.add(seed, (numbers["dof"],), "seed")
            at.call.flags[0] = 1
        at.constants("geometry", robot.geometry, geometry)
        at.call.numbers[0] = tolerance
        at.call.capacity = -1
        at.call.capacity = capacity = at.run(function)
        q, branch, continuum, count, status = solution_arrays(at, capacity, numbers["dof"])
        meets = np.zeros_like(continuum)
        at.run(function, q, branch, continuum, count, status, meets)
        return Assemblies(q, count, status, branch, continuum, meets)

    return made(name, [given, ("seed", None), "*", ("geometry", None), ("tolerance", USUAL_TOLERANCE)], f"{given}, seed, geometry, tolerance",
                SET_DOC.format(given=given, size=size, meaning=meaning), call)


def _follow(robot):
    """The function that finds the assembly next to a seed."""
    numbers = _numbers(robot)
    dof = numbers["dof"]

    def call(a, seed, path, geometry):
        from . import Followed
        at = Rows(np.float64)
        at.add(a, sizes("driven_count", numbers), "a")
        if at.add(seed, (dof,), "seed").ndim == 2 and path:
            raise ValueError("on a path there is one seed, that of the first row")
        at.constants("geometry", robot.geometry, geometry)
        at.call.flags[1] = bool(path)
        found = Followed(np.full(at.shape(dof), np.nan), np.zeros(at.shape(), bool))
        at.run(robot.function("rows_follow", np.float64), *found)
        return found

    return made("follow", ["a", "seed", "*", ("path", False), ("geometry", None)], "a, seed, path, geometry", FOLLOW_DOC, call)


def _tip_motion(robot, name):
    """The function that says where a tip is in the world, and how it moves."""
    numbers, size = _numbers(robot), _numbers(robot)["moved_count"]
    rows = {each: sizes(ON_FLOATING_BASE[each][0], numbers) for each in ("q", "ad")}

    def call(q, ad, geometry):
        from . import TipMotion
        at = Rows(np.float64)
        for value, each in ((q, "q"), (ad, "ad")):
            at.add(value, rows[each], each)
        at.constants("geometry", robot.geometry, geometry)
        found = TipMotion(*(np.empty(at.shape(*shape)) for shape in ((7,), (6, size), (6,))))
        at.run(robot.function(f"rows_{name}", np.float64), *found)
        return found

    doc = TIP_DOC.format(tip=name[len(TIP_MOTION):], q=rows["q"][0], ad=size, of_q=ON_FLOATING_BASE["q"][1], of_ad=ON_FLOATING_BASE["ad"][1])
    return made(name, ["q", "ad", "*", ("geometry", None)], "q, ad, geometry", doc, call)


def loop_functions(robot):
    """Functions of a robot's closed loops, by their names."""
    def function(name):
        if given_of(name):
            return _set(robot, name)
        if name == "follow":
            return _follow(robot)
        return _tip_motion(robot, name) if name.startswith(TIP_MOTION) else _plain(robot, name)

    return {name: function(name) for name in robot.loops.functions}


def loop_values(loops):
    """Facts of a module about its closed loops, by their names."""
    return {"driven_count": loops.numbers["driven_count"], **loops.joints}
