#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Dynamics of whole robots beside Pinocchio's own loops: nanoseconds and instructions a call, size of the code, and what
generating and compiling it take. Both are compiled with the same options.

    tests/benchmark/trees.py [--tool build/ci/generator/cli/qvgen] [--robot quad] [--robot humanoid]

Needs g++ and `pip install pin`; exit code 77, and says so, without it. Instructions need valgrind. No test passes or fails by
what this prints.
"""
import argparse
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Without -march: Pinocchio comes compiled, and what Eigen aligns by is part of its types.
OPTIONS = ["-O3", "-DNDEBUG"]
FOR_PINOCCHIO = ["-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS", "-DFUSION_MAX_VECTOR_SIZE=10",
                 "-DBOOST_FUSION_INVOKE_MAX_ARITY=10"]
FUNCTIONS = ["inverse_dynamics", "mass_matrix", "forward_dynamics", "inverse_dynamics_derivatives"]


def humanoid():
    """A URDF of 30 joints: waist of two, head of two, legs of six, arms of seven."""
    text = ['<robot name="humanoid">']

    def link(name, k):
        mass, long = 0.6 + 0.13 * (k % 7), 0.03 + 0.01 * (k % 4)
        text.append(f'<link name="{name}"><inertial><origin xyz="{0.01 * (k % 3 - 1):g} {0.005 * (k % 4):g} {-long:g}"/>'
                    f'<mass value="{mass:g}"/><inertia ixx="{0.01 + 0.001 * (k % 5):g}" iyy="{0.012 + 0.001 * (k % 3):g}" '
                    f'izz="{0.008 + 0.001 * (k % 4):g}" ixy="{0.0001 * (k % 3):g}" ixz="{-0.0002 * (k % 2):g}" iyz="0.0001"/>'
                    '</inertial></link>')

    count = [0]

    def limb(name, parent, origin, axes, step):
        for i, axis in enumerate(axes):
            child = f"{name}{i + 1}"
            count[0] += 1
            link(child, count[0])
            place = origin if i == 0 else step[i % len(step)]
            text.append(f'<joint name="{child}_joint" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
                        f'<origin xyz="{place}"/><axis xyz="{axis}"/><limit lower="-2" upper="2" effort="9" velocity="9"/></joint>')
            parent = child
        return parent

    x, y, z = "1 0 0", "0 1 0", "0 0 1"
    link("pelvis", 3)
    for side, sign in (("left", 1), ("right", -1)):
        limb(side + "_leg", "pelvis", f"0 {0.1 * sign} -0.05", [z, x, y, y, y, x], ["0 0 -0.02", "0 0 0", "0.01 0 -0.35"])
    chest = limb("waist", "pelvis", "0 0 0.1", [z, y], ["0 0 0.1"])
    limb("head", chest, "0.02 0 0.3", [z, y], ["0 0 0.05"])
    for side, sign in (("left", 1), ("right", -1)):
        limb(side + "_arm", chest, f"0 {0.2 * sign} 0.25", [y, x, z, y, z, y, x], ["0 0 -0.14", "0 0 0", "0.01 0 -0.1"])
    return "\n".join(text) + "</robot>\n"


def timed(command, **options):
    begin = time.monotonic()
    subprocess.run(command, check=True, **options)
    return time.monotonic() - begin


COMMON = r"""
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
/// Times a function, or calls it as often as the command line says.
struct Runner {
  int count;
  char** arguments;
  template <class Call>
  void operator()(const char* name, const Call& call) const {
    if (count > 3) {
      if (std::strcmp(arguments[2], name) != 0) return;
      for (long i = 0; i < std::atol(arguments[3]); ++i) call(i);
      return;
    }
    double best = 1e300;
    for (int repeat = 0; repeat < 7; ++repeat) {
      const auto begin = std::chrono::steady_clock::now();
      for (long i = 0; i < 5000; ++i) call(i);
      const double spent = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count();
      if (spent < best) best = spent;
    }
    std::printf("%s %.0f\n", name, best / 5000);
  }
};
"""

HARNESS = COMMON + r"""
#include <qvgen/robots/NAME/dynamics.h>
#include <qvgen/robots/NAME/dynamics_derivatives.h>
namespace robot = qvgen::robots::NAME;
int main(int count, char** arguments) {
  robot::Configuration<double> at;
  at.q.setConstant(0.3);
  const robot::Velocity<double> v = robot::Velocity<double>::Constant(0.4), a = v;
  double sum = 0;
  const Runner run{count, arguments};
  const auto change = [&](long i) { at.q[0] = 1e-4 * double(i); };
  run("inverse_dynamics", [&](long i) { change(i); sum += robot::inverse_dynamics(at, v, a)[1]; });
  run("mass_matrix", [&](long i) { change(i); sum += robot::mass_matrix(at)(1, 1); });
  run("forward_dynamics", [&](long i) { change(i); sum += robot::forward_dynamics(at, v, a)[1]; });
  run("inverse_dynamics_derivatives",
      [&](long i) { change(i); sum += robot::inverse_dynamics_derivatives(at, v, a).by_rate(1, 1); });
  std::fprintf(stderr, "%g\n", sum);
  return 0;
}
"""

LOOPS = COMMON + r"""
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/parsers/urdf.hpp>
int main(int count, char** arguments) {
  pinocchio::Model model;
  pinocchio::urdf::buildModel(arguments[1], pinocchio::JointModelFreeFlyer(), model);
  pinocchio::Data data(model);
  Eigen::VectorXd q = Eigen::VectorXd::Constant(model.nq, 0.3);
  q.head<7>() << 0, 0, 0, 0, 0, 0, 1;
  const Eigen::VectorXd v = Eigen::VectorXd::Constant(model.nv, 0.4), a = v;
  const Runner run{count, arguments};
  const auto change = [&](long i) { q[7] = 1e-4 * double(i); };
  run("inverse_dynamics", [&](long i) { change(i); pinocchio::rnea(model, data, q, v, a); });
  run("mass_matrix", [&](long i) { change(i); pinocchio::crba(model, data, q); });
  run("forward_dynamics", [&](long i) { change(i); pinocchio::aba(model, data, q, v, a); });
  run("inverse_dynamics_derivatives",
      [&](long i) { change(i); pinocchio::computeRNEADerivatives(model, data, q, v, a); });
  return 0;
}
"""


def compiled(sources, includes, folder):
    objects = []
    for source in sources:
        objects.append(folder / (source.parent.name + "_" + source.stem + ".o"))
        standard = ["-std=c++17"] if source.suffix == ".cpp" else []
        subprocess.run(["g++" if source.suffix == ".cpp" else "gcc", *standard, *OPTIONS, *includes, "-c", source, "-o", objects[-1]],
                       check=True)
    return objects


def instructions(program, urdf, name):
    """A call's, by the difference of two runs."""
    if shutil.which("valgrind") is None:
        return float("nan")

    def total(calls):
        with tempfile.NamedTemporaryFile() as out:
            done = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out.name}", program, urdf, name, str(calls)],
                                  capture_output=True, text=True, check=True)
        return int(re.search(r"Collected : (\d+)", done.stderr).group(1))
    return (total(300) - total(100)) / 200


def times(program, urdf):
    output = subprocess.run([program, urdf], check=True, capture_output=True, text=True).stdout
    return {line.split()[0]: float(line.split()[1]) for line in output.splitlines()}


def measure(name, urdf, tool, folder):
    code = folder / "code"
    generating = timed([tool, "generate", urdf, "--floating", "--only", "dynamics", "--output", code, "--name", name],
                       stdout=subprocess.DEVNULL)
    include = ["-I", str(code / "include"), "-I", str(ROOT / "runtime/include"), "-isystem", "/usr/include/eigen3"]
    sources = [code / "source" / name / part for part in ("dynamics.cpp", "dynamics_derivatives.cpp")]
    begin = time.monotonic()
    own = compiled(sources, include, folder)
    compiling = time.monotonic() - begin
    harness, program = folder / "harness.cpp", folder / "harness"
    harness.write_text(HARNESS.replace("NAME", name))
    library = sorted((ROOT / "build").glob("*/runtime/libqvgen_runtime_core.a"))
    subprocess.run(["g++", "-std=c++17", *OPTIONS, *include, harness, *own, *map(str, library[:1]), "-o", program], check=True)
    peer = loops(folder)
    mine, theirs = times(program, urdf), times(peer, urdf)
    parts = list((code / "include").rglob(f"{name}/dynamics*.h"))
    size = sum(p.stat().st_size for p in parts + sources)
    print(f"{name}: {size / 1000:.0f} kB, generated in {generating:.1f} s, compiled in {compiling:.1f} s (double and float)")
    print(f"{'function':30} {'ns':>8} {'Pinocchio':>10} {'ratio':>6} {'instructions':>13} {'Pinocchio':>10} {'ratio':>6}")
    for function in FUNCTIONS:
        counts = [instructions(which, urdf, function) for which in (program, peer)]
        print(f"{function:30} {mine[function]:8.0f} {theirs[function]:10.0f} {mine[function] / theirs[function]:6.2f} "
              f"{counts[0]:13.0f} {counts[1]:10.0f} {counts[0] / counts[1]:6.2f}", flush=True)


def loops(folder):
    import pinocchio
    prefix = next(p for p in pathlib.Path(pinocchio.__file__).resolve().parents if p.name == "cmeel.prefix")
    source, program = folder / "loops.cpp", folder / "loops"
    source.write_text(LOOPS)
    subprocess.run(["g++", "-std=c++17", *OPTIONS, *FOR_PINOCCHIO, "-I", prefix / "include", "-isystem", "/usr/include/eigen3", source, "-o", program,
                    "-L", prefix / "lib", f"-Wl,-rpath,{prefix / 'lib'}", "-lpinocchio_default", "-lpinocchio_parsers"], check=True)
    return program


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tool", default=ROOT / "build/ci/generator/cli/qvgen", type=pathlib.Path)
    parser.add_argument("--robot", action="append", choices=["quad", "humanoid"])
    arguments = parser.parse_args()
    if importlib.util.find_spec("pinocchio") is None:
        print("skipped: pip install pin")
        return 77
    for name in arguments.robot or ["quad", "humanoid"]:
        with tempfile.TemporaryDirectory() as folder:
            urdf = pathlib.Path(folder) / f"{name}.urdf"
            urdf.write_text((ROOT / "tests/floating/quad.urdf").read_text() if name == "quad" else humanoid())
            measure(name, urdf, arguments.tool.resolve(), pathlib.Path(folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
