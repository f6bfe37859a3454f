#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Generated dynamics of an arm, a quadruped and a humanoid against Pinocchio's loops and CasADi's C of Pinocchio.

    ./qvgen benchmark trees [ROBOT...]     # pip install pin casadi example-robot-data, else it says so and exits with 77
    QVGEN_LOOPS=0 ./qvgen benchmark trees  # without Pinocchio's own loops, whose headers take minutes and 5 GB to compile
    measure.py TOOL FOLDER [ROBOT...]

All are compiled with the same flags, run in one program, must agree to 1e-8, and are counted by valgrind.
"""
import concurrent.futures
import importlib.metadata
import os
import pathlib
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
# valgrind knows no wider vectors.
FLAGS = ["-O3", "-march=x86-64-v3", "-DNDEBUG"]
# As Pinocchio's own files for CMake have it.
OF_PINOCCHIO = ["-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
                "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS", "-DBOOST_FUSION_INVOKE_MAX_ARITY=12"]
# Pinocchio's headers take 5 GB and minutes to compile.
WITH_LOOPS = os.environ.get("QVGEN_LOOPS", "1") != "0"
LIBRARIES = ("qvgen", "CasADi") + (("Pinocchio",) if WITH_LOOPS else ())
NAMES = ("ID", "M", "FD", "dID", "dFD")
GRIPPERS = ("gripper_left_joint", "gripper_right_joint")


def prefix():
    """Folder in which PyPI's packages of Pinocchio have their headers, and the public models."""
    import pinocchio
    return next(p for p in pathlib.Path(pinocchio.__file__).parents if (p / "include/pinocchio").exists())


def robots():
    """Name: (description, base floats, joints held)."""
    public = prefix() / "share/example-robot-data/robots"
    return {
        "iiwa14": (ROOT / "generator/robots/iiwa14.toml", False, ()),
        "go1": (public / "go1_description/urdf/go1.urdf", True, ()),
        "talos": (public / "talos_data/robots/talos_reduced.urdf", True, GRIPPERS),
    }


class Cost:
    """Seconds and megabytes of a command."""

    def __init__(self, *command):
        start = time.monotonic()
        child = subprocess.Popen([str(part) for part in command], stdout=subprocess.DEVNULL)
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode:
            sys.exit(f"failed: {' '.join(map(str, command))}")
        self.seconds, self.megabytes = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
        self.wall = time.monotonic() - start


def without_friction(urdf, folder):
    """A copy of the URDF without what the joints' drives take: the other libraries leave it out."""
    copy = folder / urdf.name
    copy.write_text(re.sub(r"<dynamics[^>]*/>", "", urdf.read_text()))
    return copy


def generate(tool, name, file, floating, fixed, folder):
    command = [tool, "generate", file, "--only", "dynamics,dynamics_derivatives", "--output", folder, "--quiet"]
    # Angles that are rounded at the fourth decimal stay so: the other libraries read them as they stand.
    command += ["--name", name, "--snap", "1e-9"] if file.suffix != ".toml" else []
    command += ["--floating"] if floating else []
    command += ["--fixed", ",".join(fixed)] if fixed else []
    return Cost(*command)


def compiled(source, made, *options):
    """Cost of an object, made by way of assembly: of two encodings of vmovq valgrind knows one."""
    assembly = made.with_suffix(".s")
    cost = Cost("g++", "-std=c++17", *FLAGS, *options, "-S", source, "-o", assembly)
    assembly.write_text(re.sub(r"\bvmovq(?=\s+%xmm\d+, %xmm)", "{load} vmovq", assembly.read_text()))
    cost.seconds += Cost("g++", "-c", assembly, "-o", made).seconds
    return cost


def compile_all(name, floating, folder):
    """Objects of everything, and what the compilation of generated code took: (qvgen's, CasADi's)."""
    include = ["-I", folder / "include", "-I", ROOT / "runtime/include", "-isystem", "/usr/include/eigen3"]
    defines = [f"-DQVGEN_ROBOT={name}", f"-DQVGEN_FLOATING={int(floating)}",
               f"-DQVGEN_DYNAMICS=<qvgen/robots/{name}/dynamics.h>",
               f"-DQVGEN_DERIVATIVES=<qvgen/robots/{name}/dynamics_derivatives.h>"]
    sources = sorted((folder / "source" / name).glob("dynamics*.cpp"))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        theirs = [pool.submit(Cost, "gcc", *FLAGS, "-c", folder / "peer.c", "-o", folder / "peer.o")]
        ours = [pool.submit(compiled, s, folder / (s.stem + ".o"), *include) for s in sources]
        pool.submit(Cost, "g++", "-std=c++17", *FLAGS, *include, *defines, "-c", HERE / "qvgen.cpp", "-o", folder / "of_qvgen.o").result()
        ours, theirs = [job.result() for job in ours], [job.result() for job in theirs]
    objects = [folder / (s.stem + ".o") for s in sources] + [folder / "of_qvgen.o", folder / "peer.o"]
    Cost("g++", *objects, *harness(folder.parent), "-lm", "-o", folder / "measure")
    return ours, theirs


def is_older(program, *sources):
    return not program.exists() or program.stat().st_mtime < max(s.stat().st_mtime for s in sources)


def harness(folder):
    """Objects that all robots have in common; Pinocchio's headers are compiled for minutes."""
    objects = [folder / "sine_cosine.o"]
    if is_older(objects[0], ROOT / "runtime/source/core/sine_cosine.cpp"):
        Cost("g++", "-std=c++17", *FLAGS, "-I", ROOT / "runtime/include", "-isystem", "/usr/include/eigen3", "-c",
             ROOT / "runtime/source/core/sine_cosine.cpp", "-o", objects[0])
    for name in ("main", "casadi") + (("pinocchio",) if WITH_LOOPS else ()):
        source, made = HERE / f"{name}.cpp", folder / f"{name}_{len(LIBRARIES)}.o"
        if is_older(made, source, HERE / "implementation.h", HERE / "model.h"):
            Cost("g++", "-std=c++17", *FLAGS, f"-DQVGEN_WITH_LOOPS={int(WITH_LOOPS)}", *OF_PINOCCHIO, "-isystem", "/usr/include/eigen3",
                 "-isystem", prefix() / "include", "-c", source, "-o", made)
        objects.append(made)
    return objects


def instructions(program, library, name):
    """Instructions a call; not a number where valgrind does not know one of them."""
    def counted(calls):
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *program, str(library), name, str(calls)]
        done = subprocess.run(command, check=False, capture_output=True, text=True)
        if done.returncode:
            return float("nan")
        return int(re.search(r"Collected : (\d+)", done.stderr).group(1))
    return (counted(96) - counted(32)) / 64


def table(title, unit, rows):
    """Rows of (name, numbers of the libraries) with their ratios to qvgen's."""
    print(f"\n{title}, {unit}".ljust(29) + "".join(f"{library:>12}" for library in LIBRARIES) + "     ratios")
    for name, (ours, *others) in rows:
        print(f"  {name:26}{ours:12.0f}" + "".join(f"{x:12.0f}" for x in others) + "   " +
              "".join(f"{x / ours:6.1f}x" for x in others))


def casadi_writer(folder):
    """A program that writes CasADi's C: PyPI's Pinocchio has CasADi in its headers, not in Python."""
    import casadi
    of_casadi = pathlib.Path(casadi.__file__).parent
    program, source = folder / "write_casadi", HERE / "write_casadi.cpp"
    if is_older(program, source, HERE / "model.h"):
        Cost("g++", "-std=c++17", "-O0", *OF_PINOCCHIO, "-isystem", "/usr/include/eigen3", "-isystem", prefix() / "include", "-isystem",
             of_casadi / "include", source, f"-L{of_casadi}", f"-Wl,-rpath,{of_casadi}", "-lcasadi", "-o", program)
    return program


def kilobytes(files):
    return sum(f.stat().st_size for f in files) / 1000


def measure(tool, writer, folder, name, file, floating, fixed):
    import peers
    folder.mkdir(parents=True, exist_ok=True)
    if file.suffix != ".toml":
        file = without_friction(file, folder)
    made = generate(tool, name, file, floating, fixed, folder)
    model = peers.of_toml(file) if file.suffix == ".toml" else peers.of_urdf(file, floating, fixed)
    peers.write_model(model, folder / "model")
    Cost(writer, folder / "model", folder)
    peers.write_states(model, folder / "states")
    ours, theirs = compile_all(name, floating, folder)
    program = [folder / "measure", folder / "states", folder / "model"]
    lines = subprocess.run(program, check=True, capture_output=True, text=True).stdout.split("\n")
    times = {words[0]: [float(x) for x in words[1:]] for words in map(str.split, lines) if words}
    count = len(LIBRARIES)
    differences = [x for values in times.values() for x in values[count:]]
    if not max(differences) < 1e-8:
        sys.exit(f"{name}: the libraries differ by {max(differences)}: {lines}")
    title = f"{name}, {model.nv} coordinates"
    table(title, "ns a call", [(f, times[f][:count]) for f in NAMES])
    table(title, "instructions", [(f, [instructions(program, k, f) for k in range(count)]) for f in NAMES])
    size = kilobytes(folder.glob(f"include/qvgen/robots/{name}/dynamics*_definitions.h"))
    print(f"  emitted {size:.0f} kB (CasADi {kilobytes([folder / 'peer.c']):.0f} kB); derived in {made.wall:.0f} s; compiled in "
          f"{sum(c.seconds for c in ours):.0f} s and {max(c.megabytes for c in ours):.0f} MB for double and float "
          f"(CasADi, double: {sum(c.seconds for c in theirs):.0f} s and {max(c.megabytes for c in theirs):.0f} MB)", flush=True)


def installed(package):
    try:
        return bool(importlib.metadata.version(package))
    except importlib.metadata.PackageNotFoundError:
        return False


def main():
    missing = [package for package in ("pin", "casadi", "example-robot-data") if not installed(package)]
    if missing:
        print(f"skipped: pip install {' '.join(missing)} (QVGEN_PYTHON names the Python that has them)")
        sys.exit(77)
    tool, folder, *names = sys.argv[1:]
    folder = pathlib.Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    all_robots = robots()
    writer = casadi_writer(folder)
    for name in names or all_robots:
        measure(tool, writer, folder / name, name, *all_robots[name])


if __name__ == "__main__":
    main()
