#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the compiled quadruped with Pinocchio and MuJoCo, which read the same URDF themselves.

    tests/floating/compare_with_peers.py PROGRAM quad.urdf      # PROGRAM: floating_values

Exit code 1 if a number differs by more than 1e-12 of the largest one of its quantity (1e-10 for accelerations, which are
solutions of equations), 77 without either library (pip install pin mujoco numpy).
"""
import importlib.util
import re
import subprocess
import sys

ALLOWED = 1e-12
SOLVED = 1e-10


def motions(program):
    """Names of the joints and tips, and a dictionary of lists of numbers for each motion."""
    lines = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
    joints, tips = lines[0].split()[1:], lines[1].split()[1:]
    all_motions, current = [], {}
    for line in lines[2:]:
        if line == "end":
            all_motions.append(current)
            current = {}
            continue
        name, *values = line.split()
        current.setdefault(name, []).append(np.array([float(v) for v in values]))
    return joints, tips, all_motions


class Comparison:
    def __init__(self, peer):
        self.peer, self.worst = peer, {}

    def add(self, name, ours, theirs, allowed=ALLOWED):
        ours, theirs = np.asarray(ours), np.asarray(theirs)
        error = np.abs(ours - theirs).max() / (1 + np.abs(theirs).max())
        worst, _ = self.worst.get(name, (0, allowed))
        self.worst[name] = (max(worst, error), allowed)

    def report(self):
        good = bool(self.worst)
        for name, (error, allowed) in self.worst.items():
            good = good and error <= allowed
            print(f"{self.peer:10} {name:26} {error:8.1e}{'' if error <= allowed else '  FAILS'}")
        return good


def places(ours, theirs):
    """The place among our velocities of each of theirs, the base's six first."""
    return np.array(list(range(6)) + [6 + ours.index(name) for name in theirs])


def with_pinocchio(urdf, joints, tips, all_motions):
    import pinocchio as pin
    model = pin.buildModelFromUrdf(urdf, pin.JointModelFreeFlyer())
    data = model.createData()
    take = places(joints, [model.names[i] for i in range(2, model.njoints)])
    take_q = np.concatenate([np.arange(7), take[6:] + 1])
    result = Comparison("Pinocchio")
    for m in all_motions:
        q, v = m["pinocchio_position"][0][take_q], m["velocity"][0][take]
        a, force = m["acceleration"][0][take], m["force"][0][take]
        nv = model.nv
        result.add("inverse dynamics", m["inverse_dynamics"][0][take], pin.rnea(model, data, q, v, a))
        result.add("gravity", m["gravity"][0][take], pin.computeGeneralizedGravity(model, data, q))
        mass = m["mass_matrix"][0].reshape(nv, nv)[np.ix_(take, take)]
        theirs = pin.crba(model, data, q)
        theirs = np.triu(theirs) + np.triu(theirs, 1).T
        result.add("mass matrix", mass, theirs)
        result.add("forward dynamics", m["forward_dynamics"][0][take], pin.aba(model, data, q, v, force), SOLVED)
        result.add("kinetic energy", m["kinetic_energy"][0], [pin.computeKineticEnergy(model, data, q, v)])
        result.add("centre of mass", m["centre_of_mass"][0], pin.centerOfMass(model, data, q, v))
        result.add("its velocity", m["centre_of_mass_velocity"][0], data.vcom[0])
        matrix = m["centroidal_matrix"][0].reshape(nv, 6).T[:, take]
        result.add("centroidal matrix", matrix, pin.computeCentroidalMap(model, data, q))
        pin.computeCentroidalMomentumTimeVariation(model, data, q, v, a)
        result.add("rate of the momentum", m["centroidal_rate"][0], data.dhg.vector)
        pin.computeJointJacobians(model, data, q)
        pin.forwardKinematics(model, data, q, v, 0 * a)
        pin.updateFramePlacements(model, data)
        for k, tip in enumerate(tips):
            frame = model.getFrameId(tip)
            world = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
            result.add("tips", m["tip_position"][k], data.oMf[frame].translation)
            jacobian = m["tip_jacobian"][k].reshape(nv, 6).T[:, take]
            result.add("Jacobians of tips", jacobian, pin.getFrameJacobian(model, data, frame, world))
            bias = pin.getFrameClassicalAcceleration(model, data, frame, world).vector
            result.add("bias of tips", m["tip_bias"][k], bias)
    return result.report()


def mjcf_of(urdf):
    """MuJoCo reads the root of a URDF as fixed: told to keep bodies apart, and written as MJCF, it gets a free joint."""
    import mujoco
    text = open(urdf).read()
    text = re.sub(r"(<robot[^>]*>)", r'\1<mujoco><compiler fusestatic="false" discardvisual="false"/></mujoco>', text, count=1)
    text = text.replace('<link name="torso">', '<link name="world"/><link name="torso">', 1)
    free = '<joint name="base" type="floating"><parent link="world"/><child link="torso"/></joint></robot>'
    return mujoco.MjModel.from_xml_string(text.replace("</robot>", free))


def with_mujoco(urdf, joints, all_motions):
    import mujoco
    model = mjcf_of(urdf)
    model.opt.gravity[:] = (0, 0, -9.81)
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT | mujoco.mjtDisableBit.mjDSBL_CONTACT
    model.dof_damping[:] = model.dof_frictionloss[:] = model.dof_armature[:] = 0
    data = mujoco.MjData(model)
    take = places(joints, [model.joint(i).name for i in range(1, model.njnt)])
    take_q = np.concatenate([np.arange(7), take[6:] + 1])
    result = Comparison("MuJoCo")
    for m in all_motions:
        data.qpos[:] = m["mujoco_position"][0][take_q]
        data.qvel[:] = m["mujoco_velocity"][0][take]
        data.qacc[:] = m["mujoco_acceleration"][0][take]
        mujoco.mj_inverse(model, data)
        result.add("inverse dynamics", m["mujoco_inverse_dynamics"][0][take], data.qfrc_inverse)
        result.add("centre of mass", m["centre_of_mass"][0], data.subtree_com[0])
    return result.report()


def main():
    program, urdf = sys.argv[1:3]
    joints, tips, all_motions = motions(program)
    good = not has_pinocchio or with_pinocchio(urdf, joints, tips, all_motions)
    return 0 if (not has_mujoco or with_mujoco(urdf, joints, all_motions)) and good else 1


if __name__ == "__main__":
    try:
        import numpy as np
    except ImportError:
        print("skipped: pip install numpy pin mujoco")
        sys.exit(77)
    has_pinocchio = importlib.util.find_spec("pinocchio") is not None
    has_mujoco = importlib.util.find_spec("mujoco") is not None
    for name, found in (("pin", has_pinocchio), ("mujoco", has_mujoco)):
        if not found:
            print(f"skipped: pip install {name}")
    sys.exit(main() if has_pinocchio or has_mujoco else 77)
