# SPDX-License-Identifier: MIT
"""Pictures: `arm.plot(q)` draws configurations by matplotlib, `arm.show()` opens the arm's page in a browser or notebook.

A drawing needs the pose and the Jacobian alone. A revolute joint's column says where its axis is, and each joint is drawn where
its axis comes nearest to the joint before it: the elbow of a planar arm is its elbow. Slides are the lines between.
"""

import functools
import html
import pathlib
import subprocess

import numpy as np

from ._library import BuildError, cache_folder
from ._paths import _reading
from ._tool import tool

_NEEDS = "plot needs matplotlib: pip install matplotlib"


def _turned(quaternion, points):
    """Points turned by a quaternion w x y z."""
    w, v = quaternion[0], quaternion[1:]
    return points + 2 * np.cross(v, np.cross(v, points) + w * points)


def skeleton(arm, q):
    """Points (k, 3), m, of a configuration (dof,): the base, one on each turning joint's axis, the tool."""
    tool_position, jacobian = arm.forward_kinematics(q)[4:], arm.jacobian(q)
    points = [np.zeros(3)]
    for velocity, axis in zip(jacobian[:3].T, jacobian[3:].T):
        length = np.linalg.norm(axis)
        if length < 1e-9:  # a slide
            continue
        axis = axis / length
        foot = tool_position + np.cross(axis, velocity / length)
        points.append(foot + axis * np.dot(points[-1] - foot, axis))
    return np.array([*points, tool_position])


def _chains(robot, q):
    """The skeletons of a configuration: of the arm, or of each limb where the joints branch."""
    if "jacobian" in robot.functions and robot.functions["jacobian"] == "here":
        return [skeleton(robot, q)]
    base, joints = (q[:7], q[7:]) if hasattr(robot, "velocity_size") else (None, q)
    place = {name: i for i, name in enumerate(robot.joint_names)}
    chains = []
    for limb in getattr(robot, "limbs", {}).values():
        points = skeleton(limb, joints[[place[name] for name in limb.joint_names]])
        chains.append(points if base is None else _turned(base[:4], points) + base[4:])
    if not chains:
        raise ValueError(f"{robot.__name__} has no Jacobian by which it could be drawn")
    return chains


def plot(robot, q, *, axes=None):
    """Draws configurations, (dof,) or (n, dof), with matplotlib; returns the axes.

    `axes`: three-dimensional axes to draw into, new ones without. A floating base's configurations begin with its pose. Joints are
    drawn where their axes come nearest to the joint before, in metres. Raises ImportError without matplotlib.
    """
    rows = np.atleast_2d(np.asarray(q, float))
    size = len(robot.joint_names) + (7 if hasattr(robot, "velocity_size") else 0)
    if rows.ndim != 2 or rows.shape[1] != size:
        raise ValueError(f"q has the shape {np.shape(q)}; it must be ({size},) or (n, {size})")
    try:
        import matplotlib.pyplot as plt
    except ImportError:
        raise ImportError(_NEEDS) from None
    axes = axes if axes is not None else plt.figure().add_subplot(projection="3d")
    for row in rows:
        for points in _chains(robot, row):
            axes.plot(*points.T, marker="o")
    axes.set(xlabel="x [m]", ylabel="y [m]", zlabel="z [m]", title=robot.__name__)
    axes.set_aspect("equal")
    return axes


class Page:
    """A robot's page. `path` is its file; a notebook shows it."""

    def __init__(self, path):
        self.path = path

    def __repr__(self):
        return f"Page({str(self.path)!r})"

    def _repr_html_(self):
        text = html.escape(self.path.read_text(encoding="utf-8"))
        return f'<iframe srcdoc="{text}" style="width: 100%; height: 700px; border: 0"></iframe>'


def _is_in_notebook():
    try:
        from IPython import get_ipython
    except ImportError:
        return False
    return hasattr(get_ipython(), "kernel")


def show(source, robot, *, browser=True):
    """Makes the robot's page (`qvgen report`) and opens it in a browser, unless a notebook shows it; returns a Page.

    Where clang compiles for WebAssembly the page has the arm alive: it moves, and solves poses. `browser`: False opens none.
    Raises BuildError with the tool's messages.
    """
    description, *options = source
    folder = pathlib.Path(cache_folder()) / "pages" / robot.__name__
    command = [tool(), "report", description, *_reading(options), "-o", folder]
    done = subprocess.run([str(each) for each in command], capture_output=True, text=True)
    path = folder / f"{robot.__name__}.html"
    if done.returncode != 0 or not path.exists():
        raise BuildError(done.stderr or f"{robot.__name__} has no page")
    if browser and not _is_in_notebook():
        import webbrowser
        webbrowser.open(path.resolve().as_uri())
    return Page(path)


def with_plot(module):
    """The module with `plot`."""
    @functools.wraps(plot)
    def own(q, *, axes=None):
        return plot(module, q, axes=axes)

    module.plot = own
    return module
