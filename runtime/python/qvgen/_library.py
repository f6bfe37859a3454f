# SPDX-License-Identifier: MIT
"""Compiles sources of a robot into a shared library, once for each content of what it is made from."""

import concurrent.futures
import hashlib
import importlib.util
import os
import pathlib
import platform
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE / "_tree" if (HERE / "_tree").exists() else HERE.parents[2]  # of an installed package, or of the sources


class BuildError(RuntimeError):
    """The generator or the compiler has refused; the text is what it said."""


def cache_folder():
    """Returns the folder of libraries: $QVGEN_CACHE, or ~/.cache/qvgen. It may be deleted at any time."""
    default = pathlib.Path(os.environ.get("XDG_CACHE_HOME", pathlib.Path.home() / ".cache")) / "qvgen"
    return pathlib.Path(os.environ.get("QVGEN_CACHE", default))


def run(command, **more):
    """Runs a program; BuildError has what it says if it fails."""
    done = subprocess.run([str(each) for each in command], capture_output=True, text=True, **more)
    if done.returncode != 0:
        raise BuildError(f"{shlex.join(str(each) for each in command)}\n{done.stderr}{done.stdout}")
    return done.stdout


def hash_of(texts):
    """A name for what has this content."""
    digest = hashlib.sha256()
    for text in texts:
        digest.update(text if isinstance(text, bytes) else str(text).encode())
        digest.update(b"\0")
    return digest.hexdigest()[:24]


def compiler(variable, usual):
    """The command of a compiler: that of CC or CXX, the system's, or the one that `pip install ziglang` brings."""
    if os.environ.get(variable):
        return shlex.split(os.environ[variable])
    if shutil.which(usual):
        return [usual]
    if importlib.util.find_spec("ziglang"):
        return [sys.executable, "-m", "ziglang", {"CC": "cc", "CXX": "c++"}[variable]]
    return [usual]


def own_options(variable):
    """Options of CFLAGS or CXXFLAGS, which stand behind those that every robot has."""
    return shlex.split(os.environ.get(variable, ""))


def check(command):
    """Says in a sentence that there is no compiler."""
    if shutil.which(command[0]) is None:
        raise BuildError(f"there is no compiler {command[0]}: pip install qvgen[compiler] brings one, or install gcc or clang, or "
                         "set CC (CXX for C++); a wheel with compiled robots needs none (--config-settings=robots=all)")


def check_eigen(command, folders):
    """Says in a sentence that Eigen is missing, or that the compiler fails, before a robot is compiled in C++."""
    check(command)
    with tempfile.TemporaryDirectory() as work:
        probe = pathlib.Path(work) / "probe.cpp"
        probe.write_text("#include <Eigen/Core>\n")
        done = subprocess.run([*command, "-std=c++17", *(f"-I{each}" for each in folders), "-E", str(probe), "-o", os.devnull],
                              capture_output=True, text=True)
    if done.returncode == 0:
        return
    if re.search(r"['\"< ]Eigen/Core['\">: ]", done.stderr):
        raise BuildError("Eigen is missing, which this function needs, as it is in C++ only: install libeigen3-dev, or set "
                         "QVGEN_EIGEN to its folder")
    raise BuildError(f"the compiler {command[0]} fails: {done.stderr}")


def linked(target, command, jobs, more=()):
    """Compiles (source, options) side by side and links them; the library appears whole, or not at all."""
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target.parent) as work:
        work = pathlib.Path(work)

        def compile_(numbered):
            number, (source, options) = numbered
            made = work / f"{number}.o"
            if isinstance(source, tuple):  # a name and a text
                name, text = source
                source = work / name
                source.write_text(text)
            run([*command, *options, "-c", source, "-o", made])
            return made

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            objects = list(pool.map(compile_, enumerate(jobs)))
        # Optimised, without symbols: the compiler that pip brings builds libraries of its own here, in a sixth of the time.
        run([*command, "-O2", "-s", "-shared", "-o", work / target.name, *objects, *more])
        os.replace(work / target.name, target)


C_OPTIONS = ["-std=c99", "-O2", "-fPIC", "-ffp-contract=off", "-fno-math-errno"]


def c_library(robot, sources, rows):
    """Path of the library of a robot's C files and of the text of its loops."""
    command, own = compiler("CC", "cc"), own_options("CFLAGS")
    headers = sorted({*(HERE.glob("*.h")), *(source.with_suffix(".h") for source in sources)})
    key = hash_of([rows, *command, *own, *(each.read_bytes() for each in [*sources, *headers])])
    target = cache_folder() / f"{robot}-{key}" / f"{robot}.so"
    if not target.exists():
        check(command)
        options = [*C_OPTIONS, *own, f"-I{sources[0].parent}", f"-I{HERE}"]
        linked(target, command, [(("rows.c", rows), options), *((source, options) for source in sources)], ["-lm"])
    return target


# Libraries of the C++ runtime, in the linker's order.
_LIBRARIES = ("certified", "arm_angle", "given_joint", "nearest_pose", "elimination", "inverse", "core")
_has_avx2_forms = platform.machine() in ("x86_64", "AMD64")


def _cxx_options(source):
    """As CMake compiles it: inverse kinematics without contraction, vector forms for AVX2."""
    options = ["-std=c++17", "-O2", "-fPIC", "-fvisibility=hidden", "-fno-math-errno", "-Wno-psabi"]
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


def _runtime_sources():
    sources = sorted((ROOT / "runtime/source").rglob("*.cpp"))
    return sources if _has_avx2_forms else [each for each in sources if each.name not in ("sine_cosine_avx2.cpp", "within_avx2.cpp")]


def _together(jobs):
    """Joins files that have the same options into as many units as there are processors, since each unit reads Eigen."""
    alike = {}
    for source, options in jobs:
        alike.setdefault(tuple(options), []).append(source)
    units = []
    for options, sources in alike.items():
        count = min(len(sources), os.cpu_count() or 1)
        for k in range(count):
            text = "".join(f'#include "{source.as_posix()}"\n' for source in sources[k::count])
            units.append(((f"unit_{len(units)}.cpp", text), list(options)))
    return units


def cxx_library(robot, generated, rows, is_own, tips=None):
    """Path of the library of a robot's C++ and of the text of its loops over rows.

    `is_own`: one of this source tree's robots. `tips`: limbs that its closed loops call, with the parts of each.
    """
    command, options = compiler("CXX", "c++"), own_options("CXXFLAGS")
    own = sorted((generated / "source" / robot).glob("*.cpp"))
    limbs = [generated / "source" / tip / f"{part}.cpp" for tip, parts in (tips or {}).items() for part in parts]
    own += [source for source in limbs if source.exists()]  # lanes are there for some
    made_of = [*own, *(generated / "include/qvgen/robots" / robot).glob("*"), *HERE.glob("*.h"),
               *(ROOT / "runtime/include").rglob("*.h"), *(ROOT / "runtime/source").rglob("*.h"), *_runtime_sources()]
    key = hash_of([rows, *command, *options, *(path.read_bytes() for path in sorted(made_of))])
    target = cache_folder() / f"{robot}-{key}" / f"{robot}_cxx.so"
    if target.exists():
        return target
    folders = [generated / "include", HERE, ROOT / "runtime/include", os.environ.get("QVGEN_EIGEN", "/usr/include/eigen3")]
    check_eigen(command, folders)
    robot_library = _built(f"libqvgen_robot_{robot}.a") if is_own else None
    libraries = [_built(f"libqvgen_runtime_{each}.a") for each in _LIBRARIES]
    options += [f"-I{each}" for each in folders]
    jobs = [(("rows.cpp", rows), ["-std=c++17", "-O1", "-fPIC", "-fvisibility=hidden", "-Wno-psabi", *options])]
    if not robot_library:
        jobs += _together([(source, [*_cxx_options(source), *options]) for source in own])
    if not all(libraries):
        jobs += [(source, [*_cxx_options(source), *options]) for source in _runtime_sources()]
    linked(target, command, jobs, [*([robot_library] if robot_library else []), *(libraries if all(libraries) else [])])
    return target
