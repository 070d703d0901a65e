#!/usr/bin/python3
"""`run` and `attach` walk people to the same bits: real scenarios, SUMO in process and over TraCI.

usage: test_same.py PEDZONE_PROGRAM SCENARIOS_FOLDER
"""

import os
import sys
import unittest
from pathlib import Path

import attached
from attached import LONG, AttachedCase

SCENARIOS = Path(os.path.abspath(sys.argv.pop(2)))


class Same(AttachedCase):
    def check(self, name, end, seed=None):
        config = SCENARIOS / name
        seeds = [] if seed is None else ["--seed", seed]
        run = self.start(self.pedzone, "run", config, "--end", end, "--trajectories", "run.csv",
                         "--summary", "run.json", *seeds)
        _, errors = run.communicate(timeout=LONG)
        self.assertEqual(run.returncode, 0, errors)
        self.start_sumo(1, *seeds, config=config)
        pedzone = self.attach("--order", 1, "--end", end, "--trajectories", "attach.csv",
                              config=config)
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 0, errors)
        walked = (self.folder / "run.csv").read_bytes()
        self.assertGreater(walked.count(b"\n"), 10_000)
        self.assertTrue(walked == (self.folder / "attach.csv").read_bytes(), "another bit")

    def test_plaza_with_vehicles(self):
        self.check("plaza/plaza-medium.sumocfg", 150)

    def test_plaza_of_groups_with_another_seed(self):
        self.check("groups/plaza.sumocfg", 150, seed=7)

    def test_street(self):
        self.check("street-zone/street-zone-high.sumocfg", 150)

    def test_bad_hersfeld_with_a_shuttle(self):
        self.check("bad-hersfeld/centre-shuttle.sumocfg", 200)


if __name__ == "__main__":
    attached.main(__doc__)
