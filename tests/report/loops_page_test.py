#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""loops_page_test.py TOOL SOURCE WORK: pages of mechanisms with closed loops. Every assembly that a page's functions find
closes in the page's picture, which is computed from the description alone; tips are where the functions say; a dragged tip
takes the motors along. Without clang and node pages are looked at as text, and the rest is skipped."""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import webdriver

tool, source, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
robots = source / "tests/loops/robots"
lacking = [name for name in ("clang", "wasm-ld", "node") if shutil.which(name) is None]
no_browser = lacking + webdriver.missing()
# The lengths of rods by the description; 0: points that are one.
mechanisms = {
    "five_bar": [0],
    "palletiser": [1, 1, 1.1],
    "ankle": [0.19, 0.29],
    "excavator": [0, 0, 0, 0.3],
}


def report(name, folder="pages", source_folder=robots):
    call = [tool, "report", str(source_folder / f"{name}.toml"), "--output", str(work / folder), "--force"]
    work.mkdir(parents=True, exist_ok=True)
    subprocess.run(call, check=True, capture_output=True)
    return (work / folder / f"{name}.html").read_text()


class LoopPages(unittest.TestCase):
    def test_the_derivation_and_a_drawing_are_there_without_a_compiler(self):
        page = report("five_bar")
        self.assertIn("2 freedoms, 2 driven", page)
        self.assertIn("left_elbow: loop 1: distance from the axis of right_elbow", page)
        self.assertEqual(page.count('class="turn"'), 4, "a symbol for each joint")
        self.assertRegex((work / "pages/index.html").read_text(), r'href="five_bar\.html"')

    def test_a_page_is_the_same_in_every_run(self):
        self.assertEqual(report("five_bar"), report("five_bar", "again"))

    def test_a_mechanism_without_a_closed_form_says_why(self):
        turns = "".join(f'[[joint]]\ntype = "revolute"\naxis = "+{axis}"\nvariable = "{variable}"\nlink = [0.3, 0, 0.1]\n'
                        for variable, axis in zip("abcd", "zyxy"))
        held = '[[loop]]\ntype = "ball"\nbetween = ["d", "base"]\nat = [[0, 0, 0], [0.4, 0.1, 0.1]]\n'
        work.mkdir(parents=True, exist_ok=True)
        (work / "held.toml").write_text(f'name = "held"\ntitle = "held"\nactuated = ["a"]\n{turns}{held}')
        page = report("held", "held", work)
        self.assertIn("loop 1 has no closed form: its axes are not all parallel", page)
        self.assertFalse('id="live-loops-data"' in page)
        self.assertEqual(page.count('class="turn"'), 4)

    @unittest.skipIf(lacking, "no " + ", ".join(lacking))
    def test_assemblies_close_in_the_picture(self):
        scripts = [source / f"templates/report/live_{name}.js" for name in ("motion", "arm", "loops")]
        for name, lengths in mechanisms.items():
            with self.subTest(mechanism=name):
                report(name)
                call = ["node", source / "tests/report/loops_run.mjs", work / "pages" / f"{name}.html", *scripts, "40"]
                found = json.loads(subprocess.run(call, check=True, capture_output=True, text=True).stdout)
                self.assertGreaterEqual(found["sets"], 10)
                self.assertGreaterEqual(found["assemblies"], 20)
                self.assertGreater(found["drags"], 10)
                self.assertLess(found["closed"], 1e-12)
                self.assertLess(found["tips"], 1e-12)
                self.assertLess(found["follow"], 1e-7)
                self.assertLess(found["dragged"] / found["drags"], 0.1)
                for length, wanted in zip(found["lengths"], lengths, strict=True):
                    self.assertAlmostEqual(length, wanted, delta=1e-9)


# The largest gap of the drawn ties, and how far the dragged tip is from a place.
state = """
const { live } = window;
const gaps = placedLinkage(live.data, live.q).ties.map(([a, b]) => norm(subtract(a, b)));
return { q: live.q, gap: Math.max(...gaps), tip: live.target.p, status: document.getElementById("live-status").textContent,
         pressed: [...document.querySelectorAll("#live-assemblies button")].map((b) => b.getAttribute("aria-pressed")) };
"""


@unittest.skipIf(no_browser, "no " + ", ".join(no_browser))
class LoopsInABrowser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        report("five_bar")
        cls.browser = webdriver.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def setUp(self):
        self.browser.open(work / "pages/five_bar.html")
        self.browser.wait("return window.live !== undefined")
        self.browser.run("document.getElementById('live').scrollIntoView()")
        self.settle()

    def tearDown(self):
        self.assertEqual(self.browser.said(), [])

    def settle(self):
        self.browser.run_async("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")

    def state(self):
        found = self.browser.run(state)
        self.assertLess(found["gap"], 1e-12)
        return found

    def test_a_motor_moves_the_mechanism_on_its_assembly(self):
        before = self.state()
        self.assertEqual(before["status"], "2 assemblies")
        self.assertEqual(sorted(before["pressed"]), ["false", "true"])
        self.browser.run("""
const slider = document.getElementById("live-joint-0");
slider.value = Number(slider.value) + 0.05;
slider.dispatchEvent(new Event("input"));""")
        self.settle()
        after = self.state()
        self.assertNotEqual(before["q"], after["q"])
        self.assertEqual(before["pressed"], after["pressed"])

    def test_a_button_goes_to_another_assembly(self):
        before = self.state()
        self.browser.run("document.querySelector('#live-assemblies button[aria-pressed=false]').click()")
        self.settle()
        after = self.state()
        self.assertNotEqual(before["pressed"], after["pressed"])
        self.assertGreater(max(abs(a - b) for a, b in zip(before["q"], after["q"])), 0.1)

    def test_a_dragged_tip_takes_the_motors_along(self):
        before = self.state()
        x, y = self.browser.run("""
const box = document.getElementById("live-canvas").getBoundingClientRect();
const [x, y] = window.live.camera.place(window.live.target.p);
return [box.left + x, box.top + y];""")
        self.browser.drag([(x, y), (x - 4, y - 4), (x - 8, y - 8)])
        self.settle()
        after = self.state()
        self.assertNotEqual(before["tip"], after["tip"])
        self.assertNotEqual(before["q"], after["q"])


if __name__ == "__main__":
    program = unittest.main(argv=sys.argv[:1], exit=False)
    if lacking and program.result.wasSuccessful():
        print("skipped: no", ", ".join(lacking))
        sys.exit(77)
    sys.exit(not program.result.wasSuccessful())
