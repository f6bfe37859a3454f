# SPDX-License-Identifier: MIT
"""Python: all solutions of a thousand poses, and the Jacobians there. `qvgen.load("my_arm.toml")` takes an arm of one's own."""
import numpy
import qvgen

arm = qvgen.robots.ns  # compiled at first use, and kept
q = numpy.random.default_rng(1).uniform(-1, 1, (1000, arm.dof))
poses = arm.forward_kinematics(q)  # (1000, 7): w x y z, then metres
found = arm.inverse_kinematics(poses, seed=q)  # nearest to the seed first
assert numpy.allclose(found.q[:, 0], q)

jacobians = arm.jacobian(q)
manipulability = numpy.abs(numpy.linalg.det(jacobians))
print(f"{found.count.sum()} solutions of {len(q)} poses, manipulability {manipulability.min():.1e} to {manipulability.max():.1e}")
