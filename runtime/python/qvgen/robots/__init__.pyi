# SPDX-License-Identifier: MIT
from .. import Robot

def __getattr__(name: str) -> Robot: ...
