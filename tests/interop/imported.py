# SPDX-License-Identifier: MIT
"""What `qvgen import` reads of a file, moved by plain matrices: the side of qvgen in comparisons with other readers.

    description, run = ...   # description.links(values), mass_matrix(values), gravity_torque(values, fall)
"""
import importlib.util
import math
import pathlib
import re
import subprocess
import tomllib

import numpy as np
from try_files import Run, proposed_options

ALLOWED = 1e-9  # differences of poses, m, and of masses, as shares of the largest entry


def number(entry):
    """A number or an expression of a description, angles in radians."""
    if not isinstance(entry, str):
        return float(entry)
    text = re.sub(r"([^\s+-][^+-]*?)\s*deg\b", r"(\1)*(pi/180)", entry).replace("^", "**").replace(" rad", "")
    return float(eval(text, {"__builtins__": {}}, {"pi": math.pi, "sqrt": math.sqrt, "sin": math.sin, "cos": math.cos}))


def axis_of(entry):
    if not isinstance(entry, str):
        return np.array([number(x) for x in entry])
    return np.eye(3)["xyz".index(entry[-1])] * (-1 if entry[0] == "-" else 1)


def rotation(axis, angle):
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def transform(turn, position):
    result = np.eye(4)
    result[:3, :3], result[:3, 3] = turn, position
    return result


def frame_of(table, key):
    turn = np.eye(3)
    for each in table.get("turns", []):
        turn = turn @ rotation(axis_of(each["axis"]), number(each["angle"]))
    return transform(turn, [number(x) for x in table.get(key, [0, 0, 0])])


class Description:
    """A description as qvgen has written it, moved by plain matrices."""

    def __init__(self, text):
        self.table = tomllib.loads(text)
        self.joints = self.table["joint"]

    def links(self, values):
        """Axis (None: a slide's), a point on it, and frame of every link; last the tool's frame."""
        at = frame_of(self.table.get("base", {}), "translation")
        result = []
        for joint, value in zip(self.joints, values):
            at = at @ frame_of(joint, "origin")
            axis, point = at[:3, :3] @ axis_of(joint["axis"]), at[:3, 3].copy()
            turns = joint["type"] == "revolute"
            local = axis_of(joint["axis"])
            at = at @ (transform(rotation(local, value), [0, 0, 0]) if turns else transform(np.eye(3), value * local))
            at = at @ transform(np.eye(3), [number(x) for x in joint.get("link", [0, 0, 0])])
            result.append((turns, axis, point, at))
        return result, at @ frame_of(self.table.get("tool", {}), "translation")

    def bodies(self, values):
        """Mass, Jacobians of the centre and of the turn, and tensor of inertia of every link that has a mass."""
        links, _ = self.links(values)
        for i, (joint, (_, _, _, at)) in enumerate(zip(self.joints, links)):
            if "mass" not in joint:
                continue
            centre = at[:3, :3] @ [number(x) for x in joint.get("centre_of_mass", [0, 0, 0])] + at[:3, 3]
            xx, yy, zz, xy, yz, xz = ([number(x) for x in joint.get("inertia", [0, 0, 0])] + [0, 0, 0])[:6]
            tensor = at[:3, :3] @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ at[:3, :3].T
            linear, angular = np.zeros((3, len(links))), np.zeros((3, len(links)))
            for k, (turns, axis, point, _) in enumerate(links[: i + 1]):
                linear[:, k] = np.cross(axis, centre - point) if turns else axis
                angular[:, k] = axis if turns else 0
            yield number(joint["mass"]), linear, angular, tensor

    def mass_matrix(self, values):
        size = len(self.joints)
        return sum((mass * linear.T @ linear + angular.T @ tensor @ angular
                    for mass, linear, angular, tensor in self.bodies(values)), np.zeros((size, size)))

    def gravity_torque(self, values, fall):
        """Forces of the joints that hold the chain at rest, by the acceleration of free fall."""
        return sum((-mass * linear.T @ fall for mass, linear, _, _ in self.bodies(values)), np.zeros(len(self.joints)))


def imported(tool, path):
    """The description, the run, and nothing where qvgen refuses the file."""
    words = [tool, "import", str(path), "--snap", "off"]
    run = subprocess.run(words, capture_output=True, text=True, timeout=60)
    if run.returncode != 0:
        check = Run([tool, "check", str(path)], 60)
        run = subprocess.run(words + proposed_options(check), capture_output=True, text=True, timeout=60)
    return run if run.returncode == 0 else None


def base_and_tip(description):
    """The frames between which the chain lies, by their names in the file."""
    return re.fullmatch(r".*, (.*?) to (.*)", description.table["title"]).groups()


def frames_of(description, links):
    """(name, pose) of the frames of a description whose links are there."""
    variables = [joint["variable"] for joint in description.joints]
    for frame in description.table.get("frame", []):
        link = links[variables.index(frame["joint"]) if "joint" in frame else -1][3]
        yield frame["name"], link @ frame_of(frame, "translation")


def difference_of_places(description, chain, links, tool_frame):
    """Largest difference of the tool's and the frames' poses from those of another reader's chain, m or of a matrix's entry."""
    largest = abs(tool_frame - chain.pose()).max()
    for name, here in frames_of(description, links):
        other = chain.frame(name)
        if other is not None:
            largest = max(largest, abs(here - other).max())
    return largest


def folders_of_packages(names):
    """Folders of those Python packages that are installed."""
    found = [importlib.util.find_spec(name) for name in names]
    return [pathlib.Path(spec.origin).parent for spec in found if spec is not None and spec.origin]


def report(peer, count, results):
    """Prints how many of `count` files were compared, and why others were not. `results`: (path, difference, has masses, why
    not). Returns the exit code: 1 if one differs, or of some files none could be compared."""
    compared = [result for result in results if not result[3]]
    with_masses = sum(result[2] for result in compared)
    print(f"{count} files, {len(compared)} compared with {peer}, {with_masses} of them with masses")
    left_out = {}
    for path, _, _, reason in results:
        if reason:
            left_out.setdefault(reason, []).append(path)
    for reason, paths in sorted(left_out.items(), key=lambda item: -len(item[1])):
        print(f"{len(paths):6}  not compared: {reason}  (e.g. {paths[0]})")
    wrong = [f"{path}: differs by {difference:.3g}" for path, difference, _, _ in compared if not difference < ALLOWED]
    print("\n".join(wrong))
    return 1 if wrong or (count and not compared) else 0
