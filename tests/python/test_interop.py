# SPDX-License-Identifier: MIT
"""Derivatives against steps of the functions themselves; CasADi, JAX and PyTorch against both, where they are installed."""

import numpy as np
import pytest

from qvgen import derivatives, interop

STEP = 1e-6


@pytest.fixture(scope="module", params=["ns", "arm"])
def robot(request):
    return request.getfixturevalue(request.param)


def functions_of(robot):
    for name in derivatives.OF:
        try:
            yield name, len(derivatives.arguments_of(robot, name))
        except ValueError:
            pass


def arguments(robot, count, rows=4):
    return list(np.random.default_rng(7).uniform(-1.3, 1.3, (count, rows, robot.dof)))


def differences(function, given, place):
    """Derivative of a function of rows by one argument, its axis last."""
    columns = []
    for step in STEP * np.eye(given[place].shape[-1]):
        ahead, behind = list(given), list(given)
        ahead[place], behind[place] = given[place] + step, given[place] - step
        columns.append((function(*ahead) - function(*behind)) / (2 * STEP))
    return np.stack(columns, axis=-1)


def test_derivatives(ns, arm):
    assert {name for name, _ in functions_of(arm)} == set(derivatives.OF)
    assert {name for name, _ in functions_of(ns)} == {"forward_kinematics", "homogeneous_transform", "jacobian", "velocity"}
    for robot in (ns, arm):
        for name, count in functions_of(robot):
            given = arguments(robot, count)
            value, by = derivatives.OF[name][0](robot, *given)
            np.testing.assert_array_equal(value, getattr(robot, name)(*given), err_msg=name)
            for place in range(count):
                np.testing.assert_allclose(by[place], differences(getattr(robot, name), given, place), atol=2e-7, err_msg=name)


def test_what_has_no_derivatives(ns):
    with pytest.raises(ValueError, match="ns has no derivatives of inverse_dynamics; .*--only dynamics_derivatives"):
        interop.casadi(ns, "inverse_dynamics")
    with pytest.raises(ValueError, match="it has those of forward_kinematics"):
        interop.torch(ns, "elbow")


def test_casadi(robot):
    cs = pytest.importorskip("casadi")
    for name, count in functions_of(robot):
        function = interop.casadi(robot, name)
        given = [each[0] for each in arguments(robot, count)]
        value = getattr(robot, name)(*given)
        np.testing.assert_allclose(np.array(function(*given)).reshape(value.shape), value, atol=1e-15)
        symbols = [cs.MX.sym(f"x{i}", robot.dof) for i in range(count)]
        wanted = derivatives.OF[name][0](robot, *(each[None] for each in given))[1]
        for place, symbol in enumerate(symbols):
            by = np.array(cs.Function("by", symbols, [cs.jacobian(function(*symbols), symbol)])(*given))
            matrix = wanted[place][0]
            by_columns = matrix if matrix.ndim == 2 else np.moveaxis(matrix, 0, 1).reshape(-1, robot.dof)
            np.testing.assert_allclose(by, by_columns, atol=1e-12, err_msg=name)


def test_an_optimal_control_problem_of_casadi(arm):
    """From rest to rest in a second, with the least effort: the dynamics hold at every step."""
    cs = pytest.importorskip("casadi")
    steps, duration = 10, 1.0
    dynamics = interop.casadi(arm, "forward_dynamics")
    problem = cs.Opti()
    q, qd, torque = problem.variable(2, steps + 1), problem.variable(2, steps + 1), problem.variable(2, steps)
    h = duration / steps
    for k in range(steps):
        problem.subject_to(qd[:, k + 1] == qd[:, k] + h * dynamics(q[:, k], qd[:, k], torque[:, k]))
        problem.subject_to(q[:, k + 1] == q[:, k] + h * qd[:, k + 1])
    goal = np.array([0.4, -0.3])
    for each, value in ((q[:, 0], [0, 0]), (qd[:, 0], [0, 0]), (q[:, -1], goal), (qd[:, -1], [0, 0])):
        problem.subject_to(each == np.array(value))
    problem.minimize(cs.sumsqr(torque))
    problem.solver("ipopt", {"print_time": False}, {"print_level": 0, "hessian_approximation": "limited-memory"})
    found = problem.solve()
    at, rates, forces = (found.value(each).T for each in (q, qd, torque))
    np.testing.assert_allclose(np.diff(rates, axis=0) / h, arm.forward_dynamics(at[:-1], rates[:-1], forces), atol=1e-5)
    np.testing.assert_allclose(np.diff(at, axis=0) / h, rates[1:], atol=1e-6)
    np.testing.assert_allclose([*at[0], *at[-1]], [0, 0, *goal], atol=1e-7)


def test_jax(robot):
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    for name, count in functions_of(robot):
        function = interop.jax(robot, name)
        given = arguments(robot, count)
        value, by = derivatives.OF[name][0](robot, *given)
        np.testing.assert_allclose(jax.jit(function)(*given), value, atol=1e-15)
        for place in range(count):
            one = jax.jacrev(function, argnums=place)(*(each[2] for each in given))
            np.testing.assert_allclose(one, by[place][2], atol=1e-12, err_msg=name)
            many = jax.vmap(jax.jacfwd(function, argnums=place))(*given)
            np.testing.assert_allclose(many, by[place], atol=1e-12, err_msg=name)
    single = interop.jax(robot, "forward_kinematics")(np.zeros(robot.dof, np.float32))
    assert single.dtype == np.float32


def test_torch(robot):
    torch = pytest.importorskip("torch")
    for name, count in functions_of(robot):
        function = interop.torch(robot, name)
        tensors = [torch.tensor(each, requires_grad=True) for each in arguments(robot, count)]
        np.testing.assert_allclose(function(*tensors).detach().numpy(), getattr(robot, name)(*arguments(robot, count)), atol=1e-15)
        assert torch.autograd.gradcheck(function, tensors, eps=STEP, atol=1e-6), name
        shared = [each.detach()[0].requires_grad_() if place else each for place, each in enumerate(tensors)]
        assert torch.autograd.gradcheck(function, shared, eps=STEP, atol=1e-6), name  # one row for all of the others
    single = interop.torch(robot, "jacobian")(torch.zeros(3, robot.dof))
    assert single.dtype == torch.float32 and single.shape == (3, 6, robot.dof)
