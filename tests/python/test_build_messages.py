# SPDX-License-Identifier: MIT
"""A sentence says what is missing for compiling a robot."""

import pytest

from qvgen import BuildError, _build


def compiler_that_says(folder, text):
    script = folder / "compiler"
    script.write_text(f"#!/bin/sh\necho \"{text}\" >&2\nexit 1\n")
    script.chmod(0o755)
    return [str(script)]


@pytest.mark.parametrize("said, sentence", [
    ("probe.cpp:1:10: fatal error: pybind11/pybind11.h: No such file or directory", "pybind11 is missing: pip install pybind11"),
    ("probe.cpp:1:10: fatal error: 'pybind11/pybind11.h' file not found", "pybind11 is missing"),
    ("detail/common.h:2:10: fatal error: Python.h: No such file or directory", "install python3-dev"),
    ("probe.cpp:2:10: fatal error: Eigen/Core: No such file or directory", "Eigen is missing"),
    ("cannot execute cc1plus", "cannot execute cc1plus")])
def test_missing_headers(tmp_path, said, sentence):
    with pytest.raises(BuildError, match=sentence):
        _build._check_compiler(compiler_that_says(tmp_path, said), [])


def test_no_compiler():
    with pytest.raises(BuildError, match="there is no compiler no-such-compiler: install g"):
        _build._check_compiler(["no-such-compiler"], [])


def test_real_compiler_without_pythons_headers():
    with pytest.raises(BuildError, match="is missing|are missing"):
        _build._check_compiler(["c++"], [])
