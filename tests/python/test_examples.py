# SPDX-License-Identifier: MIT
"""The example in Python runs as it stands."""

import pathlib
import subprocess
import sys

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "runtime/examples"


def test_arm():
    said = subprocess.run([sys.executable, EXAMPLES / "arm.py"], check=True, capture_output=True, text=True).stdout
    assert "solutions of 1000 poses" in said
