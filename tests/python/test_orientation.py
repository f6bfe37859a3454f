# SPDX-License-Identifier: MIT
"""Notations of orientations, against products of plain matrices, and scipy where it is installed."""

import numpy as np
import pytest

from qvgen import orientation

RANDOM = np.random.default_rng(7)


def about(axis, angle):
    """Rotation matrix about a coordinate axis."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    r = np.eye(3)
    r[i, i] = r[j, j] = np.cos(angle)
    r[j, i] = np.sin(angle)
    r[i, j] = -r[j, i]
    return r


def by_definition(angles, letters):
    r = np.eye(3)
    for letter, angle in zip(letters, angles):
        turn = about("xyz".index(letter.lower()), angle)
        r = turn @ r if letters.islower() else r @ turn
    return r


@pytest.mark.parametrize("letters", orientation.LETTERS)
def test_euler_angles(letters):
    angles = RANDOM.uniform(-np.pi, np.pi, (200, 3))
    lock = 0.0 if letters[0] == letters[2] else np.pi / 2
    angles[::4, 1] = lock
    angles[1::4, 1] = lock - np.pi
    expected = np.array([by_definition(each, letters) for each in angles])
    q = orientation.from_euler(angles, letters)
    assert np.abs(orientation.matrix(q) - expected).max() < 3e-15
    back = orientation.euler_angles(orientation.from_matrix(expected), letters)
    assert np.isfinite(back.angles).all()
    assert np.abs(orientation.matrix(orientation.from_euler(back.angles, letters)) - expected).max() < 3e-14
    found = orientation.euler_angles(q, letters, last_in_lock=0.25)
    assert found.gimbal_lock[::4].all() and found.gimbal_lock[1::4].all() and not found.gimbal_lock[2::4].any()
    assert np.allclose(found.angles[::4, 2], 0.25)
    assert np.abs(orientation.matrix(orientation.from_euler(found.angles, letters)) - expected).max() < 3e-14


def test_twenty_four_conventions_and_names():
    assert len(set(orientation.LETTERS)) == 24
    assert set(orientation.CONVENTIONS.values()) <= set(orientation.LETTERS)
    a = [0.1, -0.4, 1.2]
    assert np.allclose(orientation.matrix(orientation.from_euler(a, "kuka_abc")), about(2, 0.1) @ about(1, -0.4) @ about(0, 1.2))
    assert np.allclose(orientation.matrix(orientation.from_euler(a, "fanuc_wpr")), about(2, 1.2) @ about(1, -0.4) @ about(0, 0.1))
    with pytest.raises(ValueError, match="kawasaki_oat"):
        orientation.from_euler(a, "ZZX")


def test_quaternions_matrices_and_vectors():
    q = RANDOM.normal(size=(500, 4))
    q /= np.linalg.norm(q, axis=1)[:, None]
    q[q[:, 0] < 0] *= -1
    assert np.abs(orientation.from_matrix(orientation.matrix(q)) - q).max() < 1e-14
    assert np.abs(orientation.from_rotation_vector(orientation.rotation_vector(q)) - q).max() < 1e-14
    assert np.array_equal(orientation.from_xyzw(orientation.to_xyzw(q)), q)
    assert np.array_equal(orientation.to_xyzw([1, 2, 3, 4]), [2, 3, 4, 1])
    assert np.array_equal(orientation.rotation_vector([1, 0, 0, 0]), [0, 0, 0])
    assert np.isnan(orientation.euler_angles([0, 0, 0, 0], "xyz").angles).all()
    with pytest.raises(ValueError, match="shape"):
        orientation.matrix([1, 0, 0])


@pytest.mark.parametrize("letters", orientation.LETTERS)
def test_rates(letters):
    angles, rates, h = RANDOM.uniform(-3, 3, (50, 3)), RANDOM.normal(size=(50, 3)), 1e-5
    after, before = (orientation.from_euler(angles + s * h * rates, letters) for s in (1, -1))
    step = orientation.multiply(after, before * [1, -1, -1, -1])
    e = orientation.euler_rate_matrix(angles, letters)
    omega = np.einsum("nij,nj->ni", e, rates)
    assert np.abs(orientation.rotation_vector(step) / (2 * h) - omega).max() < 1e-8
    inverse = orientation.euler_rate_inverse(angles, letters)
    assert not inverse.singular.any()
    assert np.abs(np.einsum("nij,nj->ni", inverse.matrix, omega) - rates).max() < 1e-9
    j = orientation.analytical_jacobian(np.concatenate([e, e], axis=1), angles, letters)
    assert np.allclose(j.matrix[:, 3:], np.eye(3), atol=1e-9)
    locked = orientation.euler_rate_inverse([0.3, 0.0 if letters[0] == letters[2] else np.pi / 2, 1], letters)
    assert locked.singular and not locked.matrix.any()


@pytest.mark.parametrize("letters", orientation.LETTERS)
def test_other_euler_angles(letters):
    angles = RANDOM.uniform(-np.pi, np.pi, (200, 3))
    other = orientation.other_euler_angles(angles, letters)
    turns = [orientation.matrix(orientation.from_euler(each, letters)) for each in (angles, other)]
    assert np.abs(turns[0] - turns[1]).max() < 1e-14
    assert np.abs(other - angles).max(axis=1).min() > 1e-3 and (other > -np.pi).all() and (other <= np.pi).all()
    assert np.abs(np.exp(1j * orientation.other_euler_angles(other, letters)) - np.exp(1j * angles)).max() < 1e-14


def test_rates_of_rotation_vectors():
    scale = 10 ** RANDOM.uniform(-9, 0.6, (400, 1))
    vectors, rates, h = scale * RANDOM.uniform(-1, 1, (400, 3)), RANDOM.normal(size=(400, 3)), 1e-5
    after, before = (orientation.from_rotation_vector(vectors + s * h * rates) for s in (1, -1))
    omega = orientation.rotation_vector(orientation.multiply(after, before * [1, -1, -1, -1])) / (2 * h)
    inverse = orientation.rotation_vector_rate_inverse(vectors)
    lengths = np.linalg.norm(vectors, axis=1)
    regular = np.abs(np.sin(lengths / 2)) > 0.05 * lengths
    assert not inverse.singular.any() and regular.sum() > 300
    assert np.abs(np.einsum("nij,nj->ni", inverse.matrix, omega) - rates)[regular].max() < 1e-6
    geometric = np.broadcast_to(np.concatenate([np.eye(3), np.eye(3)]), (400, 6, 3))
    j = orientation.analytical_jacobian(geometric, vectors)
    assert np.array_equal(j.matrix[:, 3:], inverse.matrix) and (j.matrix[:, :3] == np.eye(3)).all()
    turn = orientation.rotation_vector_rate_inverse([[0, 0, 2 * np.pi], [0, 0, 0]])
    assert list(turn.singular) == [True, False] and not turn.matrix[0].any() and (turn.matrix[1] == np.eye(3)).all()


def test_nearest_rotation():
    q = RANDOM.normal(size=(200, 4))
    q /= np.linalg.norm(q, axis=1)[:, None]
    q[q[:, 0] < 0] *= -1
    near = orientation.nearest_rotation(np.round(orientation.matrix(q), 4))
    assert np.allclose(np.linalg.norm(near, axis=1), 1, atol=1e-15)
    assert np.abs(near - q).max() < 2e-4
    assert np.allclose(orientation.nearest_rotation(3 * q), q)
    for bad in ([0, 0, 0, 0], [1, np.nan, 0, 0], np.zeros((3, 3)), -np.eye(3)):
        with pytest.raises(ValueError):
            orientation.nearest_rotation(bad)


@pytest.mark.parametrize("letters", orientation.LETTERS)
def test_scipy_agrees(letters):
    rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    angles = RANDOM.uniform(-3, 3, (100, 3))
    theirs = rotation.from_euler(letters, angles)
    q = orientation.from_xyzw(theirs.as_quat())
    assert np.abs(orientation.matrix(orientation.from_euler(angles, letters)) - orientation.matrix(q)).max() < 1e-14
    assert np.abs(orientation.euler_angles(q, letters).angles - theirs.as_euler(letters)).max() < 1e-9
