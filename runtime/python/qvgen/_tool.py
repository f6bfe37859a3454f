# SPDX-License-Identifier: MIT
"""Finds the tool, which derives robots: that of the package, of the source tree or of the system. Runs it for reports."""

import os
import shutil
import subprocess

from ._library import ROOT, BuildError

_PLACES = (ROOT / "bin/qvgen", ROOT / "build/release/generator/cli/qvgen")


def own_tool():
    """Path of the tool of the package or of the source tree; None if there is none."""
    return next((each for each in _PLACES if each.exists()), None)


def tool():
    """Path of the tool: QVGEN_TOOL, that of the package or of the source tree, or one on the path."""
    found = os.environ.get("QVGEN_TOOL") or own_tool() or shutil.which("qvgen")
    if found is None:
        raise BuildError("there is no tool qvgen: run ./qvgen generate once, or set QVGEN_TOOL")
    return found


def report_of(command, inputs, output, options):
    """Runs a command that measures an arm, `calibrate` or `identify`; returns its report."""
    written = [] if output is None else ["-o", output]
    done = subprocess.run([str(each) for each in [tool(), command, *inputs, *written, *options]],
                          capture_output=True, text=True)
    if done.returncode != 0:
        raise BuildError(done.stderr)
    return done.stdout
