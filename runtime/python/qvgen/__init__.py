# SPDX-License-Identifier: MIT
"""Kinematics and dynamics of robot arms, generated: qvgen.robots.puma560, or qvgen.load("arm.urdf").

Every function takes one configuration or a batch along the first axis and loops over a batch without Python and without
the interpreter's lock. What gets arrays of float32 only computes and returns float32, inverse kinematics excepted; all
else is float64. SI units, radians; quaternions are w, x, y, z; twists linear first.
"""

import enum
import importlib
import os
import typing

from . import robots
from ._library import BuildError, cache_folder
from ._paths import Motion, Paths
from ._tool import report_of

__all__ = ["Assemblies", "BuildError", "Followed", "JointRates", "Motion", "NearSolution", "NearestRows", "Page", "Paths", "Solutions", "Status",
           "TipMotion", "VelocityStatus", "cache_folder", "calibrate", "derivatives", "identify", "interop", "load", "metrics", "orientation", "robots"]


class Status(enum.IntEnum):
    """Status of a pose."""
    solved = 0
    singular = 1
    unreachable = 2
    invalid = 3
    incomplete = 4


class VelocityStatus(enum.IntEnum):
    """Outcome of a twist."""
    solved = 0
    damped = 1
    invalid_input = 2
    incomplete = 3


class Solutions(typing.NamedTuple):
    """Result of inverse_kinematics; for a batch every field has the batch's axis in front."""
    q: typing.Any  #: (max, dof), rad or m, the rows of a pose one after the other; NaN behind the last
    count: typing.Any  #: (), how many rows there are
    status: typing.Any  #: (), of qvgen.Status
    branch: typing.Any  #: (max,), which sign each step took; -1 behind the last
    continuum: typing.Any  #: (max,), whether a free joint was chosen


class Assemblies(typing.NamedTuple):
    """Result of assemble; for a batch every field has the batch's axis in front."""
    q: typing.Any  #: (max, dof), rad or m, the assemblies one after the other; NaN behind the last
    count: typing.Any  #: (), how many assemblies there are
    status: typing.Any  #: (), of qvgen.Status
    branch: typing.Any  #: (max,), which sign each step took; -1 behind the last
    continuum: typing.Any  #: (max,), whether a free joint was chosen
    meets: typing.Any  #: (max,), whether another assembly is so near that both meet, at a dead centre for instance


class Followed(typing.NamedTuple):
    """Result of follow; for a batch both fields have the batch's axis in front."""
    q: typing.Any  #: (dof,), rad or m; NaN where the loops do not close
    closed: typing.Any  #: (), whether the loops close


class TipMotion(typing.NamedTuple):
    """Result of driven_tip_motion_of_TIP, in the world; for a batch every field has the batch's axis in front."""
    pose: typing.Any  #: (7,), quaternion w, x, y, z, then the position in metres
    jacobian: typing.Any  #: (6, moved), by the base's velocity and the rates of the driven joints, linear rows first
    bias: typing.Any  #: (6,), acceleration where the base and the driven joints have none


class NearSolution(typing.NamedTuple):
    """Result of inverse_kinematics_near; for a batch both fields have the batch's axis in front."""
    q: typing.Any  #: (dof,), rad or m; NaN if there is none
    status: typing.Any  #: (), of qvgen.Status


class NearestRows(typing.NamedTuple):
    """Result of nearest_pose; for a batch every field has the batch's axis in front."""
    q: typing.Any  #: (16, dof), rad or m, the nearest row first; NaN behind the last
    position_error: typing.Any  #: (16,), m, from the tool to the pose
    orientation_error: typing.Any  #: (16,), rad, from the tool to the pose
    continuum: typing.Any  #: (16,), whether other joints next to these may be as near
    count: typing.Any  #: (), how many rows there are
    status: typing.Any  #: (), of qvgen.Status: solved where the first row reaches the pose


class JointRates(typing.NamedTuple):
    """Result of inverse_velocity, inverse_velocity_scaled and inverse_velocity_within; of a batch every field has its axis in front."""
    qd: typing.Any  #: (dof,), rad/s or m/s
    status: typing.Any  #: (), of qvgen.VelocityStatus
    residual: typing.Any  #: (), |J qd - factor twist|
    factor: typing.Any  #: (), what all rates were scaled by, in [0, 1]; 1 where they are not scaled
    limited: typing.Any  #: (), whether the rates without limits are not within them


def __getattr__(name):
    """Imports qvgen.metrics and the like when they are used: they need NumPy, and whoever builds a wheel may not
    have it."""
    if name == "Page":
        return importlib.import_module("._show", __name__).Page
    if name in ("derivatives", "interop", "metrics", "orientation"):
        return importlib.import_module("." + name, __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def calibrate(description, data, output, *options):
    """Finds the errors of an arm's geometry from a table of measurements, and writes its description to `output`.

    `description` is a known robot's name or a file; `options` are those of `qvgen calibrate`, "--errors", "zeros". Returns
    the report as text. Raises BuildError with the tool's messages. Then load(output) is the calibrated arm.
    """
    return report_of("calibrate", [description, data], output, options)


def identify(description, logs, output=None, *options):
    """Finds inertias and friction of an arm from logs of its motion and torques, and writes its description to `output`.

    `description` is a known robot's name or a file; `logs` one table or several; `options` are those of `qvgen identify`,
    "--hold-out", "other.csv". Returns the report as text. Raises BuildError with the tool's messages. Then load(output) is
    the arm with its inertias.
    """
    logs = [logs] if isinstance(logs, (str, os.PathLike)) else list(logs)
    return report_of("identify", [description, *logs], output, options)


def load(description, *options, floating=False):
    """The module of a robot described in a file (TOML, URDF, MJCF): generated in C, compiled, and kept in a cache.

    `options` are those of `qvgen generate`: load("arm.urdf", "--tip", "tool0"). Raises BuildError with the generator's
    messages.

    If the joints branch (load("quad.urdf", "--tips", "all"), or [[tip]] in TOML) it is the whole robot, with its
    dynamics. `limbs` has the modules of the chains to its tips, by the tips' names; each is compiled when it is asked
    for. A limb's joints have the names that they have in the whole robot.

    If it has closed loops (load("four_bar.toml")) there are assemble, rates, driven_inverse_dynamics and the others of
    assembly.h too, and pose_of_TIP, jacobian_of_TIP by its motors.

    `floating`: the base moves freely, as with "--floating". Functions of dynamics take configurations then: the pose of the
    base, w x y z and metres, and the joints; velocities begin with the base's six.
    """
    if floating and "--floating" not in options:
        options += ("--floating",)
    from . import _build
    return _build.loaded(description, options)
