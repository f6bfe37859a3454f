# SPDX-License-Identifier: MIT
"""Compiles kernels of CUDA for sm_90 and reads what ptxas says of registers and spills.

    python3 nvcc_test.py QVGEN FOLDER ROBOT...

nvcc is that of the path, or of PyPI (pip install nvidia-cuda-nvcc nvidia-cuda-runtime nvidia-cuda-crt); skipped without one.
"""
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys

SKIPPED = 77
MAY_SPILL = ("derivatives", "regressor", "_with_wrench", "_with_gravity_vector")


def nvcc():
    """Path of nvcc, or None."""
    if found := shutil.which("nvcc"):
        return found
    spec = importlib.util.find_spec("nvidia")
    places = [place for root in (spec.submodule_search_locations if spec else []) for place in pathlib.Path(root).glob("*/bin/nvcc")]
    return str(places[0]) if places else None


def kernels_of(log):
    """Yields (kernel, registers, bytes of the stack, bytes spilled)."""
    entry = re.compile(r"entry function '(\w+)_batch'.*?(\d+) bytes stack frame, (\d+) bytes spill stores.*?Used (\d+) registers", re.S)
    for name, stack, spilled, registers in entry.findall(log):
        yield name, int(registers), int(stack), int(spilled)


def main(tool, folder, *robots):
    program = nvcc()
    if program is None:
        print("skipped: there is no nvcc (pip install nvidia-cuda-nvcc nvidia-cuda-runtime nvidia-cuda-crt)")
        sys.exit(SKIPPED)
    for robot in robots:
        subprocess.run([tool, "generate", robot, "--language", "cuda", "--output", folder, "--quiet"], check=True)
        source = pathlib.Path(folder) / "cuda" / f"qvgen_{robot}.cu"
        done = subprocess.run([program, "-arch=sm_90", "-cubin", "-Xptxas", "-v", "--fmad=false", "-O3", source, "-o", f"{folder}/{robot}.cubin"],
                              capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr)
        found = list(kernels_of(done.stderr))
        assert len(found) == source.read_text().count("KERNEL void"), [each[0] for each in found]
        assert any(name == f"{robot}_inverse_kinematics" for name, *_ in found)
        for name, registers, stack, spilled in found:
            print(f"{name:50} {registers:4} registers {stack:5} bytes of stack {spilled:5} spilled")
            assert spilled == 0 or any(each in name for each in MAY_SPILL), name


if __name__ == "__main__":
    main(*sys.argv[1:])
