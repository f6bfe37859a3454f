# SPDX-License-Identifier: MIT
"""Kernels on a card of NVIDIA: right, and how fast.

    python3 measure.py make QVGEN FOLDER ROBOT...     # writes kernels and C; ROBOT is a name or a file, options behind a comma:
                                                      # puma560 tests/floating/quad.urdf,--floating,--tips,all
    python3 measure.py check FOLDER [--rows 1000000]  # each kernel against the robot's C on the host
    python3 measure.py time FOLDER [--rows 2097152]   # each kernel: time, registers, share of what the card can do
    python3 measure.py test QVGEN FOLDER ROBOT...     # make and check with few rows, as the tests do

`make` needs the tool alone; the others a card, nvcc, a C compiler and NumPy. Exit code 77: there is no card, or no nvcc.
"""
import argparse
import ctypes
import pathlib
import re
import subprocess
import sys

try:
    import numpy as np
except ImportError:
    print("skipped: there is no NumPy; needs a card of NVIDIA with its driver, nvcc, a C compiler and NumPy")
    sys.exit(77)

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "languages"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import device  # noqa: E402
import kernels  # noqa: E402
from inputs import arguments, on, poses_for  # noqa: E402
from nvcc_test import kernels_of, nvcc  # noqa: E402

SKIPPED = 77
# Differences of sines grow with a row's numbers and with the condition of a mass matrix: 4,500 units of the last place are 1e-12 in
# double and 5e-4 in float.
ULPS = 4500
POISON = 0x7e  # 0x7e7e7e7e: a number that no kernel gives


def make(tool, folder, *robots):
    for robot in robots:
        name, *options = robot.split(",")
        for real in kernels.REALS:
            for language in ("cuda", "c"):
                subprocess.run([tool, "generate", name, *options, "--language", language, "--scalar", real, "--quiet",
                                "--output", f"{folder}/{real}"], check=True)


def robots_in(folder, wanted):
    """Robots with kernels, and in which precision."""
    for real in kernels.REALS:
        for path in sorted(pathlib.Path(folder).glob(f"{real}/cuda/qvgen_*.cu")):
            name = path.stem[len("qvgen_"):]
            if not wanted or name in wanted:
                yield kernels.Robot(name, folder, real)


def compiled(robot, card, options=("--fmad=false",)):
    """Returns the path of the robot's cubin, and {kernel: (registers, stack, spills)}."""
    source = robot.folder / f"cuda/qvgen_{robot.name}.cu"
    cubin = source.with_suffix(".fused.cubin" if "--fmad=true" in options else ".cubin")
    log = cubin.with_suffix(".log")
    if cubin.exists() and log.exists() and log.stat().st_mtime > source.stat().st_mtime:
        return cubin, resources_in(log.read_text())
    done = subprocess.run([nvcc(), f"-arch={card.architecture}", "-cubin", "-O3", *options, "-Xptxas", "-v", source, "-o", cubin],
                          capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stderr)
    log.write_text(done.stderr)
    return cubin, resources_in(done.stderr)


def resources_in(log):
    return {name: (registers, stack, spilled) for name, registers, stack, spilled in kernels_of(log)}


# --- check ----------------------------------------------------------------------------------------------------------------------


def difference(got, wanted):
    """The largest difference in units of the last place of a row's largest number, or of what rows typically have, as energies
    may vanish; infinite if numbers stand where C has none."""
    finite = np.isfinite(wanted)
    if (np.isfinite(got) != finite).any():
        return np.inf
    scale = np.abs(np.where(finite, wanted, 0)).max(axis=0)
    with np.errstate(invalid="ignore", over="ignore"):
        apart = np.where(finite, np.abs(got - wanted), 0).max(axis=0)
    worst = apart / np.maximum(np.maximum(scale, np.median(scale)), np.finfo(wanted.dtype).tiny)
    return worst.max() / np.finfo(wanted.dtype).eps


def counts_of_rows(most):
    """Around a block, one, none, and many, no multiple of a block."""
    return [0, 1, device.BLOCK - 1, device.BLOCK, device.BLOCK + 1, most + 37]


def check_function(robot, card, kernel, function, rows, seed):
    """Returns the largest difference over all counts; what lies behind the results may not change."""
    random = np.random.default_rng(seed)
    size, worst = robot.size(function), 0.0
    for n in counts_of_rows(min(rows, max(2000, 60_000_000 // size))):
        host, given = arguments(robot, function, n, random)
        item, guard = np.dtype(robot.kind).itemsize, 512
        result = card.empty(size * n * item + guard)
        result.fill(POISON)
        kernel(n, [n, *on(card, given), result])
        card.finish()
        everything = result.get(size * n * item + guard, np.uint8)
        if (everything[size * n * item:] != POISON).any():
            return np.inf
        if n:
            worst = max(worst, difference(everything[:size * n * item].view(robot.kind).reshape(size, n), robot.rows(function, host, n)))
    return worst


def check_inverse(robot, card, module, rows):
    """Rows, branches, counts and statuses are those of C but where the kernel leaves the pose to it. Returns a line and whether
    that holds."""
    kernel, random = module.kernel(f"{robot.name}_inverse_kinematics_batch"), np.random.default_rng(3)
    tolerance = 1e-13 if robot.real == "double" else 8e-6
    worst, doubts, wrong = 0.0, 0, 0
    for n in counts_of_rows(min(rows, 400_000)):
        orientation, position = poses_for(robot, n, random)
        wanted = robot.solutions(orientation, position, tolerance)
        found = [card.empty(each.nbytes) for each in wanted]
        for each in found:
            each.fill(POISON)
        constants = [data for data in [robot.constants(f"{robot.name}_geometry")] if data]
        kernel(n, [n, card.array(orientation), card.array(position), *constants, robot.kind(tolerance), *found])
        card.finish()
        q, branch, count, status = (each.get(like.shape, like.dtype) for each, like in zip(found, wanted))
        sure = status != 5
        wrong += ((status != wanted[3]) & sure).sum() + (count != np.where(sure, wanted[2], 0)).sum()
        wrong += (np.where(sure, branch != wanted[1], branch != -1).any(axis=0)).sum()
        same = sure & (count == wanted[2]) & (count > 0)
        if same.any():
            apart = np.abs(q[:, same] - wanted[0][:, same])
            worst = max(worst, np.nanmax(apart))
            wrong += (apart > ULPS * np.finfo(robot.kind).eps * np.maximum(1, np.abs(wanted[0][:, same]))).any(axis=0).sum()
        wrong += (np.isnan(q) != np.isnan(np.where(sure, wanted[0], np.nan))).any(axis=0).sum()
        if n > 1000:
            doubts = (~sure[304:]).mean()
            wrong += sure[300:304].sum()
    line = f"{wrong} of all poses differ, {100 * doubts:.3f} % of random ones are doubtful, joints at most {worst:.1e} apart"
    return line, wrong == 0 and doubts < (0.01 if robot.real == "double" else 0.2)


def check_beyond_32_bits(card, folder, wanted):
    """The kernel with the fewest numbers over 2^32 + 5 configurations: the first, the last, and some between. Returns whether it is
    wrong; false where the card has no memory for it."""
    n, edge = (1 << 32) + 5, 1000
    built = [robot.build() for robot in robots_in(folder, wanted) if robot.real == "float"]
    every = [(robot, each) for robot in built for each in robot.functions
             if not any(p.structure and robot.constants(p.structure) for p in each.parameters)]
    robot, function = min(every, key=lambda pair: pair[0].size(pair[1]) + sum(p.size for p in pair[1].parameters))
    sizes = [p.size for p in function.parameters if p.size]
    needed = 4 * n * (sum(sizes) + robot.size(function))
    if needed > card.free_bytes():
        print(f"{function.name} over {n} configurations: not checked, {needed / 1e9:.0f} GB are not there")
        return False
    host, given = arguments(robot, function, 3 * edge, np.random.default_rng(2))
    begins = [0, (1 << 31) + 7, n - edge]
    kept = []
    for each in given:
        if isinstance(each, np.ndarray):
            array = card.empty(4 * n * each.shape[0])
            for i, row in enumerate(each):
                for part, begin in enumerate(begins):
                    array.put(np.ascontiguousarray(row[part * edge:(part + 1) * edge]), 4 * (i * n + begin))
            each = array
        kept.append(each)
    result = card.empty(4 * n * robot.size(function))
    result.fill(POISON)
    card.module(compiled(robot, card)[0]).kernel(f"{function.name}_batch")(n, [n, *kept, result])
    card.finish()
    got = np.stack([np.concatenate([result.get(edge, np.float32, 4 * (i * n + begin)) for begin in begins])
                    for i in range(robot.size(function))])
    ulps = difference(got, robot.rows(function, host, 3 * edge))
    print(f"{function.name} over {n} configurations: {ulps:.1f} ulp{'' if ulps <= ULPS else '   WRONG'}")
    return not ulps <= ULPS


def check(card, folder, wanted, rows):
    failed = 0
    for robot in robots_in(folder, wanted):
        robot.build()
        cubin, _ = compiled(robot, card)
        module = card.module(cubin)
        for seed, function in enumerate(robot.functions):
            ulps = check_function(robot, card, module.kernel(f"{function.name}_batch"), function, rows, seed)
            failed += not ulps <= ULPS
            print(f"{robot.real:6} {function.name:60} {ulps:10.1f} ulp{'' if ulps <= ULPS else '   WRONG'}", flush=True)
        if robot.has_inverse:
            line, holds = check_inverse(robot, card, module, rows)
            failed += not holds
            print(f"{robot.real:6} {robot.name}_inverse_kinematics: {line}{'' if holds else '   WRONG'}", flush=True)
    print(f"{card.name}: {failed} kernels are wrong")
    return failed


# --- time -----------------------------------------------------------------------------------------------------------------------

CEILINGS = """
template <class Real> __device__ void spin(Real* x, int steps) {
  Real a[8];
  for (int i = 0; i < 8; ++i) a[i] = x[threadIdx.x] + i;
  for (int k = 0; k < steps; ++k)
    for (int i = 0; i < 8; ++i) a[i] = a[i] * Real(1.0000001) + Real(1e-7);
  Real sum = 0;
  for (int i = 0; i < 8; ++i) sum += a[i];
  x[(size_t)blockIdx.x * blockDim.x + threadIdx.x] = sum;
}
extern "C" __global__ void spin_double(size_t steps, double* x) { spin(x, (int)steps); }
extern "C" __global__ void spin_float(size_t steps, float* x) { spin(x, (int)steps); }
"""


def ceilings(card, folder):
    """Bytes a second of a copy (read and written), and operations a second, in double and in float, of products and sums that are
    not fused: instructions, that is."""
    size = 1 << 30
    a, b = card.empty(size), card.empty(size)
    a.fill(1)
    copy = card.seconds(lambda: card.call("cuMemcpyDtoD_v2", b.place, a.place, size))
    source = pathlib.Path(folder) / "ceilings.cu"
    source.write_text(CEILINGS)
    subprocess.run([nvcc(), f"-arch={card.architecture}", "-cubin", "-O3", "--fmad=false", source,
                    "-o", source.with_suffix(".cubin")], check=True)
    module, threads, steps = card.module(source.with_suffix(".cubin")), 1 << 19, 512
    spin = {real: card.seconds(lambda kernel=module.kernel(f"spin_{real}"): kernel(threads, [steps, a])) for real in kernels.REALS}
    return 2 * size / copy, {real: threads * steps * 16 / spin[real] for real in kernels.REALS}


def operations(cubin):
    """{kernel: instructions on numbers} of both precisions, as the machine code has them; empty without cuobjdump."""
    try:
        text = subprocess.run(["cuobjdump", "-sass", cubin], capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return {}
    pattern = re.compile(r"\b(DFMA|DMUL|DADD|FFMA|FMUL|FADD|MUFU)\b")
    parts = (part.split(maxsplit=1) for part in text.split("Function : ")[1:])
    return {name: {kind: sum(each[0] == kind for each in pattern.findall(code)) for kind in "DF"} for name, code in parts}


class Measured:
    """One kernel's row of the table."""

    def __init__(self, name, n, seconds, moved, counted, limits, resources):
        self.name, self.rate = name, n / seconds
        self.moved = moved * n / seconds / limits[0]
        shares = (counted[kind] * n / seconds / limits[1][real] for kind, real in zip("DF", kernels.REALS) if counted)
        self.counted = max(shares, default=0)
        self.resources = resources

    def line(self, transfer):
        registers, stack, spilled = self.resources
        return (f"{self.name:58}{self.rate / 1e6:10.1f}{transfer:>10}{registers:6}{stack:7}{spilled:7}"
                f"{100 * self.moved:7.0f} %{100 * self.counted:7.0f} %")


def time_kernel(card, kernel, arrays, constants, sizes, n, pinned, places):
    """Seconds with everything on the card, and with transfers of all arrays from and to pinned memory."""
    inside = card.seconds(lambda: kernel(n, constants(arrays)))
    if sum(sizes) > pinned.nbytes:
        return inside, None

    def whole():
        for at, (array, size) in enumerate(zip(arrays, sizes)):
            if at < places:
                card.call("cuMemcpyHtoD_v2", array.place, ctypes.c_void_p(pinned.ctypes.data), ctypes.c_size_t(size))
        kernel(n, constants(arrays))
        for array, size in list(zip(arrays, sizes))[places:]:
            card.call("cuMemcpyDtoH_v2", ctypes.c_void_p(pinned.ctypes.data), array.place, ctypes.c_size_t(size))
    return inside, card.seconds(whole, 3)


def measure(card, folder, wanted, rows, options, transfers):
    limits = ceilings(card, folder)
    print(f"{card.name}: a copy moves {limits[0] / 1e9:.0f} GB/s; " +
          ", ".join(f"{value / 1e12:.2f}e12 operations a second in {real}" for real, value in limits[1].items()))
    pinned = card.pinned(1 << 30) if transfers else np.empty(0, np.uint8)
    for robot in robots_in(folder, wanted):
        robot.build()
        cubin, resources = compiled(robot, card, options)
        module, counted = card.module(cubin), operations(cubin)
        print(f"\n{robot.name}, {robot.real}, {' '.join(options)}\n{'':58}{'1e6/s':>10}{'with PCIe':>10}{'regs':>6}{'stack':>7}{'spill':>7}"
              f"{'bytes':>9}{'numbers':>9}")
        for function in robot.functions:
            print(measure_function(card, robot, module, function, rows, limits, counted, resources, pinned), flush=True)
        if robot.has_inverse:
            measure_inverse(card, robot, module, rows, limits, counted, resources)


def measure_function(card, robot, module, function, rows, limits, counted, resources, pinned):
    """A line of the table; fewer rows where they would not fit on the card."""
    random, size, item = np.random.default_rng(1), robot.size(function), np.dtype(robot.kind).itemsize
    moved = item * (size + sum(each.size for each in function.parameters))
    n = int(min(rows, 0.4 * card.free_bytes() / moved))
    given = on(card, arguments(robot, function, n, random)[1])
    arrays = [each for each in given if isinstance(each, device.Array)] + [card.empty(size * n * item)]
    inside, whole = time_kernel(card, module.kernel(f"{function.name}_batch"), arrays, lambda arrays: [n, *given, arrays[-1]],
                                [each.size for each in arrays], n, pinned, len(arrays) - 1)
    row = Measured(function.name, n, inside, moved, counted.get(f"{function.name}_batch"), limits,
                   resources.get(function.name, (0, 0, 0)))
    return row.line(f"{n / whole / 1e6:.1f}" if whole else "-")


def measure_inverse(card, robot, module, rows, limits, counted, resources):
    name, random = f"{robot.name}_inverse_kinematics", np.random.default_rng(1)
    n = min(rows, 1 << 20)
    orientation, position = poses_for(robot, n, random)
    item = np.dtype(robot.kind).itemsize
    found = [card.empty(size * n) for size in (robot.capacity * robot.dof * item, robot.capacity * 4, 4, 4)]
    constants = [data for data in [robot.constants(f"{robot.name}_geometry")] if data]
    given = [n, card.array(orientation), card.array(position), *constants, robot.kind(1e-13 if item == 8 else 8e-6), *found]
    kernel = module.kernel(f"{name}_batch")
    seconds = card.seconds(lambda: kernel(n, given))
    moved = 7 * item + robot.capacity * (robot.dof * item + 4) + 8
    print(Measured(name, n, seconds, moved, None, limits, resources[name]).line("-"), flush=True)


def card_or_skip():
    """The card; ends the program with the code of skipped tests where there is none, or no compiler for it."""
    try:
        card = device.Card()
    except device.NoCard as reason:
        print(f"skipped: {reason}; needs a card of NVIDIA with its driver, nvcc, a C compiler and NumPy")
        sys.exit(SKIPPED)
    if nvcc() is None:
        print("skipped: there is no nvcc (CUDA's toolkit, or pip install nvidia-cuda-nvcc nvidia-cuda-runtime nvidia-cuda-crt)")
        sys.exit(SKIPPED)
    return card


def main():
    if sys.argv[1:2] == ["make"]:
        return make(*sys.argv[2:])
    if sys.argv[1:2] == ["test"]:
        card = card_or_skip()
        make(*sys.argv[2:])
        sys.exit(check(card, sys.argv[3], [], 2000) != 0)
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("what", choices=["check", "time"])
    parser.add_argument("folder")
    parser.add_argument("--rows", type=int, default=0)
    parser.add_argument("--robots", default="")
    parser.add_argument("--huge", action="store_true",
                        help="one kernel over more than 2^32 configurations")
    parser.add_argument("--fused", action="store_true", help="products and sums in one operation")
    parser.add_argument("--transfers", action="store_true", help="also with transfers")
    line = parser.parse_args()
    card = card_or_skip()
    wanted = [each for each in line.robots.split(",") if each]
    if line.huge:
        sys.exit(check_beyond_32_bits(card, line.folder, wanted))
    if line.what == "check":
        sys.exit(check(card, line.folder, wanted, line.rows or 1_000_000) != 0)
    measure(card, line.folder, wanted, line.rows or 1 << 21, ("--fmad=true",) if line.fused else ("--fmad=false",), line.transfers)


if __name__ == "__main__":
    main()
