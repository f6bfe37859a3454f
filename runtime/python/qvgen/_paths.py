# SPDX-License-Identifier: MIT
"""Motions along paths: `arm.paths(poses)` runs `qvgen path`, which compiles a program for the arm once."""

import csv
import json
import pathlib
import subprocess
import tempfile
import typing

from ._tool import tool

# Options of `generate` that say how a description is read; the others say what is written.
_READING = ("--base", "--tip", "--name", "--snap", "--xacro-arg")


class Motion(typing.NamedTuple):
    """A continuous motion of the joints along a path. The path coordinate s counts poses from 0."""
    s: typing.Any  #: (n,), the poses that it passes, and its ends
    q: typing.Any  #: (n, dof), rad or m, at these places
    begins: str  #: why: "path_end", "meeting", "boundary", "flip", "limit", "unclear"
    ends: str  #: why, likewise
    branches: list  #: numbers along it; empty for arms by elimination
    turns: float  #: choices of whole turns within limits that give this motion
    values: typing.Any  #: (n,), what the free coordinate is, rad or m, (n, k) of several; None without one
    gaps: typing.Any  #: stretches (from, to) that are not proven; None without a proof
    t: typing.Any = None  #: (n,), s, at these places: least times with `time`, else the poses' `times`; None without
    overload: typing.Any = None  #: (joint, s, torque): the joint that cannot bear its load, for which there is no least time


class Paths(typing.NamedTuple):
    """Result of paths."""
    motions: list  #: of Motion: all that there are, or the best one where a coordinate is free
    whole: list  #: numbers of the motions that follow the whole path
    chain: list  #: (number, s): the fewest that follow it one after the other, and where each begins; else empty
    gaps: list  #: stretches (from, to) that no motion follows
    others: typing.Any = None  #: stretches on which other motions are not excluded; None without a proof
    fastest: typing.Any = None  #: with `time`, the number of the motion along the whole path that takes least; None without


def paths(source, robot, poses, *, free=None, hold=None, limits="description", times=None, screw=False, prefer=None,
          prove=False, time=None, joint_speeds=None, spline=False, blend=None, free_range=None, joint_torques=None,
          joint_jerks=None):
    """Every continuous motion of the joints that follows poses, (n, 7): w x y z, then metres.

    `limits`: "description", None, or (lower, upper). `times`: (n,), s. `hold`: {"theta3": 0.2}, a joint of seven that stays.
    `free`: "tool_x", "tool_y", "tool_z", "rail_x", "rail_y", "rail_z", "arm_angle" or a joint: the best motion, near to the
    joints `prefer` if there are any; `free_range`: (lower, upper) of it. Several, and tolerances, as a dictionary of what is
    free and its range, one number for both sides, or None: {"tool_z": None, "cone_z": 0.2, "shift_x": (-0.001, 0.002)}; also
    "base_x" to "base_z". A cone's half angle has two values, tilts about the other two axes, rad. `screw`: screw motions between the poses, not straight
    lines; `spline`: a cubic spline through them; `blend`: straight lines with corners rounded from so many metres before them.
    `prove`: each motion is proven, and that there is no other. `time`: largest joint accelerations, rad/s^2 or m/s^2, one or
    one for each: each motion gets its least times, from rest to rest, under these and the joints' speeds, the description's or
    `joint_speeds`, with rows between the poses. `joint_torques`: the largest ones too, N m or N, one or one for each, or
    "description". `joint_jerks`: the largest ones too, rad/s^3 or m/s^3; not beside torques. Raises ValueError with what is wrong with the path or the arm.
    """
    description, *options = source
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        _write(folder / "poses.csv", _rows(poses), times)
        command = [tool(), "path", description, folder / "poses.csv", *_reading(options), "-o", folder / "out.csv"]
        command += _options(robot, free, hold, limits, screw, prefer, prove)
        command += ["--spline"] * bool(spline) + _numbers("--blend", blend)
        command += [] if free_range is None else [f"--range={float(free_range[0])!r}:{float(free_range[1])!r}"]
        command += _numbers("--time", time) + _numbers("--joint-speeds", joint_speeds)
        command += _numbers("--joint-jerks", joint_jerks)
        by_description = isinstance(joint_torques, str)
        command += [f"--joint-torques={joint_torques}"] if by_description else _numbers("--joint-torques", joint_torques)
        command += [] if free else ["-o", folder / "out.json"]
        done = subprocess.run([str(each) for each in command], capture_output=True, text=True)
        if not (folder / "out.csv").exists():
            raise ValueError(done.stderr.strip().replace(str(folder) + "/", ""))
        rows = _read(folder / "out.csv")
        if free:
            return _best(rows, times, len(poses), robot.dof)
        return _all(rows, folder / "out.json", robot, hold or {}, times is not None or time is not None)


def _numpy():
    import numpy
    return numpy


def _rows(poses):
    rows = _numpy().asarray(poses, dtype=float)
    if rows.ndim != 2 or rows.shape[1] != 7 or len(rows) == 0:
        raise ValueError(f"poses has the shape {rows.shape}; it must be (n, 7): w x y z, then metres")
    return rows


def _write(file, rows, times):
    if times is not None and len(times) != len(rows):
        raise ValueError(f"there are {len(times)} times for {len(rows)} poses")
    columns = ["qw", "qx", "qy", "qz", "x [m]", "y [m]", "z [m]", *([] if times is None else ["t [s]"])]
    lines = [",".join(columns)]
    for i, row in enumerate(rows):
        numbers = [*row, *([] if times is None else [times[i]])]
        lines.append(",".join(repr(float(each)) for each in numbers))
    file.write_text("\n".join(lines) + "\n")


def _reading(options):
    chosen = []
    for option, value in zip(options, [*options[1:], None]):
        name = option.partition("=")[0]
        if name in _READING:
            chosen += [option] if "=" in option else [option, value]
    return chosen


def _limits_of(robot, limits):
    if isinstance(limits, str) and limits == "description":
        return []
    if limits is None:
        return ["--without-limits"]
    lower, upper = (_numpy().broadcast_to(_numpy().asarray(each, dtype=float), (robot.dof,)) for each in limits)
    chosen = ["--without-limits"]
    for name, low, high in zip(robot.joint_names, lower, upper):
        if abs(low) < float("inf") and abs(high) < float("inf"):
            chosen += ["--limit", f"{name}={float(low)!r}:{float(high)!r}"]
        elif abs(low) < float("inf") or abs(high) < float("inf") or low != low or high != high:
            raise ValueError(f"{name}: limits are two numbers, or infinite both")
    return chosen


def _options(robot, free, hold, limits, screw, prefer, prove):
    chosen = _limits_of(robot, limits)
    for name, value in (hold or {}).items():
        chosen += ["--hold", f"{name}={float(value)!r}"]
    chosen += ["--free=" + ",".join(_free_words(free))] if free else []
    chosen += ["--prefer=" + ",".join(repr(float(each)) for each in prefer)] if prefer is not None else []
    return chosen + ["--screw"] * bool(screw) + ["--prove"] * bool(prove)


def _free_words(free):
    if isinstance(free, str):
        return [free]
    words = []
    for name, ends in free.items():
        numbers = [] if ends is None else [f"{float(each)!r}" for each in _numpy().atleast_1d(ends)]
        if len(numbers) > 2:
            raise ValueError(f"{name}: {len(numbers)} numbers; a range has two, rad or m")
        words.append(name + "=" * bool(numbers) + ":".join(numbers))
    return words


def _numbers(option, values):
    if values is None:
        return []
    return [f"{option}=" + ",".join(repr(float(each)) for each in _numpy().atleast_1d(values))]


def _read(file):
    with file.open(newline="") as stream:
        return _numpy().array([[float(each) for each in row] for row in list(csv.reader(stream))[1:]])


def _all(rows, file, robot, hold, has_times):
    about = json.loads(file.read_text())
    first = 2 + has_times
    motions = []
    for number, each in enumerate(about["motions"], 1):
        own = rows[rows[:, 0] == number]
        branches = [branch for branch in (each["branches"][0], *(one["behind"] for one in each["crossings"])) if branch >= 0]
        gaps = [tuple(gap) for gap in each["proof"]["gaps"]] if "proof" in each else None
        motions.append(Motion(own[:, 1], _with_held(own[:, first:], about["joints"], robot, hold), each["begin"]["cause"],
                              each["end"]["cause"], branches, each["representatives"], None, gaps,
                              own[:, 2] if has_times else None, _overload(each, robot)))
    end = about["samples"] - 1
    whole = [i for i, each in enumerate(about["motions"]) if each["begin"]["s"] <= 0 and each["end"]["s"] >= end]
    chain = [(each["motion"], each["s"]) for each in about["chain"]]
    others = [tuple(gap) for gap in about["complete"]["gaps"]] if "complete" in about else None
    least = {i: about["motions"][i].get("least_time") for i in whole}
    timed = [i for i in whole if least[i] is not None]
    fastest = min(timed, key=least.get) if timed else None
    return Paths(motions, whole, chain, [tuple(gap) for gap in about["gaps"]], others, fastest)


def _overload(motion, robot):
    over = motion.get("overload")
    return None if over is None else (robot.joint_names[over["joint"]], over["s"], over["force"])


def _with_held(q, joints, robot, hold):
    """All joints in the arm's order, from those that move."""
    if len(joints) == robot.dof:
        return q
    moving = {name: q[:, column] for column, name in enumerate(joints)}
    columns = [moving.get(name, hold.get(name)) for name in robot.joint_names]
    return _numpy().stack([_numpy().broadcast_to(each, len(q)) for each in columns], axis=1)


def _best(rows, times, count, dof):
    if len(rows) == 0:
        return Paths([], [], [], [(0, count - 1)])
    first = 1 + (times is not None)
    is_whole = len(rows) == count
    values = rows[:, first:-dof]
    motion = Motion(rows[:, 0], rows[:, -dof:], "path_end", "path_end" if is_whole else "unclear", [], 1,
                    values[:, 0] if values.shape[1] == 1 else values, None, None if times is None else rows[:, 1])
    return Paths([motion], [0] if is_whole else [], [], [] if is_whole else [(rows[-1, 0], count - 1)])
