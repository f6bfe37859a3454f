# SPDX-License-Identifier: MIT
"""The robots of the library, by their names; each is compiled when it is first asked for, and kept in a cache."""

import importlib


def _build():
    return importlib.import_module("qvgen._build")  # which needs NumPy; whoever builds a wheel may not have it


def __dir__():
    return sorted(_build().known_robots())


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    module = _build().known(name)
    globals()[name] = module
    return module
