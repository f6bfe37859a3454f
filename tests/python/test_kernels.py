# SPDX-License-Identifier: MIT
"""Kernels for devices give the numbers of the robot's C: those of CUDA, whose threads are a loop here, bit by bit; those of OpenCL on
a device of pyopencl, to rounding, where one is installed (pip install "pyopencl[pocl]")."""

import ctypes
import os
import pathlib
import subprocess

import numpy as np
import pytest

import qvgen
from qvgen import _tables, _tool

COUNT = 40

STAND_INS = """#include <cstddef>
#define __device__
#define __global__
struct Place { std::size_t x; };
static Place blockIdx, blockDim, threadIdx;
extern "C" void go_to(std::size_t thread) { threadIdx.x = thread; }
"""


@pytest.fixture(scope="module", params=["ns", pathlib.Path(__file__).resolve().parents[1] / "c/robots/urdf_arm.urdf"], ids=["ns", "urdf"])
def description(request):
    return request.param


@pytest.fixture(scope="module")
def robot(description):
    return qvgen.robots.ns if description == "ns" else qvgen.load(description)


def text_of(description, robot, language, folder, *options):
    subprocess.run([str(_tool.tool()), "generate", str(description), "--language", language, "--output", str(folder), "--quiet",
                    *options], check=True)
    ending = {"opencl": "cl", "cuda": "cu"}[language]
    return folder / language / f"qvgen_{robot.__name__}.{ending}"


class Case:
    """One kernel: arrays as it takes them, and what the C gives."""

    def __init__(self, robot, name, entry, random):
        arguments, _, _, dynamics = entry
        sizes = {"q": robot.dof, "qd": robot.dof, "qdd": robot.dof, "torque": robot.dof, "point": 3, "fall": 3, "wrench": 6}
        self.name = f"{robot.__name__}_{name}_batch"
        rows = {each: random.uniform(-1.4, 1.4, (COUNT, sizes[each])) for each in arguments.split()}
        constants = {"geometry": {key: random.uniform(0.2, 1) for key in robot.default_geometry}}
        if dynamics:
            constants["inertia"] = {key: random.uniform(0.2, 1) for key in robot.default_inertia}
        gravity = {"gravity": 3.7} if name in _tables.WITH_GRAVITY else {}
        wanted = getattr(robot, name)(*rows.values(), **constants, **gravity)
        wanted = wanted if isinstance(wanted, np.ndarray) else np.concatenate([each.reshape(COUNT, -1) for each in wanted], axis=1)
        self.wanted = wanted.reshape(COUNT, -1)
        behind = [rows.pop(each) for each in _tables.AFTER_INERTIA if each in rows]
        self.given = [*rows.values(), *(each for each in constants.values() if each), *gravity.values(), *behind]

    def call(self, array_of, struct_of, number_of):
        """The kernel's arguments behind the count, but for the result."""
        kinds = {np.ndarray: lambda each: array_of(np.ascontiguousarray(each.T)), dict: lambda each: struct_of(list(each.values())),
                 float: number_of}
        return [kinds[type(each)](each) for each in self.given]


def cases(robot):
    random = np.random.default_rng(11)
    names = [name for name, place in robot.functions.items() if place == "here" and _tables.entry_of(name)]
    found = [Case(robot, name, _tables.entry_of(name), random) for name in names]
    return [each for each in found if each.wanted.size]


def on_the_host(description, robot, folder, *options):
    """The kernels of CUDA as a library of C++, whose threads go_to sets."""
    source = folder / "host.cpp"
    source.write_text(STAND_INS + text_of(description, robot, "cuda", folder, *options).read_text())
    level = "-O1" if os.environ.get("QVGEN_PYTHON_ROBOTS") else "-O0"  # bits do not depend on it
    options = ["-std=c++17", level, "-fPIC", "-shared", "-ffp-contract=off", "-fno-math-errno", "-Wno-unused-function"]
    subprocess.run(["c++", *options, "-Wall", "-Werror", str(source), "-o", str(folder / "host.so")], check=True)
    return ctypes.CDLL(str(folder / "host.so"))


def struct_of(values, number=ctypes.c_double):
    class Constants(ctypes.Structure):
        _fields_ = [(f"x{i}", number) for i in range(len(values))]
    return Constants(*values)


def test_cuda_on_the_host(description, robot, tmp_path):
    check_on_the_host(description, robot, "double", tmp_path)


def test_cuda_in_float_on_the_host(tmp_path):
    check_on_the_host("ns", qvgen.robots.ns, "float", tmp_path)


def check_on_the_host(description, robot, scalar, tmp_path):
    """In double bit by bit; in float to its rounding."""
    library = on_the_host(description, robot, tmp_path, "--scalar", scalar)
    number, kind = (ctypes.c_double, np.float64) if scalar == "double" else (ctypes.c_float, np.float32)
    every = cases(robot)
    assert len(every) > 15
    for case in every:
        got = np.full((case.wanted.shape[1], COUNT), np.nan, kind)
        kept = []

        def array_of(array, kept=kept):
            kept.append(array.astype(kind))
            return ctypes.c_void_p(kept[-1].ctypes.data)

        arguments = case.call(array_of, lambda values: struct_of(values, number), number)
        for thread in range(COUNT + 3):  # those behind the last configuration do nothing
            library.go_to(ctypes.c_size_t(thread))
            getattr(library, case.name)(ctypes.c_size_t(COUNT), *arguments, ctypes.c_void_p(got.ctypes.data))
        if scalar == "double":
            np.testing.assert_array_equal(got.T, case.wanted, err_msg=case.name)
        else:
            np.testing.assert_allclose(got.T, case.wanted, atol=1e-5 * max(1, np.abs(case.wanted).max()), rtol=1e-3, err_msg=case.name)


class Poses:
    """Poses for the kernel of inverse kinematics: random ones, singular ones, ones out of reach, ones with NaN."""

    def __init__(self, robot):
        random = np.random.default_rng(5)
        turns = random.choice([0, np.pi / 2, np.pi], (8, robot.dof))
        q = np.concatenate([random.uniform(-1.5, 1.5, (60, robot.dof)), turns, turns[:4] + 1e-9])
        self.poses = robot.forward_kinematics(q)
        self.poses[:4, 4] += 3
        self.far_away = qvgen.Status.unreachable if all(robot.is_revolute) else qvgen.Status.solved
        self.poses[4, 5], self.poses[5, 0] = np.nan, np.nan
        self.poses[6, :4] *= 1.1  # no rotation
        self.capacity, self.dof = robot.inverse_kinematics(self.poses[0]).q.shape
        self.wanted = robot.inverse_kinematics(self.poses)
        self.results = [np.full((self.capacity * self.dof, len(q)), 7.0), np.full((self.capacity, len(q)), 7, np.int32),
                        np.full(len(q), 7, np.int32), np.full(len(q), 7, np.int32)]
        self.given = [np.ascontiguousarray(self.poses[:, :4].T), np.ascontiguousarray(self.poses[:, 4:].T)]

    def compare(self, **tolerances):
        """Rows, branches and statuses are those of C, but of poses that are doubtful."""
        q, branch, count, status = self.results
        sure = status != 5
        kinds = self.wanted.status
        assert sure[7:60].mean() > 0.95 and (kinds[:4] == self.far_away).all() and (sure[:4].all() or self.dof < 6)
        assert (kinds[4:7] == qvgen.Status.invalid).all() and ((kinds == qvgen.Status.singular).any() or self.dof < 6)
        assert not sure[(kinds == qvgen.Status.singular) | (kinds == qvgen.Status.invalid)].any()
        np.testing.assert_array_equal(status[sure], self.wanted.status[sure])
        np.testing.assert_array_equal(count, np.where(sure, self.wanted.count, 0))
        np.testing.assert_array_equal(branch.T[sure], self.wanted.branch[sure])
        rows = np.moveaxis(q.reshape(self.capacity, self.dof, -1), -1, 0)
        np.testing.assert_allclose(rows[sure], self.wanted.q[sure], **tolerances)
        assert np.isnan(rows[~sure]).all() and (branch.T[~sure] == -1).all()


SOLVED = ("--only", "kinematics,inverse")


@pytest.fixture(params=["ns", "planar_3r", *(["puma560"] if os.environ.get("QVGEN_PYTHON_ROBOTS") else [])])
def solved(request):
    """Robots with all solutions of a pose: one whose slide reaches far away, one of three joints, one that turns alone."""
    return getattr(qvgen.robots, request.param)


def test_all_solutions_of_cuda_on_the_host(solved, tmp_path):
    library, case = on_the_host(solved.__name__, solved, tmp_path, *SOLVED), Poses(solved)
    kernel = getattr(library, f"{solved.__name__}_inverse_kinematics_batch")
    pointers = [ctypes.c_void_p(each.ctypes.data) for each in [*case.given, *case.results]]
    constants = [struct_of(list(solved.default_geometry.values()))] if solved.default_geometry else []
    constants.append(ctypes.c_double(1e-13))
    for thread in range(len(case.poses) + 3):
        library.go_to(ctypes.c_size_t(thread))
        kernel(ctypes.c_size_t(len(case.poses)), *pointers[:2], *constants, *pointers[2:])
    case.compare(rtol=0, atol=0)


def context_of(cl):
    """A context with a device that has double and compiles; skips the test where there is none."""
    try:
        devices = [device for platform in cl.get_platforms() for device in platform.get_devices() if device.double_fp_config]
        context = cl.Context(devices[:1])
        cl.Program(context, "__kernel void f(__global double* x) { x[0] = 1; }").build()
    except (cl.Error, IndexError) as error:
        pytest.skip(f"there is no device of OpenCL that compiles kernels in double (Debian: pocl-opencl-icd): {error}"[:200])
    return context


def test_opencl(description, robot, tmp_path):
    cl = pytest.importorskip("pyopencl")
    context = context_of(cl)
    queue = cl.CommandQueue(context)
    program = cl.Program(context, text_of(description, robot, "opencl", tmp_path).read_text()).build()
    flags = cl.mem_flags.READ_ONLY | cl.mem_flags.COPY_HOST_PTR
    for case in cases(robot):
        result = cl.Buffer(context, cl.mem_flags.WRITE_ONLY, case.wanted.nbytes)
        arguments = case.call(lambda array: cl.Buffer(context, flags, hostbuf=array), lambda values: np.array(values).tobytes(), np.float64)
        getattr(program, case.name)(queue, (COUNT + 24,), None, np.uint64(COUNT), *arguments, result)
        got = np.empty(case.wanted.shape[::-1])
        cl.enqueue_copy(queue, got, result)
        size = max(1, np.abs(case.wanted).max())
        np.testing.assert_allclose(got.T, case.wanted, atol=1e-13 * size, rtol=1e-11, err_msg=case.name)


def test_all_solutions_of_opencl(solved, tmp_path):
    cl = pytest.importorskip("pyopencl")
    context, case = context_of(cl), Poses(solved)
    queue = cl.CommandQueue(context)
    program = cl.Program(context, text_of(solved.__name__, solved, "opencl", tmp_path, *SOLVED).read_text()).build()
    flags = cl.mem_flags.READ_WRITE | cl.mem_flags.COPY_HOST_PTR
    given, results = ([cl.Buffer(context, flags, hostbuf=each) for each in arrays] for arrays in (case.given, case.results))
    count = len(case.poses)
    kernel = getattr(program, f"{solved.__name__}_inverse_kinematics_batch")
    constants = [np.array(list(solved.default_geometry.values())).tobytes()] if solved.default_geometry else []
    kernel(queue, (count + 24,), None, np.uint64(count), *given, *constants, np.float64(1e-13), *results)
    for array, buffer in zip(case.results, results):
        cl.enqueue_copy(queue, array, buffer)
    case.compare(rtol=0, atol=1e-11)


def test_what_the_readme_shows(tmp_path, monkeypatch):
    cl = pytest.importorskip("pyopencl")
    context_of(cl)
    lines = (pathlib.Path(__file__).resolve().parents[2] / "runtime/docs/devices.md").read_text().splitlines()
    begin = next(place for place, line in enumerate(lines) if line.startswith("    import numpy as np, pyopencl"))
    end = next(place for place in range(begin, len(lines)) if not lines[place])
    subprocess.run([str(_tool.tool()), "generate", "puma560", "--only", "kinematics", "--language", "opencl", "--output",
                    str(tmp_path / "out"), "--quiet"], check=True)
    monkeypatch.chdir(tmp_path)
    space = {}
    exec("\n".join(line[4:] for line in lines[begin:end]), space)
    wanted = qvgen.robots.puma560.forward_kinematics(space["q"].T[:100])
    np.testing.assert_allclose(space["result"].T[:100], wanted, atol=1e-13)
