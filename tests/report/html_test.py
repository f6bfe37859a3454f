#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""html_test.py PAGES: the pages are valid HTML, by HTML Tidy. Exit 77: tidy is missing (apt-get install tidy)."""
import pathlib
import re
import shutil
import subprocess
import sys

if shutil.which("tidy") is None:
    print("skipped: no tidy")
    sys.exit(77)

# Tidy knows a title of an SVG as that of a page only.
known = re.compile(r"<title> proprietary attribute \"id\"")
pages = sorted(pathlib.Path(sys.argv[1]).glob("*.html"))
assert len(pages) > 3, "no pages"
mistakes = []
for page in pages:
    said = subprocess.run(["tidy", "-quiet", "-errors", "--show-info", "no", str(page)], capture_output=True, text=True).stderr
    mistakes += [f"{page.name}: {line}" for line in said.splitlines() if line and not known.search(line)]
print("\n".join(mistakes) or f"{len(pages)} pages: valid")

# The test can fail.
broken = subprocess.run(["tidy", "-quiet", "-errors", "--show-info", "no"], input="<!DOCTYPE html><title>t</title><p><div></p>",
                        capture_output=True, text=True).stderr
sys.exit(1 if mistakes or not broken else 0)
