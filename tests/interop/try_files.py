#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Gives all robot files of folders to qvgen and says what hung, what was refused, and why, by kind.

    tests/interop/try_files.py FOLDER... [--tool build/ci/generator/cli/qvgen] [--seconds 60]

Each file is checked and generated, with a bound on the time of each command. Files that leave the tip open are
tried with the tip that the message proposes. The exit code is 1 if a command hung or crashed, or if qvgen said that a
check of its own has failed.
"""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import time

ENDINGS = {".urdf", ".xml", ".mjcf", ".xacro", ".toml"}
MARKS = (b"<robot", b"<mujoco", b"[[joint]]", b"[[dh]]", b"[[screw]]")
PARTS = "kinematics,inverse,dynamics"
DEFECT = 70  # how qvgen exits if a check of its own has failed


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="+", type=pathlib.Path, help="folders to search, or files")
    parser.add_argument("--tool", default=os.environ.get("QVGEN", "qvgen"), help="the qvgen to try; $QVGEN, qvgen")
    parser.add_argument("--seconds", type=float, default=60, help="bound on the time of a command")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="files at a time")
    parser.add_argument("--only", default=PARTS, help="parts to generate; empty: check alone")
    parser.add_argument("--ending", action="append", help="only files that end so, e.g. .urdf; may be repeated")
    parser.add_argument("--package-path", action="append", default=[], help="handed on to qvgen")
    parser.add_argument("--verbose", action="store_true", help="a line for each file")
    return parser.parse_args()


def robot_files(folders, endings):
    """All files that look like a robot's, each once, in order."""
    found = {}
    for folder in folders:
        for path in sorted(folder.rglob("*")) if folder.is_dir() else [folder]:
            if path.suffix in endings and path.is_file() and any(mark in path.read_bytes() for mark in MARKS):
                found.setdefault(path.resolve(), path)
    return list(found.values())


class Run:
    """A command that has ended, or was ended."""

    def __init__(self, words, seconds):
        begin = time.monotonic()
        process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
                                   stdin=subprocess.DEVNULL)
        try:
            output, error = process.communicate(timeout=seconds)
            self.hung = False
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            output, error = process.communicate()
            self.hung = True
        self.seconds = time.monotonic() - begin
        self.code = process.returncode
        self.lines = (error + output).decode(errors="replace").splitlines()

    @property
    def crashed(self):
        return not self.hung and self.code not in (0, 1, 3, DEFECT)

    @property
    def trouble(self):
        """Says what is wrong with the tool itself, empty if nothing."""
        return "hung" if self.hung else "crashed" if self.crashed else "defect" if self.code == DEFECT else ""

    def errors(self):
        return [line for line in self.lines if ": error: " in line or line.startswith("qvgen: ")]


def kind_of(line):
    """A message without what is of one file alone: places, names, numbers."""
    text = line.split(": error: ", 1)[-1]
    text = re.sub(r"^qvgen: ", "", text)
    if text.startswith("the chain may end at "):
        return "the chain may end at several places"
    text = re.sub(r"'[^']*'|\"[^\"]*\"|<[^>]*>", "'...'", text.split("; ")[0])
    text = re.sub(r"(from|between) \S+ (to|and) \S+", r"\1 ... \2 ...", text)
    return re.sub(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", "N", text)[:140]


def proposed_options(run):
    """--base and --tip of the command that a message proposes."""
    for line in run.errors():
        if "say where: qvgen check " in line:
            words = shlex.split(line.split("say where: qvgen check ", 1)[1])
            return words[1:]
    return []


def try_file(options, path):
    """(outcome, kind, notes): the outcome of a file, why, and what generate left out."""
    common = [word for folder in options.package_path for word in ("--package-path", folder)]
    check = Run([options.tool, "check", str(path), *common], options.seconds)
    tip = proposed_options(check)
    several = bool(tip)
    if tip:
        check = Run([options.tool, "check", str(path), *common, *tip], options.seconds)
    if check.trouble:
        return "check " + check.trouble, "", [], several
    if check.code != 0:
        return "refused", kind_of((check.errors() or check.lines or ["no word"])[0]), [], several
    if not options.only:
        return "checked", "", [], several
    with tempfile.TemporaryDirectory() as folder:
        words = [options.tool, "generate", str(path), *common, *tip, "--only", options.only, "--quiet", "-o", folder]
        generate = Run(words, options.seconds)
    if generate.trouble:
        return "generate " + generate.trouble, "", [], several
    left_out = [kind_of(line.split(": ", 1)[1]) for line in generate.lines
                if re.match(r"\S+: no \w+: ", line) and ": note: " not in line]
    if generate.code != 0:
        return "not generated", kind_of((generate.errors() or left_out or ["no word"])[0]), left_out, several
    return "generated", "", left_out, several


def print_kinds(title, kinds):
    if not kinds:
        return
    print(f"\n{title}")
    for kind, paths in sorted(kinds.items(), key=lambda item: (-len(item[1]), item[0])):
        print(f"{len(paths):6}  {kind}  (e.g. {paths[0]})")


def main():
    options = arguments()
    files = robot_files(options.folders, set(options.ending or ENDINGS))
    outcomes, refused, left_out, bad = collections.Counter(), {}, {}, []
    several = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for path, result in zip(files, pool.map(lambda path: try_file(options, path), files)):
            outcome, kind, missing, had_several = result
            outcomes[outcome] += 1
            several += had_several
            if kind:
                refused.setdefault(f"{outcome}: {kind}", []).append(path)
            for part in missing:
                left_out.setdefault(part, []).append(path)
            if outcome.endswith(("hung", "crashed", "defect")):
                bad.append((outcome, path))
            if options.verbose:
                print(f"{path}: {outcome} {kind} {'; '.join(missing)}", flush=True)
    print(f"{len(files)} files, {several} of them with a proposed tip")
    for outcome, count in outcomes.most_common():
        print(f"{count:6}  {outcome}")
    print_kinds("why, by kind", refused)
    print_kinds("left out of what was generated, by kind", left_out)
    for outcome, path in bad:
        print(f"\n{outcome}: {path}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
