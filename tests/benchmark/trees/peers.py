# SPDX-License-Identifier: MIT
"""Models of robots in Pinocchio, and the numbers of models and states that the programs read.

The free flyer of a model is its joint 1. Velocities of the base are linear, then angular, in its own frame.
"""
import tomllib

import numpy as np
import pinocchio as pin

GRAVITY = 9.80665


def of_urdf(file, floating, fixed=()):
    """Model of a URDF, with some joints held at zero."""
    model = pin.buildModelFromUrdf(str(file), *([pin.JointModelFreeFlyer()] if floating else []))
    if fixed:
        model = pin.buildReducedModel(model, [model.getJointId(name) for name in fixed], pin.neutral(model))
    model.gravity.linear = np.array([0, 0, -GRAVITY])
    return model


def of_toml(file):
    """Model of an arm's description with turns about z, numbers and rpy in words such as "90 deg"."""
    def angle(value):
        return float(value.removesuffix(" deg")) * np.pi / 180 if isinstance(value, str) else float(value)
    model, parent = pin.Model(), 0
    for k, joint in enumerate(tomllib.loads(file.read_text())["joint"]):
        rotation = pin.rpy.rpyToMatrix(*[angle(a) for a in joint.get("rpy", (0, 0, 0))])
        place = pin.SE3(rotation, np.array(joint["origin"], dtype=float))
        parent = model.addJoint(parent, pin.JointModelRZ(), place, joint.get("name", f"joint{k + 1}"))
        body = pin.Inertia(joint["mass"], np.array(joint["centre_of_mass"], dtype=float), np.diag(joint["inertia"]))
        model.appendBodyToJoint(parent, body, pin.SE3.Identity())
    model.gravity.linear = np.array([0, 0, -GRAVITY])
    return model


def write_model(model, file):
    """A line a joint: name, type, parent, placement, mass, centre of mass and inertia about it."""
    with open(file, "w") as out:
        for k in range(1, model.njoints):
            place, body = model.jointPlacements[k], model.inertias[k]
            numbers = [*place.rotation.ravel(), *place.translation, body.mass, *body.lever, *body.inertia.ravel()]
            print(model.names[k], model.joints[k].shortname(), model.parents[k], *(f"{x:.17g}" for x in numbers), file=out)


def write_states(model, file, count=64):
    """Random states; coordinates between -1 and 1."""
    random = np.random.default_rng(1)
    floating = model.nq != model.nv
    with open(file, "w") as out:
        print(model.nv, int(floating), model.njoints - (2 if floating else 1), count, file=out)
        print(*list(model.names)[2 if floating else 1:], file=out)
        for _ in range(count):
            q, v, a = (random.uniform(-1, 1, n) for n in (model.nq, model.nv, model.nv))
            if floating:
                q[3:7] /= np.linalg.norm(q[3:7])
            for values in (q, v, a):
                print(*(f"{x:.17g}" for x in values), file=out)
