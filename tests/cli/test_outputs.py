#!/usr/bin/python3
"""Where outputs go, and what a run that is interrupted leaves: real processes, real signals.

usage: test_outputs.py PEDZONE_PROGRAM
"""

import csv
import gzip
import io
import json
import os
import signal
import stat
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from tiny_scenario import TinyCase

PEDZONE = None  # set from the command line
FOR_EVER = "100000000"  # s
FLOW = """<routes><personFlow id="f" begin="0" end="1000" period="5">
  <walk edges="west shared east"/></personFlow></routes>"""


class OutputCase(TinyCase):
    def setUp(self):
        super().setUp()
        self.tiny.write("tiny.rou.xml", FLOW)
        self.config = self.tiny.config()

    def start(self, *words):
        process = subprocess.Popen([PEDZONE, "run", str(self.config), *words], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.kill)
        return process

    def run_for(self, seconds, *words):
        done = self.start("--end", str(seconds), *words)
        output, errors = done.communicate(timeout=120)
        return subprocess.CompletedProcess(words, done.returncode, output, errors.decode())

    def leftovers(self):
        return [path.name for path in self.folder.rglob("*.partial")]


class Interrupted(OutputCase):
    def interrupt(self, number, receiver=lambda process: process.pid):
        """A run that would go on for ever, interrupted once it has walked people for a while."""
        process = self.start("--end", FOR_EVER, "--summary", "s.json", "--trajectories", "t.csv",
                             "--", "--tripinfo-output", "trips.xml", "--fcd-output", "fcd.xml")
        seen = self.folder / "fcd.xml"
        while not (seen.exists() and seen.stat().st_size > 500_000):
            self.assertIsNone(process.poll(), "ended before it could be interrupted")
            time.sleep(0.01)
        os.kill(receiver(process), number)
        _, errors = process.communicate(timeout=60)
        return process.returncode, errors.decode()

    def check(self, number, **where):
        code, errors = self.interrupt(number, **where)
        self.assertEqual(code, 128 + number, errors)
        self.assertIn("Interrupted at", errors)
        summary = json.loads((self.folder / "s.json").read_text())
        self.assertIs(summary["interrupted"], True)
        rows = list(csv.DictReader(io.StringIO((self.folder / "t.csv").read_text())))
        # What was simulated is there whole: by our own file and by SUMO's.
        steps = ElementTree.parse(self.folder / "fcd.xml").getroot().findall("timestep")
        self.assertTrue(rows[-1]["activity"], "the last row is cut")
        self.assertLessEqual(float(rows[-1]["time"]), float(steps[-1].get("time")))
        ElementTree.parse(self.folder / "trips.xml")
        self.assertAlmostEqual(summary["time"]["simulated_s"], float(steps[-1].get("time")),
                               delta=1.0)
        self.assertEqual(self.leftovers(), [])

    def test_from_the_terminal(self):
        self.check(signal.SIGINT)

    def test_by_kill(self):
        self.check(signal.SIGTERM)

    def test_when_the_terminal_goes(self):
        self.check(signal.SIGHUP)

    def test_the_process_that_simulates(self):
        self.check(signal.SIGTERM, receiver=lambda process: int(
            Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()[0]))

    def test_a_second_signal_ends_at_once(self):
        # Nobody reads what it writes, so that it cannot end by itself.
        process = self.start("--end", FOR_EVER, "--trajectories", "-", "--summary", "s.json")
        time.sleep(2.0)
        process.send_signal(signal.SIGINT)
        time.sleep(1.0)
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=10), 130)
        self.assertFalse((self.folder / "s.json").exists())
        self.assertEqual(self.leftovers(), [])

    def test_a_whole_run_is_not_marked(self):
        done = self.run_for(20, "--summary", "s.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIs(json.loads((self.folder / "s.json").read_text())["interrupted"], False)


class Places(OutputCase):
    def rows(self, text):
        return list(csv.DictReader(io.StringIO(text)))

    def test_standard_output_holds_nothing_else(self):
        for name in ("-", "/dev/stdout", "/dev/fd/1"):
            with self.subTest(name):
                done = self.run_for(60, "--trajectories", name)
                self.assertEqual(done.returncode, 0, done.stderr)
                rows = self.rows(done.stdout.decode())
                self.assertGreater(len(rows), 10)
                self.assertTrue(all(row["time"] and row["activity"] for row in rows))
                self.assertIn("still there", done.stderr)
        self.assertTrue(stat.S_ISLNK(os.lstat("/dev/stdout").st_mode))

    def test_standard_output_into_a_file(self):
        with open(self.folder / "all.json", "wb") as into:
            subprocess.run([PEDZONE, "run", str(self.config), "--end", "20", "--summary",
                            "/dev/stdout"], stdout=into, stderr=subprocess.DEVNULL, check=True)
        self.assertIn("persons", json.loads((self.folder / "all.json").read_text()))

    def test_a_link_stays_one(self):
        (self.folder / "other").mkdir()
        (self.folder / "link.json").symlink_to("other/real.json")
        done = self.run_for(20, "--summary", "link.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "link.json").is_symlink())
        json.loads((self.folder / "other/real.json").read_text())
        self.assertEqual(self.leftovers(), [])

    def test_devices_and_fifos_are_written_to(self):
        # A node of the same kind as /dev/null would need rights: a link to it does not.
        (self.folder / "null").symlink_to("/dev/null")
        done = self.run_for(20, "--summary", "null")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))
        os.mkfifo(self.folder / "fifo")
        reader = subprocess.Popen(["cat", "fifo"], cwd=self.folder, stdout=subprocess.PIPE)
        done = self.run_for(60, "--trajectories", "fifo")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(len(self.rows(reader.communicate(timeout=30)[0].decode())), 10)
        self.assertTrue(stat.S_ISFIFO(os.stat(self.folder / "fifo").st_mode))

    def test_a_full_disk_is_an_error(self):
        done = self.run_for(20, "--summary", "/dev/full")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("/dev/full: No space left", done.stderr)

    def test_compressed_by_name(self):
        done = self.run_for(60, "--trajectories", "t.csv.gz", "--summary", "plain.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        with gzip.open(self.folder / "t.csv.gz", "rt") as packed:
            self.assertGreater(len(self.rows(packed.read())), 10)
        json.loads((self.folder / "plain.json").read_text())

    def test_two_outputs_of_one_name(self):
        for second in ("a.csv", "./a.csv", "sub/../a.csv"):
            with self.subTest(second):
                done = self.run_for(20, "--trajectories", "a.csv", "--summary", second)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn("same file", done.stderr)
                self.assertFalse((self.folder / "a.csv").exists())
        self.assertEqual(self.leftovers(), [])

    def test_none_takes_the_place_of_an_input(self):
        self.assertEqual(self.run_for(20, "--", "--fcd-output", "fcd.xml").returncode, 0)
        inputs = [self.folder / f"tiny.{kind}.xml" for kind in ("net", "rou", "add")] + [self.config]
        (self.folder / "link.xml").symlink_to("tiny.rou.xml")
        before = {path: path.read_bytes() for path in [*inputs, self.folder / "fcd.xml"]}

        def refused(*words):
            done = subprocess.run([PEDZONE, *map(str, words)], cwd=self.folder, text=True,
                                  capture_output=True, timeout=120)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("names a file that is read", done.stderr)
            self.assertEqual({path: path.read_bytes() for path in before}, before)

        for path in [*inputs, "link.xml"]:
            for option in ("--summary", "--trajectories", "--animate"):
                with self.subTest(path, option=option):
                    refused("run", self.config, "--end", 20, option, path)
        refused("conflicts", "fcd.xml", "--scenario", self.config, "--conflict-output", "fcd.xml")
        refused("maps", "fcd.xml", "--scenario", self.config, "--out", self.config)
        refused("animate", "fcd.xml", "--scenario", self.config, "--out", "fcd.xml")
        self.assertEqual(self.leftovers(), [])

    def test_nor_that_of_sumos_outputs(self):
        done = self.run_for(20, "--summary", "a.xml", "--", "--fcd-output", "a.xml")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("same file as --fcd-output", done.stderr)


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
