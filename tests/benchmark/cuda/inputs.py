# SPDX-License-Identifier: MIT
"""What kernels and the robot's C are run on: random numbers and poses, and among them the special ones."""
import numpy as np


def inputs(parameter, n, random, kind):
    """Random numbers, and among the first rows special ones: zeros, right angles, large angles, values that are no numbers."""
    if parameter.name == "standard":
        return random.uniform(0.2, 1, (parameter.size, n)).astype(kind)
    values = random.uniform(-3, 3, (parameter.size, n))
    if parameter.name == "base":
        values[:4] /= np.linalg.norm(values[:4], axis=0)
    elif n > 8:
        values[:, 0] = 0
        values[:, 1] = np.pi / 2
        values[:, 2] = -np.pi
        values[:, 3] = 1e6 + values[:, 3]  # beyond the short reduction of sines in float, within that in double
        values[0, 4] = np.nan
        values[-1, 5] = np.inf
    return values.astype(kind)


def arguments(robot, function, n, random):
    """Makes what C takes, and what the kernel takes: arrays, numbers, constants by their structure's name or as bytes."""
    host, card = [], []
    for each in function.parameters:
        if each.size:
            host.append(inputs(each, n, random, robot.kind))
            card.append(host[-1])
        elif each.structure:
            host.append(each.structure)
            if data := robot.constants(each.structure):
                card.append(data)
        else:
            host.append(9.81)
            card.append(robot.kind(9.81))
    return host, card


def on(card, given):
    """Puts the arrays among the arguments on the card."""
    return [card.array(each) if isinstance(each, np.ndarray) else each for each in given]


def poses_for(robot, n, random):
    """Poses of random joints; the first ones singular or nearly so, out of reach, no rotations, no numbers."""
    function = next(each for each in robot.functions if each.name == f"{robot.name}_forward_kinematics")
    size = function.parameters[0].size
    q = random.uniform(-3, 3, (size, n)).astype(robot.kind)
    special = min(n, 200)
    q[:, :special] = random.choice([0, np.pi / 2, np.pi], (size, special)) + random.choice([0, 1e-9], special)
    poses = robot.rows(function, [q, *[each.structure for each in function.parameters[1:]]], n)
    if n > 1000:
        poses[4:, 200:300] += 30
        poses[:4, 300] *= 1.1
        poses[4, 301], poses[0, 302], poses[:, 303] = np.nan, np.nan, 0
    return np.ascontiguousarray(poses[:4]), np.ascontiguousarray(poses[4:])
