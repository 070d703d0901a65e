#!/usr/bin/python3
"""tools/experiment.sh: what it leaves, and what it refuses.

usage: test_experiment.py PEDZONE_PROGRAM
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PEDZONE = None  # set from the command line
ROOT = Path(__file__).resolve().parents[2]


class Experiment(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = Path(self.folder.name) / "out"

    def tearDown(self):
        self.folder.cleanup()

    def run_it(self, *words):
        return subprocess.run([ROOT / "tools/experiment.sh", *words, "--out", str(self.out)],
                              text=True, capture_output=True, timeout=300,
                              env={**os.environ, "PEDZONE": PEDZONE})

    def test_pictures_animation_and_measures(self):
        done = self.run_it("5.3", "--seed", "3")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("5.3-time.svg", "5.3-speed.svg", "5.3-clearance.svg", "5.3.html", "5.3.csv",
                     "5.3.fcd.xml", "5.3.json"):
            self.assertGreater((self.out / name).stat().st_size, 500, name)
        self.assertIn("clearance", done.stdout)
        self.assertIn("smaller part", done.stdout)

    def test_unknown_model(self):
        done = self.run_it("5.4", "--model", "magic")
        self.assertEqual(done.returncode, 2)
        self.assertIn("magic", done.stderr)
        self.assertEqual([file for file in self.out.glob("*") if file.stat().st_size > 0], [])

    def test_refused(self):
        for words, fragment in ((("5.5",), "'5.5' is no experiment"), (("",), "no experiment"),
                                (("5.1", "--modle", "x"), "unknown option '--modle'")):
            done = self.run_it(*words)
            self.assertEqual(done.returncode, 2)
            self.assertIn(fragment, done.stderr)
            self.assertFalse(self.out.exists())


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
