#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""layers.py RUNTIME: each header and source of the runtime includes only what its library may know (runtime/CMakeLists.txt).

The headers share one include folder, as they do once they are installed; this stands in for folders of their own."""
import pathlib
import re
import sys

LIBRARIES = re.compile(r"^qvgen_runtime_library\((\w+)([^)]*)\)", re.MULTILINE)
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"](qvgen/[^>"]+)[>"]', re.MULTILINE)
# Headers that do not stand where their library's do: they use the type of solutions.
ELSEWHERE = {"qvgen/assembly.h": "inverse", "qvgen/closed_arm.h": "inverse", "qvgen/loop_motion.h": "inverse", "qvgen/cubic_trajectory.h": "inverse", "qvgen/paden_kahan.h": "inverse"}


def needs_of(text):
    """Library -> all libraries that it may include, itself among them."""
    needs = {}
    for name, rest in LIBRARIES.findall(text):
        direct = re.search(r"NEEDS ([\w\s]+?)(?:SOURCES|$)", rest)
        known = {name}
        for each in direct.group(1).split() if direct else []:
            known |= needs[each]
        needs[name] = known
    return needs


def library_of_header(header, libraries):
    if header in ELSEWHERE:
        return ELSEWHERE[header]
    first, *rest = [part.removesuffix(".h") for part in header.split("/")[1:]]
    if first == "inverse" and rest[0] in libraries:
        return rest[0]
    return first if first in libraries else "core"


def wrong_includes(runtime):
    needs = needs_of((runtime / "CMakeLists.txt").read_text())
    files = {file: library_of_header(str(file.relative_to(runtime / "include")), needs)
             for file in (runtime / "include").rglob("*.h")}
    files |= {file: file.relative_to(runtime / "source").parts[0]
              for file in (runtime / "source").rglob("*") if file.suffix in (".h", ".cpp")}
    unknown = sorted(str(file) for file, library in files.items() if library not in needs)
    wrong = [f"{file}: no library {files[pathlib.Path(file)]}" for file in unknown]
    for file, library in sorted(files.items()):
        for header in INCLUDE.findall(file.read_text()):
            of = library_of_header(header, needs)
            if library in needs and of not in needs[library]:
                wrong.append(f"{file.relative_to(runtime)}: qvgen::{library} includes {header} of qvgen::{of}")
    return len(files), wrong


def main():
    count, wrong = wrong_includes(pathlib.Path(sys.argv[1]))
    print("\n".join(wrong) or f"{count} files include what their libraries may know")
    return 1 if wrong or count < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
