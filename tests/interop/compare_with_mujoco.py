#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares what `qvgen import` reads of MJCF files with MuJoCo's own reading: poses, frames and masses.

    tests/interop/compare_with_mujoco.py [FOLDER...] [--tool build/ci/generator/cli/qvgen]

Each file is read by MuJoCo and by qvgen (with the tip that it proposes, numbers as they are written). At random joints the
pose of the tip, the frames of the same name, and the mass matrix of the chain with what is fixed to it are compared, in
metres, and kilograms divided by the largest entry. Without folders all models in Python packages that are installed are taken. The exit
code is 1 if one differs by more than 1e-9, and 77 without MuJoCo.
"""
import argparse
import importlib.util
import math
import pathlib
import re
import subprocess
import sys
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from try_files import Run, proposed_options, robot_files  # noqa: E402

try:
    import mujoco
    import numpy as np
except ImportError:
    print("skipped: pip install mujoco numpy")
    sys.exit(77)

PACKAGES = ["mujoco", "dm_control", "mujoco_playground", "gymnasium_robotics", "robosuite"]
ALLOWED = 1e-9
# MuJoCo looks for the principal axes of a body until what is left beside them is less than 1e-12 kg m^2.
PRINCIPAL_AXES = 1e-11


def number(entry):
    """A number or an expression of a description, angles in radians."""
    if not isinstance(entry, str):
        return float(entry)
    text = re.sub(r"([^\s+-][^+-]*?)\s*deg\b", r"(\1)*(pi/180)", entry).replace("^", "**")
    return float(eval(text, {"__builtins__": {}}, {"pi": math.pi, "sqrt": math.sqrt, "sin": math.sin, "cos": math.cos}))


def axis_of(entry):
    if not isinstance(entry, str):
        return np.array([number(x) for x in entry])
    return np.eye(3)["xyz".index(entry[-1])] * (-1 if entry[0] == "-" else 1)


def rotation(axis, angle):
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def transform(turn, position):
    result = np.eye(4)
    result[:3, :3], result[:3, 3] = turn, position
    return result


def frame_of(table, key):
    turn = np.eye(3)
    for each in table.get("turns", []):
        turn = turn @ rotation(axis_of(each["axis"]), number(each["angle"]))
    return transform(turn, [number(x) for x in table.get(key, [0, 0, 0])])


class Description:
    """A description as qvgen has written it, moved by plain matrices."""

    def __init__(self, text):
        self.table = tomllib.loads(text)
        self.joints = self.table["joint"]

    def links(self, values):
        """Axis (None: a slide's), a point on it, and frame of every link; last the tool's frame."""
        at = frame_of(self.table.get("base", {}), "translation")
        result = []
        for joint, value in zip(self.joints, values):
            at = at @ frame_of(joint, "origin")
            axis, point = at[:3, :3] @ axis_of(joint["axis"]), at[:3, 3].copy()
            turns = joint["type"] == "revolute"
            local = axis_of(joint["axis"])
            at = at @ (transform(rotation(local, value), [0, 0, 0]) if turns else transform(np.eye(3), value * local))
            at = at @ transform(np.eye(3), [number(x) for x in joint.get("link", [0, 0, 0])])
            result.append((turns, axis, point, at))
        return result, at @ frame_of(self.table.get("tool", {}), "translation")

    def mass_matrix(self, values):
        links, _ = self.links(values)
        total = np.zeros((len(links), len(links)))
        for i, (joint, (_, _, _, at)) in enumerate(zip(self.joints, links)):
            if "mass" not in joint:
                continue
            centre = at[:3, :3] @ [number(x) for x in joint.get("centre_of_mass", [0, 0, 0])] + at[:3, 3]
            xx, yy, zz, xy, yz, xz = ([number(x) for x in joint.get("inertia", [0, 0, 0])] + [0, 0, 0])[:6]
            tensor = at[:3, :3] @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ at[:3, :3].T
            linear, angular = np.zeros((3, len(links))), np.zeros((3, len(links)))
            for k, (turns, axis, point, _) in enumerate(links[: i + 1]):
                linear[:, k] = np.cross(axis, centre - point) if turns else axis
                angular[:, k] = axis if turns else 0
            total += number(joint["mass"]) * linear.T @ linear + angular.T @ tensor @ angular
        return total


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


def imported(tool, path):
    """The description, the run, and nothing where qvgen refuses the file."""
    words = [tool, "import", str(path), "--snap", "off"]
    run = subprocess.run(words, capture_output=True, text=True, timeout=60)
    if run.returncode != 0:
        check = Run([tool, "check", str(path)], 60)
        run = subprocess.run(words + proposed_options(check), capture_output=True, text=True, timeout=60)
    return run if run.returncode == 0 else None


def compare(tool, path):
    """(largest difference of poses, of masses or None, why nothing was compared)"""
    run = imported(tool, path)
    if run is None:
        return None, None, "refused"
    description = Description(run.stdout)
    _, base, tip = re.fullmatch(r"(.*), (.*?) to (.*)", description.table["title"]).groups()
    try:
        chain = Chain(path, base, tip)
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
        poses = max(poses, abs(tool_frame - chain.pose()).max())
        for frame in description.table.get("frame", []):
            other = chain.frame(frame["name"])
            if other is None:
                continue
            variables = [joint["variable"] for joint in description.joints]
            link = links[variables.index(frame["joint"]) if "joint" in frame else -1][3]
            here = link @ frame_of(frame, "translation")
            poses = max(poses, abs(here - other).max())
        if has_masses and not has_balls:
            own, other = description.mass_matrix(values), chain.mass_matrix()
            gap = max(0, abs(own - other).max() - PRINCIPAL_AXES)
            masses = max(masses, gap / max(PRINCIPAL_AXES, abs(other).max()))
    return poses, masses if has_masses and not has_balls else None, ""


def folders_of_packages():
    found = [importlib.util.find_spec(name) for name in PACKAGES]
    return [pathlib.Path(spec.origin).parent for spec in found if spec is not None and spec.origin]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*", type=pathlib.Path)
    parser.add_argument("--tool", default="qvgen")
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    files = robot_files(options.folders or folders_of_packages(), {".xml", ".mjcf"})
    with_masses = compared = 0
    left_out, wrong = {}, []
    for path in files:
        if b"<mujoco" not in path.read_bytes() or b"<mujocoinclude" in path.read_bytes():
            continue
        poses, masses, reason = compare(options.tool, path)
        if reason:
            left_out.setdefault(reason, []).append(path)
        else:
            compared += 1
            with_masses += masses is not None
            if not max(poses, masses or 0) < ALLOWED:
                wrong.append(f"{path}: poses differ by {poses:.3g}, masses by {masses or 0:.3g}")
        if options.verbose:
            print(f"{path}: {poses} {masses} {reason}", flush=True)
    print(f"{len(files)} files, {compared} compared with MuJoCo {mujoco.__version__}, {with_masses} of them with masses")
    for reason, paths in sorted(left_out.items(), key=lambda item: -len(item[1])):
        print(f"{len(paths):6}  not compared: {reason}  (e.g. {paths[0]})")
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
