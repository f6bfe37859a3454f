# SPDX-License-Identifier: MIT
"""Orders of what inverse_kinematics has found, by what makes one solution better than another.

A metric takes the ways of the joints from the seed, an array (..., dof) in rad or m, and gives a number for each row; so does
a score, of the joints themselves:

    found = arm.inverse_kinematics(poses, seed, limits="description")
    fastest = sort_by(found, FastestTime(arm.velocity_limits, accelerations), seed)
    found = arm.inverse_kinematics(poses)
    fastest = sort_by(found, FastestTime(arm.velocity_limits, accelerations), seed, arm.is_revolute)
    highest = sort_by(found, lambda q: -arm.forward_kinematics(q)[..., 6])

The functions of those names in C++ (qvgen/inverse/metrics.h) give the same order.
"""

import dataclasses
import typing

import numpy as np

__all__ = ["FastestTime", "LargestJoint", "TurnsOfMotors", "WeightedDistance", "best", "sort_by"]


class TurnsOfMotors(typing.NamedTuple):
    """Whole turns of arms with motors: those of joints, each of which moves several motors. `arm.turns_of_motors`."""
    joints_by_motors: typing.Any  #: (joints, dof)
    motors_by_joints: typing.Any  #: (dof, joints)
    is_revolute: typing.Any  #: (joints,), whether a joint turns

    def short_way(self, way):
        """The ways of motors (..., dof) with whole turns of joints taken off."""
        joints = _short_way(way @ np.asarray(self.joints_by_motors).T, self.is_revolute)
        return joints @ np.asarray(self.motors_by_joints).T


def _short_way(way, is_revolute):
    """The ways of joints with whole turns of those that turn taken off."""
    return np.where(np.asarray(is_revolute), way - 2 * np.pi * np.rint(way / (2 * np.pi)), way)


@dataclasses.dataclass
class WeightedDistance:
    """Root of the weighted sum of squares; the weights also make one unit of radians and metres."""
    weights: typing.Any

    def __call__(self, way):
        return np.sqrt((np.asarray(self.weights) * np.square(way)).sum(axis=-1))


@dataclasses.dataclass
class LargestJoint:
    """The longest way of all joints, each in units of its own."""
    units: typing.Any = 1.0

    def __call__(self, way):
        return np.abs(np.asarray(way) / np.asarray(self.units)).max(axis=-1)


@dataclasses.dataclass
class FastestTime:
    """Time, s, until the last joint has arrived, from rest to rest: each goes with its greatest acceleration up to its greatest
    speed, and back to rest; without accelerations way / speed."""
    speeds: typing.Any
    accelerations: typing.Any = np.inf

    def __call__(self, way):
        length = np.abs(way)
        speeds, accelerations = np.asarray(self.speeds, float), np.asarray(self.accelerations, float)
        with np.errstate(invalid="ignore"):  # an infinite speed is never reached
            ramp = speeds / accelerations
            trapezoid = length / speeds + ramp
        triangle = 2 * np.sqrt(length / accelerations)
        return np.where(length < speeds * ramp, triangle, trapezoid).max(axis=-1)


def _shares(found, metric, seed, is_revolute):
    """The number that a metric gives each row; NaN behind the last row of a pose."""
    rows = found.q if seed is None else found.q - np.asarray(seed)[..., None, :]
    if seed is not None and is_revolute is not None:
        has_motors = isinstance(is_revolute, TurnsOfMotors)
        rows = is_revolute.short_way(rows) if has_motors else _short_way(rows, is_revolute)
    there = np.arange(found.q.shape[-2]) < np.asarray(found.count)[..., None]
    shares = np.full(there.shape, np.nan)
    if there.any():
        shares[there] = metric(rows[there])
    return shares


def sort_by(found, metric, seed=None, is_revolute=None):
    """Solutions in the order of a metric of their ways from a seed, or of a score of their joints without one, the least first;
    equal ones keep their order, and what is not a number comes last.

    found: qvgen.Solutions of one pose or a batch
    seed: (dof,) or (n, dof)
    is_revolute: that of the robot: angles go the short way round; of an arm with motors its turns_of_motors; None: rows within
        limits, whose ways are as they stand
    Returns qvgen.Solutions.
    """
    shares = _shares(found, metric, seed, is_revolute)
    behind = np.arange(shares.shape[-1]) >= np.asarray(found.count)[..., None]
    order = np.lexsort((np.broadcast_to(np.arange(shares.shape[-1]), shares.shape), shares, np.isnan(shares), behind), axis=-1)
    return found._replace(q=np.take_along_axis(found.q, order[..., None], axis=-2),
                          branch=np.take_along_axis(found.branch, order, axis=-1),
                          continuum=np.take_along_axis(found.continuum, order, axis=-1))


def best(found, metric, seed=None, is_revolute=None):
    """Joints of the solution with the least metric, (dof,), or of each pose of a batch, (n, dof); NaN if there is none, or
    none whose metric is finite. Arguments are those of sort_by."""
    shares = _shares(found, metric, seed, is_revolute)
    shares = np.where(np.isfinite(shares), shares, np.inf)
    if shares.shape[-1] == 0:
        return np.full((*found.q.shape[:-2], found.q.shape[-1]), np.nan)
    place = shares.argmin(axis=-1)[..., None]
    q = np.take_along_axis(found.q, place[..., None], axis=-2)[..., 0, :]
    return np.where(np.isfinite(np.take_along_axis(shares, place, axis=-1)), q, np.nan)
