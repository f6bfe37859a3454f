#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares random arms whose motors act on fixed tendons with MuJoCo: lengths, poses and masses by motors.

    tests/interop/tendons_with_mujoco.py [--tool build/ci/generator/cli/qvgen] [--count 100]

Each arm is read by `qvgen import`. At random values of its motors the joints are placed in MuJoCo: lengths of tendons have to be the
motors' values, the tool's pose and the mass matrix, changed to motors, those of MuJoCo, to 1e-9. The exit code is 77 without MuJoCo.
"""
import argparse
import pathlib
import re
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
try:
    import mujoco
    import numpy as np
except ImportError:
    print("skipped: pip install mujoco numpy")
    sys.exit(77)

from imported import ALLOWED, Description, imported, number, transform  # noqa: E402


def random_arm(random, joints, motors):
    """An MJCF of so many hinges and slides; the last `motors` of them have tendons, the others motors of their own."""
    def three(scale=1.0):
        return " ".join(f"{x:.3f}" for x in scale * random.uniform(-1, 1, 3))
    bodies = ends = actuators = tendons = ""
    for i in range(joints):
        kind = "slide" if random.uniform() < 0.2 else "hinge"
        axis = three()
        bodies += (f'<body name="b{i}" pos="{three(0.4)}"><joint name="j{i}" type="{kind}" axis="{axis}" ref="{random.uniform(-1, 1):.3f}"/>'
                   f'<geom type="box" size=".1 .2 .3" pos="{three(0.2)}" mass="{random.uniform(0.5, 2):.3f}"/>\n')
        ends += "</body>"
    for i in range(joints - motors):
        actuators += f'<motor joint="j{i}"/>'
    for k in range(motors):
        parts = "".join(f'<joint joint="j{i}" coef="{random.uniform(-2, 2):.3f}"/>' for i in range(joints)
                        if i >= joints - motors or random.uniform() < 0.5)
        tendons += f'<fixed name="t{k}" armature="{random.uniform(0, 0.5):.3f}">{parts}</fixed>\n'
        actuators += f'<motor tendon="t{k}"/>'
    return (f'<mujoco model="arm"><compiler angle="radian"/><worldbody>\n{bodies}{ends}</worldbody>\n<tendon>{tendons}</tendon>\n'
            f'<actuator>{actuators}</actuator></mujoco>\n')


def shares(description):
    """The matrix A of joints = A motors, and the names of the motors: joints that follow none, and motors that are none."""
    motors = [joint["variable"] for joint in description.joints if "follows" not in joint]
    motors += [motor["variable"] for motor in description.table.get("motor", [])]
    matrix = np.zeros((len(description.joints), len(motors)))
    for row, joint in zip(matrix, description.joints):
        if "follows" not in joint:
            row[motors.index(joint["variable"])] = 1
        for sign, factor, name in re.findall(r"([+-]?)\s*(?:([\d/]+)\s+)?([A-Za-z_]\w*)", joint.get("follows", "")):
            top, bottom = (factor or "1").split("/") if "/" in (factor or "") else (factor or "1", "1")
            row[motors.index(name)] += (-1 if sign == "-" else 1) * int(top) / int(bottom)
        if "ratio" in joint:
            row *= number(joint["ratio"])
    return matrix, motors


def inertia_of(description, name):
    found = [each for each in description.joints + description.table.get("motor", []) if each["variable"] == name]
    return number(found[0].get("rotor_inertia", 0))


def differences(random, path, description):
    """Largest differences of lengths, poses and masses at random motors."""
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    matrix, motors = shares(description)
    for _ in range(3):
        values = random.uniform(-1, 1, len(motors))
        # Each joint's frame holds minus its reference: what the description moves by is MuJoCo's position.
        joints = matrix @ values
        data.qpos[:] = joints
        mujoco.mj_forward(model, data)
        lengths = [data.ten_length[mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_TENDON, name)] - value
                   for name, value in zip(motors, values) if name.startswith("t")]
        _, tool = description.links(joints)
        pose = tool - transform(data.xmat[model.nbody - 1].reshape(3, 3), data.xpos[model.nbody - 1])
        dense = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, dense, data.qM) if hasattr(data, "qM") else mujoco.mj_fullM(model, data, dense)
        if not hasattr(model, "tendon_armature"):
            raise LookupError("this MuJoCo has no armature of tendons")
        own = matrix.T @ description.mass_matrix(joints) @ matrix + np.diag([inertia_of(description, m) for m in motors])
        masses = (own - matrix.T @ dense @ matrix) / abs(own).max()
        yield max(abs(np.array(lengths)).max(), abs(pose).max(), abs(masses).max())


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tool", default="build/ci/generator/cli/qvgen")
    parser.add_argument("--count", type=int, default=100)
    options = parser.parse_args()
    random = np.random.default_rng(7)
    worst = 0.0
    for k in range(options.count):
        motors = 1 + k % 3
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "arm.xml"
            path.write_text(random_arm(random, motors + int(random.integers(0, 4)), motors))
            run = imported(options.tool, path)
            if run is None:
                print(f"arm {k}: refused\n{path.read_text()}")
                return 1
            description = Description(run.stdout)
            if len(description.table.get("motor", [])) != motors:
                print(f"arm {k}: {motors} motors on tendons were not read\n{path.read_text()}{run.stderr}")
                return 1
            difference = max(differences(random, path, description))
        worst = max(worst, difference)
        if not difference < ALLOWED:
            print(f"arm {k}: differs by {difference:.3g}")
            return 1
    print(f"{options.count} arms with motors on tendons, largest difference {worst:.2g}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
