# SPDX-License-Identifier: MIT
"""simulated_machine.py MACHINE FOLDER: writes the configuration of a machine for LinuxCNC, whose motors are where they shall be.

Each machine starts with its tool pointing downwards.
"""

import json
import pathlib
import sys

MACHINES = {
    "puma560": {"coordinates": "XYZABC", "home": [10, -60, 20, 0, -140, -170], "slides": [], "direction": 0, "given": []},
    "gantry": {"coordinates": "XYZABCUVW", "home": [500, 100, 20, 40, 50, 0, 90, 0, 30], "slides": [0, 1], "direction": 0,
               "given": [0, 1, 8]},
    "five_axes": {"coordinates": "XYZBC", "home": [100, 50, 400, 20, 0], "slides": [0, 1, 2], "direction": -1, "given": []}}

INI = """[EMC]
VERSION = 1.1
MACHINE = {machine}
DEBUG = 0
[DISPLAY]
DISPLAY = ./drive.py
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[RS274NGC]
PARAMETER_FILE = simulation.var
[EMCMOT]
EMCMOT = motmod
COMM_TIMEOUT = 60
SERVO_PERIOD = 1000000
[HAL]
HALFILE = simulation.hal
[EMCIO]
EMCIO = io
CYCLE_TIME = 0.02
TOOL_TABLE = simulation.tbl
[KINS]
KINEMATICS = qvgen_{machine}_kins
JOINTS = {joints}
[TRAJ]
COORDINATES = {coordinates}
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
DEFAULT_LINEAR_VELOCITY = 200
MAX_LINEAR_VELOCITY = 400
MAX_ANGULAR_VELOCITY = 100
"""
MOVES = "MAX_VELOCITY = 500\nMAX_ACCELERATION = 5000\nMIN_LIMIT = -5000\nMAX_LIMIT = 5000\n"
JOINT = "[JOINT_{i}]\nTYPE = {type}\n" + MOVES + """FERROR = 50
MIN_FERROR = 50
HOME = {home}
HOME_OFFSET = {home}
HOME_SEARCH_VEL = 0
HOME_LATCH_VEL = 0
HOME_SEQUENCE = 0
"""
HAL = """loadrt [KINS]KINEMATICS
loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS
addf motion-command-handler servo-thread
addf motion-controller servo-thread
net enable iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in
net prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared
net change iocontrol.0.tool-change => iocontrol.0.tool-changed
net tool motion.tooloffset.z => {component}.tool-offset
"""


def main(machine, folder):
    facts = MACHINES[machine]
    joints = range(len(facts["home"]))
    text = INI.format(machine=machine, joints=len(joints), coordinates=facts["coordinates"])
    text += "".join(f"[AXIS_{axis}]\n{MOVES}" for axis in facts["coordinates"])
    text += "".join(JOINT.format(i=i, type="LINEAR" if i in facts["slides"] else "ANGULAR", home=facts["home"][i]) for i in joints)
    (folder / "simulation.ini").write_text(text)
    hal = HAL.format(component=f"qvgen_{machine}_kins")
    hal += "".join(f"net joint{i} joint.{i}.motor-pos-cmd => joint.{i}.motor-pos-fb\n" for i in joints)
    (folder / "simulation.hal").write_text(hal)
    (folder / "simulation.tbl").write_text("T1 P1 Z+50\n")
    (folder / "machine.json").write_text(json.dumps({**facts, "name": machine}))


main(sys.argv[1], pathlib.Path(sys.argv[2]))
