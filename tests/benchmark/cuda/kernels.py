# SPDX-License-Identifier: MIT
"""Functions of a robot's C header, and the C that runs them over rows: the yardstick of its kernels.

Names and sizes are read from the header that C programs include, not from the kernels; the loops here gather and scatter by
themselves.
"""
import concurrent.futures
import ctypes
import os
import pathlib
import re
import subprocess

import numpy as np

REALS = {"double": np.float64, "float": np.float32}


class Parameter:
    """One of a function: an array of `size` numbers, one number, or constants of a structure."""

    def __init__(self, text, real):
        self.name = re.search(r"(\w+)(?:\[\d+\])*$", text)[1]
        sizes = [int(size) for size in re.findall(r"\[(\d+)\]", text)]
        self.structure = (re.fullmatch(r"(?:const )?(\w+)\* \w+", text) or [None, None])[1]
        self.size = int(np.prod(sizes)) if sizes else 0
        self.is_number = not self.size and not self.structure
        self.shape = "".join(f"[{size}]" for size in sizes)
        assert self.structure or text.split()[-2] == real, text


class Function:
    """A function NAME of the header that has a kernel NAME_batch."""

    def __init__(self, result, name, parameters, real):
        every = [Parameter(" ".join(each.split()), real) for each in parameters.split(",")]
        self.name, self.real, self.returns = name, real, result != "void"
        self.last = None if self.returns else every.pop()
        self.parameters = every

    def loop(self):
        """C that runs the function over rows from `begin` to `end` of arrays with `n` numbers beside one another."""
        taken, lines, call = [], [], []
        for each in self.parameters:
            if each.size:
                taken.append(f"const {self.real}* {each.name}")
                lines += [f"{self.real} {each.name}_[{each.size}];",
                          f"for (int i = 0; i < {each.size}; ++i) {each.name}_[i] = {each.name}[i * n + k];"]
                call.append(each.name + "_")
            else:
                taken.append(f"const {each.structure}* {each.name}" if each.structure else f"{self.real} {each.name}")
                call.append(each.name)
        size = f"{self.name}_size_of_result()"
        if self.returns:
            kind, lines = self.real, [*lines, f"result[k] = {self.name}({', '.join(call)});"]
        else:
            kind = self.last.structure or self.real
            variable = f"{kind} result_{'' if self.last.structure else self.last.shape};"
            reference = "&result_" if self.last.structure else "result_"
            lines += [variable, f"{self.name}({', '.join([*call, reference])});",
                      f"for (int i = 0; i < {size}; ++i) result[i * n + k] = ((const {self.real}*){reference})[i];"]
        shape = "" if self.returns or self.last.structure else self.last.shape
        return (f"int {size.replace('()', '(void)')} {{ return (int)(sizeof({kind}{shape}) / sizeof({self.real})); }}\n"
                f"void {self.name}_rows(size_t begin, size_t end, size_t n, {', '.join(taken)}, {self.real}* result) {{\n"
                "  for (size_t k = begin; k < end; ++k) {\n    " + "\n    ".join(lines) + "\n  }\n}\n")


INVERSE = """
int {robot}_capacity(void) {{ return {robot}_solutions_capacity; }}
void {robot}_inverse_rows(size_t begin, size_t end, size_t n, const {real}* o, const {real}* p, const {robot}_geometry* g, {real} tolerance,
                          {real}* q, int* branch, int* count, int* status) {{
  for (size_t k = begin; k < end; ++k) {{
    {real} o_[4], p_[3];
    for (int i = 0; i < 4; ++i) o_[i] = o[i * n + k];
    for (int i = 0; i < 3; ++i) p_[i] = p[i * n + k];
    static _Thread_local {robot}_solutions found;
    {robot}_inverse_kinematics(o_, p_, NULL, g, tolerance, &found);
    for (int r = 0; r < {robot}_solutions_capacity; ++r) {{
      for (int i = 0; i < {robot}_dof; ++i) q[(r * {robot}_dof + i) * n + k] = r < found.count ? found.rows[r].q[i] : ({real})NAN;
      branch[r * n + k] = r < found.count ? found.rows[r].branch : -1;
    }}
    count[k] = found.count;
    status[k] = found.status;
  }}
}}
"""


class Robot:
    """A robot's kernels and C in a folder that `measure.py make` wrote; `real` is double or float."""

    def __init__(self, name, folder, real):
        self.name, self.real, self.kind = name, real, REALS[real]
        self.folder = pathlib.Path(folder) / real
        self.kernels = (self.folder / f"cuda/qvgen_{name}.cu").read_text()
        self.c = self.folder / "c"
        header = (self.c / f"qvgen_{name}.h").read_text()
        there = set(re.findall(r"KERNEL void (\w+)_batch\(", self.kernels))
        declared = re.findall(r"^(void|double|float) (\w+)\(([^)]*)\);", header, re.M)
        self.functions = [Function(*each, real) for each in declared if each[1] in there]
        self.has_inverse = f"{name}_inverse_kinematics" in there
        left_out = there - {each.name for each in self.functions} - {f"{name}_inverse_kinematics"}
        assert not left_out and self.functions, f"kernels that no function of the header explains: {left_out}"

    def build(self):
        """Compiles the C with its loops: the bits of C, so no a * b + c becomes one operation."""
        parts = ["#include <math.h>", "#include <stddef.h>", f'#include "qvgen_{self.name}.h"']
        sources = [self.c / f"qvgen_{self.name}.c"]
        if self.has_inverse:
            parts.append(f'#include "qvgen_{self.name}_inverse.h"')
            sources.append(self.c / f"qvgen_{self.name}_inverse.c")
        parts += [each.loop() for each in self.functions]
        if self.has_inverse:
            parts.append(INVERSE.format(robot=self.name, real=self.real))
        (self.c / f"{self.name}_rows.c").write_text("\n".join(parts))
        library = self.c / f"{self.name}_rows.so"
        subprocess.run([os.environ.get("CC", "cc"), "-std=c11", "-O2", "-ffp-contract=off", "-fno-math-errno", "-fPIC", "-shared",
                        f"{self.c}/{self.name}_rows.c", *sources, "-o", library, "-lm"], check=True)
        self.compiled = ctypes.CDLL(str(library.resolve()))
        if self.has_inverse:
            self.capacity = self.compiled[f"{self.name}_capacity"]()
            self.dof = int(re.search(rf"enum {{ {self.name}_dof = (\d+) }}", self.kernels)[1])
        return self

    def size(self, function):
        return getattr(self.compiled, f"{function.name}_size_of_result")()

    def constants(self, structure):
        """Bytes of the structure's default values; none if all are numbers within the code."""
        if self.place_of_constants(structure) is None:
            return b""
        fields = re.search(rf"typedef struct {structure} {{(.*?)}}", self.kernels, re.S)[1]
        count = len(re.findall(rf"\b{self.real} \w+;", fields))
        return ctypes.string_at(self.place_of_constants(structure), count * np.dtype(self.kind).itemsize)

    def place_of_constants(self, structure):
        """Address of the structure's default values; None if all are numbers within the code."""
        if re.search(rf"typedef struct {structure} {{\s*char none;", self.kernels):
            return None
        return ctypes.addressof(ctypes.c_char.in_dll(self.compiled, structure.replace(f"{self.name}_", f"{self.name}_default_")))

    def number(self, value):
        return (ctypes.c_double if self.real == "double" else ctypes.c_float)(value)

    def in_threads(self, run, n):
        """Runs run(begin, end) over all rows, on all cores."""
        workers = os.cpu_count()
        bounds = np.linspace(0, n, 4 * workers + 1).astype(int)
        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            list(pool.map(run, bounds[:-1], bounds[1:]))

    def rows(self, function, given, n):
        """Results of C, number by number: `given` has arrays, numbers, and names of structures for their default values."""
        result = np.full((self.size(function), n), np.nan, self.kind)
        arguments = [ctypes.c_void_p(each.ctypes.data) if isinstance(each, np.ndarray) else
                     ctypes.c_void_p(self.place_of_constants(each)) if isinstance(each, str) else self.number(each) for each in given]
        rows = getattr(self.compiled, f"{function.name}_rows")
        self.in_threads(lambda begin, end: rows(ctypes.c_size_t(begin), ctypes.c_size_t(end), ctypes.c_size_t(n), *arguments,
                                                ctypes.c_void_p(result.ctypes.data)), n)
        return result

    def solutions(self, orientation, position, tolerance):
        """All solutions of poses by C: joints, branches, counts, statuses."""
        n = orientation.shape[1]
        results = [np.full((self.capacity * self.dof, n), np.nan, self.kind), np.zeros((self.capacity, n), np.int32),
                   np.zeros(n, np.int32), np.zeros(n, np.int32)]
        pointers = [ctypes.c_void_p(each.ctypes.data) for each in (orientation, position, *results)]
        rows = self.compiled[f"{self.name}_inverse_rows"]
        geometry = ctypes.c_void_p(self.place_of_constants(f"{self.name}_geometry"))
        self.in_threads(lambda begin, end: rows(ctypes.c_size_t(begin), ctypes.c_size_t(end), ctypes.c_size_t(n), *pointers[:2],
                                                geometry, self.number(tolerance), *pointers[2:]), n)
        return results
