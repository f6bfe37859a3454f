# SPDX-License-Identifier: MIT
"""A sentence says what is missing for compiling a robot."""

import ctypes
import sys

import pytest

from qvgen import BuildError, _library


def compiler_that_says(folder, text):
    script = folder / "compiler"
    script.write_text(f"#!/bin/sh\necho \"{text}\" >&2\nexit 1\n")
    script.chmod(0o755)
    return [str(script)]


@pytest.mark.parametrize("said, sentence", [
    ("probe.cpp:1:10: fatal error: Eigen/Core: No such file or directory", "Eigen is missing"),
    ("probe.cpp:1:10: fatal error: 'Eigen/Core' file not found", "Eigen is missing"),
    ("cannot execute cc1plus", "cannot execute cc1plus")])
def test_functions_in_cxx(tmp_path, said, sentence):
    with pytest.raises(BuildError, match=sentence):
        _library.check_eigen(compiler_that_says(tmp_path, said), [])


def test_no_compiler():
    with pytest.raises(BuildError, match=r"there is no compiler no-such-compiler: pip install qvgen\[compiler\] brings one"):
        _library.check(["no-such-compiler"])


def test_the_compiler_that_pip_brings(tmp_path, monkeypatch):
    """Without a compiler of the system the one of the package ziglang is called, if it is installed."""
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(_library.shutil, "which", lambda name: None)
    assert _library.compiler("CC", "cc") == ["cc"] or _library.importlib.util.find_spec("ziglang")
    (tmp_path / "ziglang").mkdir()
    (tmp_path / "ziglang/__init__.py").write_text("")
    monkeypatch.syspath_prepend(tmp_path)
    assert _library.compiler("CC", "cc") == [sys.executable, "-m", "ziglang", "cc"]


def test_the_compilers_own_words_are_shown(tmp_path):
    with pytest.raises(BuildError, match="expected"):
        _library.linked(tmp_path / "made/x.so", ["cc"], [(("x.c", "int x"), ["-fPIC"])])
    assert list((tmp_path / "made").iterdir()) == []


def test_own_options_of_the_compiler(tmp_path, monkeypatch):
    """CFLAGS stand behind the options that every robot has, and make a library of their own."""
    (tmp_path / "arm.h").write_text("")
    (tmp_path / "arm.c").write_text("int plus(void) { return PLUS; }\n")
    monkeypatch.setenv("QVGEN_CACHE", str(tmp_path / "cache"))
    libraries = []
    for plus in (1, 2):
        monkeypatch.setenv("CFLAGS", f"-DPLUS={plus}")
        libraries.append(_library.c_library("arm", [tmp_path / "arm.c"], ""))
        assert ctypes.CDLL(str(libraries[-1])).plus() == plus
    assert libraries[0] != libraries[1]
