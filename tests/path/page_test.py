#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""page_test.py TOOL WORK REPORT_TESTS: the page of a path is whole, valid, the same in every run, needs no network, and
draws the tool on the path: by its own script under node, and moved by hand in Chromium, where these are installed."""
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as tree

tool, work = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, sys.argv[3])
import webdriver


def rows():
    """Poses before a UR5, the last of which are out of its reach: x y z, roll pitch yaw in degrees."""
    for i in range(41):
        u = i / 40
        yield 0.4 + 0.9 * u, -0.3 + 0.5 * u, 0.25 + 0.1 * math.sin(3 * u), 180, 20 * u, 30 * u


def made(name, *options):
    work.mkdir(parents=True, exist_ok=True)
    lines = ["x [m],y [m],z [m],roll [deg],pitch [deg],yaw [deg]"] + [",".join(map(str, row)) for row in rows()]
    (work / "seam.csv").write_text("\n".join(lines) + "\n")
    call = [tool, "path", "ur5", "seam.csv", "-o", f"{name}.html", "-o", f"{name}.json", *options]
    subprocess.run(call, cwd=work, check=True, capture_output=True)
    return (work / f"{name}.html").read_text(), json.loads((work / f"{name}.json").read_text())


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page, cls.json = made("page", "--time", "6", "--joint-speeds", "2")
        cls.root = tree.fromstring(cls.page)
        cls.data = json.loads(re.search(r'id="path-data">(.*?)</script>', cls.page, re.DOTALL).group(1))

    def test_it_is_one_file_the_same_in_every_run(self):
        self.assertEqual(made("again", "--time", "6", "--joint-speeds", "2")[0], self.page)
        ids = [each.get("id") for each in self.root.iter() if each.get("id")]
        self.assertEqual(len(ids), len(set(ids)))
        self.assertEqual([each for each in re.findall(r'(?:src|href)="([^"]*)"', self.page) if each[0] != "#"], ["data:,"])

    def test_it_has_the_motions(self):
        self.assertEqual(len(self.data["motions"]), len(self.json["motions"]))
        for shown, motion in zip(self.data["motions"], self.json["motions"]):
            self.assertEqual(len(shown["q"]), len(motion["curve"]))
            self.assertAlmostEqual(shown["t"][-1], motion["least_time"], 5)
            for q, place in zip(shown["q"], motion["curve"]):
                self.assertLess(max(abs(a - b) for a, b in zip(q, place[1])), 1e-6)

    def test_times_stand_where_they_are_known(self):
        plain = json.loads(re.search(r'id="path-data">(.*?)</script>', made("plain")[0], re.DOTALL).group(1))
        self.assertNotIn("t", plain["motions"][0])

    @unittest.skipIf(shutil.which("tidy") is None, "no tidy")
    def test_it_is_valid(self):
        said = subprocess.run(["tidy", "-quiet", "-errors", "--show-info", "no", work / "page.html"], capture_output=True, text=True)
        self.assertEqual(said.stderr, "")

    @unittest.skipIf(shutil.which("node") is None, "no node")
    def test_the_tool_is_drawn_on_the_path(self):
        script = pathlib.Path(__file__).parent / "page_run.mjs"
        said = subprocess.run(["node", script, work / "page.html"], capture_output=True, text=True, check=True)
        poses, at_poses = list(rows()), 0
        for motion in json.loads(said.stdout):
            for s, *place in motion:
                if abs(s - round(s)) < 1e-9:
                    self.assertLess(math.dist(place, poses[round(s)][:3]), 1e-5)
                    at_poses += 1
        self.assertGreater(at_poses, 100)

    @unittest.skipIf(webdriver.missing(), "no " + ", ".join(webdriver.missing()))
    def test_the_arm_moves_in_a_browser(self):
        browser = webdriver.Browser()
        try:
            browser.open(work / "page.html")
            browser.wait("return window.player !== undefined")
            settle = "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))"
            browser.run("window.player.choose(1); window.player.moveTo(5)")
            browser.run_async(settle)
            self.assertEqual(browser.run("return document.getElementById('path-number').textContent"), "5.00")
            self.assertEqual(browser.run("return Number(document.getElementById('path-motion').value)"), 1)
            self.assertIn("motion 2", browser.run("return document.getElementById('path-status').textContent"))
            browser.run("document.getElementById('path-play').click()")
            browser.wait("return document.getElementById('path-play').textContent === 'play'")
            ends = self.data["motions"][1]["s"][-1]
            self.assertAlmostEqual(browser.run("return window.player.s"), ends, 5)
            browser.screenshot(work / "page.png")
            self.assertEqual(browser.said(), [])
        finally:
            browser.close()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
