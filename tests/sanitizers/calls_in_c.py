#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""calls_in_c.py HEADER...: a C program that calls every function of the generated headers of a robot, at random,
singular, unreachable and invalid inputs; each array on the heap in exactly the size that its declaration says, so that
the address sanitizer sees what goes beyond."""
import re
import sys

HEAD = """#include <math.h>
#include <stdio.h>
#include <stdlib.h>
{includes}
static unsigned long long state = 1;
static double uniform(void) {{
  state = state * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(state >> 11) / 4503599627370496.0 - 1;
}}
/* By `kind`: random, right angles, next to them, far away, not finite. */
static double sample(int kind) {{
  const double right = 1.5707963267948966 * floor(4 * uniform());
  if (kind == 0) return 3 * uniform();
  if (kind == 1) return right;
  if (kind == 2) return right + 1e-7 * uniform();
  if (kind == 3) return 1e200 * uniform();
  return uniform() > 0 ? NAN : INFINITY;
}}
static double* drawn(int kind, size_t size) {{
  double* const values = malloc(size * sizeof *values);
  for (size_t i = 0; i < size; ++i) values[i] = sample(kind);
  return values;
}}
static double* copy(const double* values, size_t size) {{
  double* const result = malloc(size * sizeof *result);
  for (size_t i = 0; i < size; ++i) result[i] = values[i];
  return result;
}}
"""


def prototypes(text):
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
    for result, name, arguments in re.findall(r"^(void|int|double) (\w+)\(([^;{]*?)\);", text, flags=re.M):
        yield result, name, re.split(r",\s*", " ".join(arguments.split()))


def size_of(argument):
    return eval("*".join(re.findall(r"\[(\d+)\]", argument)))  # digits alone


def call(name, arguments, dof):
    """Statements that call a function once; poses are those of `q` unless the kind says otherwise."""
    before, values, after = [], [], []
    for argument in arguments:
        word = re.search(r"(\w+)\s*(?:\[[\d\]\[]*)?$", argument).group(1)
        if "[" in argument and argument.startswith("const"):
            pose = word in ("orientation", "position") and size_of(argument) in (3, 4)
            start = f"kind < 3 ? copy(tool.{word}, {size_of(argument)}) : " if pose else ""
            before.append(f"double* const {word} = {start}drawn(kind, {size_of(argument)});")
            values.append(word)
            after.append(f"free({word});")
        elif "[" in argument:
            dimensions = re.findall(r"\[\d+\]", argument)
            rest = "".join(dimensions[1:])
            kind = f"double (*const {word}){rest}" if rest else f"double* const {word}"
            before.append(f"{kind} = malloc({size_of(argument)} * sizeof(double));")
            values.append(word)
            after.append(f"free({word});")
        elif argument == "const void* constants":  # of metrics: at most two numbers a joint
            before.append(f"double* const {word} = drawn(kind, {2 * dof});")
            values.append(word)
            after.append(f"free({word});")
        elif argument.startswith("const double*"):
            before.append(f"double* const {word} = uniform() > 0 ? drawn(kind, {dof}) : NULL;")
            values.append(word)
            after.append(f"free({word});")
        elif argument.startswith("const"):
            values.append("&" + re.search(r"const (\w+)_(geometry|inertia|damping)\*", argument).expand(r"\1_default_\2"))
        elif argument.startswith("double "):
            values.append("1e-13" if word == "tolerance" else "9.80665" if word == "gravity" else "sample(kind)")
        else:
            kind = argument.split("*")[0]
            before.append(f"{kind}* const {word} = malloc(sizeof *{word});")
            values.append(word)
            after.append(f"free({word});")
    return before + [f"{name}({', '.join(values)});"] + after


def main():
    texts = [open(header, encoding="utf-8").read() for header in sys.argv[1:]]
    includes = "\n".join(f'#include "{header}"' for header in sys.argv[1:])
    robot, dof = re.search(r"enum \{ (\w+)_dof = (\d+)", texts[0]).groups()
    dof = int(dof)
    print(HEAD.format(includes=includes))
    count = 0
    print(f"int main(void) {{\n  for (int round = 0; round < 100; ++round) {{\n    const int kind = round % 5;\n"
          f"    double* const joints = drawn(kind, {dof});\n    {robot}_pose tool;\n"
          f"    {robot}_forward_kinematics(joints, &{robot}_default_geometry, &tool);\n"
          "    free(joints);\n    free(copy(tool.position, 3));")
    for text in texts:
        for _, name, arguments in prototypes(text):
            if any(argument.endswith("_metric metric") for argument in arguments):
                continue  # it takes solutions and a function: tests/c/metrics_test.cpp
            count += 1
            print("    {\n      " + "\n      ".join(call(name, arguments, dof)) + "\n    }")
    print(f'  }}\n  puts("{robot}: {count} functions in C");\n  return 0;\n}}')


if __name__ == "__main__":
    main()
