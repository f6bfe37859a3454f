# SPDX-License-Identifier: MIT
"""Makes the Python functions of a module's inverse kinematics, of the arm angle and of the nearest pose.

Rows of solutions are padded to equal length. Everything is computed in float64.
"""

import numpy as np

from . import orientation
from ._c_rows import label_of
from ._call import Rows, numbers, pair_of_rows
from ._functions import made
from ._tables import POSE, TASKS

GIVEN_DOC = "given: () or (n,), of several joints (k,) or (n, k): value of {joint}, rad or m"

REFERENCE_DOC = 'reference: "conventional": counted from a fixed direction, or "stereographic": from one that turns along'

ANGLE_DOC = f"""Arm angle of joint values, rad in (-pi, pi]: the turn of the elbow about the line from shoulder to wrist.

q: (dof,) or (n, dof), joint positions, rad
{REFERENCE_DOC}
geometry: values of constants of the description, by name
Returns float64 of the shape (), a batch axis in front if q has one."""

COMMON_DOC = """geometry: values of constants of the description, by name
tolerance: how far beyond the boundary of reach, as a share of the arm's size, a pose is still solved"""

ANGLE_SOLUTIONS_DOC = f"""All joint values that bring the tool to a pose with an arm angle.

pose: (7,) or (n, 7), {POSE}
psi: () or (n,), arm angle, rad
seed: (dof,) or (n, dof): solutions are sorted by their distance from it, free joints are taken from it
{REFERENCE_DOC}
{COMMON_DOC}
Returns qvgen.Solutions, with a batch axis in front of each field if an argument has one."""

ANGLE_LIMITS_DOC = f"""Joint values within limits that bring the tool to a pose, wherever there are any: one row for each branch.

pose: (7,) or (n, 7), {POSE}
seed: (dof,) or (n, dof): the arm angle nearest to its, the nearest row first; without: the one farthest from the limits
limits: "description": the description's; (lower, upper): two rows of dof numbers
{COMMON_DOC}
Returns qvgen.Solutions, with a batch axis in front of each field if an argument has one."""

ALL_DOC = """All joint values that bring the tool to a pose.

{targets}seed: (dof,) or (n, dof): solutions are sorted by their distance from it, free joints are taken from it
limits: None: angles in (-pi, pi], each once; "description": the description's; (lower, upper): two rows of dof numbers.
    Within limits angles that differ by whole turns are different solutions; with a seed the nearest of each branch
{common}
Returns qvgen.Solutions: q (max, dof), count (), status (), branch (max,), continuum (max,), with a batch axis in
front of each if an argument has one. Always computed and returned in float64."""

NEAR_DOC = """For control loops: the joint values on the branch of the seed, the joints that went before.

{targets}seed: (dof,) or (n, dof); angles are within half a turn of it
path: the targets follow each other: `seed`, a single row, is the first one's, then the last solution before a target is its seed
limits: None; "description": the description's; (lower, upper): two rows of dof numbers. The solution without limits if it is
    within them, else none: it neither jumps to another branch nor by whole turns
{common}
Returns qvgen.NearSolution: q (dof,), NaN if there is none, and status (), with a batch axis in front of each if an
argument has one. Check the distance of q to the seed if jumps are not allowed. Always computed and returned in float64."""

NEAREST_POSE_DOC = f"""Joint values whose pose is nearest to a given one, the nearest first: for poses that were rounded or are out of reach.

pose: (7,) or (n, 7), {POSE}
seed: (dof,) or (n, dof): one more start of the descent
prefer: "both": least squares; "position" or "orientation": that first, and of what is left the nearest other
metres_per_radian: m, the distance that counts as much as a radian; 0: the arm's size
limits: None; "description": the description's; (lower, upper): two rows of dof numbers
starts: starts spread over the joints' ranges; with a good seed 0 is enough
geometry: values of constants of the description, by name
Returns qvgen.NearestRows: q (16, dof), position_error (16,), m, orientation_error (16,), rad, continuum (16,), count (),
status (): solved where the first row reaches the pose, else unreachable; with a batch axis in front of each if an argument
has one. Always computed and returned in float64."""

TOLERANCE = ("tolerance", 1e-13)
GEOMETRY = ("geometry", None)


def _limits(robot, limits):
    """Lower and upper limits, or None."""
    if limits is None:
        return None
    dof = robot.header.numbers["dof"]
    if isinstance(limits, str) and limits == "description":
        return [np.array(robot.facts[name], float) for name in ("lower_limits", "upper_limits")]
    pair = pair_of_rows(limits, dof, np.float64, "poses")
    if pair is None:
        raise ValueError('limits: neither None, nor "description", nor a pair (lower, upper)')
    return pair


def solution_arrays(at, capacity, dof):
    """q, branch, continuum, count and status as they are where there is no row."""
    return [np.full(at.shape(capacity, dof), np.nan), np.full(at.shape(capacity), -1, np.int32), np.zeros(at.shape(capacity), bool),
            np.empty(at.shape(), np.int32), np.empty(at.shape(), np.int32)]


def _solutions(robot, at, function, capacity, seed, limits, tolerance):
    """qvgen.Solutions of a call; rows within limits without a seed are counted before there is room for them."""
    from . import Solutions
    dof = robot.header.numbers["dof"]
    if seed is not None:
        at.add(seed, (dof,), "seed")
        at.call.flags[0] = 1
    if limits is not None:
        at.limits(*limits)
    at.call.numbers[0] = tolerance
    if capacity is None:
        at.call.capacity = 0
        most = at.run(function, *solution_arrays(at, 0, dof))
        if float(most) * max(at.batch, 1) * dof > 5e8:
            raise ValueError(f"limits: a pose has {most} solutions that differ by whole turns: narrow the limits, pass fewer poses "
                             "at once, or a seed, for one solution of each branch")
        capacity = most
    arrays = solution_arrays(at, capacity, dof)
    at.call.capacity = capacity
    at.run(function, *arrays)
    q, branch, continuum, count, status = arrays
    return Solutions(q, count, status, branch, continuum)


def _task_of(taken, target):
    """The kind of a target, told by the length of its last axis. Returns the array too."""
    array = numbers(target, np.float64, "pose" if taken == ["pose"] else "target")
    if array.ndim in (2, 3) and array.shape[-2:] == (4, 4) and not any(TASKS[task][0] == 4 for task in taken):
        array = np.concatenate([orientation.from_matrix(array[..., :3, :3]), array[..., :3, 3]], axis=-1)
    length = array.shape[-1] if array.ndim else -1
    return next((task for task in ["pose", *taken] if task in taken and TASKS[task][0] == length), taken[0]), array


def _targets_doc(target, taken, joint):
    shapes = [f"({size},) or (n, {size}), {meaning}" for size, meaning, *_ in (TASKS[task] for task in taken)]
    given = GIVEN_DOC.format(joint=joint) + "\n" if joint else ""
    if not any(TASKS[task][0] == 4 for task in taken):
        shapes.append("(4, 4) or (n, 4, 4), the pose as a matrix")
    return f"{target}: " + ";\n    or ".join(shapes) + "\n" + given


def inverse(robot, name, taken, given_count):
    """A function of inverse kinematics; `taken` are the names of the tasks that it takes."""
    joint = name.partition("_given_")[2]
    target = "pose" if taken == ["pose"] else "target"
    near = name.startswith("inverse_kinematics_near")
    dof = robot.header.numbers["dof"]

    def begin(pose, given, geometry):
        task, array = _task_of(taken, pose)
        at = Rows(np.float64)
        at.add(array, (TASKS[task][0],), target)
        if joint:
            at.add(given, () if given_count == 1 else (given_count,), "given")
        at.constants("geometry", robot.geometry, geometry)
        return at, robot.function(f"rows_{label_of(name, task)}", np.float64)

    def all_(pose, given, seed, limits, geometry, tolerance):
        at, function = begin(pose, given, geometry)
        bounds = _limits(robot, limits)
        at.call.capacity = -1
        capacity = None if bounds is not None and seed is None else robot.capacity or at.run(function)
        return _solutions(robot, at, function, capacity, seed, bounds, tolerance)

    def near_(pose, given, seed, path, limits, geometry, tolerance):
        from . import NearSolution
        at, function = begin(pose, given, geometry)
        bounds = _limits(robot, limits)
        if at.add(seed, (dof,), "seed").ndim == 2 and path:
            raise ValueError("on a path there is one seed, that of the first pose")
        if bounds is not None:
            at.limits(*bounds)
        at.call.flags[1] = bool(path)
        at.call.numbers[0] = tolerance
        found = NearSolution(np.full(at.shape(dof), np.nan), np.empty(at.shape(), np.int32))
        at.run(function, *found)
        return found

    first = [target, "given"] if joint else [target]
    doc = (NEAR_DOC if near else ALL_DOC).format(targets=_targets_doc(target, taken, joint), common=COMMON_DOC)
    given = "given" if joint else None
    if near:
        return made(name, [*first, "seed", "*", ("path", False), ("limits", None), GEOMETRY, TOLERANCE],
                    f"{target}, {given}, seed, path, limits, geometry, tolerance", doc, near_)
    return made(name, [*first, ("seed", None), "*", ("limits", None), GEOMETRY, TOLERANCE],
                f"{target}, {given}, seed, limits, geometry, tolerance", doc, all_)


def _reference(name):
    if name not in ("conventional", "stereographic"):
        raise ValueError('reference: neither "conventional" nor "stereographic"')
    return name == "stereographic"


def arm_angle(robot):
    """Functions of arms with a spherical shoulder and wrist, by their names."""
    dof = robot.header.numbers["dof"]

    def angle(q, reference, geometry):
        at = Rows(np.float64)
        at.call.flags[1] = _reference(reference)
        at.add(q, (dof,), "q")
        at.constants("geometry", robot.geometry, geometry)
        found = np.empty(at.shape())
        at.run(robot.function("rows_arm_angle", np.float64), found)
        return found

    def with_angle(pose, psi, seed, reference, geometry, tolerance):
        at = Rows(np.float64)
        at.call.flags[1] = _reference(reference)
        at.add(pose, (7,), "pose")
        at.add(psi, (), "psi")
        at.constants("geometry", robot.geometry, geometry)
        return _solutions(robot, at, robot.function("rows_inverse_kinematics_arm_angle__pose", np.float64), 8, seed, None, tolerance)

    def within(pose, seed, limits, geometry, tolerance):
        if limits is None:
            raise ValueError('limits: "description", or a pair (lower, upper)')
        at = Rows(np.float64)
        at.add(pose, (7,), "pose")
        at.constants("geometry", robot.geometry, geometry)
        bounds = _limits(robot, limits)
        return _solutions(robot, at, robot.function("rows_inverse_kinematics__pose", np.float64), 8, seed, bounds, tolerance)

    reference = ("reference", "conventional")
    return {
        "arm_angle": made("arm_angle", ["q", "*", reference, GEOMETRY], "q, reference, geometry", ANGLE_DOC, angle),
        "inverse_kinematics_arm_angle": made(
            "inverse_kinematics_arm_angle", ["pose", "psi", ("seed", None), "*", reference, GEOMETRY, TOLERANCE],
            "pose, psi, seed, reference, geometry, tolerance", ANGLE_SOLUTIONS_DOC, with_angle),
        "inverse_kinematics": made(
            "inverse_kinematics", ["pose", ("seed", None), "*", ("limits", "description"), GEOMETRY, TOLERANCE],
            "pose, seed, limits, geometry, tolerance", ANGLE_LIMITS_DOC, within)}


def nearest_pose(robot):
    """The function that finds the nearest reachable pose."""
    dof, most = robot.header.numbers["dof"], 16
    choices = ("both", "position", "orientation")

    def call(pose, seed, prefer, metres_per_radian, limits, starts, geometry):
        from . import NearestRows
        if prefer not in choices:
            raise ValueError('prefer: neither "both", nor "position", nor "orientation"')
        at = Rows(np.float64)
        at.add(pose, (7,), "pose")
        if seed is not None:
            at.add(seed, (dof,), "seed")
            at.call.flags[0] = 1
        at.constants("geometry", robot.geometry, geometry)
        bounds = _limits(robot, limits)
        if bounds is not None:
            at.limits(*bounds)
        at.call.flags[1] = choices.index(prefer)
        at.call.numbers[0], at.call.numbers[1] = metres_per_radian, starts
        found = NearestRows(np.full(at.shape(most, dof), np.nan), np.full(at.shape(most), np.nan), np.full(at.shape(most), np.nan),
                            np.zeros(at.shape(most), bool), np.empty(at.shape(), np.int32), np.empty(at.shape(), np.int32))
        at.run(robot.function("rows_nearest_pose", np.float64), *found)
        return found

    parameters = ["pose", ("seed", None), "*", ("prefer", "both"), ("metres_per_radian", 0.0), ("limits", None), ("starts", 32), GEOMETRY]
    return made("nearest_pose", parameters, "pose, seed, prefer, metres_per_radian, limits, starts, geometry", NEAREST_POSE_DOC, call)
