# SPDX-License-Identifier: MIT
"""The robots of the library, by their names; each is compiled when it is first asked for, and kept in a cache."""

import json

from .. import _build


def __dir__():
    counts = json.loads((_build.generated_folder / "operation_counts.json").read_text())
    return sorted(name for name in counts if "/" not in name)  # c/NAME is a robot's C


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    module = _build.build_module(name)
    globals()[name] = module
    return module
