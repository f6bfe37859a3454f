# SPDX-License-Identifier: MIT
"""Makes a family of a mechanism: every length of a description becomes a parameter, with its number as default.

    family.py robots/ankle.toml FOLDER     # FOLDER/ankle_any.toml, and FOLDER/ankle_any.h, which sets them

Zeros and tips stay. Masses go: only assemblies are looked at.
"""
import pathlib
import re
import sys

LENGTHS = re.compile(r"^(origin|link|at|length) = (.*?)( *#.*)?$")
NUMBER = re.compile(r'"[^"]*"|-?\d+\.?\d*')
LEFT_OUT = re.compile(r"^(mass|centre_of_mass|inertia|rotor_inertia) = ")
HEADER = """// The parameters of {name}.toml, in their order.
#pragma once
#include <array>
#include <qvgen/robots/{name}/assembly.h>
namespace qvgen::test::loops {{
struct Any_{base} {{
  static constexpr std::array<const char*, {count}> names{{{names}}};
  static constexpr std::array<double, {count}> usual{{{values}}};
  static robots::{name}::Geometry geometry(const std::array<double, {count}>& values) {{
    robots::{name}::Geometry g;
{sets}
    return g;
  }}
}};
}}  // namespace qvgen::test::loops
"""


class Family:
    def __init__(self, text):
        self.parameters = {}
        in_tip = False
        lines = []
        for line in text.splitlines():
            if line.startswith("[["):
                in_tip = line.startswith("[[tip]]")
            if not LEFT_OUT.match(line):
                found = None if in_tip else LENGTHS.match(line)
                lines.append(f"{found[1]} = {NUMBER.sub(self.parameter, found[2])}" if found else line)
        first = next(i for i, line in enumerate(lines) if line.startswith("[["))
        defaults = [f"{name} = {value}" for name, value in self.parameters.items()]
        self.lines = lines[:first] + ["[defaults]"] + defaults + [""] + lines[first:]

    def parameter(self, found):
        text = found[0].strip('"')
        value = self.value(text)
        if not value:
            return found[0]
        name = f"g{len(self.parameters) + 1}"
        self.parameters[name] = value
        return f'"{name}"'

    @staticmethod
    def value(text):
        """The number that a text is; None of a joint's name, whose value is a rod's length."""
        try:
            return float(eval(text, {"__builtins__": {}}, {"sqrt": lambda x: x**0.5}))
        except NameError:
            return None


def main(file, folder):
    base = pathlib.Path(file).stem
    name = base + "_any"
    family = Family(pathlib.Path(file).read_text())
    text = "\n".join(family.lines) + "\n"
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{name}.toml").write_text(text.replace(f'name = "{base}"', f'name = "{name}"', 1))
    parameters = family.parameters
    header = HEADER.format(name=name, base=base, count=len(parameters),
                           names=", ".join(f'"{each}"' for each in parameters),
                           values=", ".join(map(repr, parameters.values())),
                           sets="\n".join(f"    g.{each} = values[{i}];" for i, each in enumerate(parameters)))
    (folder / f"{name}.h").write_text(header)


main(*sys.argv[1:])
