#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares what `qvgen import` reads of MJCF files with MuJoCo's own reading: poses, frames and masses.

    tests/interop/compare_with_mujoco.py [FOLDER...] [--tool build/ci/generator/cli/qvgen]

Each file is read by MuJoCo and by qvgen (with the tip that it proposes, numbers as they are written). At random joints the
pose of the tip, the frames of the same name, and the mass matrix of the chain with what is fixed to it are compared, in
metres, and kilograms divided by the largest entry. Without folders all models in Python packages that are installed are taken. The exit
code is 1 if one differs by more than 1e-9 (1e-7 where masses are those of meshes), and 77 without MuJoCo.
"""
import argparse
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from try_files import robot_files  # noqa: E402

try:
    import mujoco
    import numpy as np
except ImportError:
    print("skipped: pip install mujoco numpy")
    sys.exit(77)

from imported import (ALLOWED, Description, base_and_tip, difference_of_places, folders_of_packages, imported, report,  # noqa: E402
                      rotation, transform)

PACKAGES = ["mujoco", "dm_control", "mujoco_playground", "gymnasium_robotics", "robosuite"]
# The moments of a mesh are right to 3e-13 in MuJoCo, its principal axes to 1e-7 of them (measured for tetrahedra, 4.0.1).
ALLOWED_WITH_MESHES = 1e-7


class Chain:
    """A chain between two bodies in MuJoCo's model."""

    def __init__(self, path, base, tip):
        self.model = mujoco.MjModel.from_xml_path(str(path))
        self.data = mujoco.MjData(self.model)
        self.base, _ = self.body_of(base)
        self.tip, self.site = self.body_of(tip)
        self.bodies = [self.tip]
        while self.bodies[-1] not in (self.base, 0):
            self.bodies.append(self.model.body_parentid[self.bodies[-1]])
        self.bodies = [body for body in reversed(self.bodies) if body != self.base]
        self.joints = [j for body in self.bodies for j in self.joints_of(body)]

    def body_of(self, name):
        site = mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_SITE, name)
        body = mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_BODY, name)
        if body < 0 and site < 0:
            raise LookupError(f"MuJoCo has no body or site {name}")
        return (body, None) if body >= 0 else (self.model.site_bodyid[site], site)

    def joints_of(self, body):
        first = self.model.body_jntadr[body]
        return range(first, first + self.model.body_jntnum[body])

    def free(self, joint):
        return self.model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE

    def count(self):
        """One value for each hinge and slide, three for a ball, none for what floats."""
        return sum(3 if self.model.jnt_type[j] == mujoco.mjtJoint.mjJNT_BALL else 1 for j in self.joints if not self.free(j))

    def place(self, values):
        self.data.qpos[:] = self.model.qpos0
        at = 0
        for joint in self.joints:
            address = self.model.jnt_qposadr[joint]
            if self.free(joint):
                continue
            if self.model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_BALL:
                turn = np.eye(3)
                for axis in range(3):
                    turn = turn @ rotation(np.eye(3)[axis], values[at + axis])
                mujoco.mju_mat2Quat(self.data.qpos[address : address + 4], turn.flatten())
                at += 3
            else:
                self.data.qpos[address] = values[at]
                at += 1
        mujoco.mj_forward(self.model, self.data)

    def seen_from_base(self, turn, position):
        base = transform(self.data.xmat[self.base].reshape(3, 3), self.data.xpos[self.base])
        return np.linalg.inv(base) @ transform(turn.reshape(3, 3), position)

    def pose(self):
        return self.pose_of_site(self.site) if self.site is not None else self.pose_of_body(self.tip)

    def pose_of_site(self, site):
        return self.seen_from_base(self.data.site_xmat[site], self.data.site_xpos[site])

    def pose_of_body(self, body):
        return self.seen_from_base(self.data.xmat[body], self.data.xpos[body])

    def frame(self, name):
        """Returns the pose of a site, else of a body of that name, or nothing; a site may be called as its body."""
        site = mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_SITE, name)
        body = mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_BODY, name)
        return self.pose_of_site(site) if site >= 0 else self.pose_of_body(body) if body >= 0 else None

    def carried(self):
        """The bodies that only the chain's joints move: its own, and what is fixed to them."""
        moved = []
        for body in range(1, self.model.nbody):
            at = body
            while at not in (0, self.base) and at not in self.bodies and self.model.body_jntnum[at] == 0:
                at = self.model.body_parentid[at]
            if at in self.bodies:
                moved.append(body)
        return moved

    def mass_matrix(self):
        columns = [self.model.jnt_dofadr[j] for j in self.joints]
        total = np.zeros((len(columns), len(columns)))
        for body in self.carried():
            linear, angular = np.zeros((3, self.model.nv)), np.zeros((3, self.model.nv))
            mujoco.mj_jacBodyCom(self.model, self.data, linear, angular, body)
            linear, angular = linear[:, columns], angular[:, columns]
            axes = self.data.ximat[body].reshape(3, 3)
            tensor = axes @ np.diag(self.model.body_inertia[body]) @ axes.T
            total += self.model.body_mass[body] * linear.T @ linear + angular.T @ tensor @ angular
        return total


def compare(tool, path):
    """(largest difference of poses, of masses or None, why nothing was compared)"""
    run = imported(tool, path)
    if run is None:
        return None, None, "refused"
    description = Description(run.stdout)
    try:
        chain = Chain(path, *base_and_tip(description))
    except (ValueError, LookupError) as error:
        return None, None, "MuJoCo: " + re.sub(r"'.*", "...", str(error).splitlines()[0])
    if chain.count() != len(description.joints) or any("follows" in joint for joint in description.joints):
        return None, None, f"{chain.count()} joints in MuJoCo, {len(description.joints)} here"
    has_masses = "mass" in description.joints[-1] and "inertia" not in run.stderr
    has_balls = any(chain.model.jnt_type[j] in (0, 1) for j in chain.joints)
    poses = masses = 0.0
    random = np.random.default_rng(1)
    for _ in range(5):
        values = random.uniform(-1.5, 1.5, len(description.joints))
        chain.place(values)
        links, tool_frame = description.links(values)
        poses = max(poses, difference_of_places(description, chain, links, tool_frame))
        if has_masses and not has_balls:
            own, other = description.mass_matrix(values), chain.mass_matrix()
            gap = abs(own - other).max() / max(1e-9, abs(other).max())
            masses = max(masses, gap * (ALLOWED / ALLOWED_WITH_MESHES if chain.model.nmesh else 1))
    return poses, masses if has_masses and not has_balls else None, ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*", type=pathlib.Path)
    parser.add_argument("--tool", default="qvgen")
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    files = robot_files(options.folders or folders_of_packages(PACKAGES), {".xml", ".mjcf"})
    results = []
    for path in files:
        if b"<mujoco" not in path.read_bytes() or b"<mujocoinclude" in path.read_bytes():
            continue
        poses, masses, reason = compare(options.tool, path)
        results.append((path, max(poses or 0, masses or 0), masses is not None, reason))
        if options.verbose:
            print(f"{path}: {poses} {masses} {reason}", flush=True)
    return report(f"MuJoCo {mujoco.__version__}", len(files), results)


if __name__ == "__main__":
    sys.exit(main())
