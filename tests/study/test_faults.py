#!/usr/bin/python3
"""A study whose driver and runs are killed at random, and that is resumed each time, ends with the
same tables, byte for byte, as one that nobody disturbed; nothing lost, nothing doubled.

usage: test_faults.py PEDZONE_PROGRAM KILLS
"""

import csv
import os
import random
import signal
import subprocess
import sys
import unittest

import study_case
from family import family, wait_until_none_uses
from study_case import StudyCase

KILLS = None  # set from the command line
SEEDS = 20
MODELS = ("striping", "nonInteracting", "constant-velocity")
MOMENT = 0.6  # [s] within which somebody is killed, about what a run takes
OUTPUTS = ("conflicts.csv", "density.csv", "series.csv")  # with neither clock nor path


class Faults(StudyCase):
    def setUp(self):
        super().setUp()
        self.random = random.Random(6)
        self.driver = None

    def study_of_60_runs(self):
        return self.study(seeds=f"1-{SEEDS}", models=" ".join(MODELS), end=20)

    def over(self):
        return [name for name in self.run_names() if not name.startswith(".")]

    def resumed_driver(self, study):
        """The one that runs; a new one where it has been killed or has ended."""
        if self.driver is None or self.driver.poll() is not None:
            self.finish_driver()
            self.driver = self.start("run", study, "--out", self.results, "--jobs", "2")
        return self.driver

    def finish_driver(self):
        if self.driver is None:
            return
        _, errors = self.driver.communicate(timeout=300)
        self.assertIn(self.driver.returncode, (0, 4, -signal.SIGKILL), errors)
        wait_until_none_uses(self.folder)

    def kill_somebody(self, driver):
        """The driver, or one of its runs or what those have started; says whether there was one."""
        victims = family(driver.pid)
        victim = driver.pid if self.random.random() < 0.5 else self.random.choice(victims)
        try:
            os.kill(victim, signal.SIGKILL)
        except ProcessLookupError:  # it has ended meanwhile
            return False
        if victim == driver.pid:
            driver.wait()
        return True

    def disturb(self, study, runs):
        """Has the study go on a little, then kills somebody; again and again."""
        killed = 0
        while killed < KILLS:
            driver = self.resumed_driver(study)
            # Never so far that it is done before it has been disturbed as often as it has to be.
            spare = (runs - len(self.over())) - (KILLS - killed) * runs // (2 * KILLS)
            aim = len(self.over()) + (self.random.randint(0, 3) if spare > 3 else 0)
            while len(self.over()) < aim and driver.poll() is None:
                pass
            try:
                driver.wait(timeout=self.random.uniform(0.0, MOMENT))
            except subprocess.TimeoutExpired:
                killed += self.kill_somebody(driver)
            else:
                self.assertLess(len(self.over()), runs, f"it was over after {killed} kills")
        self.finish_driver_now()

    def finish_driver_now(self):
        if self.driver.poll() is None:
            self.driver.kill()
        self.finish_driver()

    def test_kills_at_random_change_nothing(self):
        study = self.study_of_60_runs()
        reference = self.folder / "undisturbed"
        self.make(study, "--jobs", "2", results=reference)
        names = self.run_names(reference)
        self.disturb(study, len(names))
        self.make(study, "--jobs", "2")
        self.check_same_tables(self.results, reference)
        self.assertEqual(self.run_names(), names)
        self.check_runs(names, reference)
        rows = list(csv.DictReader((self.results / "runs.csv").read_text().splitlines()))
        self.assertEqual(len(rows), SEEDS * len(MODELS))
        self.assertEqual(len({(row["model"], row["seed"]) for row in rows}), len(rows))
        self.assertEqual({row["status"] for row in rows}, {"done"})

    def check_runs(self, names, reference):
        """The same files in each run's folder, and the same in those that hold no clock."""
        for name in names:
            run, other = self.results / "runs" / name, reference / "runs" / name
            self.assertEqual(sorted(path.name for path in run.iterdir()),
                             sorted(path.name for path in other.iterdir()))
            for output in OUTPUTS:
                if (other / output).exists():
                    self.assertEqual((run / output).read_bytes(), (other / output).read_bytes())


if __name__ == "__main__":
    KILLS = int(sys.argv.pop(2))
    study_case.main()
