# SPDX-License-Identifier: MIT
"""Writes a robot's vectors as Octave takes them: all calls of a function as columns of one file.

A file holds the arguments, then the results, as doubles in Octave's order; the program calls check_vectors.m for each.
"""
import math
import struct

WITH_USUAL_VALUE = ("gravity", "tolerance")  # these go behind all that has to be given


def number(text):
    return float(text[1:]) if text.startswith("#") else struct.unpack(">d", bytes.fromhex(text))[0]


def leaves(header, name, rows=None):
    """Fields of a struct in the order of C: (name, sizes, is a whole number, rows of a solution set or None)."""
    for type_, field, sizes in header.structs[name]:
        if type_ in ("double", "int"):
            yield field, sizes, type_ == "int", rows
        else:
            yield from leaves(header, type_, sizes[0] if sizes else rows)


def columns_of(values, sizes):
    """Numbers of an array of C, row by row, as Octave has them: the first index runs fastest."""
    a, b, c = (*sizes, 1, 1, 1)[:3]
    return [values[(i * b + j) * c + k] for k in range(c) for j in range(b) for i in range(a)]


def outputs(header, kinds, result):
    """[(sizes, rows)] of what a function gives, in Octave's order, and a function from a call's result to their numbers."""
    kind = kinds[-1]
    if kind[0] != "result" or isinstance(kind[2], list):
        sizes = kind[2] if kind[0] == "result" else []
        return [(sizes, None)], lambda values: [columns_of(values, sizes)]
    fields = list(leaves(header, kind[2]))
    names = [field[0] for field in fields]
    order = sorted(range(len(fields)), key=lambda i: 1 if fields[i][3] is None else 2 if fields[i][2] else 0)

    def read(values):
        values, found = list(values), [[] for _ in fields]
        plain = [i for i, field in enumerate(fields) if field[3] is None]
        in_rows = [i for i, field in enumerate(fields) if field[3] is not None]
        for i in plain:
            size = math.prod(fields[i][1])
            found[i], values = columns_of(values[:size], fields[i][1]), values[size:]
        for _ in range(int(found[names.index("count")][0]) if in_rows else 0):
            for i in in_rows:
                size = math.prod(fields[i][1])
                found[i], values = found[i] + columns_of(values[:size], fields[i][1]), values[size:]
        for i in in_rows:
            found[i] += [math.nan] * (math.prod(fields[i][1]) * fields[i][3] - len(found[i]))
        assert not values
        return [found[i] for i in order]

    return [(fields[i][1], fields[i][3]) for i in order], read


def arguments(kinds, call):
    """Arguments in Octave's order: (rows, numbers), rows 0 for what is left out."""
    given = []
    for (kind, name, size), values in zip(kinds, call["arguments"]):
        if kind in ("array", "optional", "number"):
            is_there = values != "none"
            given.append((kind == "number" and name in WITH_USUAL_VALUE, size or 1 if is_there else 0, [number(x) for x in values] if is_there else []))
    return [(rows, values) for _, rows, values in sorted(given, key=lambda each: each[0])]


def write(header, vectors, folder, made):
    """Files in the folder; returns the program that checks them."""
    folder.mkdir(parents=True, exist_ok=True)
    robot, lines = header.robot, [f"addpath('{made}');", f"qvgen_{header.robot}.build();", "failures = 0;"]
    functions = {name: (kinds, result) for name, kinds, result in header.functions}
    groups = {}
    for call in vectors["calls"]:
        if call["function"] in functions:
            rows = tuple(each[0] for each in arguments(functions[call["function"]][0], call))
            groups.setdefault((call["function"], rows), []).append(call)
    for i, ((name, rows), calls) in enumerate(groups.items()):
        kinds, result = functions[name]
        shapes, read = outputs(header, kinds, result)
        given = [arguments(kinds, call) for call in calls]
        wanted = [read([number(x) for x in call["result"]]) for call in calls]
        numbers = [x for k in range(len(rows)) for each in given for x in each[k][1]]
        numbers += [x for k in range(len(shapes)) for each in wanted for x in each[k]]
        file = folder / f"{robot}_{i}.bin"
        file.write_bytes(struct.pack(f"<{len(numbers)}d", *numbers))
        sizes = [([*shape] + ([capacity] if capacity else [])) or [1] for shape, capacity in shapes]
        lines.append(f"failures += check_vectors('{robot}', '{name}', '{file}', {len(calls)}, {list(rows)}, "
                     f"{{{', '.join(map(str, sizes))}}});")
    lines.append(f"printf('{robot}: {len(vectors['calls'])} vectors in Octave, %d failures\\n', failures);")
    return "\n".join([*lines, "exit(failures > 0);", ""])
