#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares generated dynamics of whole robots, whose bases float, with Pinocchio's of the same URDF files.

    tests/interop/whole_robots_with_pinocchio.py [FOLDER...] [--tool build/ci/generator/cli/qvgen] [--count 24]

Each file is read by Pinocchio and by the Python module, with all its tips and a base that floats, numbers as they are written. At
random configurations the forces of inverse dynamics, the mass matrix, gravity's forces and the accelerations of forward dynamics
are compared, as shares of the largest entry. Without folders the models of example-robot-data are taken, the smallest files
first. The exit code is 1 if one differs by more than 1e-9, and 77 without Pinocchio.
"""
import argparse
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from compare_with_pinocchio import FALL, PYTHON, folders_of_models, np, pin, share  # noqa: E402
from imported import report  # noqa: E402
from try_files import robot_files  # noqa: E402


def motion(robot, random):
    """A configuration, velocities, and accelerations or forces."""
    turn = random.normal(size=4)
    base = np.concatenate([turn / np.linalg.norm(turn), random.uniform(-1, 1, 3)])
    q = np.concatenate([base, random.uniform(-1.5, 1.5, robot.dof)])
    return q, *random.uniform(-1, 1, (2, robot.velocity_size))


def names_of(robot, model):
    """Pinocchio's names of the joints whose names are others here, which are identifiers of C."""
    def plain(name):
        return "".join(c for c in name.lower() if c.isalnum())
    theirs = {plain(name): name for name in model.names}
    found = {name: theirs.get(plain(name), theirs.get(plain(name.removesuffix("_joint")))) for name in robot.joint_names}
    return {name: other for name, other in found.items() if other}


def both(convert, matrix):
    """Converts the rows of a symmetric matrix, then its columns."""
    rows = np.array([convert(row) for row in matrix])
    return np.array([convert(column) for column in rows.T])


def difference(robot, model):
    """The largest one of all quantities, at five configurations."""
    from qvgen import interop
    data, to = model.createData(), interop.pinocchio(robot, model, names=names_of(robot, model))
    random, largest = np.random.default_rng(3), 0.0
    for _ in range(5):
        q, qd, other = motion(robot, random)
        at, velocity = to.to_configuration(q), to.to_velocity(q, qd)

        def theirs(vector):
            return to.from_velocity(q, vector)

        def ours(vector):
            return to.to_velocity(q, vector)

        # Pinocchio keeps the joints' friction and leaves it to its callers.
        friction = model.damping * velocity + model.upperDryFrictionLimit * np.sign(velocity)
        force = friction + pin.rnea(model, data, at, velocity, ours(other))
        weight = pin.computeGeneralizedGravity(model, data, at)
        mass = pin.crba(model, data, at)
        mass = np.triu(mass) + np.triu(mass, 1).T
        acceleration = pin.aba(model, data, at, velocity, ours(other) - friction)
        # Forces and rates of one joint stand at the same place: conversions of velocities only reorder both.
        # NaN stays NaN, which Python's max may drop.
        largest = np.max([largest,
                          share(robot.inverse_dynamics(q, qd, other), theirs(force)),
                          share(robot.gravity_torque(q), theirs(weight)),
                          share(robot.mass_matrix(q), both(theirs, mass)),
                          share(robot.forward_dynamics(q, qd, other), theirs(acceleration))])
    return largest


def compare(path):
    """(largest difference, whether masses were compared, why nothing was)"""
    import qvgen
    try:
        model = pin.buildModelFromUrdf(str(path), pin.JointModelFreeFlyer())
        model.gravity.linear = FALL
        robot = qvgen.load(path, "--tips", "all", "--snap", "off", "--only", "dynamics", floating=True)
    except (ValueError, RuntimeError) as error:
        return 0.0, False, str(error).splitlines()[0][:100]
    if "inverse_dynamics" not in robot.functions:
        return 0.0, False, "links without masses"
    if model.nv != robot.velocity_size:
        return 0.0, False, "joints that follow others"
    try:
        return difference(robot, model), True, ""
    except ValueError as error:  # a joint of a kind that there is no conversion for
        return 0.0, False, str(error).splitlines()[0][:100]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="*", type=pathlib.Path)
    parser.add_argument("--tool", default="qvgen")
    parser.add_argument("--count", type=int, default=1000)
    options = parser.parse_args()
    os.environ.setdefault("QVGEN_TOOL", options.tool)
    sys.path.insert(0, str(PYTHON))
    files = sorted(robot_files(options.folders or folders_of_models(), {".urdf"}), key=lambda path: path.stat().st_size)
    results = []
    for path in files[:options.count]:
        results.append((path, *compare(path)))
        print(*results[-1], flush=True)
    return report(f"Pinocchio {pin.__version__}", len(results), results)


if __name__ == "__main__":
    sys.exit(main())
