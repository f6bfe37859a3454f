# SPDX-License-Identifier: MIT
"""try_files.py with a stand-in for qvgen that hangs, crashes, fails a check of its own, refuses and proposes a tip."""
import pathlib
import subprocess
import sys
import tempfile
import textwrap

HERE = pathlib.Path(__file__).parent
STAND_IN = textwrap.dedent("""\
    #!/bin/sh
    case "$1 $2 $*" in
      *hang.urdf*) sleep 60 ;;
      *crash.urdf*) kill -SEGV $$ ;;
      generate*defect.urdf*) exit 70 ;;
      check*refused.urdf*) echo "$2:3:4: error: the link 'x7' is there twice; give each a name" >&2; exit 3 ;;
      *tips.urdf*--tip*"it's"*) ;;
      check*tips.urdf*) echo "$2:1:1: error: the chain may end at a, b; say where: qvgen check $2 --tip 'it'\\\\''s'" >&2
                        exit 3 ;;
      generate*partly.urdf*) echo "arm: no inverse: 3 joints of 'q' are symbols" >&2 ;;
    esac
    """)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        tool = folder / "stand_in"
        tool.write_text(STAND_IN)
        tool.chmod(0o755)
        for robot in ("hang", "crash", "refused", "tips", "partly", "defect", "good"):
            (folder / f"{robot}.urdf").write_text("<robot/>")
        (folder / "no_robot.xml").write_text("<html/>")
        run = subprocess.run([sys.executable, HERE / "try_files.py", folder, "--tool", tool, "--seconds", "1"],
                             capture_output=True, text=True, check=False)
    lines = [line.strip() for line in run.stdout.splitlines()]
    for wanted in ("7 files, 1 of them with a proposed tip", "3  generated", "1  refused", "1  check hung",
                   "1  check crashed", "1  generate defect"):
        assert wanted in lines, f"'{wanted}' is not in\n{run.stdout}{run.stderr}"
    assert any(line.startswith("1  refused: the link '...' is there twice") for line in lines), run.stdout
    assert any(line.startswith("1  no inverse: N joints of '...' are symbols") for line in lines), run.stdout
    assert run.returncode == 1


if __name__ == "__main__":
    main()
