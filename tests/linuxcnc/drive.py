#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Stands where LinuxCNC has its display: drives a simulated machine and compares where its joints lead with the coordinates.

Where joints lead is said by the matrix of the robot's C, which the component does not use. Writes "MACHINE: passed" into `result`.
"""

import ctypes
import json
import math
import pathlib
import random
import subprocess
import time

import linuxcnc

MACHINE = json.loads(pathlib.Path("machine.json").read_text())
NAME, DOF, DIRECTION = MACHINE["name"], len(MACHINE["home"]), MACHINE["direction"]
ROBOT = ctypes.CDLL("./robot.so")
LETTERS = "XYZABCUVW"
command, status, errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()


def matrix_of(joints):
    """The tool's frame, millimetres."""
    values = [value * (0.001 if i in MACHINE["slides"] else math.pi / 180) for i, value in enumerate(joints[:DOF])]
    result = (ctypes.c_double * 16)()
    geometry = ctypes.byref(ctypes.c_char.in_dll(ROBOT, f"{NAME}_default_geometry"))
    getattr(ROBOT, f"{NAME}_homogeneous_transform")((ctypes.c_double * DOF)(*values), geometry, result)
    rows = [list(result[4 * i:4 * i + 4]) for i in range(3)]
    return [[*row[:3], 1000 * row[3]] for row in rows]


def rotation_of(coordinates):
    """c about z after b about y after a about x."""
    a, b, c = (math.radians(each) for each in coordinates[3:6])
    sa, ca, sb, cb, sc, cc = math.sin(a), math.cos(a), math.sin(b), math.cos(b), math.sin(c), math.cos(c)
    return [[cc * cb, cc * sb * sa - sc * ca, cc * sb * ca + sc * sa], [sc * cb, sc * sb * sa + cc * ca, sc * sb * ca - cc * sa],
            [-sb, cb * sa, cb * ca]]


def tip(joints, length):
    frame = matrix_of(joints)
    return [row[3] + length * row[2] for row in frame]


def poll():
    status.poll()
    return list(status.joint_position[:DOF]), list(status.position[:9])


def expect(holds, text):
    if holds:
        return
    while said := errors.poll():
        text += f"\nLinuxCNC: {said[1]}"
    raise AssertionError(f"{text}\n{poll()}")


def distance(one, other):
    return max(abs(x - y) for x, y in zip(one, other))


def joints_lead_to(coordinates, length, text):
    joints, _ = poll()
    frame, wanted = matrix_of(joints), rotation_of(coordinates)
    expect(distance(tip(joints, length), coordinates) < 1e-5, f"{text}: the tip is elsewhere: {tip(joints, length)}, {coordinates}")
    for i, value in zip(MACHINE["given"], coordinates[6:]):
        expect(abs(joints[i] - value) < 1e-5, f"{text}: joint {i} is not the coordinate {value}")
    for row, turned in zip(frame, wanted):
        apart = distance(row[:3], turned) if DIRECTION == 0 else abs(DIRECTION * row[2] - turned[2])
        expect(apart < 1e-7, f"{text}: the tool points elsewhere: {frame}, {wanted}")


def do(text, call, *arguments):
    call(*arguments)
    expect(command.wait_complete(60) == linuxcnc.RCS_DONE, f"{text} is not done")


def in_joints(is_so):
    """Joints move by themselves, or by coordinates, which are found anew."""
    do("mode", command.mode, linuxcnc.MODE_MANUAL)
    do("world", command.teleop_enable, 0 if is_so else 1)
    time.sleep(0.2)


def on_the_line(begin, end, length, joints):
    """How far the tip is from the line between two places."""
    place = tip(joints, length)
    along = [y - x for x, y in zip(begin[:3], end[:3])]
    size = sum(each * each for each in along)
    share = min(1, max(0, sum((p - x) * each for p, x, each in zip(place, begin, along)) / size))
    return math.dist(place, [x + share * each for x, each in zip(begin, along)])


def move(target, length, text):
    """Moves to coordinates of the tip, by a straight line, on which every sample lies."""
    begin = tip(poll()[0], length)
    command.mdi("G1 F6000 " + " ".join(f"{letter}{target[i]:.9f}" for i, letter in enumerate(LETTERS) if letter in MACHINE["coordinates"]))
    samples = 0
    while command.wait_complete(0.002) == -1:
        joints, _ = poll()
        apart = on_the_line(begin, target, length, joints)
        expect(apart < 0.01, f"{text}: {apart} mm beside the line")
        samples += 1
    time.sleep(0.05)
    joints_lead_to(target, length, text)
    return samples


def moves(coordinates, length, text, count):
    generator, samples, before = random.Random(1), 0, poll()[0]
    for i in range(count):
        target = [each + generator.uniform(-40, 40) for each in coordinates[:3]]
        target += [each + generator.uniform(-10, 10) * (letter in MACHINE["coordinates"]) for letter, each in zip(LETTERS[3:], coordinates[3:])]
        samples += move(target, length, f"{text} {i}")
        expect(distance(poll()[0], before) < 170, f"{text} {i}: the arm has turned over")
    move(coordinates, length, f"{text}, back")
    # The turn of a vertical tool that has only a direction is where the last tilted one was.
    expect(distance(poll()[0], before) < (1e-3 if DIRECTION else 1e-4), f"{text}: joints of another branch")
    return samples


def start():
    """Switches the machine on, and goes home with its tool pointing downwards."""
    do("reset", command.state, linuxcnc.STATE_ESTOP_RESET)
    do("on", command.state, linuxcnc.STATE_ON)
    do("mode", command.mode, linuxcnc.MODE_MANUAL)
    do("home", command.home, -1)
    for _ in range(100):
        time.sleep(0.05)
        status.poll()
        if all(status.homed[:DOF]):
            break
    expect(distance(poll()[0], MACHINE["home"]) < 1e-9, "not at home")


def without_a_tool():
    in_joints(False)
    coordinates = poll()[1]
    joints_lead_to(coordinates, 0, "home")
    do("mode", command.mode, linuxcnc.MODE_MDI)
    return moves(coordinates, 0, "without a tool", 3)


def with_a_tool_that_stays():
    """Joints stay when its length is switched, the tip is further out."""
    joints, before = poll()
    in_joints(True)
    subprocess.run(["halcmd", "setp", f"qvgen_{NAME}_kins.tool-length", "70"], check=True)
    in_joints(False)
    now, coordinates = poll()
    expect(distance(now, joints) < 1e-4, "joints move when the tool's length is switched")
    expect(abs(coordinates[2] - before[2] + 70) < 1e-4, "the tip stays when the tool's length is switched")
    joints_lead_to(coordinates, 70, "a longer tool")
    do("mode", command.mode, linuxcnc.MODE_MDI)
    return moves(coordinates, 70, "a longer tool", 2)


def with_a_tool_of_the_table():
    """The program says where its tip is."""
    joints, coordinates = poll()
    for line in ("T1 M6", "G43"):
        do(line, command.mdi, line)
    time.sleep(0.2)
    expect(distance(poll()[0], joints) < 1e-4, "joints move at G43, though the tool points downwards")
    coordinates[2] -= 50
    return moves(coordinates, 120, "a tool of the table", 2)


def main():
    start()
    samples = without_a_tool() + with_a_tool_that_stays() + with_a_tool_of_the_table()
    clocks = int(subprocess.run(["halcmd", "getp", "motion-controller.time"], check=True, capture_output=True, text=True).stdout)
    return f"{samples} samples on lines, {clocks} clocks of the motion controller in the last cycle\n{NAME}: passed\n"


try:
    text = main()
except BaseException as error:
    text = f"{NAME}: {type(error).__name__}: {error}\n"
pathlib.Path("result").write_text(text)
