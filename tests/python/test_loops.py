# SPDX-License-Identifier: MIT
"""Closed loops: a four-bar against its own geometry, and a five-bar whose outputs are a point."""

import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import qvgen

ROBOTS = pathlib.Path(__file__).resolve().parents[1] / "loops/robots"
STEP = 1e-6


@pytest.fixture(scope="module")
def bar():
    return qvgen.load(ROBOTS / "four_bar.toml", "--only", "dynamics,kinematics,jacobian,assembly")


@pytest.fixture(scope="module")
def small():
    """With few files of C++, which are compiled when something is asked for that C does not have."""
    return qvgen.load(ROBOTS / "four_bar.toml", "--only", "assembly")


def ends(q, r1=0.1, r2=0.35, r3=0.25, ground=0.3):
    """The pin as the coupler has it, and as the rocker has it."""
    turned = q[..., 0] + q[..., 1]
    coupler = [r1 * np.cos(q[..., 0]) + r2 * np.cos(turned), r1 * np.sin(q[..., 0]) + r2 * np.sin(turned)]
    return np.stack(coupler, -1), np.stack([ground + r3 * np.cos(q[..., 2]), r3 * np.sin(q[..., 2])], -1)


def energy(bar, q, ad):
    """Kinetic energy at a rate of the crank."""
    return bar.kinetic_energy(q, bar.rates(q)[:, 0] * ad)


def test_assemblies_close_the_loop(bar):
    crank = np.linspace(-3, 3, 40)[:, None]
    found = bar.assemble(crank)
    assert found.q.shape == (40, 2, 3) and (found.count == 2).all() and (found.status == qvgen.Status.solved).all()
    coupler, rocker = ends(found.q)
    np.testing.assert_allclose(coupler, rocker, atol=1e-13)
    assert np.abs(found.q[:, 0, 2] - found.q[:, 1, 2]).min() > 0.1 and not found.meets.any()
    assert np.abs(bar.loop_gaps(found.q[:, 0])).max() < 1e-13
    one = bar.assemble([crank[3, 0]])
    assert one.q.shape == (2, 3) and one.count == 2 and (one.q == found.q[3]).all()
    assert bar.driven_joints == [0] and bar.passive_joints == [1, 2] and bar.driven_count == 1


def test_a_seed_comes_first_and_paths_are_followed(bar):
    crank = np.linspace(0.3, 7, 200)[:, None]
    start = bar.assemble(crank[0])
    for row in range(2):
        path = bar.follow(crank, start.q[row], path=True)
        assert path.closed.all() and np.abs(np.diff(path.q, axis=0)).max() < 0.2
        near = bar.assemble(crank, path.q + 0.01)
        np.testing.assert_allclose(near.q[:, 0], path.q, atol=1e-9)
    with pytest.raises(ValueError, match="on a path there is one seed"):
        bar.follow(crank, np.repeat(start.q[:1], 200, 0), path=True)


def test_other_lengths(bar):
    """Lengths that cannot be assembled, NaN, and what tips are told about the lengths."""
    assert bar.assemble([0.5], geometry={"r2": 2}).status == qvgen.Status.unreachable
    assert bar.assemble([np.nan]).status == qvgen.Status.invalid
    assert not bar.follow([0.5], [0.5, 0, 0], geometry={"r2": 2}).closed
    longer = {"r1": 0.12}
    q = bar.assemble([0.5], geometry=longer).q[0]
    np.testing.assert_allclose(*ends(q, **longer), atol=1e-13)
    turn = q[0] + q[1]
    x, y = 0.12 * np.cos(0.5), 0.12 * np.sin(0.5)
    point = [x + 0.2 * np.cos(turn) - 0.1 * np.sin(turn), y + 0.2 * np.sin(turn) + 0.1 * np.cos(turn), 0]
    np.testing.assert_allclose(bar.pose_of_point(q, geometry=longer)[4:], point, atol=1e-15)
    fold = bar.assemble([0.0], geometry={"r1": 0.1, "r2": 0.3, "r3": 0.1, "ground": 0.3})
    assert fold.meets.any()  # a parallelogram in line may fold


def test_rates_are_differences(bar):
    at = bar.assemble([0.7]).q[1]
    ahead, behind = (bar.follow([0.7 + step], at).q for step in (STEP, -STEP))
    np.testing.assert_allclose(bar.rates(at)[:, 0], (ahead - behind) / (2 * STEP), atol=1e-8)
    moved = (bar.pose_of_point(ahead)[4:] - bar.pose_of_point(behind)[4:]) / (2 * STEP)
    np.testing.assert_allclose(bar.jacobian_of_point(at)[:3, 0], moved, atol=1e-8)
    curved = (bar.rates(ahead)[:, 0] - bar.rates(behind)[:, 0]) / (2 * STEP)
    found = bar.accelerations(at, 3 * bar.rates(at)[:, 0], [2.0])
    np.testing.assert_allclose(found, 9 * curved + 2 * bar.rates(at)[:, 0], atol=1e-7)
    assert 0 < bar.drive_measure(at) <= 1


def test_power_of_the_motor_is_what_energies_take(bar):
    rate, acceleration = 2.0, 5.0
    q = bar.assemble([1.1]).q[0]
    force = bar.driven_inverse_dynamics(q, [rate], [acceleration], gravity=0)
    after, before = (bar.follow([1.1 + step], q).q for step in (rate * STEP, -rate * STEP))
    gained = (energy(bar, after, rate + acceleration * STEP) - energy(bar, before, rate - acceleration * STEP)) / (2 * STEP)
    friction = 0.05 * (bar.rates(q)[2, 0] * rate) ** 2
    np.testing.assert_allclose(force[0] * rate, gained + friction, rtol=1e-6)
    np.testing.assert_allclose(bar.driven_mass_matrix(q)[0, 0], 2 * energy(bar, q, 1.0), rtol=1e-13)
    np.testing.assert_allclose(bar.driven_forward_dynamics(q, [rate], force, gravity=0), acceleration, rtol=1e-12)


def test_batches_are_their_rows(bar, small):
    q = bar.assemble(np.linspace(0, 3, 20)[:, None]).q[:, 0]
    for function in (small.rates, small.loop_jacobian, bar.driven_mass_matrix, small.pose_of_point, small.jacobian_of_point):
        whole = function(q)
        np.testing.assert_array_equal(whole[7], function(q[7]))
        into = np.empty_like(whole)
        assert function(q, out=into) is into and (into == whole).all()
    with pytest.raises(ValueError, match=r"q has the shape \(2,\)"):
        bar.rates([0, 0])
    assert bar.functions["assemble"] == "here" and "a: (driven_count,)" in bar.assemble.__doc__
    with pytest.raises(AttributeError, match="platform_measure"):
        small.platform_measure


def test_inertias_by_name(tmp_path):
    """Symbols of inertia in C++ are those that C has: twice the kinetic energy at a unit rate of the crank."""
    if not os.environ.get("QVGEN_PYTHON_ROBOTS"):
        pytest.skip("QVGEN_PYTHON_ROBOTS=1 compiles more robots")
    text = (ROBOTS / "four_bar.toml").read_text().replace("[defaults]", "[defaults]\nm3 = 0.6\nm2 = 0.8")
    file = tmp_path / "four_bar.toml"
    file.write_text(text.replace("mass = 0.8", 'mass = "m2"').replace("mass = 0.6", 'mass = "m3"'))
    bar = qvgen.load(file, "--only", "dynamics,assembly")
    q = bar.assemble([1.1]).q[0]
    plain = bar.driven_mass_matrix(q)[0, 0]
    for inertia in ({"m2": 2.0}, {"m3": 3.0}):
        found = bar.driven_mass_matrix(q, inertia=inertia)[0, 0]
        np.testing.assert_allclose(found, 2 * bar.kinetic_energy(q, bar.rates(q)[:, 0], inertia=inertia), rtol=1e-13)
        assert found > 1.1 * plain
    with pytest.raises(ValueError, match="inertia has no m4"):
        bar.driven_mass_matrix(q, inertia={"m4": 1.0})


def test_platforms_both_ways():
    if not os.environ.get("QVGEN_PYTHON_ROBOTS"):
        pytest.skip("QVGEN_PYTHON_ROBOTS=1 compiles more robots")
    delta = qvgen.load(ROBOTS / "delta.toml", "--only", "dynamics,kinematics,jacobian,assembly")
    found = delta.assemble(np.random.default_rng(1).uniform(-0.3, 0.3, (50, 3)))
    q = found.q[found.count > 0, 0]
    assert len(q) > 20 and len(delta.output_joints) == 3
    back = delta.assemble_from_outputs(q[:, delta.output_joints], q)
    np.testing.assert_allclose(back.q[:, 0], q, atol=1e-9)
    ahead = delta.follow(q[:, delta.driven_joints] + [STEP, 0, 0], q).q
    np.testing.assert_allclose(delta.platform_rates(q)[:, :, 0], (ahead - q)[:, delta.output_joints] / STEP, atol=1e-4)
    assert (delta.platform_measure(q) > 0).all()


def test_legs_with_rods_reach_poses():
    if not os.environ.get("QVGEN_PYTHON_ROBOTS"):
        pytest.skip("QVGEN_PYTHON_ROBOTS=1 compiles more robots")
    leg = qvgen.load(ROBOTS / "leg.toml", "--only", "dynamics,kinematics,jacobian,inverse,assembly")
    chain = np.random.default_rng(1).uniform(0.05, 0.5, (20, 6)) * [1, 1, -1, 1, -1, 0.2]
    q = leg.assemble_from_joints_of_foot(chain)
    q = q.q[q.count > 0, 0]
    assert len(q) > 10
    found = leg.inverse_kinematics_of_foot(leg.pose_of_foot(q), q)
    np.testing.assert_allclose(found.q[:, 0], q, atol=1e-9)
    one = leg.inverse_kinematics_of_foot(leg.pose_of_foot(q[0]))
    assert one.count == found.count[0] and one.q.shape == found.q.shape[1:]
    wrench = np.array([1.0, 2, 3, 4, 5, 6])
    np.testing.assert_allclose(leg.motor_forces_of_foot(q[0], wrench), -leg.jacobian_of_foot(q[0]).T @ wrench, atol=1e-12)
    assert np.isfinite(leg.loop_forces(q[0], np.ones(6), np.ones(6))).all()


FLOATING = "[floating_base]\nmass = 2\ncentre_of_mass = [0.01, 0.02, 0.1]\ninertia = [0.02, 0.015, 0.01, 0.001, -0.003, 0.002]\n"


@pytest.mark.parametrize("name, motors", [("four_bar", [0.5]), ("strider", [0.1, 0.05, 0.05, 0.1])])
def test_dynamics_on_a_base_that_floats(name, motors, tmp_path):
    """A four-bar, and a leg on rods: vectors begin with the base's six, and the energy is that of the tree."""
    description = ROBOTS.parents[1] / f"floating/{name}.toml"
    if name == "four_bar":
        description = tmp_path / "four_bar.toml"
        description.write_text((ROBOTS / "four_bar.toml").read_text().replace("[defaults]", FLOATING + "[defaults]"))
    elif not os.environ.get("QVGEN_PYTHON_ROBOTS"):
        pytest.skip("QVGEN_PYTHON_ROBOTS=1 compiles more robots")
    robot = qvgen.load(description, "--only", "dynamics,assembly")
    random = np.random.default_rng(3)
    q = robot.assemble(motors).q[0]
    turn = random.normal(size=4)
    at = np.concatenate([turn / np.linalg.norm(turn), random.normal(size=3), q])
    ad, forces = random.normal(size=(2, 5, 6 + len(motors)))
    add = robot.driven_forward_dynamics(at, ad, forces)
    np.testing.assert_allclose(robot.driven_inverse_dynamics(at, ad, add), forces, atol=1e-10)
    whole = np.concatenate([ad[:, :6], ad[:, 6:] @ robot.rates(q).T], axis=1)
    masses = robot.driven_mass_matrix(at)
    np.testing.assert_allclose(np.einsum("ni,ij,nj->n", ad, masses, ad) / 2, robot.kinetic_energy(at, whole), rtol=1e-12)
    # Forces of motors and loops, by the gaps' derivatives, are those of the open tree.
    gaps = np.stack([robot.loop_gaps(q + step) - robot.loop_gaps(q - step) for step in STEP * np.eye(len(q))]) / (2 * STEP)
    held = robot.loop_forces(at, ad, add) @ gaps.T
    held[:, robot.driven_joints] += forces[:, 6:]
    qdd = np.concatenate([add[:, :6], robot.accelerations(q, whole[:, 6:], add[:, 6:])], axis=1)
    np.testing.assert_allclose(np.concatenate([forces[:, :6], held], axis=1), robot.inverse_dynamics(at, whole, qdd), atol=1e-6)
    with pytest.raises(ValueError, match="shape"):
        robot.driven_mass_matrix(q)
    fall = [0, 0, -9.80665]
    for each in ("driven_inverse_dynamics", "driven_forward_dynamics", "loop_forces"):
        falling = getattr(robot, each + "_with_gravity_vector")
        np.testing.assert_allclose(falling(at, ad, add, fall), getattr(robot, each)(at, ad, add), atol=1e-10)
        assert np.abs(falling(at, ad, add, [1, 2, 3]) - falling(at, ad, add, fall)).max() > 0.1
    check_tip(robot, "point" if name == "four_bar" else "foot", at, ad)


def check_tip(robot, tip, at, ad):
    """The tip moves as differences say, along a motion without accelerations; from the base's frame it is where pose_of_TIP says."""
    moves, q = getattr(robot, f"driven_tip_motion_of_{tip}"), at[7:]
    found, turn, place = moves(at, ad), qvgen.orientation.matrix(at[:4]), getattr(robot, f"pose_of_{tip}")(q)
    np.testing.assert_allclose(found.pose[:, 4:], np.broadcast_to(at[4:7] + turn @ place[4:], (len(ad), 3)), atol=1e-12)
    by_motors = getattr(robot, f"jacobian_of_{tip}")(q)
    np.testing.assert_allclose(found.jacobian[0, :, 6:], np.concatenate([turn @ by_motors[:3], turn @ by_motors[3:]]), atol=1e-12)

    def after(time):
        rows = []
        for velocity in ad:
            v, w = velocity[:3], velocity[3:6]
            base = qvgen.orientation.multiply(at[:4], qvgen.orientation.from_rotation_vector(w * time))
            position = at[4:7] + turn @ (v * time + np.cross(w, v) * time ** 2 / 2)
            rows.append(np.concatenate([base, position, robot.follow(q[robot.driven_joints] + time * velocity[6:], q).q]))
        return moves(np.array(rows), ad)

    velocity = np.einsum("nij,nj->ni", found.jacobian, ad)
    before, behind = after(-STEP), after(STEP)
    np.testing.assert_allclose((behind.pose[:, 4:] - before.pose[:, 4:]) / (2 * STEP), velocity[:, :3], atol=1e-7)
    change = np.einsum("nij,nj->ni", behind.jacobian - before.jacobian, ad) / (2 * STEP)
    np.testing.assert_allclose(change, found.bias, atol=1e-6)


def test_loops_need_no_cxx_compiler():
    code = ("import qvgen, numpy, sys\n"
            "bar = qvgen.load(sys.argv[1], '--only', 'dynamics,kinematics,jacobian,assembly')\n"
            "found = bar.assemble([[0.4], [0.5]], [0.4, 0, 0]).q[:, 0]\n"
            "assert bar.follow([0.5], found[0]).closed and bar.rates(found).shape == (2, 3, 1)\n"
            "assert bar.pose_of_point(found).shape == (2, 7) and bar.driven_mass_matrix(found).shape == (2, 1, 1)\n")
    environment = {**os.environ, "CXX": "false"}
    subprocess.run([sys.executable, "-c", code, str(ROBOTS / "four_bar.toml")], check=True, env=environment)


def test_rows_of_c_are_those_of_cxx(small):
    crank = np.linspace(-7, 7, 100)[:, None]
    crank[50] = np.nan
    in_c, in_cxx = small.assemble(crank, [0, 0, 9]), small.assemble(crank, [0, 0, 9], tolerance=1.0001e-13)
    for one, other in zip(in_c, in_cxx):
        np.testing.assert_allclose(one, other, atol=1e-12)
    assert in_c.status[50] == qvgen.Status.invalid
