# SPDX-License-Identifier: MIT
"""Hands arrays to a robot's library: one row of an argument or a batch of rows in, arrays out.

`Call` is the struct of rows.h. Libraries are called by ctypes, which lets go of the interpreter's lock.
"""

import ctypes

import numpy as np


class Call(ctypes.Structure):
    """The struct qvgen_call of rows.h."""
    _fields_ = [("count", ctypes.c_ssize_t), ("rows", ctypes.c_void_p * 5), ("steps", ctypes.c_ssize_t * 5),
                ("geometry", ctypes.c_void_p), ("inertia", ctypes.c_void_p), ("lower", ctypes.c_void_p),
                ("upper", ctypes.c_void_p), ("numbers", ctypes.c_double * 3), ("flags", ctypes.c_int * 2),
                ("capacity", ctypes.c_ssize_t), ("results", ctypes.c_void_p * 6)]


def address(array):
    """Address of an array's first number; None if there is no array."""
    return None if array is None else array.__array_interface__["data"][0]


def scalar_of(arguments):
    """float32 if all arguments are arrays of float32, else float64."""
    for each in arguments:
        if getattr(each, "dtype", None) != np.float32 or not isinstance(each, np.ndarray):
            return np.float64
    return np.float32


def numbers(given, dtype, name):
    """The argument as a C-contiguous array; of another library's arrays those on the CPU, by DLPack or as NumPy takes them."""
    try:
        if not hasattr(given, "__array__") and hasattr(given, "__dlpack__"):
            given = np.from_dlpack(given)
        return np.asarray(given, dtype=dtype, order="C")
    except (TypeError, ValueError):
        raise TypeError(f"{name}: not an array of numbers") from None


class Rows:
    """Arguments of a call, each one row of its shape or a batch of them; all batches have the same length."""

    def __init__(self, dtype):
        self.dtype = dtype
        self.batch = -1  # -1: every argument is a single row
        self.count = 0  # arguments so far
        self._kept = []  # alive until the call is over
        self.call = Call()

    def add(self, given, shape, name):
        """Takes one more argument. Returns its array."""
        array = numbers(given, self.dtype, name)
        place = self.count
        if array.shape != shape:
            if array.ndim != len(shape) + 1 or array.shape[1:] != shape:
                raise ValueError(f"{name} has the shape {array.shape}; it must be {shape}, or have a batch axis before that")
            if self.batch not in (-1, len(array)):
                raise ValueError(f"batches of {self.batch} and of {len(array)} rows")
            self.batch = len(array)
            self.call.steps[place] = array[0].size if len(array) else 0
        self.call.rows[place] = address(array)
        self.count += 1
        self._kept.append(array)
        return array

    def shape(self, *row):
        """Shape of a result whose rows have the shape `row`."""
        return row if self.batch < 0 else (self.batch, *row)

    def constants(self, place, constants, given):
        """Sets geometry or inertia: values by name, those of the description for the others."""
        array = constants.array(given, self.dtype)
        self._kept.append(array)
        setattr(self.call, place, address(array))

    def limits(self, lower, upper):
        """Sets limits, one row each."""
        self._kept += [lower, upper]
        self.call.lower, self.call.upper = address(lower), address(upper)

    def run(self, function, *results):
        """Calls a function of a library. Returns what it returns."""
        self.call.count = 1 if self.batch < 0 else self.batch
        for place, array in enumerate(results):
            self.call.results[place] = address(array)
        return function(ctypes.byref(self.call))


def result(out, shape, dtype):
    """Returns the array for a result: `out` if it is given and fits, else a new one."""
    if out is None:
        return np.empty(shape, dtype)
    if not isinstance(out, np.ndarray) or out.dtype != dtype:
        raise TypeError(f"out: not an array of {np.dtype(dtype).name}")
    if out.shape != shape or not out.flags.writeable or not out.flags.c_contiguous:
        raise ValueError(f"out must be a writeable, C-contiguous array of the shape {shape}")
    return out


class Constants:
    """Names and values of the description's constants, of its geometry or its inertias."""

    def __init__(self, what, values):
        self.what = what
        self.values = dict(values)
        self._defaults = {each: np.array(list(self.values.values()) or [0], each) for each in (np.float32, np.float64)}
        self._places = {name: place for place, name in enumerate(self.values)}

    def array(self, given, dtype):
        """Values in the struct's order, some of them from a dictionary."""
        if given is None:
            return self._defaults[dtype]
        array = self._defaults[dtype].copy()
        for name, value in dict(given).items():
            if name not in self._places:
                raise ValueError(f"{self.what} has no {name}")
            array[self._places[name]] = value
        return array


def pair_of_rows(limits, dof, dtype, owners):
    """Two rows of limits, (dof,) each; None if `limits` is no pair. `owners` says in messages for what they are the same."""
    if isinstance(limits, str) or not hasattr(limits, "__len__") or len(limits) != 2:
        return None
    rows = []
    for which, name in zip(limits, ("lower limits", "upper limits")):
        array = numbers(which, dtype, name)
        if array.shape == (dof,):
            rows.append(array)
        elif array.ndim == 2 and array.shape[1] == dof:
            raise ValueError(f"{name} are the same for all {owners}: one row")
        else:
            raise ValueError(f"{name} has the shape {array.shape}; it must be {(dof,)}, or have a batch axis before that")
    return rows
