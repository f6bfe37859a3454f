# SPDX-License-Identifier: MIT
"""The type stubs say of every function what its module says."""

import ast
import inspect
import pathlib
import re

import qvgen

STUBS = pathlib.Path(qvgen.__file__).with_suffix(".pyi")


def stub_class(name):
    body = ast.parse(STUBS.read_text()).body
    return next(each for each in body if isinstance(each, ast.ClassDef) and each.name == name)


def signatures_of_stubs():
    """name: (arguments without self, those that only have a keyword, defaults)"""
    found = {}
    for each in stub_class("Robot").body:
        if isinstance(each, ast.FunctionDef) and each.name != "__getattr__":
            names = [one.arg for one in each.args.args[1:]]
            only = [one.arg for one in each.args.kwonlyargs]
            defaults = [ast.literal_eval(one) for one in [*each.args.defaults, *each.args.kw_defaults]]
            found[each.name] = (names, only, defaults)
    return found


def signature_of(function):
    """Returns the signature of a function of a module, from the first line of its docstring."""
    listed = re.match(r"\w+\((.*)\) ->", function.__doc__).group(1).split(", ")
    star = listed.index("*")
    name = [re.match(r"\w*", each).group(0) for each in listed]
    defaults = [ast.literal_eval(each.partition(" = ")[2]) for each in listed if " = " in each]
    return name[:star], name[star + 1:], defaults


def test_functions(ns, arm):
    stubs = signatures_of_stubs()
    seen = set()
    for robot in (ns, arm):
        for name, place in robot.functions.items():
            if place != "here":
                continue
            positional, only, defaults = signature_of(getattr(robot, name))
            if robot is arm and name in ("inverse_kinematics", "inverse_kinematics_near"):
                positional[0] = "pose"  # the stub's comment: a module says `target` where it takes less too
            assert stubs[name] == (positional, only, defaults), name
            seen.add(name)
    assert set(stubs) - seen == {"arm_angle", "inverse_kinematics_arm_angle", "paths", "plot", "show"}


def test_functions_of_the_arm_angle(iiwa14):
    stubs = signatures_of_stubs()
    for name in ("arm_angle", "inverse_kinematics_arm_angle"):
        assert stubs[name] == signature_of(getattr(iiwa14, name)), name


def test_paths(ns):
    stub = next(each for each in stub_class("Robot").body if isinstance(each, ast.FunctionDef) and each.name == "paths")
    source, robot, poses, *only = inspect.signature(ns.paths).parameters.values()
    assert [each.arg for each in stub.args.args] == ["self", poses.name]
    assert [each.arg for each in stub.args.kwonlyargs] == [each.name for each in only]
    assert [ast.literal_eval(each) for each in stub.args.kw_defaults] == [each.default for each in only]


def test_pictures(ns):
    for name in ("plot", "show"):
        stub = next(each for each in stub_class("Robot").body if isinstance(each, ast.FunctionDef) and each.name == name)
        given = inspect.signature(getattr(ns, name), follow_wrapped=False).parameters.values()
        assert [each.arg for each in [*stub.args.args[1:], *stub.args.kwonlyargs]] == [each.name for each in given]
        assert getattr(ns, name).__doc__


def test_values(arm):
    fields = {each.target.id for each in stub_class("Robot").body if isinstance(each, ast.AnnAssign)}
    own = {name for name in dir(arm) if not name.startswith("_") and not callable(getattr(arm, name))}
    assert own == fields


def test_package():
    tree = ast.parse(STUBS.read_text())
    named = {each.name for each in tree.body if isinstance(each, (ast.ClassDef, ast.FunctionDef))} | {"derivatives", "interop", "metrics", "orientation", "robots"}
    assert named - {"Robot"} == set(qvgen.__all__)
    for name in ("Solutions", "NearSolution", "Motion", "Paths", "Status", "JointRates", "VelocityStatus"):
        lines = stub_class(name).body
        fields = [each.target.id if isinstance(each, ast.AnnAssign) else each.targets[0].id for each in lines]
        members = getattr(qvgen, name)
        assert fields == list(getattr(members, "_fields", None) or members.__members__)
    stub = next(each for each in tree.body if isinstance(each, ast.FunctionDef) and each.name == "load")
    signature = inspect.signature(qvgen.load).parameters
    only = [each.arg for each in stub.args.kwonlyargs]
    assert [*(each.arg for each in stub.args.args), stub.args.vararg.arg, *only] == list(signature)


def test_the_oldest_python():
    """Every module is in the syntax of Python 3.9."""
    modules = sorted(pathlib.Path(qvgen.__file__).parent.rglob("*.py"))
    assert len(modules) > 15
    for module in modules:
        ast.parse(module.read_text(encoding="utf-8"), filename=str(module), feature_version=(3, 9))
