#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openings.py FOLDER: no comment opens with words that make its reader look for a subject.

A comment stands alone: editors and documentation tools show it without its neighbour. So it names its subject, or begins with
a verb ("Returns", "True if"). It does not open with "Of", "What", "Whether", "That", "Where" or "The same".
"""
import pathlib
import re
import sys

RULED_OUT = re.compile(r"(Of|What|Whether|That|Where|The same)\b")
TAGS = re.compile(r"^({{[^}]*}}+)+")  # of a template, in front of a comment
NOTE = re.compile(r"///<\s*[Tt]he same\b")  # behind a member; otherwise its words go on from the member's name
MARKS = {".py": r"#|\"\"\"", ".pyi": r"#|\"\"\"", ".sh": "#", ".cmake": "#", ".txt": "#", "": "#"}
BY_NAME = {"CMakeLists.txt", "qvgen"}
CODE = {".h", ".cpp", ".c", ".in", ".js", ".mjs", ".mustache", ".py", ".pyi", ".sh", ".cmake"}


def openings(text, mark=r"///?<?|/\*\*"):
    """Yields the line numbers of comments that open with a word that is ruled out; a blank line within one begins another."""
    was_comment = False
    for number, line in enumerate(text.splitlines(), 1):
        found = re.match(rf"\s*({mark})\s*(.*)", TAGS.sub("", line))
        words = found.group(2) if found else ""
        if NOTE.search(line) or (words and not was_comment and RULED_OUT.match(words)):
            yield number
        was_comment = bool(words)


def files_of(folder):
    """Yields all files whose comments are checked: those that people and templates write, and those that are generated."""
    yield folder / "qvgen"
    yield folder / "CMakeLists.txt"
    for part in ("generator", "runtime", "templates", "tests", "generated"):
        for path in sorted((folder / part).rglob("*")):
            if path.is_file() and (path.suffix in CODE or path.name in BY_NAME) and "__pycache__" not in path.parts:
                yield path


def main():
    assert list(openings("/// Of a joint.\n/// That one.\nint a;  ///< of a\n\n  // What is left.\n///\n/// Where it is.")) == [1, 5, 7]
    assert list(openings("{{/a}}{{#b}}/// The same.")) == [1]
    assert not list(openings("/// Returns what is left.\n/// Of course.\n/// Office hours.")), "a word within a comment"
    folder = pathlib.Path(sys.argv[1])
    failed = False
    for path in files_of(folder):
        text = path.read_text(encoding="utf-8")
        lines = text.splitlines()
        for number in openings(text, MARKS[path.suffix]) if path.suffix in MARKS else openings(text):
            print(f"{path.relative_to(folder)}:{number}: {lines[number - 1].strip()}")
            failed = True
    if failed:
        sys.exit("name the subject of these comments, or begin with a verb (CONTRIBUTING.md, Words)")


if __name__ == "__main__":
    main()
