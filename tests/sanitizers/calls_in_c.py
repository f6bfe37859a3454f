#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""calls_in_c.py HEADER...: a C program that calls every function of the generated headers of a robot, at random,
singular, unreachable and invalid inputs; each array on the heap in exactly the size that its declaration says, so that
the address sanitizer sees what goes beyond."""
import re
import sys

ROWS = 3  # for which a caller has room

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
    return eval("*".join(re.findall(r"\[(\d+)\]", argument.replace("[]", f"[{ROWS}]"))))  # digits alone


def on_heap(kind, word, start="malloc(sizeof *{word})"):
    """A declaration of `word`, the argument itself, and what frees it."""
    return [f"{kind} const {word} = {start.format(word=word)};"], word, [f"free({word});"]


def argument(text, functions, dof):
    """Statements that declare an argument, its value, and statements that free it; poses are those of `q` unless the kind
    says otherwise."""
    word = re.search(r"(\w+)\s*(?:\[[\d\]\[]*)?$", text).group(1)
    if "[" in text and text.startswith("const"):
        pose = word in ("orientation", "position") and size_of(text) in (3, 4)
        start = f"kind < 3 ? copy(reached.{word}, {size_of(text)}) : " if pose else ""
        return on_heap("double*", word, f"{start}drawn(kind, {size_of(text)})")
    if text == "int rows":
        return [], str(ROWS), []
    if re.match(r"int\* (branches|free_joints|meets)$", text):
        return on_heap("int*", word, f"malloc({ROWS} * sizeof(int))")
    if re.match(r"const double\* (geometry|inertia)$", text):
        return [], "NULL", []
    if "[" in text:
        rest = "".join(re.findall(r"\[\d*\]", text)[1:])
        start = f"malloc({size_of(text)} * sizeof(double))"
        declared, value, freed = on_heap("double*", word, start)
        return [f"double (*const {word}){rest} = {start};"] if rest else declared, value, freed
    if text == "const void* constants":  # of metrics: at most two numbers a joint
        return on_heap("double*", word, f"drawn(kind, {2 * dof})")
    if text.startswith("const double*"):
        return on_heap("double*", word, f"uniform() > 0 ? drawn(kind, {dof}) : NULL")
    if re.match(r"const \w+_solutions\* ", text):
        return solved(text[len("const "):].split("*")[0], word, functions, dof)
    if text.startswith("const"):
        return [], "&" + re.search(r"const (\w+)_(geometry|inertia|damping)\*", text).expand(r"\1_default_\2"), []
    if text.startswith("double "):
        return [], "1e-13" if word == "tolerance" else "9.80665" if word == "gravity" else "sample(kind)", []
    return on_heap(text.split("*")[0] + "*", word)


def solved(kind, word, functions, dof):
    """`argument` for the solutions of a pose."""
    declared, value, freed = on_heap(kind + "*", word)
    solver = kind.replace("_solutions", "_inverse_kinematics")
    name = next(each for each in functions if each.startswith(solver))  # of seven joints: given one of them
    return [*declared, "{", *call(name, functions, dof, {functions[name][-1]: word}), "}"], value, freed


def went_through(name, functions):
    """A statement that calls what goes on from where `name` starts, if there is such a function, up to 100 times."""
    next_one = re.sub("_start_(.*)s$", r"_next_\1", name)
    if next_one == name or next_one not in functions:
        return []
    state = functions[next_one][0].split("*")[1].strip()
    return [f"for (int k = 0; k < 100 && {next_one}({state}); ++k) continue;"]


def call(name, functions, dof, given={}):
    """Statements that call a function once, with the arguments that are `given`."""
    parts = [([], given[text], []) if text in given else argument(text, functions, dof) for text in functions[name]]
    before, values, after = zip(*parts) if parts else ((), (), ())
    return [*sum(before, []), f"{name}({', '.join(values)});", *went_through(name, functions), *sum(after, [])]


def is_called(name, arguments):
    """False for metrics, which take a function (tests/c/metrics_test.cpp), and for what goes on from a start."""
    return "_next_" not in name and not any(text.endswith("_metric metric") for text in arguments)


def main():
    texts = [open(header, encoding="utf-8").read() for header in sys.argv[1:]]
    includes = "\n".join(f'#include "{header}"' for header in sys.argv[1:])
    arm = next(text for text in texts if "_forward_kinematics(" in text)  # of a whole robot: a limb
    robot = re.search(r"enum \{ (\w+)_dof = ", arm).group(1)
    dof = max(map(int, re.findall(r"(?:_dof = |q\[\]\[)(\d+)", "".join(texts))))  # passive joints of loops among them
    print(HEAD.format(includes=includes))
    functions = {name: arguments for text in texts for _, name, arguments in prototypes(text)}
    called = [name for name, arguments in functions.items() if is_called(name, arguments)]
    print(f"int main(void) {{\n  for (int round = 0; round < 100; ++round) {{\n    const int kind = round % 5;\n"
          f"    double* const joints = drawn(kind, {dof});\n    {robot}_pose reached;\n"
          f"    {robot}_forward_kinematics(joints, &{robot}_default_geometry, &reached);\n"
          "    free(joints);\n    free(copy(reached.position, 3));")
    for name in called:
        print("    {\n      " + "\n      ".join(call(name, functions, dof)) + "\n    }")
    print(f'  }}\n  puts("{robot}: {len(called)} functions in C");\n  return 0;\n}}')


if __name__ == "__main__":
    main()
