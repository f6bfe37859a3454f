#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares what `qvgen import` reads of URDF files with Pinocchio's own reading: poses, frames, masses and gravity.

    tests/interop/compare_with_pinocchio.py [FOLDER...] [--tool build/ci/generator/cli/qvgen] [--generated COUNT]

Each file is read by Pinocchio and by qvgen (with the tip that it proposes, numbers as they are written). At random joints the pose
of the tip, the links of the same name, the mass matrix of the chain with what is fixed to it, and the forces that hold it
against gravity are compared, in metres, and shares of the largest entry. Without folders the models of example-robot-data are
taken. Of so many files the generated code is compared, too: poses, mass matrix, gravity and Coriolis forces, by the Python module
with a C compiler. The exit code is 1 if one differs by more than 1e-9, and 77 without Pinocchio.
"""
import argparse
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from try_files import robot_files  # noqa: E402

try:
    import numpy as np
    import pinocchio as pin
except ImportError:
    print("skipped: pip install pin numpy example-robot-data")
    sys.exit(77)

from imported import Description, base_and_tip, difference_of_places, imported, report  # noqa: E402

PYTHON = pathlib.Path(__file__).resolve().parents[2] / "runtime/python"
FALL = np.array([0, 0, -9.80665])  # in the frame of the chain's base


class Chain:
    """A chain between two links of Pinocchio's model."""

    def __init__(self, path, base, tip):
        self.model = pin.buildModelFromUrdf(str(path))
        self.data = self.model.createData()
        self.base, self.tip = self.link(base), self.link(tip)
        carriers = set(self.model.supports[self.model.frames[self.base].parentJoint])
        self.joints = [j for j in self.model.supports[self.model.frames[self.tip].parentJoint] if j not in carriers]
        self.velocities = [self.model.joints[j].idx_v for j in self.joints]

    def link(self, name):
        frame = self.model.getFrameId(name, pin.FrameType.BODY)
        if frame >= self.model.nframes:
            raise LookupError("no link of the name that qvgen gives")
        return frame

    def carry_the_chain_alone(self):
        """Takes away what joints beside the chain move."""
        for joint in set(range(1, self.model.njoints)) - set(self.joints):
            self.model.inertias[joint] = pin.Inertia.Zero()
        self.model.gravity.linear[:] = 0

    def coriolis_torque(self, values, rates):
        """Forces of the joints at constant rates, without gravity."""
        moved, moving = np.zeros(self.model.nv), np.zeros(self.model.nv)
        moved[self.velocities], moving[self.velocities] = values, rates
        at = pin.integrate(self.model, pin.neutral(self.model), moved)
        return pin.rnea(self.model, self.data, at, moving, np.zeros(self.model.nv))[self.velocities]

    def is_of_single_joints(self):
        return all(self.model.joints[j].nv == 1 for j in self.joints)

    def place(self, values):
        moved = np.zeros(self.model.nv)
        moved[self.velocities] = values
        at = pin.integrate(self.model, pin.neutral(self.model), moved)
        pin.computeJointJacobians(self.model, self.data, at)
        pin.updateFramePlacements(self.model, self.data)

    def seen_from_base(self, frame):
        return self.data.oMf[self.base].actInv(self.data.oMf[frame]).homogeneous

    def pose(self):
        return self.seen_from_base(self.tip)

    def frame(self, name):
        """The pose of the link of that name, or nothing."""
        frame = self.model.getFrameId(name, pin.FrameType.BODY)
        return self.seen_from_base(frame) if frame < self.model.nframes else None

    def bodies(self):
        """Inertia of what each joint of the chain carries, without what further joints move, and its Jacobian, in its frame."""
        for joint in self.joints:
            jacobian = pin.getJointJacobian(self.model, self.data, joint, pin.ReferenceFrame.LOCAL)
            yield self.model.inertias[joint], jacobian[:, self.velocities], self.data.oMi[joint]

    def mass_matrix(self):
        return sum(jacobian.T @ inertia.matrix() @ jacobian for inertia, jacobian, _ in self.bodies())

    def gravity_torque(self):
        fall = self.data.oMf[self.base].rotation @ FALL
        total = np.zeros(len(self.joints))
        for inertia, jacobian, at in self.bodies():
            acceleration = pin.Motion(at.rotation.T @ fall, np.zeros(3))
            total -= jacobian.T @ (inertia * acceleration).vector
        return total


def share(own, other):
    return abs(own - other).max() / max(1e-9, abs(other).max())


def compare_generated(path, tip, chain, has_masses):
    """The largest difference of the generated code."""
    import qvgen
    arm = qvgen.load(path, "--tip", tip, "--snap", "off", "--only", "kinematics,dynamics" if has_masses else "kinematics")
    chain.carry_the_chain_alone()
    random = np.random.default_rng(2)
    largest = 0.0
    for _ in range(5):
        values, rates = random.uniform(-1.5, 1.5, (2, arm.dof))
        chain.place(values)
        largest = np.max([largest, abs(arm.homogeneous_transform(values) - chain.pose()).max()])
        if has_masses:
            coriolis = chain.coriolis_torque(values, rates)
            chain.place(values)
            largest = np.max([largest, share(arm.mass_matrix(values), chain.mass_matrix()),
                              share(arm.gravity_torque(values), chain.gravity_torque()),
                              share(arm.coriolis_torque(values, rates), coriolis)])
    return largest


def compare(tool, path, with_code):
    """(largest difference, whether masses were compared, why nothing was)"""
    run = imported(tool, path)
    if run is None:
        return 0.0, False, "refused"
    description = Description(run.stdout)
    base, tip = base_and_tip(description)
    try:
        chain = Chain(path, base, tip)
    except (ValueError, LookupError, RuntimeError) as error:
        return 0.0, False, "Pinocchio: " + str(error).splitlines()[0]
    if any("follows" in joint for joint in description.joints):
        return 0.0, False, "joints that follow others"
    if not chain.is_of_single_joints() or len(chain.joints) != len(description.joints):
        return 0.0, False, f"{len(chain.joints)} joints in Pinocchio, {len(description.joints)} here"
    has_masses = "mass" in description.joints[-1] and "inertia" not in run.stderr
    largest = 0.0
    random = np.random.default_rng(1)
    for _ in range(5):
        values = random.uniform(-1.5, 1.5, len(description.joints))
        chain.place(values)
        links, tool_frame = description.links(values)
        largest = np.max([largest, difference_of_places(description, chain, links, tool_frame)])
        if has_masses:
            largest = np.max([largest, share(description.mass_matrix(values), chain.mass_matrix()),
                              share(description.gravity_torque(values, FALL), chain.gravity_torque())])
    if with_code:
        largest = np.max([largest, compare_generated(path, tip, chain, has_masses)])
    return largest, has_masses, ""


def folders_of_models():
    """The folder of example-robot-data beside Pinocchio's own."""
    beside = pathlib.Path(pin.__file__).parents[4] / "share/example-robot-data"
    return [beside] if beside.exists() else []


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*", type=pathlib.Path)
    parser.add_argument("--tool", default="qvgen")
    parser.add_argument("--generated", type=int, default=0, metavar="COUNT")
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    os.environ.setdefault("QVGEN_TOOL", options.tool)
    sys.path.insert(0, str(PYTHON))
    files = robot_files(options.folders or folders_of_models(), {".urdf"})
    results = []
    for path in files:
        results.append((path, *compare(options.tool, path, len(results) < options.generated)))
        if options.verbose:
            print(*results[-1], flush=True)
    return report(f"Pinocchio {pin.__version__}", len(files), results)


if __name__ == "__main__":
    sys.exit(main())
