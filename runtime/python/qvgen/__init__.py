# SPDX-License-Identifier: MIT
"""Kinematics and dynamics of robot arms, generated: qvgen.robots.puma560, or qvgen.load("arm.urdf").

Every function takes one configuration or a batch along the first axis, as arrays of float64, and loops over a batch
without Python and without the interpreter's lock. SI units, radians; quaternions are w, x, y, z; twists linear first.
"""

import enum

from . import robots
from ._build import BuildError, build_module, cache_folder, generate

__all__ = ["BuildError", "Status", "cache_folder", "load", "robots"]


class Status(enum.IntEnum):
    """What became of a pose."""
    solved = 0
    singular = 1
    unreachable = 2
    invalid = 3
    incomplete = 4


def load(description, *options):
    """The module of a robot described in a file (TOML, URDF, MJCF): generated, compiled, and kept in a cache.

    `options` are those of `qvgen generate`: load("arm.urdf", "--tip", "tool0"). Raises BuildError with the generator's
    messages.
    """
    return build_module(*generate(description, options))
