# SPDX-License-Identifier: MIT
"""The stack that headers of C promise, beside the stack that GCC takes.

    python3 stack_test.py QVGEN FOLDER CC "LEVEL..." ROBOT...

A line "Stack: at most N bytes." is held against GCC's own graph of calls (-fcallgraph-info=su): the deepest chain of frames from each
public function, at levels of optimisation such as -O2, or -O3:_velocity for that of one file alone. Functions of libm are not
counted on either side. No level may warn of anything. Skipped where the compiler is not GCC.
"""
import pathlib
import re
import subprocess
import sys

SKIPPED = 77


def promised(header):
    """Bytes by the names of functions."""
    return {name: int(size) for size, name in re.findall(r"/// Stack: at most (\d+) bytes\.\n\w[\w ]*?[ *](\w+)\(", header)}


def frames_and_calls(graphs):
    """Bytes of each function's frame, and the functions that it calls, by GCC's graphs."""
    frames, calls = {}, {}
    for text in graphs:
        for name, label in re.findall(r'node: \{ title: "([^"]+)" label: "([^"]*)"', text):
            if found := re.search(r"(\d+) bytes \((static|dynamic,bounded)\)", label):
                frames[name] = int(found[1])
            elif "dynamic" in label:
                sys.exit(f"{name}: its stack has no bound: {label}")
        for source, target in re.findall(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', text):
            calls.setdefault(source, set()).add(target)
    return frames, calls


def deepest(name, frames, calls):
    """Bytes of the deepest chain from a function. GCC counts the return address in its frame."""
    return frames.get(name, 0) + max((deepest(each, frames, calls) for each in calls.get(name, ())), default=0)


def taken(cc, folder, sources, level, robot):
    """Bytes by the names of public functions, those of other files among those called."""
    graphs = []
    for source in sources:
        made = folder / f"{source.stem}{level}.o"
        options = ["-std=c99", "-Wall", "-Wextra", "-Werror", level, "-fcallgraph-info=su"]
        subprocess.run([cc, *options, "-c", source, "-o", made], check=True)
        graphs.append(made.with_suffix(".ci").read_text())
    frames, calls = frames_and_calls(graphs)
    # Static functions are "file:name" in the graph.
    return {name: deepest(name, frames, calls) for name in frames if name.startswith(robot + "_")}


def check(cc, levels, folder, robot):
    names = [f"qvgen_{robot}{part}" for part in ("", "_inverse", "_velocity")]
    sources = [path for path in (folder / "c" / f"{name}.c" for name in names) if path.exists()]
    said = {}
    for source in sources:
        said.update(promised(source.with_suffix(".h").read_text()))
    assert said, f"{robot}: no line says how much stack a function takes"
    failures, closest = 0, (0.0, "", "")
    for each in levels:
        level, _, part = each.partition(":")
        chosen = [path for path in sources if path.stem.endswith(part)]
        assert chosen, f"{robot} has no file {part}"
        for name, bytes_ in taken(cc, folder, chosen, level, robot).items():
            if name not in said:
                continue
            closest = max(closest, (bytes_ / said[name], name, level))
            if bytes_ > said[name]:
                failures += 1
                print(f"{name} {level}: {bytes_} bytes of stack, and its header says {said[name]}")
    print(f"{robot}: {len(said)} functions; {closest[1]} comes closest, with {closest[0]:.2f} of its bytes at {closest[2]}")
    return failures


def main(tool, folder, cc, levels, *robots):
    version = subprocess.run([cc, "--version"], capture_output=True, text=True).stdout
    if "Free Software Foundation" not in version:
        print(f"skipped: {cc} is not GCC, which says the stack of each function")
        sys.exit(SKIPPED)
    folder, failures = pathlib.Path(folder), 0
    for each in robots:
        subprocess.run([tool, "generate", each, "--language", "c", "--output", folder, "--quiet"], check=True)
        failures += check(cc, levels.split(), folder, pathlib.Path(each).stem)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
