# SPDX-License-Identifier: MIT
"""Writes a C program that calls every public function of a robot and prints what it got and gave, bit by bit.

Poses are reached ones, ones out of reach, ones with NaN, and ones of joints at zero and at right angles, where arms are
singular. sin, cos and their like are recorded, so that a language with sines of its own can be held to the same bits.
"""
import math
import random

LIBRARY = {"sin": 1, "cos": 1, "tan": 1, "asin": 1, "acos": 1, "atan": 1, "cbrt": 1, "atan2": 2}

# Default tolerances of inverse kinematics.
TOLERANCES = {"double": 1e-13, "float": 1.78e-6}

HEAD = """#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
%(includes)s
typedef %(real)s real;
static int is_first;
static void number(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  printf("%%s%%016llx", is_first ? "" : ",", (unsigned long long)bits);
  is_first = 0;
}
static void whole(int x) { printf("%%s#%%d", is_first ? "" : ",", x); is_first = 0; }
static void numbers(const real* x, int count) { for (int i = 0; i < count; ++i) number(x[i]); }
static void wholes(const int* x, int count) { for (int i = 0; i < count; ++i) whole(x[i]); }
static void begin(const char* sign) { printf("%%s", sign); is_first = 1; }
"""


def recorded():
    lines = []
    for name, count in LIBRARY.items():
        parameters = ", ".join(f"double x{i}" for i in range(count))
        arguments = ", ".join(f"x{i}" for i in range(count))
        prints = " ".join(f"fprintf(stderr, \" %016llx\", bits_of(x{i}));" for i in range(count))
        lines.append(f"double recorded_{name}({parameters}) {{ const double y = {name}({arguments}); "
                     f"fprintf(stderr, \"{name}\"); {prints} fprintf(stderr, \" %016llx\\n\", bits_of(y)); return y; }}")
    return ("static unsigned long long bits_of(double x) { uint64_t b; memcpy(&b, &x, sizeof b); return b; }\n" +
            "\n".join(lines) + "\n")


def shim():
    """A header in front of the robot's own files, by which they call the recorded functions."""
    lines = ["#include <math.h>"]
    for name, count in LIBRARY.items():
        lines += [f"double recorded_{name}({', '.join(['double'] * count)});", f"#define {name} recorded_{name}"]
    return "\n".join(lines) + "\n"


class Driver:
    """`scalar` is double or float, whose numbers are printed as the doubles that they are."""

    def __init__(self, header, rounds, scalar="double"):
        self.header = header
        self.rounds = rounds
        self.scalar = scalar
        self.tolerance = TOLERANCES[scalar]
        self.random = random.Random(20261125)
        self.dof = header.numbers[header.robot + "_dof"]
        self.lines = []

    def text(self, includes):
        head = HEAD % {"real": self.scalar, "includes": "\n".join(f'#include "{each}"' for each in includes)}
        for name, kinds, result in self.header.functions:
            solves = kinds[-1][1] == "found"
            for round_ in range(self.rounds * (4 if solves else 1)):
                self.call(name, kinds, result, round_)
        if self.header.has_representatives():
            for round_ in range(2 * self.rounds):
                self.representatives(round_)
                self.metrics(round_)
        return head + recorded() + "int main(void) {\n" + "\n".join(self.lines) + "\n  return 0;\n}\n"

    def joints(self, round_):
        special = [0.0, math.pi / 2, math.pi]
        if round_ % 6 == 4:
            return [self.random.choice(special) for _ in range(self.dof)]
        if round_ % 6 == 5:
            return [self.random.choice(special) + self.random.choice([0, 1e-9, 1e-5]) for _ in range(self.dof)]
        return [self.random.uniform(-3, 3) for _ in range(self.dof)]

    def array(self, name, size, round_):
        if name == "q" or name == "seed":
            return self.joints(round_)
        if name == "direction":
            v = [self.random.gauss(0, 1) for _ in range(3)]
            return [x / math.sqrt(sum(y * y for y in v)) for x in v]
        if name in ("lower", "upper"):
            sign = -1 if name == "lower" else 1
            return [sign * self.random.uniform(2, 7) for _ in range(size)]
        return [self.random.uniform(-2, 2) for _ in range(size)]

    def number(self, name):
        if name == "gravity":
            return 9.81
        return self.tolerance if name == "tolerance" else self.random.uniform(-1.5, 1.5)

    def call(self, name, kinds, result, round_):
        robot, add = self.header.robot, self.lines.append
        add("  {")
        pose = any(kind[1] in ("orientation", "position") for kind in kinds)
        if pose:
            add(f"    const real at[] = {self.list(self.joints(round_))};")
            add(f"    {robot}_pose pose;")
            add(f"    {robot}_forward_kinematics(at, &{robot}_default_geometry, &pose);")
            if round_ % 12 == 7:
                add("    pose.position[1] += 100;")
            if round_ % 12 == 9:
                add("    pose.position[0] = NAN;")
        arguments, prints = [], []
        for i, (kind, own, size) in enumerate(kinds):
            if kind == "result":
                arguments.append(self.result_variable(size))
                continue
            text, printed = self.argument(kind, own, size, round_, i, pose)
            arguments.append(text)
            prints.append(printed)
        give = f"{robot}_{name}({', '.join(arguments)})"
        returns = result if result != "void" and kinds[-1][0] != "result" else ""
        add(f"    {'const ' + returns.replace('double', 'real') + ' given = ' if returns else '(void)' if result != 'void' else ''}{give};")
        add(f'    printf("%s", "{name}");')
        for printed in prints:
            add("    begin(\"|\"); " + printed)
        add('    begin("|="); ' + (f"{'number' if returns == 'double' else 'whole'}(given);" if returns
                                   else self.printed_result(kinds[-1][2])))
        add('    printf("\\n");')
        add("  }")

    def representatives(self, round_):
        """Goes through at most fifty rows within limits that admit several turns."""
        robot, add = self.header.robot, self.lines.append
        add("  {")
        add(f"    const real at[] = {self.list(self.joints(round_))};")
        for name in ("lower", "upper"):
            add(f"    const real {name}[] = {self.list(self.array(name, self.dof, round_))};")
        add(f"    {robot}_pose pose;")
        add(f"    {robot}_forward_kinematics(at, &{robot}_default_geometry, &pose);")
        add(f"    {robot}_solutions found;")
        add(f"    {robot}_representatives all;")
        add(f"    (void){robot}_inverse_kinematics(pose.orientation, pose.position, NULL, &{robot}_default_geometry, {self.tolerance}, &found);")
        add(f"    {robot}_start_representatives(&found, lower, upper, &all);")
        add('    printf("representatives"); begin("|"); numbers(pose.orientation, 4); begin("|"); numbers(pose.position, 3);')
        add(f'    begin("|"); numbers(lower, {self.dof}); begin("|"); numbers(upper, {self.dof}); begin("|=");')
        add(f"    for (int k = 0; k < 50 && {robot}_next_representative(&all); ++k) numbers(all.row.q, {self.dof});")
        add('    printf("\\n");')
        add("  }")

    def metrics(self, round_):
        """Sorts all rows by time, by weighted distance and by the largest joint; the least one's branch behind each order."""
        robot, add = self.header.robot, self.lines.append
        add("  {")
        add(f"    const real at[] = {self.list(self.joints(round_))}, seed[] = {self.list(self.joints(0))};")
        for name in ("speeds", "accelerations"):
            add(f"    const real {name}[] = {self.list([self.random.uniform(0.3, 3) for _ in range(self.dof)])};")
        add(f"    {robot}_drives drives;")
        add("    memcpy(drives.speeds, speeds, sizeof speeds); memcpy(drives.accelerations, accelerations, sizeof speeds);")
        add(f"    {robot}_pose pose;")
        add(f"    {robot}_forward_kinematics(at, &{robot}_default_geometry, &pose);")
        add('    printf("metrics"); begin("|"); numbers(pose.orientation, 4); begin("|"); numbers(pose.position, 3);')
        add(f'    begin("|"); numbers(seed, {self.dof}); begin("|"); numbers(speeds, {self.dof}); begin("|"); '
            f'numbers(accelerations, {self.dof}); begin("|=");')
        for metric, constants, within in (("fastest_time", "&drives", 0), ("weighted_distance", "speeds", 1),
                                          ("largest_joint", "accelerations", 0), ("largest_joint", "NULL", 0)):
            add(f"    {{ {robot}_solutions found;")
            add(f"    (void){robot}_inverse_kinematics(pose.orientation, pose.position, NULL, &{robot}_default_geometry, {self.tolerance}, &found);")
            add(f"    const {robot}_solution* best = {robot}_best_by(&found, seed, {within}, {robot}_{metric}, {constants});")
            add("    whole(best == NULL ? -2 : best->branch);")
            add(f"    {robot}_sort_by(&found, {'NULL' if constants == 'NULL' else 'seed'}, {within}, {robot}_{metric}, {constants});")
            add(f"    for (int k = 0; k < found.count; ++k) numbers(found.rows[k].q, {self.dof}); }}")
        add('    printf("\\n");')
        add("  }")

    def list(self, values):
        return "{" + ", ".join(float(v).hex() for v in values) + "}"

    def argument(self, kind, own, size, round_, i, pose):
        robot, name = self.header.robot, f"a{i}"
        if kind in ("geometry", "inertia"):
            return f"&{robot}_default_{kind}", f'printf("{kind}");'
        if kind == "usual":
            return "NULL", 'printf("none");'
        if kind == "number":
            self.lines.append(f"    const real {name} = {float(self.number(own)).hex()};")
            return name, f"number({name});"
        if pose and own in ("orientation", "position"):
            return f"pose.{own}", f"numbers(pose.{own}, {size});"
        if kind == "optional" and round_ % 3 == (0 if own == "seed" else 1):
            return "NULL", 'printf("none");'
        self.lines.append(f"    const real {name}[] = {self.list(self.array(own, size, round_))};")
        return name, f"numbers({name}, {size});"

    def result_variable(self, size):
        if isinstance(size, list):
            self.lines.append("    real result" + "".join(f"[{n}]" for n in size) + ";")
            return "result"
        self.lines.append(f"    {size} result;")
        return "&result"

    def printed_result(self, size):
        if isinstance(size, list):
            return "numbers((const real*)result, %d);" % math.prod(size)
        return self.printed_struct(size, "result")

    def printed_struct(self, struct, place):
        text = ""
        for type_, field, sizes in self.header.structs[struct]:
            own, count = f"{place}.{field}", math.prod(sizes)
            if type_ == "double":
                text += f"numbers((const real*){own}, {count}); " if sizes else f"number({own}); "
            elif type_ == "int":
                text += f"wholes((const int*){own}, {count}); " if sizes else f"whole({own}); "
            elif sizes:
                inner = self.printed_struct(type_, f"{own}[k]")
                text += f"for (int k = 0; k < {place}.count; ++k) {{ {inner} }} "
            else:
                text += self.printed_struct(type_, own)
        return text
