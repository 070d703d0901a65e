#!/usr/bin/python3
"""A study whose driver and runs are killed at random, and that is resumed each time, ends with the
same tables, byte for byte, as one that nobody disturbed; nothing lost, nothing doubled.

usage: test_faults.py PEDZONE_PROGRAM
"""

import csv
import os
import random
import signal
import subprocess
import time
import unittest

import study_case
from family import family, wait_until_none_uses
from study_case import StudyCase

KILLS = 50
FEWEST_KILLS = 25  # where the machine is so fast that the study is over before
SEEDS = 20
MODELS = ("striping", "nonInteracting", "constant-velocity")
JOBS = 2
NEARLY_OVER = 10  # runs left: drivers are killed early, so that the study is not over too soon
# With neither clock nor path.
OUTPUTS = ("conflicts.csv", "zone-conflicts.csv", "density.csv", "series.csv")


class Faults(StudyCase):
    def setUp(self):
        super().setUp()
        self.random = random.Random(6)
        self.driver = None
        self.moment = None  # [s] within which somebody is killed: what a run takes

    def study_of_60_runs(self):
        return self.study(seeds=f"1-{SEEDS}", models=" ".join(MODELS), end=20)

    def over(self):
        return [name for name in self.run_names() if not name.startswith(".")]

    def resumed_driver(self, study):
        """The one that runs; a new one where it has been killed or has ended."""
        if self.driver is None or self.driver.poll() is not None:
            self.finish_driver()
            self.driver = self.start("run", study, "--out", self.results, "--jobs", str(JOBS))
        return self.driver

    def finish_driver(self):
        if self.driver is None:
            return
        _, errors = self.driver.communicate(timeout=300)
        if self.driver.returncode == 3:  # it was SUMO telling its version or options that was killed
            self.assertRegex(errors, r"Error: sumo --(version|save-template) ended with exit code 137")
        else:
            self.assertIn(self.driver.returncode, (0, 4, -signal.SIGKILL), errors)
        wait_until_none_uses(self.folder)

    def kill_somebody(self, driver, nearly_over):
        """The driver, or one of its runs or what those have started; says whether there was one."""
        victim = driver.pid
        others = family(driver.pid)[1:]
        if others and not nearly_over and self.random.random() < 0.6:
            victim = self.random.choice(others)
        try:
            os.kill(victim, signal.SIGKILL)
        except ProcessLookupError:  # it has ended meanwhile
            return False
        if victim == driver.pid:
            driver.wait()
        return True

    def disturb(self, study, runs):
        """Has the study go on a little, then kills somebody; again and again, all along the study."""
        killed = 0
        while killed < KILLS and len(self.over()) < runs:
            driver = self.resumed_driver(study)
            nearly_over = runs - len(self.over()) < NEARLY_OVER
            ahead = nearly_over or len(self.over()) * KILLS > killed * runs
            aim = len(self.over()) + (0 if ahead else self.random.randint(0, 2))
            while len(self.over()) < aim and driver.poll() is None:
                pass
            try:
                driver.wait(timeout=self.random.uniform(0.0, self.moment / 5 if ahead else self.moment))
            except subprocess.TimeoutExpired:
                killed += self.kill_somebody(driver, nearly_over)
        self.assertGreaterEqual(killed, FEWEST_KILLS)
        self.finish_driver_now()

    def finish_driver_now(self):
        if self.driver.poll() is None:
            self.driver.kill()
        self.finish_driver()

    def test_kills_at_random_change_nothing(self):
        study = self.study_of_60_runs()
        reference = self.folder / "undisturbed"
        start = time.monotonic()
        self.make(study, "--jobs", str(JOBS), results=reference)
        names = self.run_names(reference)
        self.moment = (time.monotonic() - start) * JOBS / len(names)
        self.disturb(study, len(names))
        self.make(study, "--jobs", str(JOBS))
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
    study_case.main()
