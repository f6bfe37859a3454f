# SPDX-License-Identifier: MIT
"""The robots that are asked: of the library, and one that is loaded from a description."""

import os
import pathlib

import numpy as np
import pytest

import qvgen

URDF = pathlib.Path(__file__).resolve().parents[1] / "c/robots/urdf_arm.urdf"


@pytest.fixture(scope="session")
def ns():
    """Six joints, of which the third slides."""
    return qvgen.robots.ns


@pytest.fixture(scope="session")
def planar():
    """Three parallel axes: for a pose, and for a position with the last joint given."""
    return qvgen.robots.planar_3r


def of_the_long_form(name):
    if not os.environ.get("QVGEN_PYTHON_ROBOTS"):
        pytest.skip("QVGEN_PYTHON_ROBOTS=1 compiles more robots")
    return getattr(qvgen.robots, name)


@pytest.fixture(scope="session")
def scara():
    """Four joints: for a position and a turn."""
    return of_the_long_form("scara")


@pytest.fixture(scope="session")
def iiwa14():
    """Seven joints, of which one is given."""
    return of_the_long_form("iiwa14")


@pytest.fixture(scope="session")
def desk_arm():
    """Five joints, of which one is given: for a position and a pitch."""
    if not os.environ.get("QVGEN_PYTHON_ROBOTS"):
        pytest.skip("QVGEN_PYTHON_ROBOTS=1 compiles more robots")
    return qvgen.load(pathlib.Path(__file__).with_name("desk_arm.toml"), "--only", "kinematics,inverse")


MOTOR_ARMS = pathlib.Path(__file__).resolve().parents[1] / "motors"


@pytest.fixture(scope="session")
def bevel_arm():
    """Six joints, three of which follow motors."""
    return qvgen.load(MOTOR_ARMS / "bevel_arm.toml", "--only", "kinematics,inverse")


@pytest.fixture(scope="session")
def gantry():
    """Nine joints, three of which are given."""
    if not os.environ.get("QVGEN_PYTHON_ROBOTS"):
        pytest.skip("QVGEN_PYTHON_ROBOTS=1 compiles more robots")
    return qvgen.load(MOTOR_ARMS / "gantry.toml", "--only", "kinematics,inverse")


@pytest.fixture(scope="session")
def crx10ia():
    """Six joints, solved by elimination."""
    return of_the_long_form("crx10ia")


@pytest.fixture(scope="session")
def arm():
    """Two joints with dynamics, generated and compiled here."""
    return qvgen.load(URDF)


@pytest.fixture(scope="session")
def rows():
    """rows(arm, count, seed): joint values."""
    return lambda arm, count=50, seed=1: np.random.default_rng(seed).uniform(-1.5, 1.5, (count, arm.dof))
