#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pages_test.py TOOL SOURCE WORK: the pages of robots are whole, the same in every run, and need no network.

All robots with QVGEN_REPORT_ALL=1, else some of every kind. The tests of functions and of the browser use them too.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree as tree

tool, source, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
some = ["crx10ia", "finger", "iiwa14", "ns_arm", "pan_tilt", "puma560"]
robots = sorted(p.stem for p in (source / "generator/robots").glob("*.toml")) if os.environ.get("QVGEN_REPORT_ALL") else some
xhtml = "{http://www.w3.org/1999/xhtml}"


def report(folder, *names, fails=False):
    call = [tool, "report", *names, "--output", str(folder), "--generated", str(source / "generated")]
    result = subprocess.run(call, capture_output=True, text=True)
    if (result.returncode != 0) != fails:
        raise AssertionError(f"{call} gives {result.returncode}: {result.stderr}")
    return result.stderr


def remove(folder):
    for path in sorted(folder.rglob("*"), reverse=True):
        path.rmdir() if path.is_dir() else path.unlink()


def luminance(colour):
    parts = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [p / 12.92 if p <= 0.03928 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    low, high = sorted((luminance(a), luminance(b)))
    return (high + 0.05) / (low + 0.05)


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = work / "all"
        remove(cls.folder)
        report(cls.folder, *robots)
        cls.pages = {path.name: path.read_text() for path in cls.folder.glob("*.html")}
        cls.trees = {name: tree.fromstring(text) for name, text in cls.pages.items()}

    def test_every_robot_has_a_page(self):
        self.assertEqual(sorted(self.pages), sorted([r + ".html" for r in robots] + ["index.html", "comparison.html", "errata.html"]))

    def test_ids_are_unique_and_references_resolve(self):
        for name, root in self.trees.items():
            ids = [e.get("id") for e in root.iter() if e.get("id")]
            self.assertEqual(len(ids), len(set(ids)), name)
            for element in root.iter():
                for attribute in ("aria-labelledby", "aria-describedby", "for", "aria-controls"):
                    for target in (element.get(attribute) or "").split():
                        self.assertIn(target, ids, name)
                link = element.get("href")
                if link is None or link == "data:,":
                    continue
                page, _, anchor = link.partition("#")
                there = self.trees[page] if page else root
                if anchor:
                    self.assertIn(anchor, {e.get("id") for e in there.iter()})

    def test_nothing_comes_from_elsewhere(self):
        for name, root in self.trees.items():
            for element in root.iter():
                for attribute in ("src", "srcset", "data", "action", "poster"):
                    self.assertIsNone(element.get(attribute))
            outside = re.findall(r"""(?:url\(|@import|fetch\(|https?://)[^\s"'<)]*""", self.pages[name])
            self.assertEqual([u for u in outside if not u.startswith("http://www.w3.org/")], [])

    def test_structure_for_readers(self):
        for name, root in self.trees.items():
            self.assertEqual(root.get("lang"), "en")
            self.assertEqual(len(list(root.iter(xhtml + "main"))), 1)
            self.assertEqual(len(list(root.iter(xhtml + "h1"))), 1)
            before = 1
            for element in root.iter():
                heading = re.fullmatch(r"\{.*\}h([1-6])", element.tag)
                if heading:
                    self.assertLessEqual(int(heading[1]), before + 1, "a level of headings is left out")
                    before = int(heading[1])
            for svg in (e for e in root.iter() if e.tag.endswith("svg")):
                self.assertIn(svg.get("role"), ("img", "application"))
            for table in root.iter(xhtml + "table"):
                self.assertIsNotNone(table.find(xhtml + "caption"))
                widths = {len(row) for row in table.iter(xhtml + "tr")}
                self.assertLessEqual(len(widths), 1, name)

    def test_nothing_failed(self):
        for name, text in self.pages.items():
            for failed in (r"Not made:[^<]*", r"\bnan\b|\binf\b", r"clang[^<]* has failed[^<]*"):
                self.assertEqual(re.findall(failed, text), [], name)
            self.assertLess(len(text), 2_000_000)

    def test_contrast(self):
        style = next(iter(self.trees.values())).find(f".//{xhtml}style").text
        for block in re.findall(r":root \{(.*?)\}", style, re.S):
            colours = dict(re.findall(r"--([a-z-]+): (#[0-9a-f]{6})", block))
            for ink in ("ink", "soft", "accent"):
                for ground in ("paper", "shade"):
                    self.assertGreaterEqual(contrast(colours[ink], colours[ground]), 4.5, (ink, ground))
            self.assertGreaterEqual(contrast(colours["bar"], colours["paper"]), 3)
        self.assertEqual(len(re.findall(r":root \{", style)), 2, "light and dark")

    def test_every_run_writes_the_same(self):
        self.assertIn("2 made, 0 files changed", report(self.folder, "finger", "pan_tilt", "--force"))

    def test_what_has_not_changed_is_not_made_again(self):
        self.assertIn("0 made, 0 files changed", report(self.folder, *robots))
        page = self.folder / "pan_tilt.html"
        page.write_text("lost")
        self.assertIn("1 made, 1 files changed", report(self.folder, *robots))

    def test_without_a_compiler_the_page_says_what_to_install(self):
        folder = work / "still"
        remove(folder)
        subprocess.run([tool, "report", "pan_tilt", "--output", str(folder)], check=True, capture_output=True,
                       env={"PATH": "/nowhere"})
        page = (folder / "pan_tilt.html").read_text()
        self.assertIn("apt-get install clang lld", page)
        self.assertNotIn('id="live-data"', page)
        tree.fromstring(page)

    def test_times_stand_beside_counts(self):
        folder = work / "times"
        remove(folder)
        folder.mkdir(parents=True, exist_ok=True)
        times = {"median": 119.4, "lower_quartile": 114.1, "upper_quartile": 125.4, "ratio": 1}
        row = {"robot": "ns_arm", "level": "textbook", "formulation": "pairs", "result": "quaternion", "nanoseconds": times}
        (folder / "times.json").write_text(json.dumps({"machine": "a <fast> machine", "rows": [row]}))
        (folder / "counts.json").write_text(json.dumps({"rows": [row]}))
        report(folder, "ns_arm", "--times", str(folder / "times.json"))
        for page in ("ns_arm.html", "comparison.html"):
            text = (folder / page).read_text()
            tree.fromstring(text)
            self.assertIn("a &lt;fast&gt; machine", text)
            self.assertIn("119.4", text)
        self.assertIn("0 made", report(folder, "ns_arm", "--times", str(folder / "times.json")))
        self.assertIn("compare --time", report(folder, "ns_arm", "--times", str(folder / "counts.json"), fails=True))

    def test_printed_formulas_are_all_there(self):
        document = (source / "tests/errata/printed_equations.md").read_text()
        printed = sum(line.startswith("| ") for line in document.splitlines()) - document.count("\n|---")
        rows = list(self.trees["errata.html"].iter(xhtml + "tr"))
        self.assertEqual(sum(row.find(xhtml + "td") is not None for row in rows), printed)
        self.assertEqual(len(list(self.trees["errata.html"].iter(xhtml + "h3"))), document.count("\n### "))

    def test_one_robot_more(self):
        folder = work / "more"
        remove(folder)
        report(folder, "rr_planar")
        report(folder, "pan_tilt")
        index = (folder / "index.html").read_text()
        self.assertIn('href="rr_planar.html"', index)
        self.assertIn('href="pan_tilt.html"', index)

    def test_files_of_others_are_left_alone(self):
        folder = work / "taken"
        remove(folder)
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "index.html").write_text("mine")
        self.assertIn("index.html", report(folder, "ns_arm", fails=True))
        self.assertEqual([p.name for p in folder.glob("*.html")], ["index.html"])
        self.assertEqual((folder / "index.html").read_text(), "mine")

    def test_code_and_pages_have_folders_of_their_own(self):
        folder = work / "code"
        remove(folder)
        subprocess.run([tool, "generate", "pan_tilt", "--only", "model", "--quiet", "--output", str(folder)], check=True)
        before = sorted(p for p in folder.rglob("*"))
        self.assertIn("name another folder", report(folder, "ns_arm", fails=True))
        self.assertEqual(sorted(p for p in folder.rglob("*")), before)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
