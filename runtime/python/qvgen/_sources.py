# SPDX-License-Identifier: MIT
"""Finds the sources of a robot: its C and its C++, which the tool makes, or which come with the package.

NumPy is not needed here: whoever builds a wheel with compiled robots may not have it.
"""

import json
import re

from ._c_rows import c_rows
from ._header import Header
from ._library import HERE, ROOT, c_library, cache_folder, hash_of, run
from ._loop_rows_c import loop_rows_in_c
from ._tool import tool

GENERATED = ROOT / "generated"  # C++ of this source tree's robots


class Sources:
    """A description, as the tool takes it, and what is generated of it: C, C in float, C++."""

    def __init__(self, description, options=()):
        self.description, self.options = description, tuple(options)

    def folder(self, *more):
        """Folder of what the tool makes; it makes nothing anew that is up to date."""
        folder = cache_folder() / ("generated-" + hash_of([self.description, *self.options, *more]))
        run([tool(), "generate", self.description, "--output", folder, *self.options, *more])
        return folder

    def c(self):
        """Folder of its C and of its counts."""
        return self.folder("--language", "c")

    def c_in_float(self):
        """Folder of its C in float."""
        return self.folder("--language", "c", "--scalar", "float")

    def cxx(self):
        """Folder of its C++."""
        return self.folder()

    def packed_library(self):
        """Path of the library that comes with the package, if one does."""
        return None


class KnownRobot(Sources):
    """A robot of the library, by its name: what is in the package need not be made."""

    def c(self):
        packed = ROOT / "c" / self.description
        return packed if packed.exists() else super().c()

    def cxx(self):
        return GENERATED

    def packed_library(self):
        packed = HERE / "robots" / f"{self.description}.so"
        return packed if packed.exists() else None


def _files(name, folder, is_float):
    """Its C sources; inverse kinematics is called in double alone."""
    parts = ("", "_velocity") if is_float else ("", "_inverse", "_velocity")
    sources = [folder / "c" / f"qvgen_{name}{part}.c" for part in parts]
    return [each for each in sources if each.exists()]


def header_of(name, folder, is_float=False):
    """Reads the headers of a robot."""
    return Header(name, "\n".join(each.with_suffix(".h").read_text() for each in _files(name, folder, is_float)))


def loop_files(name, folder):
    """C sources of a robot's closed loops and of the limbs that they call; none without loops."""
    loops = folder / "c" / f"qvgen_{name}_loops.c"
    if not loops.exists():
        return []
    included = re.findall(rf'#include "(qvgen_{name}_\w+)\.h"', loops.read_text())
    return [folder / "c" / f"{each}.c" for each in included]


def compiled_library(name, folder, number="double", loop_numbers=None):
    """Path of the library of a robot's C, compiled if it is not there. `loop_numbers`: counts of joints, of closed loops."""
    files = _files(name, folder, number == "float")
    targets = json.loads((folder / "operation_counts.json").read_text())[f"c/{name}"].get("targets", {})
    header = header_of(name, folder, number == "float")
    rows = c_rows(header, [each.with_suffix(".h").name for each in files], targets, number)
    if loop_numbers:
        loops = loop_files(name, folder)
        rows += loop_rows_in_c(name, loops[0].with_suffix(".h").read_text(), loop_numbers)
        files = files + loops
    return c_library(name, files, rows)
