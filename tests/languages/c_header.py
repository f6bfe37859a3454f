# SPDX-License-Identifier: MIT
"""Reads the public functions and structs of a generated C header.

The vectors of a robot are made and run by this list, so that a function that is added is tested without a word more.
"""
import re


class Header:
    """Functions as (name, [(kind, name, size)], result type), structs as {name: [(type, field, sizes)]}."""

    def __init__(self, robot, texts):
        self.robot = robot
        text = re.sub(r"\bfloat\b", "double", "\n".join(texts))  # C in float has the same functions
        text = re.sub(r"//[^\n]*|/\*.*?\*/|^#[^\n]*", "", text, flags=re.S | re.M)
        self.numbers = {}
        for body in re.findall(r"\benum\s*\{([^}]*)\}", text):
            self.numbers.update(enumerators(body))
        self.structs = {}
        for name, body in re.findall(r"typedef struct (\w+) \{(.*?)\}\s*\w+;", text, flags=re.S):
            self.structs[name] = self.fields(body)
        text = re.sub(r"typedef struct (\w+) \{(.*?)\}\s*\w+;", "", text, flags=re.S)
        self.functions = []
        self.left_out = []
        for result, name, parameters in re.findall(r"^(\w[\w ]*?)\s+(\w+)\(([^;{]*)\);", text, flags=re.S | re.M):
            self.add(result, name[len(robot) + 1:], [" ".join(p.split()) for p in parameters.split(",")])

    def has_representatives(self):
        """True if rows of a pose can be gone through within limits, whole turns counted."""
        plain = [("array", "orientation", 4), ("array", "position", 3)]
        return "next_representative" in self.left_out and any(
            name == "inverse_kinematics" and kinds[:2] == plain and kinds[2][1] == "seed"
            for name, kinds, _ in self.functions)

    def fields(self, body):
        fields = []
        for line in body.split(";"):
            found = re.match(r"\s*(const )?(\w+)\*?\s*(.*)", line.strip(), flags=re.S)
            if not found or not found.group(3):
                continue
            for declared in found.group(3).split(","):
                name, sizes = declarator(declared)
                fields.append((found.group(2), name, [self.size(s) for s in sizes]))
        return fields

    def size(self, text):
        return int(text) if text.isdigit() else self.numbers[text]

    def add(self, result, name, parameters):
        kinds = [self.kind(each) for each in parameters]
        last = kinds[-1]
        known = all(kinds) and all(kind[0] != "result" for kind in kinds[:-1])
        if not known or result == "void" and last[0] != "result":
            self.left_out.append(name)
            return
        self.functions.append((name, kinds, result))

    def kind(self, parameter):
        robot = self.robot
        if parameter == f"const {robot}_geometry* g":
            return ("geometry", "g", 0)
        if parameter == f"const {robot}_inertia* inertia":
            return ("inertia", "inertia", 0)
        if parameter == f"const {robot}_damping* damping":
            return ("usual", "damping", 0)
        if found := re.fullmatch(r"const double (\w+)\[(\d+)\]", parameter):
            return ("array", found.group(1), int(found.group(2)))
        if found := re.fullmatch(r"const double\* (\w+)", parameter):
            return ("optional", found.group(1), self.numbers[f"{robot}_dof"])
        if found := re.fullmatch(r"double (\w+)", parameter):
            return ("number", found.group(1), 0)
        if found := re.fullmatch(r"double (result)((?:\[\d+\])+)", parameter):
            return ("result", "result", [int(n) for n in re.findall(r"\d+", found.group(2))])
        if found := re.fullmatch(r"(\w+)\* (result|found)", parameter):
            return ("result", found.group(2), found.group(1))
        return None


def enumerators(body):
    values, next_value = {}, 0
    for each in body.split(","):
        name, _, value = each.partition("=")
        if name.strip():
            next_value = int(value) if value.strip() else next_value
            values[name.strip()] = next_value
            next_value += 1
    return values


def declarator(text):
    name = re.match(r"\s*\*?\s*(\w+)", text).group(1)
    return name, re.findall(r"\[(\w+)\]", text)
