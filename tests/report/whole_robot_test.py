#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""whole_robot_test.py TOOL QUAD.URDF WORK: the page of a whole robot in headless Chromium. Dragged tips are followed by their
limbs alone, a dragged base leaves tips in place as far as legs reach, and what is missed is said. Exit 77: chromium,
chromedriver or clang are missing."""
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import webdriver

tool, quad, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
lacking = webdriver.missing() + [name for name in ("clang", "wasm-ld") if shutil.which(name) is None]
if lacking:
    print("skipped: no", ", ".join(lacking))
    sys.exit(77)

# Two fingers on a palm that turns: they share its joint.
hand = 'name = "hand"\ntitle = "hand"\n[[joint]]\ntype = "revolute"\naxis = "+z"\nvariable = "palm"\nlink = [0, 0, 0.2]\n'
for finger, y, parent in (("a", "0.05", "palm"), ("b", "-0.05", "palm")):
    for joint, before in ((1, parent), (2, finger + "1")):
        hand += (f'[[joint]]\ntype = "revolute"\naxis = "+y"\nvariable = "{finger}{joint}"\nparent = "{before}"\n'
                 f'origin = [0, {y if joint == 1 else 0}, 0]\nlink = [0, 0, 0.3]\n')
hand += '[[tip]]\nname = "left"\njoint = "a2"\n[[tip]]\nname = "right"\njoint = "b2"\n'

# How far each tip is from its target, by the generated functions, and from the drawn limb's end.
gaps = """
const { live } = window;
const away = (a, b) => norm(subtract(a.p, b.p));
const drawn = live.skeletons();
return live.limbs.map((limb, i) => [away(live.tip(limb), live.targets[i]), away(live.tip(limb), drawn[i].tool)]);
"""


def report(folder, description, *options):
    subprocess.run([tool, "report", str(description), "--output", str(folder), *options], check=True, capture_output=True)


class WholeRobot(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        work.mkdir(parents=True, exist_ok=True)
        (work / "hand.toml").write_text(hand)
        report(work / "hand", work / "hand.toml")
        report(work / "quad", quad, "--floating")
        cls.browser = webdriver.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def tearDown(self):
        self.assertEqual(self.browser.said(), [])

    def open(self, robot):
        self.browser.open(work / robot / f"{robot}.html")
        self.browser.wait("return window.live?.limbs !== undefined")
        self.browser.run("document.getElementById('live').scrollIntoView()")
        self.settle()

    def settle(self):
        self.browser.run_async("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")

    def pull(self, target, dx, dy):
        """Drags the ball of a limb's target, or of the base (-1)."""
        x, y = self.browser.run("""
const box = document.getElementById("live-canvas").getBoundingClientRect();
const place = arguments[0] < 0 ? window.live.base : window.live.targets[arguments[0]];
const [x, y] = window.live.camera.place(place.p);
return [box.left + x, box.top + y];""", target)
        self.browser.drag([(x, y), (x + dx / 2, y + dy / 2), (x + dx, y + dy)])
        self.settle()

    def state(self):
        return self.browser.run("const { q, targets, base } = window.live; return { q, targets: targets.map((t) => t.p), base: base.p }")

    def status(self):
        return self.browser.run("return document.getElementById('live-status').textContent")

    def assert_in_place(self, tolerance=1e-9):
        for to_target, picture in self.browser.run(gaps):
            self.assertLess(to_target, tolerance)
            self.assertLess(picture, 1e-9)
        self.assertEqual(self.status(), "all tips are in place")

    def test_a_dragged_tip_moves_its_limb_alone(self):
        self.open("quad")
        for leg in range(4):
            with self.subTest(leg=leg):
                before = self.state()
                self.pull(leg, 5, -4)
                after = self.state()
                moved = [i for i, (a, b) in enumerate(zip(before["q"], after["q"])) if abs(a - b) > 1e-6]
                own = self.browser.run("return window.live.limbs[arguments[0]].places", leg)
                self.assertTrue(moved)
                self.assertLessEqual(set(moved), set(own))
                self.assertNotEqual(before["targets"][leg], after["targets"][leg])
                self.assertEqual(before["base"], after["base"])
                self.assert_in_place()

    def test_a_dragged_base_leaves_tips_in_place(self):
        self.open("quad")
        before = self.state()
        self.pull(-1, 4, 6)
        after = self.state()
        self.assertNotEqual(before["base"], after["base"])
        self.assertEqual(before["targets"], after["targets"])
        self.assertGreater(max(abs(a - b) for a, b in zip(before["q"], after["q"])), 1e-3)
        self.assert_in_place()
        self.browser.run("const { live } = window; live.moveTarget({ p: live.base.p, r: product(turnAbout([0, 0, 1], 0.05), live.base.r) })")
        self.settle()
        self.assertEqual(self.state()["targets"], before["targets"])
        self.assert_in_place()

    def test_tips_out_of_reach_are_said(self):
        self.open("quad")
        self.browser.run("const { live } = window; live.chosen = -1; live.moveTarget({ r: live.base.r, p: [0, 0, 5] })")
        self.settle()
        self.assertEqual(self.status(), "out of reach: fl_foot, fr_foot, hl_foot, hr_foot")
        self.assertEqual(self.browser.run("return window.live.q.filter(Number.isFinite).length"), 12)
        self.browser.run("window.live.moveTarget({ r: window.live.base.r, p: [0, 0, 0] })")
        self.settle()
        self.assert_in_place()

    def test_limbs_that_share_a_joint(self):
        self.open("hand")
        self.assertFalse(self.browser.run("return window.live.data.floating"))
        before = self.browser.run("const { live } = window; return live.tip(live.limbs[1]).p")
        self.browser.run("""
const { live } = window;
const q = live.limbs[0].own(live.q);
live.chosen = 0;
live.moveTarget(live.limbs[0].arm.pose([q[0] + 0.4, q[1] + 0.2, q[2] + 0.1]));""")
        self.settle()
        (dragged, _), (other, _) = self.browser.run(gaps)
        self.assertLess(dragged, 1e-9)
        self.assertGreater(other, 1e-3, "the palm turns about the axis between the fingers, which cannot make up for it")
        self.assertEqual(self.status(), "out of reach: right")
        self.assertEqual(self.browser.run("return window.live.targets[1].p"), before)

    def test_sliders_carry_the_tips(self):
        self.open("quad")
        before = self.state()
        self.browser.run("""
const slider = document.getElementById("live-joint-2");
slider.value = Number(slider.value) + 0.1;
slider.dispatchEvent(new Event("input"));""")
        self.settle()
        self.assertNotEqual(before["targets"][0], self.state()["targets"][0])
        self.assert_in_place()

    def test_keys_move_the_tip(self):
        self.open("quad")
        before = self.state()["targets"]
        self.browser.run("document.getElementById('live-canvas').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowUp', cancelable: true }))")
        self.settle()
        after = self.state()["targets"]
        self.assertGreater(after[0][2], before[0][2])
        self.assertEqual(after[1:], before[1:])

    def test_the_page_is_the_same_in_every_run(self):
        report(work / "again", work / "hand.toml")
        self.assertEqual((work / "again/hand.html").read_bytes(), (work / "hand/hand.html").read_bytes())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
