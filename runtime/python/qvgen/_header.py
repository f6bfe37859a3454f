# SPDX-License-Identifier: MIT
"""Reads what Python needs of a robot's C headers: numbers, functions, fields of its constants, arrays of names and limits."""

import ctypes
import math
import re

_TYPES = {"char*": ctypes.c_char_p, "int": ctypes.c_int, "double": ctypes.c_double, "float": ctypes.c_float}


class Header:
    """The headers of one robot, as text one behind the other."""

    def __init__(self, robot, text):
        self.robot = robot
        text = re.sub(r"//[^\n]*|/\*.*?\*/|^#[^\n]*", "", text, flags=re.S | re.M)
        own = re.escape(robot)
        self.functions = {name: " ".join(parameters.split())
                          for name, parameters in re.findall(rf"^\w+ {own}_(\w+)\(([^;{{]*)\);", text, flags=re.S | re.M)}
        self.arrays = re.findall(rf"extern const (char\*|int|double|float)(?: const)? {own}_(\w+)\[(\d+)\]", text)
        self.numbers = {"singularity_count": 0}
        self.numbers |= {name: int(value) for name, value in re.findall(rf"enum \{{ {own}_(\w+) = (\d+) \}}", text)}
        self.frames = re.findall(rf"{own}_frame_(\w+) = \d+", text)
        self.numbers.update({f"{what}_count": int(value) for what, value in
                             re.findall(rf"{own}_count_of_(link|frame)s = (\d+)", text)})
        self.is_floating = "double base[7]" in text or "float base[7]" in text
        self.numbers["velocity_size"] = self.numbers["dof"] + (6 if self.is_floating else 0)
        self.turns_move_motors = f"typedef struct {robot}_turns " in text
        self._structs = dict(re.findall(rf"typedef struct {own}_(\w+) \{{(.*?)\}}", text, flags=re.S))

    def constants(self, struct):
        """Names of the fields of the struct of geometry or inertia; none if all are numbers in the code."""
        return re.findall(r"(?:double|float) (\w+);", self._structs.get(struct, ""))

    def values(self, library):
        """Contents of the library's arrays, as lists by their names."""
        found = {}
        for type_, name, size in self.arrays:
            values = list((_TYPES[type_] * int(size)).in_dll(library, f"{self.robot}_{name}"))
            found[name] = [each.decode() for each in values] if type_ == "char*" else values
        return found

    def defaults(self, library, struct):
        """The description's values of constants, by name; inertias that it has not are zero, as in C++, where C has NaN."""
        names = self.constants(struct)
        values = (ctypes.c_double * len(names)).in_dll(library, f"{self.robot}_default_{struct}") if names else []
        return {name: 0.0 if struct == "inertia" and math.isnan(value) else value for name, value in zip(names, values)}
