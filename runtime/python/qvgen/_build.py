# SPDX-License-Identifier: MIT
"""Compiles a robot's module, once for each content of what it is made from."""

import collections.abc
import concurrent.futures
import difflib
import functools
import hashlib
import importlib.util
import json
import os
import pathlib
import platform
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile

from . import _paths
from ._loop_source import loop_functions, tips
from ._source import binding_source, is_bound
from ._velocity_source import FUNCTIONS as VELOCITY_FUNCTIONS

_here = pathlib.Path(__file__).resolve().parent
_root = _here / "_tree" if (_here / "_tree").exists() else _here.parents[2]  # of an installed package, or of the sources
generated_folder = _root / "generated"
_suffix = sysconfig.get_config_var("EXT_SUFFIX")


class BuildError(RuntimeError):
    """The generator or the compiler has refused; the text is what it said."""


def cache_folder():
    """Returns the folder of modules: $QVGEN_CACHE, or ~/.cache/qvgen. It may be deleted at any time."""
    default = pathlib.Path(os.environ.get("XDG_CACHE_HOME", pathlib.Path.home() / ".cache")) / "qvgen"
    return pathlib.Path(os.environ.get("QVGEN_CACHE", default))


def _run(command):
    done = subprocess.run([str(each) for each in command], capture_output=True, text=True)
    if done.returncode != 0:
        raise BuildError(f"{shlex.join(str(each) for each in command)}\n{done.stderr}{done.stdout}")


def _hash(texts):
    digest = hashlib.sha256()
    for text in texts:
        digest.update(text if isinstance(text, bytes) else str(text).encode())
        digest.update(b"\0")
    return digest.hexdigest()[:24]


# Libraries of the runtime, in the linker's order.
_LIBRARIES = ("certified", "arm_angle", "given_joint", "nearest_pose", "elimination", "inverse", "core")
_has_avx2_forms = platform.machine() in ("x86_64", "AMD64")


def _options(source):
    """As CMake compiles it: inverse kinematics without contraction, vector forms for AVX2."""
    level = "-O1" if source.name == "module.cpp" else "-O2"  # the binding only hands on
    options = ["-std=c++17", level, "-fPIC", "-fvisibility=hidden", "-fno-math-errno", "-Wno-psabi"]
    if source.name.startswith(("inverse", "assembly")) and source.parent.parent.name == "source":
        options += ["-ffp-contract=off", "-DQVGEN_NO_CONTRACTION"]
    if source.name.endswith("_avx2.cpp") and _has_avx2_forms:
        options += ["-mavx2"] if source.name.startswith(("inverse", "within")) else ["-mavx2", "-mfma"]
        if source.name.startswith(("sine", "within")):
            options += ["-ffp-contract=off"]
    if source.name in ("sine_cosine.cpp", "within.cpp") and _has_avx2_forms:
        options += ["-DQVGEN_HAS_AVX2_KERNEL"]
    return options


def _built(name):
    """A library of a build of this source tree, in one of the folders of $QVGEN_LIBRARIES."""
    folders = os.environ.get("QVGEN_LIBRARIES", "").split(":")
    return next((path for path in (pathlib.Path(each) / name for each in folders if each) if path.exists()), None)


def _pybind11():
    """Its headers where they were installed by pip; the compiler finds those of the system."""
    try:
        import pybind11
    except ImportError:
        return []
    return [pybind11.get_include()]


_PROBE = "#include <pybind11/pybind11.h>\n#include <Eigen/Core>\n"
_HEADERS = {"Python.h": "the headers of Python are missing: install python3-dev",
            "pybind11/pybind11.h": "pybind11 is missing: pip install pybind11, or install pybind11-dev",
            "Eigen/Core": "Eigen is missing: install libeigen3-dev, or set QVGEN_EIGEN to its folder"}


def _check_compiler(compiler, folders):
    """Says in a sentence what is missing on this machine, before a robot is compiled."""
    if shutil.which(compiler[0]) is None:
        raise BuildError(f"there is no compiler {compiler[0]}: install g++ or clang, or set CXX; "
                         "a wheel with compiled robots needs none (--config-settings=robots=all)")
    with tempfile.TemporaryDirectory() as work:
        probe = pathlib.Path(work) / "probe.cpp"
        probe.write_text(_PROBE)
        done = subprocess.run([*compiler, "-std=c++17", *(f"-I{each}" for each in folders), "-E", str(probe), "-o", os.devnull],
                              capture_output=True, text=True)
    if done.returncode == 0:
        return
    for header, sentence in _HEADERS.items():
        if re.search(rf"['\"< ]{re.escape(header)}['\">: ]", done.stderr):
            raise BuildError(sentence)
    raise BuildError(f"the compiler {compiler[0]} fails: {done.stderr}")


def _runtime_sources():
    sources = sorted((_root / "runtime/source").rglob("*.cpp"))
    return sources if _has_avx2_forms else [each for each in sources if each.name not in ("sine_cosine_avx2.cpp", "within_avx2.cpp")]


def _compile(robot, generated, target):
    """Compiles and links in a folder of its own; the module appears whole, or not at all."""
    sources = _binding(robot, generated)
    robot_library = _built(f"libqvgen_robot_{robot}.a") if generated == generated_folder else None
    runtime_libraries = [_built(f"libqvgen_runtime_{each}.a") for each in _LIBRARIES]
    to_compile = [] if robot_library else sorted((generated / "source" / robot).glob("*.cpp"))
    to_compile += _sources_of_tips(robot, generated)
    to_compile += [] if all(runtime_libraries) else _runtime_sources()
    folders = [generated / "include", _here, _root / "runtime/include",
               os.environ.get("QVGEN_EIGEN", "/usr/include/eigen3"), sysconfig.get_paths()["include"], *_pybind11()]
    compiler = shlex.split(os.environ.get("CXX", "c++"))
    _check_compiler(compiler, folders)
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target.parent) as work:
        work = pathlib.Path(work)
        binding = work / "module.cpp"
        binding.write_text(sources)

        def compile_(numbered):
            number, source = numbered
            made = work / f"{number}.o"
            _run([*compiler, *_options(source), *(f"-I{each}" for each in folders), "-c", source, "-o", made])
            return made

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            objects = list(pool.map(compile_, enumerate([binding, *to_compile])))
        _run([*compiler, "-shared", "-o", work / target.name, *objects,
              *([robot_library] if robot_library else []), *(runtime_libraries if all(runtime_libraries) else [])])
        os.replace(work / target.name, target)


def _functions(entry):
    """Returns the header of each function, the reason for each part that is missing, and the targets of the inverse kinematics."""
    targets = entry.get("targets", {})
    names = [name for name in entry if name not in ("missing", "targets")]
    functions = {name: "here" if is_bound(name) or name in targets else "in C++ only" for name in [*names, *targets]}
    if "arm_angle" in entry:
        functions["inverse_kinematics"] = "here"  # within limits, at any arm angle
    if {"forward_kinematics", "jacobian"} <= functions.keys():
        functions["nearest_pose"] = "here"
    if "jacobian" in functions:
        functions.update(dict.fromkeys(VELOCITY_FUNCTIONS, "here"))
    missing = {part["part"]: part["reason"] for part in entry.get("missing", [])}
    return {**functions, **missing}, targets


def _loops(robot, generated):
    """The functions of a robot's closed loops."""
    header = generated / "include/qvgen/robots" / robot / "assembly.h"
    return loop_functions(header.read_text()) if header.exists() else []


def _sources_of_tips(robot, generated):
    """Returns the sources that functions of the tips of closed loops call."""
    folders = [generated / "source" / f"{robot}_{tip}" for tip in tips(_loops(robot, generated))]
    return [folder / name for folder in folders for name in ("jacobian.cpp", "kinematics.cpp")]


def _binding(robot, generated):
    counts = json.loads((generated / "operation_counts.json").read_text())
    if robot not in counts:
        raise AttributeError(f"there is no robot {robot}; there are {', '.join(counts)}")
    functions, targets = _functions(counts[robot])
    loops = _loops(robot, generated)
    return binding_source(robot, {**functions, **dict.fromkeys(loops, "here")}, targets, loops)


def module_file(robot, generated):
    """Returns the path of the module, by the content of all that it is made from; compiles it if it is not there."""
    made_of = [*(generated / "source" / robot).glob("*"), *(generated / "include/qvgen/robots" / robot).glob("*"),
               *_sources_of_tips(robot, generated),
               *_here.glob("*.h"), *(_root / "runtime/include").rglob("*.h"),
               *(_root / "runtime/source").rglob("*.h"), *_runtime_sources()]
    key = _hash([_binding(robot, generated), sys.version, os.environ.get("CXX"),
                 *(path.read_bytes() for path in sorted(made_of))])
    target = cache_folder() / f"{robot}-{key}" / (robot + _suffix)
    if not target.exists():
        _compile(robot, generated, target)
    return target


def _explain_absence(module):
    """Lets AttributeError say why a function is not there, and which ones come near."""
    def absent(name):
        if name.startswith("_"):
            raise AttributeError(f"{module.__name__} has no {name}")
        here = [function for function, place in module.functions.items() if place == "here"]
        near = [function for function in here if function.startswith(name)]
        near = near or difflib.get_close_matches(name, here, cutoff=0.8)
        reasons = [f"no {part}: {reason}" for part, reason in module.functions.items()
                   if reason not in ("here", "in C++ only")]
        known = module.functions.get(name)
        if known:
            raise AttributeError(f"{module.__name__} has no {name}: {known}")
        hints = [f"it has {', '.join(near)}"] if near else reasons
        text = f"{module.__name__} has no {name}"
        raise AttributeError("; ".join([text, *hints]))
    module.__getattr__ = absent


def build_module(robot, generated=generated_folder, source=None):
    """The module of a robot whose generated code is in a folder: the installed one, or from the cache.

    `source`: the description and how it is read, for `paths`; by default the robot's name. False: it has no description.
    """
    generated = pathlib.Path(generated)
    installed = _here / "robots" / (robot + _suffix)
    own = generated == generated_folder and installed.exists()
    spec = importlib.util.spec_from_file_location(robot, installed if own else module_file(robot, generated))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    _explain_absence(module)
    if source is not False:
        module.paths = _bound_paths(module, source or (robot,))
    return module


def _bound_paths(robot, source):
    @functools.wraps(_paths.paths)
    def paths(poses, **options):
        return _paths.paths(source, robot, poses, **options)
    return paths


class Limbs(collections.abc.Mapping):
    """The modules of a robot's limbs by the names of their tips, compiled when they are asked for."""

    def __init__(self, robot, limbs, folder):
        self._names = {name[len(robot) + 1:]: name for name in limbs}
        self._folder = folder
        self._modules = {}

    def __getitem__(self, tip):
        name = self._names[tip]
        if tip not in self._modules:
            self._modules[tip] = build_module(name, self._folder, False)
        return self._modules[tip]

    def __iter__(self):
        return iter(self._names)

    def __len__(self):
        return len(self._names)


def _tool():
    """Path of the tool: QVGEN_TOOL, that of the source tree, or one on the path."""
    known = _root / "build/release/generator/cli/qvgen"
    tool = os.environ.get("QVGEN_TOOL") or (known if known.exists() else shutil.which("qvgen"))
    if tool is None:
        raise BuildError("there is no tool qvgen: run ./qvgen generate once, or set QVGEN_TOOL")
    return tool


def report_of(command, inputs, output, options):
    """Runs `qvgen calibrate` or `qvgen identify`; returns its report."""
    written = [] if output is None else ["-o", str(output)]
    done = subprocess.run([str(_tool()), command, *map(str, inputs), *written, *map(str, options)],
                          capture_output=True, text=True)
    if done.returncode != 0:
        raise BuildError(done.stderr)
    return done.stdout


def generate(description, options):
    """Generates the code of a description into the cache; returns the names of the robot and of its limbs, and the folder."""
    description = pathlib.Path(description).resolve()
    folder = cache_folder() / ("generated-" + _hash([description, *options]))
    _run([_tool(), "generate", description, "--output", folder, *options])
    counts = json.loads((folder / "operation_counts.json").read_text())
    robot = min(counts, key=len)  # limbs are called after it
    return robot, [name for name in counts if name != robot], folder
