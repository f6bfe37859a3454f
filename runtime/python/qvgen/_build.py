# SPDX-License-Identifier: MIT
"""Makes the module of a robot: the functions that its C and its C++ have, and what its headers say.

The library of its C is compiled when the module is made. Those of its C in float, and of what is in C++ only, are compiled when
a function of theirs is first called.
"""

import collections.abc
import ctypes
import difflib
import functools
import json
import pathlib
import re
import threading
import types

import numpy as np

from . import _functions, _inverse, _loops, _paths, _show
from ._c_rows import c_name
from ._call import Call, Constants
from ._cxx_rows import cxx_rows
from ._library import cxx_library
from ._loop_rows import Loops, loop_rows
from ._sources import GENERATED, KnownRobot, Sources, header_of, compiled_library
from ._tables import OF_A_BASE, VELOCITY, entry_of


class Robot:
    """Libraries of one robot, and what they say of it."""

    def __init__(self, name, sources, folder):
        self.name, self.sources, self._lock = name, sources, threading.Lock()
        counts = json.loads((folder / "operation_counts.json").read_text())
        self.entry = counts[f"c/{name}"]
        self.targets = self.entry.get("targets", {})
        self.header = header_of(name, folder)
        self._cxx_part(folder)
        numbers = {**self.loops.numbers, "dof": self.header.numbers["dof"]} if self.loops else None
        self.path = sources.packed_library() or compiled_library(name, folder, loop_numbers=numbers)
        self._libraries = {np.float64: ctypes.CDLL(str(self.path))}
        library = self._libraries[np.float64]
        self.facts = self.header.values(library)
        self.geometry = Constants("geometry", self.header.defaults(library, "geometry"))
        self.inertia = Constants("inertia", self.header.defaults(library, "inertia"))
        self.capacity = self.header.numbers.get("solutions_capacity")

    def _cxx_part(self, folder):
        """Finds what the robot has in C++ only."""
        lacks = {each["part"] for each in self.entry.get("missing", []) if each["kind"] == "not in this language"}
        functions = self.header.functions
        self.cxx_parts = {"nearest_pose"} if {"forward_kinematics", "jacobian"} <= functions.keys() else set()
        self.cxx_parts |= {"floating_base"} if "momentum_matrix" in functions else set()
        self.cxx_targets, self.cxx_missing, self.loops = {}, {}, None
        if lacks & {"arm_angle", "inverse"} or (folder / "c" / f"qvgen_{self.name}_loops.h").exists():
            entry = json.loads((self.sources.cxx() / "operation_counts.json").read_text())[self.name]
            self.cxx_parts |= {"arm_angle"} & entry.keys()
            self.cxx_targets = {name: taken for name, taken in entry.get("targets", {}).items() if name not in self.targets}
            header = self._cxx_header("assembly")
            self.loops = Loops(header.read_text()) if header.exists() else None
            self.cxx_missing = {each["part"]: each["reason"] for each in entry.get("missing", []) if each["part"] in lacks}

    def _cxx_header(self, part):
        return self.sources.cxx() / "include/qvgen/robots" / self.name / f"{part}.h"

    def given_count(self, name):
        """How many joints are given to a function of inverse kinematics."""
        if "_given_" not in name:
            return 0
        if name in self.targets:
            return self.header.functions[c_name(name, self.targets[name][0])].count("double given_")
        header = self._cxx_header("inverse").read_text()
        return re.search(rf"\b{name}\(([^;]*?)\);", header, flags=re.S)[1].count("double given_")

    def _compiled(self, kind):
        if kind == np.float32:
            return compiled_library(self.name, self.sources.c_in_float(), "float")
        generated = self.sources.cxx()
        given = {name: self.given_count(name) for name in self.cxx_targets}
        rows = cxx_rows(self.name, self.cxx_targets, given, self.cxx_parts)
        rows += loop_rows(self.name, self.loops) if self.loops else ""
        tips = self.loops.tips_with_parts(self.name) if self.loops else {}
        return cxx_library(self.name, generated, rows, generated == GENERATED, tips)

    def has_in_c(self, symbol):
        """True if the library of its C has a loop of that name."""
        return hasattr(self._libraries[np.float64], symbol)

    def function(self, symbol, dtype):
        """The loop of that name; compiles its library if it is the first call of one in float or in C++."""
        kind = dtype if dtype == np.float32 or self.has_in_c(symbol) else "cxx"
        with self._lock:
            if kind not in self._libraries:
                self._libraries[kind] = ctypes.CDLL(str(self._compiled(kind)))
        found = getattr(self._libraries[kind], symbol)
        found.restype, found.argtypes = ctypes.c_ssize_t, [ctypes.POINTER(Call)]
        return found


def _bound(robot):
    """Functions of a module by their names."""
    header, found = robot.header, {}
    # C has no function of the measures of an arm that has none: they are an empty array here.
    for name in {**header.functions, **({"singularity_measures": ""} if "singularity_measures" in robot.entry else {})}:
        if name in VELOCITY:
            found[name] = _functions.velocity(robot, name)
        elif entry_of(name):
            found[name] = _functions.plain(robot, name, entry_of(name))
    if "total_mass" in header.functions:
        found["total_mass"] = _functions.total_mass(robot)
    for name, taken in {**robot.targets, **robot.cxx_targets}.items():
        found[name] = _inverse.inverse(robot, name, taken, robot.given_count(name))
    if "arm_angle" in robot.cxx_parts:
        found.update({name: function for name, function in _inverse.arm_angle(robot).items()
                      if name != "inverse_kinematics" or name not in found})
    if "nearest_pose" in robot.cxx_parts:
        found["nearest_pose"] = _inverse.nearest_pose(robot)
    if "floating_base" in robot.cxx_parts:
        for name, entry in OF_A_BASE.items():
            found[name] = _functions.plain(robot, name, (*entry, True))
    return found | (_loops.loop_functions(robot) if robot.loops else {})


def _listed(robot, bound):
    """Says of each function of a module "here", and of each part that is missing why."""
    names = [name for name in robot.entry if name not in ("missing", "targets")]
    listed = {name: "here" if name in bound else "in C++ only" for name in [*names, *(name for name in bound if name not in OF_A_BASE)]}
    listed.pop("total_mass", None)
    served = {"arm_angle"} & robot.cxx_parts | ({"inverse"} if robot.cxx_targets else set()) | ({"assembly"} if robot.loops else set())
    missing = {each["part"]: each["reason"] for each in robot.entry.get("missing", []) if each["part"] not in served | bound.keys()}
    return {**listed, **missing, **robot.cxx_missing}


def _explain_absence(module):
    """Lets AttributeError say why a function is not there, and which ones come near."""
    def absent(name):
        if name.startswith("_"):
            raise AttributeError(f"{module.__name__} has no {name}")
        here = [function for function, place in module.functions.items() if place == "here"]
        near = [function for function in here if function.startswith(name)]
        near = near or difflib.get_close_matches(name, here, cutoff=0.8)
        reasons = [f"no {part}: {reason}" for part, reason in module.functions.items()
                   if reason not in ("here", "in C++ only")]
        known = module.functions.get(name)
        if known:
            raise AttributeError(f"{module.__name__} has no {name}: {known}")
        hints = [f"it has {', '.join(near)}"] if near else reasons
        text = f"{module.__name__} has no {name}"
        raise AttributeError("; ".join([text, *hints]))
    module.__getattr__ = absent


def _turns_of_motors(values):
    """The relation of joints and motors, taken out of the values of an arm, for orders of rows."""
    from .metrics import TurnsOfMotors
    is_revolute = [bool(each) for each in values.pop("joint_is_revolute")]

    def rows(name, columns):
        entries = values.pop(name)
        return [entries[i:i + columns] for i in range(0, len(entries), columns)]

    return TurnsOfMotors(rows("joints_by_motors", values["dof"]), rows("motors_by_joints", len(is_revolute)), is_revolute)


def _module(name, sources, folder):
    """The module of a robot whose C is in a folder."""
    robot = Robot(name, sources, folder)
    header, bound = robot.header, _bound(robot)
    module = types.ModuleType(name, header.robot)
    module.__file__ = str(robot.path)
    values = {**robot.facts, "dof": header.numbers["dof"], "default_geometry": robot.geometry.values}
    values["is_revolute"] = [bool(each) for each in values["is_revolute"]]
    if "joints_by_motors" in values:
        values["turns_of_motors"] = _turns_of_motors(values)
    if "mass_matrix" in bound:
        values["default_inertia"] = robot.inertia.values
    if "singularity_measures" in bound:
        values.setdefault("singularity_names", [])
    if header.frames:
        values["frame_names"] = header.frames
    if robot.loops:
        values.update(_loops.loop_values(robot.loops))
    if header.is_floating:
        values["velocity_size"] = header.numbers["velocity_size"]
    vars(module).update(values, functions=_listed(robot, bound), **bound)
    _explain_absence(module)
    return _show.with_plot(module)


def _with_paths(module, sources):
    """The module with the functions for which the tool reads the description: motions along paths, and the page."""
    source = (sources.description, *sources.options)

    @functools.wraps(_paths.paths)
    def paths(poses, **options):
        return _paths.paths(source, module, poses, **options)

    @functools.wraps(_show.show)
    def show(*, browser=True):
        return _show.show(source, module, browser=browser)

    module.paths, module.show = paths, show
    return module


def known_robots():
    """Names of the library's robots."""
    counts = json.loads((GENERATED / "operation_counts.json").read_text())
    return [name for name in counts if "/" not in name]


def known(name):
    """The module of a robot of the library."""
    if name not in known_robots():
        raise AttributeError(f"there is no robot {name}; there are {', '.join(known_robots())}")
    sources = KnownRobot(name)
    return _with_paths(_module(name, sources, sources.c()), sources)


def loaded(description, options):
    """The module of a described robot; with those of its limbs as `limbs`, which are compiled when they are asked for."""
    sources = Sources(pathlib.Path(description).resolve(), options)
    folder = sources.c()
    names = [each.removeprefix("c/") for each in json.loads((folder / "operation_counts.json").read_text())]
    robot = min(names, key=len)  # limbs are called after it
    module = _module(robot, sources, folder)
    module.limbs = Limbs(robot, [name for name in names if name != robot], sources, folder)
    return _with_paths(module, sources)


class Limbs(collections.abc.Mapping):
    """The modules of a robot's limbs by the names of their tips, compiled when they are asked for."""

    def __init__(self, robot, limbs, sources, folder):
        self._names = {name[len(robot) + 1:]: name for name in limbs}
        self._sources, self._folder = sources, folder
        self._modules = {}

    def __getitem__(self, tip):
        name = self._names[tip]
        if tip not in self._modules:
            self._modules[tip] = _module(name, self._sources, self._folder)
        return self._modules[tip]

    def __iter__(self):
        return iter(self._names)

    def __len__(self):
        return len(self._names)
