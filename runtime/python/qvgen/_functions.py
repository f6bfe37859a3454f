# SPDX-License-Identifier: MIT
"""Makes the Python functions of a robot's module: signature, docstring, and the call of the loop in its library.

Each is written as a line of Python, so that it has a plain signature and costs no more than a call:

    def jacobian(q, *, geometry=None, out=None): return _call((q,), geometry, None, 0.0, out)
"""

import collections

import numpy as np

from ._c_rows import for_base
from ._call import Rows, pair_of_rows, result, scalar_of
from ._tables import ARGUMENTS, FLOATING, OF_A_BASE, VELOCITY, WITH_GRAVITY, parts_of, sizes


def made(name, parameters, values, doc, call):
    """A function of Python with these parameters, (name, default) or a name alone, that returns call(values)."""
    written = [each if isinstance(each, str) else f"{each[0]}={each[1]!r}" for each in parameters]
    shown = ["*" if each == "*" else f"{each}: object" if isinstance(each, str) else f"{each[0]}: object = {each[1]!r}"
             for each in parameters]
    space = {"_call": call}
    exec(f"def {name}({', '.join(written)}): return _call({values})", space)
    function = space[name]
    function.__doc__ = f"{name}({', '.join(shown)}) -> object\n\n{doc}"
    return function


def _row_doc(name, shape, meaning):
    return f"{name}: ({shape},) or (n, {shape}), {meaning}"


def _result_doc(parts):
    shapes = [f"{name + ' ' if name else ''}({row}{'' if ',' in row or not row else ','})" for name, row in parts]
    return ", ".join(shapes)


def plain(robot, name, entry):
    """A function that gives an array for each row, or a named tuple of several."""
    listed, shape, text, dynamics = entry
    arguments = listed.split()
    floats = robot.header.is_floating and dynamics
    meanings = ARGUMENTS | (FLOATING if floats else {})
    facts = robot.header.numbers
    parts = parts_of(for_base(shape, floats and name not in OF_A_BASE))
    rows = [(each, sizes(meanings[each][0], facts)) for each in arguments]
    shapes = [sizes(part, facts) for _, part in parts]
    lengths = [int(np.prod(each)) for each in shapes]
    several = len(parts) > 1
    bundle = collections.namedtuple("".join(word.title() for word in name.split("_")), [part for part, _ in parts]) if several else None
    single_too = name not in OF_A_BASE  # those are in C++, in double alone
    symbol = f"rows_{name}"

    def call(given, geometry, inertia, gravity, out):
        dtype = scalar_of(given) if single_too else np.float64
        at = Rows(dtype)
        for value, (argument, size) in zip(given, rows):
            at.add(value, size, argument)
        at.constants("geometry", robot.geometry, geometry)
        if dynamics:
            at.constants("inertia", robot.inertia, inertia)
        at.call.numbers[0] = gravity
        if not several:
            to = result(out, at.shape(*shapes[0]), dtype)
            if to.size > 0:
                at.run(robot.function(symbol, dtype), to)
            return to
        to = np.empty(at.shape(sum(lengths)), dtype)
        at.run(robot.function(symbol, dtype), to)
        ends = np.cumsum(lengths)
        return bundle(*(to[..., end - length:end].reshape(at.shape(*shape)) for end, length, shape in zip(ends, lengths, shapes)))

    extra = []
    parameters = [*arguments, "*"]
    values = f"({', '.join(arguments)},), "
    if name in OF_A_BASE:
        values += "None, None, 0.0, out"
    else:
        parameters.append(("geometry", None))
        if dynamics:
            parameters.append(("inertia", None))
            extra.append("inertia: inertial parameters of the description, by name")
        if name in WITH_GRAVITY:
            parameters.append(("gravity", 9.80665))
            extra.append("gravity: acceleration of free fall along the world's -z, m/s^2")
        extra.append("geometry: values of constants of the description, by name")
        values += f"geometry, {'inertia' if dynamics else None}, {'gravity' if name in WITH_GRAVITY else 0.0}, "
        values += "None" if several else "out"
    if not several:
        parameters.append(("out", None))
    single = f"Computed and returned in float32 if all of\n{', '.join(arguments)} are arrays of float32, else in float64."
    doc = [text, "", *(_row_doc(each, *meanings[each]) for each in arguments), *extra,
           f"Returns {'a named tuple of ' if several else 'the shape '}{_result_doc(parts)}, a batch axis in front if an argument has one;",
           "" if several else "in `out`, which may not overlap an argument, if it is given. "]
    doc[-1] += single if single_too else "Computed in float64."
    return made(name, parameters, values, "\n".join(doc), call)


def total_mass(robot):
    """The mass of all links, which has no rows."""
    def call(geometry, inertia):
        at = Rows(np.float64)
        at.constants("geometry", robot.geometry, geometry)
        at.constants("inertia", robot.inertia, inertia)
        mass = np.empty(())
        at.run(robot.function("rows_total_mass", np.float64), mass)
        return float(mass)

    return made("total_mass", ["*", ("geometry", None), ("inertia", None)], "geometry, inertia",
                "Mass of all links, kg. geometry, inertia: values of constants of the description, by name.", call)


_VELOCITY_DOC = """{line}

q: (dof,) or (n, dof), joint positions, rad or m
twist: (6,) or (n, 6), twist of the tool in the world frame, m/s and rad/s, linear first
{limits}geometry: values of constants of the description, by name
threshold, damping, scale: singular values below threshold times the largest are damped, at zero by damping times the
    largest, which counts as at least scale, m or rad
Returns qvgen.JointRates: qd (dof,), status (), residual (), factor (), limited (), with a batch axis in front of each if
an argument has one. Computed and returned in float32 if q and twist are arrays of float32, else in float64."""

_RATE_LIMITS_DOC = """limits: "description": the greatest velocities of the description; (lower, upper): two rows of dof numbers, rad/s or m/s;
    {meaning}
"""


def velocity(robot, name):
    """A function that gives joint rates for a twist."""
    line, meaning = VELOCITY[name]
    dof = robot.header.numbers["dof"]

    def call(q, twist, limits, geometry, *options):
        from . import JointRates
        dtype = scalar_of((q, twist))
        at = Rows(dtype)
        pair = None
        if meaning and not (isinstance(limits, str) and limits == "description"):
            pair = pair_of_rows(limits, dof, dtype, "rows")
            if pair is None:
                raise ValueError('limits: neither "description", nor a pair (lower, upper)')
        at.add(q, (dof,), "q")
        at.add(twist, (6,), "twist")
        at.constants("geometry", robot.geometry, geometry)
        if pair is not None:
            at.limits(*pair)
        at.call.numbers[:] = options
        shape = at.shape()
        found = [np.empty(at.shape(dof), dtype), np.empty(shape, np.int32), np.empty(shape, dtype), np.empty(shape, dtype),
                 np.empty(shape, bool)]
        at.run(robot.function(f"rows_{name}", dtype), *found)
        return JointRates(*found)

    limits = [("limits", "description")] if meaning else []
    options = [("threshold", 0.02), ("damping", 0.02), ("scale", 0.05)]
    return made(name, ["q", "twist", "*", *limits, ("geometry", None), *options],
                f"q, twist, {'limits' if meaning else None}, geometry, threshold, damping, scale",
                _VELOCITY_DOC.format(line=line, limits=_RATE_LIMITS_DOC.format(meaning=meaning) if meaning else ""), call)
