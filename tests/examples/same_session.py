# SPDX-License-Identifier: MIT
"""same_session.py README HEADING: runs the commands of the indented blocks below a heading, lines that begin with "$ " or, of
Python, ">>> ", and compares what they print with the lines below them. "..." stands for any lines. Numbers may differ by two
units of their last digit."""
import contextlib
import io
import re
import subprocess
import sys

NUMBER = re.compile(r"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")


def blocks(readme, heading):
    """The lines of the indented blocks of a section."""
    section = readme.split("\n" + heading + "\n", 1)[1].split("\n## ", 1)[0]
    return [line[4:] for line in section.split("\n") if line.startswith("    ")]


def steps(lines):
    """Commands, each with the lines that are shown below it."""
    result = []
    for line in lines:
        if line.startswith(("$ ", ">>> ")):
            result.append((line, []))
        elif result:
            result[-1][1].append(line.rstrip())
    return result


def same(shown, printed):
    if NUMBER.sub("#", " ".join(shown.split())) != NUMBER.sub("#", " ".join(printed.split())):
        return False
    for a, b in zip(NUMBER.findall(shown), NUMBER.findall(printed)):
        mantissa, _, exponent = a.lower().partition("e")
        digits = len(mantissa.partition(".")[2])
        if abs(float(a) - float(b)) > 2.01 * 10.0 ** (int(exponent or 0) - digits) * (digits > 0):
            return False
    return True


def holds(shown, printed):
    """True if all shown lines come in this order; between two of them others may stand only where "..." does."""
    at, free = 0, False
    for line in shown:
        if line == "...":
            free = True
            continue
        while at < len(printed) and not same(line, printed[at]):
            if not free:
                return line, printed[at]
            at += 1
        if at == len(printed):
            return line, "nothing"
        at, free = at + 1, False
    return None if free or at == len(printed) else ("the end", printed[at])


def main():
    readme, heading = sys.argv[1:]
    names = {}
    for command, shown in steps(blocks(open(readme).read(), heading)):
        if command.startswith("$ "):
            done = subprocess.run(command[2:], shell=True, capture_output=True, text=True)
            output = done.stdout
            if done.returncode != 0:
                sys.exit(f"{command}\n{done.stderr}")
        else:
            with contextlib.redirect_stdout(io.StringIO()) as stream:
                exec(command[4:], names)
            output = stream.getvalue()
        wrong = holds(shown, [line.rstrip() for line in output.split("\n") if line.strip()]) if shown else None
        if wrong:
            sys.exit(f"{command}\nshown:   {wrong[0]}\nprinted: {wrong[1]}\n\n{output}")


main()
