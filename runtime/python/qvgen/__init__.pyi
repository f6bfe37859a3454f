# SPDX-License-Identifier: MIT
import enum
import os
import pathlib
from typing import Any

from . import robots as robots

class BuildError(RuntimeError): ...

class Status(enum.IntEnum):
    solved = 0
    singular = 1
    unreachable = 2
    invalid = 3
    incomplete = 4

def cache_folder() -> pathlib.Path: ...
def load(description: str | os.PathLike[str], *options: str) -> Any: ...
