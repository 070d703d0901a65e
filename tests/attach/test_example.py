#!/usr/bin/python3
"""The worked example of an automated shuttle, as its reader runs it, many times.

usage: test_example.py PEDZONE_PROGRAM SCENARIOS_FOLDER [RUNS]

Each run, with a seed of its own, must end by itself and leave nothing running; nobody may be run into. The
first must not touch anybody. Of many, one in ten may: who squeezes past the shuttle is touched by
centimetres (with seed 12 by 4 cm).
"""

import re
import subprocess
import sys
import tempfile

PEDZONE, SCENARIOS = sys.argv[1:3]
RUNS = int(sys.argv[3]) if len(sys.argv) > 3 else 1
LONG = 900  # s; a run takes half a minute, on a busy machine some

touched = 0
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
    touched += float(figures["least clearance [m]"]) <= 0.0
    assert touched <= k // 10, "it touches nobody"
    assert 0.0 < float(figures["hardest braking [m/s2]"]) <= 6.0, done.stdout
    assert int(figures["people run into"]) == 0, done.stdout
    left = subprocess.run(["pgrep", "-f", folder.name], capture_output=True)
    assert left.returncode == 1, "nothing is left running"
    folder.cleanup()
