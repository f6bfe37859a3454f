#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""links.py FOLDER: every link of a page leads to a file or a heading that is there. Links out of the project are not tried."""
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)\s]+)\)")


def anchors(text):
    """Returns the anchors of a page's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    plain = (re.sub(r"[^\w\- ]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", each)) for each in headings)
    return {each.lower().replace(" ", "-") for each in plain}


def broken(page, link):
    """Returns why a link of a page leads nowhere; None if it leads somewhere."""
    name, _, anchor = link.partition("#")
    target = (page.parent / name).resolve() if name else page
    if not target.exists():
        return "no such file"
    if anchor and target.suffix == ".md" and anchor not in anchors(target.read_text(encoding="utf-8")):
        return "no such heading"
    return None


def prose(text):
    """Returns a page without its blocks of code."""
    return re.sub(r"^(    |\t).*$", "", re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL), flags=re.MULTILINE)


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    here = pathlib.Path(__file__).resolve()
    assert broken(here, "no_such_page.md") and not broken(here, here.name) and anchors("## A `b` (c)\n") == {"a-b-c"}
    pages = [*folder.glob("*.md"), *(page for part in ("generator", "runtime", "tests") for page in (folder / part).rglob("*.md"))]
    links = [(page, link) for page in sorted(pages) for link in LINK.findall(prose(page.read_text(encoding="utf-8")))]
    local = [(page, link) for page, link in links if not re.match(r"[a-z]+:", link)]
    faults = [f"{page.relative_to(folder)}: {link}: {fault}" for page, link in local if (fault := broken(page, link))]
    print(f"{len(local)} links of {len(pages)} pages")
    if faults or len(local) < 50:
        sys.exit("\n".join(faults) or "too few links")


if __name__ == "__main__":
    main()
