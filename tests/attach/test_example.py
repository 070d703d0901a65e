#!/usr/bin/python3
"""The worked example of an automated shuttle, as its reader runs it, many times.

usage: test_example.py PEDZONE_PROGRAM SCENARIOS_FOLDER [RUNS]

Each run, with a seed of its own, must end by itself and leave nothing running; nobody may be run into, nor
touched by a shuttle that drives. Conflicts take bodies for discs: who passes a standing shuttle with turned shoulders
(with seed 12, by 5 cm) may overlap it by what turning saves.
"""

import csv
import re
import subprocess
import sys
import tempfile

PEDZONE, SCENARIOS = sys.argv[1:3]
RUNS = int(sys.argv[3]) if len(sys.argv) > 3 else 1
LONG = 900  # s; a run takes half a minute, on a busy machine some

DRIVES = 0.1  # m/s
TURNED = 0.12  # m; SUMO's person is 0.478 m wide, and half as wide with its shoulders turned all the way


def overlaps(folder: str) -> list:
    """(speed of the shuttle then, at the contact's begin or 0, clearance) of discs that meet a shuttle."""
    with open(f"{folder}/conflicts.csv", encoding="utf-8") as stream:
        return [(float(row["minClearance_vehicleSpeed"]), float(row["contact_vehicleSpeed"] or 0.0),
                 float(row["minClearance"]))
                for row in csv.DictReader(stream)
                if row["vehicle"].startswith("shuttle") and float(row["minClearance"] or 1.0) < 0.0]


for k in range(RUNS):
    folder = tempfile.TemporaryDirectory()
    done = subprocess.run([f"{SCENARIOS}/av-in-the-loop/run.py", "--pedzone", PEDZONE, "--seed",
                           str(k + 1), "--out", folder.name], capture_output=True, text=True,
                          timeout=LONG)
    assert done.returncode == 0, done.stderr
    figures = dict(re.findall(r"^(.+?)  +(\S+)$", done.stdout, re.MULTILINE))
    print(k + 1, figures)
    assert int(figures["trips"]) >= 1, done.stdout
    assert int(figures["conflicts"]) >= 1, done.stdout
    for speed, before, clearance in overlaps(folder.name):
        assert max(speed, before) < DRIVES and clearance > -TURNED, (speed, before, clearance)
    assert 0.0 < float(figures["hardest braking [m/s2]"]) <= 6.0, done.stdout
    assert int(figures["people run into"]) == 0, done.stdout
    left = subprocess.run(["pgrep", "-f", folder.name], capture_output=True)
    assert left.returncode == 1, "nothing is left running"
    folder.cleanup()
