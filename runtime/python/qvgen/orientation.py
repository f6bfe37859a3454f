# SPDX-License-Identifier: MIT
"""Orientations in the notations of robot controllers: quaternions in either order, matrices, rotation vectors, Euler angles.

Every function takes one orientation, or a batch along the first axes. Quaternions are w, x, y, z unless a name says xyzw.
An Euler convention is three letters or a name of `CONVENTIONS`: capitals turn about the axes that have turned already
("ZYX"), small letters about the fixed axes ("xyz"); angles are in rad, in the order of the letters.
"""

import typing

import numpy as np

#: What manufacturers and programs call their three angles.
CONVENTIONS = {"kuka_abc": "ZYX", "abb_zyx": "ZYX", "fanuc_wpr": "xyz", "yaskawa_rxyz": "xyz", "staubli_rxyz": "XYZ",
               "kawasaki_oat": "ZYZ", "ros_rpy": "xyz"}

#: All conventions that there are.
LETTERS = tuple(a + b + c for axes in ("XYZ", "xyz") for a in axes for b in axes for c in axes if a != b and b != c)

_LOCK = 16 * np.finfo(float).eps


class EulerAngles(typing.NamedTuple):
    """Euler angles, and where only the sum or the difference of the outer ones is determined."""
    angles: typing.Any  #: (3,), rad
    gimbal_lock: typing.Any  #: ()


class Rates(typing.NamedTuple):
    """The inverse of a rate matrix; zero where it is singular."""
    matrix: typing.Any  #: (3, 3)
    singular: typing.Any  #: ()


def _axes(convention):
    """The three axes, and whether they are fixed."""
    letters = CONVENTIONS.get(convention, convention)
    if letters not in LETTERS:
        raise ValueError(f"no Euler convention {convention!r}: three letters such as \"ZYX\" (about turned axes) or \"xyz\" "
                         f"(about fixed ones), or one of {', '.join(CONVENTIONS)}")
    return ["xyz".index(letter) for letter in letters.lower()], letters.islower()


def _array(numbers, *shape):
    """As an array of float64 that ends with a shape."""
    array = np.asarray(numbers, dtype=float)
    if array.shape[array.ndim - len(shape):] != shape:
        raise ValueError(f"wants the shape (..., {', '.join(map(str, shape))}), not {array.shape}")
    return array


def _norm(vectors):
    return np.sqrt(np.sum(np.square(vectors), axis=-1))


def _wrap(angles):
    """Into (-pi, pi]."""
    rest = angles - 2 * np.pi * np.ceil((angles - np.pi) / (2 * np.pi))
    return np.clip(rest, -np.pi, np.pi)


def from_xyzw(xyzw):
    """Quaternion w, x, y, z of x, y, z, w (ROS, scipy)."""
    return np.roll(_array(xyzw, 4), 1, axis=-1)


def to_xyzw(wxyz):
    """x, y, z, w (ROS, scipy) of a quaternion w, x, y, z."""
    return np.roll(_array(wxyz, 4), -1, axis=-1)


def multiply(a, b):
    """Hamilton's product of quaternions: the turn b, then a."""
    a, b = _array(a, 4), _array(b, 4)
    aw, bw, av, bv = a[..., :1], b[..., :1], a[..., 1:], b[..., 1:]
    scalar = aw * bw - np.sum(av * bv, axis=-1, keepdims=True)
    return np.concatenate([scalar, aw * bv + bw * av + np.cross(av, bv)], axis=-1)


def matrix(wxyz):
    """Rotation matrix of a unit quaternion."""
    w, x, y, z = np.moveaxis(_array(wxyz, 4), -1, 0)
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def from_matrix(rotation):
    """Unit quaternion, w not negative, of a rotation matrix; see `nearest_rotation` for what is almost one."""
    r = _array(rotation, 3, 3)
    # Four times the products of the quaternion's numbers; the row with the largest square is divided by its root.
    products = np.empty((*r.shape[:-2], 4, 4))
    diagonal = [r[..., i, i] for i in range(3)]
    products[..., 0, 0] = 1 + sum(diagonal)
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        products[..., i + 1, i + 1] = 1 + diagonal[i] - diagonal[j] - diagonal[k]
        products[..., 0, i + 1] = products[..., i + 1, 0] = r[..., k, j] - r[..., j, k]
        products[..., i + 1, j + 1] = products[..., j + 1, i + 1] = r[..., j, i] + r[..., i, j]
    largest = np.argmax(np.diagonal(products, axis1=-2, axis2=-1), axis=-1)
    q = np.take_along_axis(products, largest[..., None, None], axis=-2)[..., 0, :]
    return q * np.where(q[..., :1] < 0, -1, 1) / _norm(q)[..., None]


def rotation_vector(wxyz):
    """Axis times angle, rad, of length [0, pi], of a unit quaternion."""
    q = _array(wxyz, 4)
    sine = _norm(q[..., 1:])
    angle = 2 * np.arctan2(sine, np.abs(q[..., 0]))
    factor = np.where(sine > 0, angle / np.where(sine > 0, sine, 1), 2)
    return (np.where(q[..., 0] < 0, -1, 1) * factor)[..., None] * q[..., 1:]


def from_rotation_vector(vector):
    """Unit quaternion of axis times angle, rad."""
    v = _array(vector, 3)
    half = _norm(v) / 2
    factor = np.where(half > 0, np.sin(half) / np.where(half > 0, half, 1), 1) / 2
    return np.concatenate([np.cos(half)[..., None], factor[..., None] * v], axis=-1)


def _turn(axis, angle):
    q = np.zeros((*np.shape(angle), 4))
    q[..., 0], q[..., 1 + axis] = np.cos(angle / 2), np.sin(angle / 2)
    return q


def from_euler(angles, convention):
    """Unit quaternion of three Euler angles, rad."""
    (first, second, third), fixed = _axes(convention)
    a = _array(angles, 3)
    turns = [_turn(axis, a[..., i]) for i, axis in enumerate((first, second, third))]
    if fixed:
        turns.reverse()
    return multiply(multiply(turns[0], turns[1]), turns[2])


def euler_angles(wxyz, convention, last_in_lock=0.0):
    """Euler angles of a quaternion: the middle one in [0, pi] if the outer axes are equal, else in [-pi/2, pi/2].

    In gimbal lock the last angle is `last_in_lock`, and the first has the rest. NaN for a quaternion that is zero or not
    finite, and for nothing else. Bernardes and Viollet, PLoS ONE 17(11), 2022.
    """
    (first, j, third), fixed = _axes(convention)
    q = _array(wxyz, 4)
    proper, i = first == third, first if fixed else third
    k = 3 - i - j
    sign = 1 if (j - i) % 3 == 1 else -1
    w, x, y, z = q[..., 0], q[..., 1 + i], q[..., 1 + j], sign * q[..., 1 + k]
    a, b, c, d = (w, x, y, z) if proper else (w - y, x + z, w + y, z - x)
    cosine, sine, length = np.hypot(a, b), np.hypot(c, d), _norm(q)
    total, difference = 2 * np.arctan2(b, a), 2 * np.arctan2(d, c)
    gamma_sign = 1 if proper else sign
    total_alone = sine <= _LOCK * length
    lock = total_alone | (cosine <= _LOCK * length)
    alpha, gamma = (total - difference) / 2, (total + difference) / 2
    last = np.broadcast_to(np.asarray(last_in_lock, dtype=float), lock.shape)
    if fixed:
        gamma = np.where(lock, gamma_sign * last, gamma)
        alpha = np.where(lock, np.where(total_alone, total - gamma, gamma - difference), alpha)
    else:
        alpha = np.where(lock, last, alpha)
        gamma = np.where(lock, np.where(total_alone, total - alpha, difference + alpha), gamma)
    beta = 2 * np.arctan2(sine, cosine) - (0 if proper else np.pi / 2)
    alpha, gamma = _wrap(alpha), _wrap(gamma_sign * gamma)
    angles = np.stack([alpha, beta, gamma] if fixed else [gamma, beta, alpha], axis=-1)
    valid = np.isfinite(length) & (length > 0)
    return EulerAngles(np.where(valid[..., None], angles, np.nan), lock & valid)


def other_euler_angles(angles, convention):
    """The second set of Euler angles of the same orientation: the outer ones half a turn on."""
    (first, _, third), _ = _axes(convention)
    a = _array(angles, 3)
    middle = -a[..., 1] if first == third else np.pi - a[..., 1]
    return _wrap(np.stack([a[..., 0] + np.pi, middle, a[..., 2] + np.pi], axis=-1))


def euler_rate_matrix(angles, convention):
    """E with angular velocity in the fixed frame = E * (rates of the Euler angles)."""
    (first, second, third), fixed = _axes(convention)
    a = _array(angles, 3)
    outer, inner = (third, first) if fixed else (first, third)
    before = matrix(_turn(outer, a[..., 2 if fixed else 0]))
    both = before @ matrix(_turn(second, a[..., 1]))
    columns = [np.broadcast_to(np.eye(3)[outer], a.shape), before[..., second], both[..., inner]]
    return np.stack(columns[::-1] if fixed else columns, axis=-1)


def euler_rate_inverse(angles, convention):
    """Inverse of `euler_rate_matrix`; singular, and zero, in gimbal lock."""
    e = euler_rate_matrix(angles, convention)
    x, y, z = e[..., 0], e[..., 1], e[..., 2]
    determinant = np.sum(x * np.cross(y, z), axis=-1)
    singular = np.abs(determinant) <= 2 * _LOCK
    rows = np.stack([np.cross(y, z), np.cross(z, x), np.cross(x, y)], axis=-2)
    divided = rows / np.where(singular, 1, determinant)[..., None, None]
    return Rates(np.where(singular[..., None, None], 0, divided), singular)


def rotation_vector_rate_inverse(vector):
    """Matrix E^-1 with (rates of the rotation vector) = E^-1 * angular velocity in the fixed frame; singular, and zero, at
    whole turns other than none."""
    v = _array(vector, 3)
    angle = _norm(v)
    half = angle / 2
    sine = np.sin(half)
    singular = (angle > 1) & (np.abs(sine) <= _LOCK * half)
    divided = 1 - half * np.cos(half) / np.where((angle < 1e-3) | singular, 1, sine)
    factor = np.where(angle < 1e-3, 1 / 12 + angle * angle / 720, divided / np.where(angle < 1e-3, 1, angle * angle))
    cross = -np.cross(v[..., None, :], np.eye(3))
    inverse = np.eye(3) - cross / 2 + factor[..., None, None] * (cross @ cross)
    return Rates(np.where(singular[..., None, None], 0, inverse), singular)


def analytical_jacobian(geometric, angles, convention=None):
    """Jacobian of position and Euler angles of the one in the world frame (6, dof), linear rows first; singular: its
    angular rows are zero. Without a convention `angles` is a rotation vector."""
    j = np.asarray(geometric, dtype=float)
    rates = rotation_vector_rate_inverse(angles) if convention is None else euler_rate_inverse(angles, convention)
    return Rates(np.concatenate([j[..., :3, :], rates.matrix @ j[..., 3:, :]], axis=-2), rates.singular)


def nearest_rotation(given):
    """Unit quaternion of the nearest rotation to a quaternion (..., 4) or a matrix (..., 3, 3).

    Raises ValueError if there is none: zero, not finite, or a matrix of too low rank.
    """
    array = np.asarray(given, dtype=float)
    if not np.isfinite(array).all():
        raise ValueError("a number of the orientation is NaN or infinite")
    if array.shape[-2:] != (3, 3):
        q = _array(array, 4)
        largest = np.max(np.abs(q), axis=-1, keepdims=True)
        if not (largest > 0).all():
            raise ValueError("all numbers of the orientation are zero")
        return q / largest / _norm(q / largest)[..., None]
    u, values, v = np.linalg.svd(array)
    sign = np.where(np.linalg.det(u @ v) < 0, -1.0, 1.0)
    if not (values[..., 1] + sign * values[..., 2] > _LOCK * values[..., 0]).all():
        raise ValueError("the matrix has no unique nearest rotation")
    u = u.copy()
    u[..., 2] *= sign[..., None]
    return from_matrix(u @ v)
