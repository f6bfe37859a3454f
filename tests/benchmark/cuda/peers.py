# SPDX-License-Identifier: MIT
"""The kernel of inverse dynamics beside JAX's, on one card in one run.

    python3 peers.py FOLDER [ROWS]     # FOLDER as measure.py make wrote it, with puma560; needs jax with CUDA

JAX's is the recursion of Luh, Walker and Paul, written here from the table of Denavit and Hartenberg alone: numbers of all
configurations beside one another, components written out, constants as numbers, so that XLA folds zeros and fuses what it can.
"""
import os
import pathlib
import statistics
import sys
import time

os.environ.setdefault("XLA_PYTHON_CLIENT_PREALLOCATE", "false")
import jax  # noqa: E402
import jax.numpy as jnp  # noqa: E402
import numpy as np  # noqa: E402
import tomllib  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import device  # noqa: E402
import measure  # noqa: E402

TABLE = pathlib.Path(__file__).resolve().parents[3] / "generator/robots/puma560.toml"


def angle(text):
    return np.radians(float(text.split()[0])) if isinstance(text, str) else float(text)


def add(*vectors):
    return [sum(parts) for parts in zip(*vectors)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def times(factors, vector):
    return [f * x for f, x in zip(factors, vector)]


class Link:
    """A row of the table; the frame is behind its joint, whose axis is z of the frame before."""

    def __init__(self, row):
        self.d, self.a, alpha = row.get("d", 0.0), row.get("a", 0.0), angle(row.get("alpha", 0.0))
        self.cos, self.sin = round(np.cos(alpha), 15), round(np.sin(alpha), 15)
        self.mass, self.centre, self.inertia = row.get("mass", 0.0), row.get("centre_of_mass", [0.0] * 3), row["inertia"]
        self.offset = [self.a, self.d * self.sin, self.d * self.cos]

    def back(self, c, s, v):
        """From the frame before to this one."""
        x, y = c * v[0] + s * v[1], c * v[1] - s * v[0]
        return [x, self.cos * y + self.sin * v[2], self.cos * v[2] - self.sin * y]

    def forth(self, c, s, v):
        y, z = self.cos * v[1] - self.sin * v[2], self.sin * v[1] + self.cos * v[2]
        return [c * v[0] - s * y, s * v[0] + c * y, z]


LINKS = [Link(row) for row in tomllib.loads(TABLE.read_text())["dh"]]


def inverse_dynamics(q, qd, qdd, gravity):
    c, s = jnp.cos(q), jnp.sin(q)
    spin, turn, rise = [0.0] * 3, [0.0] * 3, [0.0, 0.0, gravity]
    forces, moments = [], []
    for i, link in enumerate(LINKS):
        turn = link.back(c[i], s[i], add(turn, [spin[1] * qd[i], -spin[0] * qd[i], qdd[i]]))
        spin = link.back(c[i], s[i], add(spin, [0.0, 0.0, qd[i]]))
        rise = add(cross(turn, link.offset), cross(spin, cross(spin, link.offset)), link.back(c[i], s[i], rise))
        at_centre = add(rise, cross(turn, link.centre), cross(spin, cross(spin, link.centre)))
        forces.append([link.mass * x for x in at_centre])
        moments.append(add(times(link.inertia, turn), cross(spin, times(link.inertia, spin))))
    force, moment, torques = [0.0] * 3, [0.0] * 3, [None] * len(LINKS)
    for i, link in reversed(list(enumerate(LINKS))):
        moment = add(moment, cross(link.offset, force), cross(add(link.offset, link.centre), forces[i]), moments[i])
        force = add(force, forces[i])
        torques[i] = link.sin * moment[1] + link.cos * moment[2]
        force, moment = link.forth(c[i], s[i], force), link.forth(c[i], s[i], moment)
    return jnp.stack(torques)


def seconds_of(function, *arguments):
    """Median of runs that are waited for, of twenty calls each: what a call takes in a stream of calls."""
    times = []
    for _ in range(9):
        begin = time.perf_counter()
        for _ in range(20):
            result = function(*arguments)
        result.block_until_ready()
        times.append((time.perf_counter() - begin) / 20)
    return statistics.median(times[2:])


def main(folder, rows=1 << 21):
    jax.config.update("jax_enable_x64", True)
    card, n = device.Card(), int(rows)
    print(f"{card.name}, {n} configurations, jax {jax.__version__}")
    for robot in measure.robots_in(folder, ["puma560"]):
        robot.build()
        function = next(each for each in robot.functions if each.name == "puma560_inverse_dynamics")
        random = np.random.default_rng(1)
        given = [random.uniform(-3, 3, (6, n)).astype(robot.kind) for _ in range(3)]
        module = card.module(measure.compiled(robot, card)[0])
        kernel, result = module.kernel("puma560_inverse_dynamics_batch"), card.empty(given[0].nbytes)
        arrays = [card.array(each) for each in given]
        own = card.seconds(lambda: kernel(n, [n, *arrays, robot.kind(9.81), result]))
        jitted = jax.jit(inverse_dynamics, static_argnums=3)
        theirs = seconds_of(jitted, *(jnp.asarray(each) for each in given), 9.81)
        host = [*given, *(p.structure if p.structure else 9.81 for p in function.parameters[3:])]
        apart = measure.difference(np.asarray(jitted(*given, 9.81)), robot.rows(function, host, n))
        print(f"{robot.real:6} kernel {n / own / 1e6:9.1f}e6/s   JAX {n / theirs / 1e6:9.1f}e6/s   {theirs / own:5.2f} times as fast; "
              f"JAX and C differ by {apart:.0f} ulp", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
