#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Dynamics of whole robots beside CasADi's C code of Pinocchio's algorithms, and Pinocchio's own loops: nanoseconds and
instructions a call, size of the code, and what generating and compiling it take. All compiled with the same options.

    tests/benchmark/trees.py [--tool build/ci/generator/cli/qvgen] [--robot quad] [--robot humanoid] [--loops]

Needs g++ and `pip install pin casadi numpy`; exit code 77, and says so, without them. Instructions need valgrind. `--loops`
compiles Pinocchio itself, which takes minutes. No test passes or fails by what this prints.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
OPTIONS = ["-O3", "-DNDEBUG", "-march=x86-64-v3"]
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


HARNESS = r"""
#include <chrono>
#include <cstdio>
#include <cstring>
#include <random>
#include <qvgen/robots/NAME/dynamics.h>
#include <qvgen/robots/NAME/dynamics_derivatives.h>
namespace robot = qvgen::robots::NAME;
extern "C" {
CASADI
}
int main(int count, char** arguments) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  robot::Configuration<double> at;
  at.base.orientation = Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5);
  at.q = at.q.unaryExpr([&](double) { return unit(random); });
  robot::Velocity<double> v, a;
  for (int i = 0; i < robot::velocity_size; ++i) v[i] = unit(random), a[i] = unit(random);
  Eigen::Matrix<double, 7 + robot::dof, 1> q;
  q << at.base.position, at.base.orientation.coeffs(), at.q;
  static double results[4][100000], work[1000000];
  static long long integers[100000];
  double sum = 0;
  const double* inputs[8] = {q.data(), v.data(), a.data()};
  const auto run = [&](const char* name, long calls, const auto& call) {
    if (count > 2) {
      if (std::strcmp(arguments[1], name) != 0) return;
      for (long i = 0; i < std::atol(arguments[2]); ++i) call(i);
      return;
    }
    double best = 1e300;
    for (int repeat = 0; repeat < 7; ++repeat) {
      const auto begin = std::chrono::steady_clock::now();
      for (long i = 0; i < calls; ++i) call(i);
      const double spent = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count();
      best = std::min(best, spent / double(calls));
    }
    std::printf("%s %.0f\n", name, best);
  };
  const auto change = [&](long i) { at.q[0] = q[7] = 1e-3 * double(i % 1000); };
  run("qvgen_inverse_dynamics", 20000, [&](long i) { change(i); sum += robot::inverse_dynamics(at, v, a)[1]; });
  run("qvgen_mass_matrix", 20000, [&](long i) { change(i); sum += robot::mass_matrix(at)(1, 1); });
  run("qvgen_forward_dynamics", 20000, [&](long i) { change(i); sum += robot::forward_dynamics(at, v, a)[1]; });
  run("qvgen_inverse_dynamics_derivatives", 5000, [&](long i) { change(i); sum += robot::inverse_dynamics_derivatives(at, v, a).by_rate(1, 1); });
  double* outputs[4] = {results[0], results[1], results[2], results[3]};
CALLS
  std::fprintf(stderr, "%g\n", sum + results[0][1]);
  return 0;
}
"""

LOOPS = r"""
#include <chrono>
#include <cstdio>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/parsers/urdf.hpp>
int main(int, char** arguments) {
  pinocchio::Model model;
  pinocchio::urdf::buildModel(arguments[1], pinocchio::JointModelFreeFlyer(), model);
  pinocchio::Data data(model);
  Eigen::VectorXd q = pinocchio::neutral(model);
  q.tail(model.nq - 7).setConstant(0.3);
  const Eigen::VectorXd v = Eigen::VectorXd::Constant(model.nv, 0.4), a = v;
  const auto run = [&](const char* name, const auto& call) {
    double best = 1e300;
    for (int repeat = 0; repeat < 7; ++repeat) {
      const auto begin = std::chrono::steady_clock::now();
      for (int i = 0; i < 5000; ++i) { q[7] = 1e-4 * i; call(); }
      best = std::min(best, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count() / 5000);
    }
    std::printf("loops_%s %.0f\n", name, best);
  };
  run("inverse_dynamics", [&] { pinocchio::rnea(model, data, q, v, a); });
  run("mass_matrix", [&] { pinocchio::crba(model, data, q); });
  run("forward_dynamics", [&] { pinocchio::aba(model, data, q, v, a); });
  run("inverse_dynamics_derivatives", [&] { pinocchio::computeRNEADerivatives(model, data, q, v, a); });
  return 0;
}
"""


def casadi_sources(urdf, folder):
    """C of Pinocchio's algorithms, one file a function; seconds that writing them took."""
    import casadi
    import pinocchio as pin
    from pinocchio import casadi as cpin
    begin = time.monotonic()
    model = cpin.Model(pin.buildModelFromUrdf(str(urdf), pin.JointModelFreeFlyer()))
    data = model.createData()
    q, v, a = casadi.SX.sym("q", model.nq), casadi.SX.sym("v", model.nv), casadi.SX.sym("a", model.nv)
    cpin.computeRNEADerivatives(model, data, q, v, a)
    derivatives = [data.tau, data.dtau_dq, data.dtau_dv]
    results = {"inverse_dynamics_derivatives": derivatives}
    results["inverse_dynamics"] = [cpin.rnea(model, model.createData(), q, v, a)]
    results["mass_matrix"] = [casadi.triu(cpin.crba(model, model.createData(), q))]
    results["forward_dynamics"] = [cpin.aba(model, model.createData(), q, v, a)]
    sources = []
    for name, outputs in results.items():
        outputs = [casadi.SX(o) for o in outputs]
        casadi.Function("casadi_" + name, [q, v, a], outputs).generate(f"casadi_{name}.c", {"with_header": False})
        shutil.move(f"casadi_{name}.c", folder / f"casadi_{name}.c")
        sources.append(folder / f"casadi_{name}.c")
    return sources, time.monotonic() - begin


def compiled(sources, includes, folder):
    objects = []
    for source in sources:
        objects.append(folder / (source.parent.name + "_" + source.stem + ".o"))
        standard = ["-std=c++17"] if source.suffix == ".cpp" else []
        subprocess.run(["g++" if source.suffix == ".cpp" else "gcc", *standard, *OPTIONS, *includes, "-c", source, "-o", objects[-1]],
                       check=True)
    return objects


def instructions(program, name):
    """A call's, by the difference of two runs."""
    if shutil.which("valgrind") is None:
        return None

    def total(calls):
        with tempfile.NamedTemporaryFile() as out:
            done = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out.name}", program, name, str(calls)],
                                  capture_output=True, text=True, check=True)
        return int(re.search(r"Collected : (\d+)", done.stderr).group(1))
    return (total(300) - total(100)) / 200


def times(program, *arguments):
    output = subprocess.run([program, *map(str, arguments)], check=True, capture_output=True, text=True).stdout
    return {line.split()[0]: float(line.split()[1]) for line in output.splitlines()}


def measure(name, urdf, tool, folder, with_loops):
    code = folder / "code"
    generating = timed([tool, "generate", urdf, "--floating", "--only", "dynamics", "--output", code, "--name", name],
                       stdout=subprocess.DEVNULL)
    include = ["-I", str(code / "include"), "-I", str(ROOT / "runtime/include"), "-isystem", "/usr/include/eigen3"]
    sources = [code / "source" / name / part for part in ("dynamics.cpp", "dynamics_derivatives.cpp")]
    begin = time.monotonic()
    own = compiled(sources, include, folder)
    compiling = time.monotonic() - begin
    peers, writing = casadi_sources(urdf, folder)
    begin = time.monotonic()
    peer_objects = compiled(peers, [], folder)
    peer_compiling = time.monotonic() - begin
    names = [peer.stem for peer in peers]
    harness = folder / "harness.cpp"
    declarations = "\n".join(f"int {n}(const double**, double**, long long*, double*, int);" for n in names)
    calls = "\n".join(f'  run("{n}", 5000, [&](long i) {{ change(i); {n}(inputs, outputs, integers, work, 0); }});' for n in names)
    harness.write_text(HARNESS.replace("NAME", name).replace("CASADI", declarations).replace("CALLS", calls))
    program = folder / "harness"
    library = sorted((ROOT / "build").glob("*/runtime/libqvgen_runtime_core.a"))
    subprocess.run(["g++", "-std=c++17", *OPTIONS, *include, harness, *own, *peer_objects, *map(str, library[:1]), "-o", program],
                   check=True)
    found = times(program)
    if with_loops:
        found |= times(loops(folder), urdf)
    parts = list((code / "include").rglob(f"{name}/dynamics*.h"))
    size = sum(p.stat().st_size for p in parts + sources)
    print(f"{name}: qvgen {size / 1000:.0f} kB, generated in {generating:.1f} s, compiled in {compiling:.1f} s (double and float); "
          f"CasADi {sum(p.stat().st_size for p in peers) / 1000:.0f} kB, {writing:.1f} s, {peer_compiling:.1f} s")
    print(f"{'function':30} {'qvgen ns':>9} {'CasADi ns':>10} {'loops ns':>9} {'ratio':>6} {'qvgen instr':>12} {'CasADi instr':>13} {'ratio':>6}")
    for function in FUNCTIONS:
        mine, peer = found["qvgen_" + function], found["casadi_" + function]
        count = [instructions(program, who + function) for who in ("qvgen_", "casadi_")]
        counted = "" if None in count else f"{count[0]:12.0f} {count[1]:13.0f} {count[0] / count[1]:6.2f}"
        print(f"{function:30} {mine:9.0f} {peer:10.0f} {found.get('loops_' + function, float('nan')):9.0f} {mine / peer:6.2f} {counted}",
              flush=True)


def loops(folder):
    import pinocchio
    prefix = next(p for p in pathlib.Path(pinocchio.__file__).resolve().parents if p.name == "cmeel.prefix")
    source, program = folder / "loops.cpp", folder / "loops"
    source.write_text(LOOPS)
    subprocess.run(["g++", "-std=c++17", *OPTIONS, "-I", prefix / "include", "-isystem", "/usr/include/eigen3", source, "-o", program,
                    "-L", prefix / "lib", f"-Wl,-rpath,{prefix / 'lib'}", "-lpinocchio_default", "-lpinocchio_parsers"], check=True)
    return program


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tool", default=ROOT / "build/ci/generator/cli/qvgen", type=pathlib.Path)
    parser.add_argument("--robot", action="append", choices=["quad", "humanoid"])
    parser.add_argument("--loops", action="store_true")
    arguments = parser.parse_args()
    try:
        import casadi  # noqa: F401
        from pinocchio import casadi as _  # noqa: F401
    except ImportError as reason:
        print(f"skipped: pip install pin casadi numpy ({reason})")
        return 77
    for name in arguments.robot or ["quad", "humanoid"]:
        with tempfile.TemporaryDirectory() as folder:
            urdf = pathlib.Path(folder) / f"{name}.urdf"
            urdf.write_text((ROOT / "tests/floating/quad.urdf").read_text() if name == "quad" else humanoid())
            measure(name, urdf, arguments.tool.resolve(), pathlib.Path(folder), arguments.loops)
    return 0


if __name__ == "__main__":
    sys.exit(main())
