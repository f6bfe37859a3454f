# SPDX-License-Identifier: MIT
"""Pictures: drawn points lie on the axes of the arm, bones keep their lengths, pages open."""

import pathlib
import sys

import numpy as np
import pytest

import qvgen
from qvgen import _show


def test_points_of_a_planar_arm(planar):
    g = planar.default_geometry
    lengths = [g[name] for name in sorted(g)][:3]
    q = np.array([0.3, 0.7, -1.1])
    turns = np.cumsum(q)
    wanted = np.cumsum([[0, 0, 0], *([l * np.cos(t), l * np.sin(t), 0] for l, t in zip(lengths, turns))], axis=0)
    found = _show.skeleton(planar, q)
    # The base is on the first axis, so that it is there twice.
    np.testing.assert_allclose(found[1:], wanted, atol=1e-12)
    np.testing.assert_allclose(found[0], 0, atol=1e-12)


def test_a_joint_moves_what_is_behind_it(ns, rows):
    """Points up to a turning joint's axis stay; the others move with bones of the same lengths."""
    turning = [i for i, turns in enumerate(ns.is_revolute) if turns]
    for q in rows(ns, 20):
        before = _show.skeleton(ns, q)
        np.testing.assert_allclose(before[-1], ns.forward_kinematics(q)[4:], atol=0)
        for place, joint in enumerate(turning):
            moved = q.copy()
            moved[joint] += 0.8
            after = _show.skeleton(ns, moved)
            np.testing.assert_allclose(after[:place + 2], before[:place + 2], atol=1e-9)
            np.testing.assert_allclose(np.linalg.norm(np.diff(after, axis=0), axis=1),
                                       np.linalg.norm(np.diff(before, axis=0), axis=1), atol=1e-9)


def test_plot(ns, rows):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    q = rows(ns, 3)
    axes = ns.plot(q)
    assert len(axes.lines) == 3 and axes.get_xlabel() == "x [m]"
    drawn = np.array(axes.lines[1].get_data_3d()).T
    np.testing.assert_allclose(drawn, _show.skeleton(ns, q[1]), atol=1e-12)
    assert ns.plot(q[0], axes=axes) is axes and len(axes.lines) == 4
    axes.figure.canvas.draw()


def test_plot_says_what_is_wrong(ns, monkeypatch):
    with pytest.raises(ValueError, match=r"q has the shape \(2, 5\); it must be \(6,\) or \(n, 6\)"):
        ns.plot(np.zeros((2, 5)))
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match="pip install matplotlib"):
        ns.plot(np.zeros(6))


def test_show(arm, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    page = arm.show()
    assert isinstance(page, qvgen.Page) and page.path.name == f"{arm.__name__}.html"
    assert opened == [page.path.resolve().as_uri()]
    assert arm.joint_names[0] in page.path.read_text(encoding="utf-8")
    shown = page._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and "<html" not in shown  # escaped, as a value of an attribute is
    arm.show(browser=False)
    assert len(opened) == 1


def test_show_has_the_words_of_the_tool(arm, monkeypatch, tmp_path):
    tool = tmp_path / "qvgen"
    tool.write_text("#!/bin/sh\necho 'arm.urdf:3: no such link' >&2\nexit 1\n")
    tool.chmod(0o755)
    monkeypatch.setenv("QVGEN_TOOL", str(tool))
    with pytest.raises(qvgen.BuildError, match="no such link"):
        arm.show(browser=False)
