#!/usr/bin/python3
"""`pedzone plot`: what figures of few people have beside their maps, and several in one picture.

usage: test_figures.py PEDZONE_PROGRAM
"""

import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

from drawn import SVG, Picture, points
from refusal import RefusalChecks
from tiny_scenario import FCD, sumo_environment

PEDZONE = None  # set from the command line

COLUMNS = "time,id,x,y,vx,vy,heading,motion,activity\n"
TYPES = '<routes><vType id="van" length="6" width="2"/></routes>'


class Figures(RefusalChecks, unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)
        self.write("types.rou.xml", TYPES)
        self.write("fcd.xml", FCD.format(person="p"))

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def plot(self, file, *words):
        return subprocess.run([PEDZONE, "plot", file, "--vtypes", "types.rou.xml", "--out",
                               "out/plot.svg", *words], cwd=self.folder, text=True, timeout=120,
                              capture_output=True, env=sumo_environment())

    def drawn(self, *words, file="fcd.xml"):
        done = self.plot(file, *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return Picture(self.folder / "out/plot.svg")

    def test_times_and_ends_are_written_beside_few(self):
        picture = self.drawn("--every", "1", "--area", "0", "-20", "40", "20")
        times = [text.text for text in picture.of_class("time")]
        self.assertEqual(set(times), {"0 s", "1 s"})
        # The van's centre is 3 m behind its bumper: from (7, 0) to (15, 0).
        (start,), (goal,) = picture.of_class("start"), picture.of_class("goal")
        self.assertEqual(picture.place(float(start.get("cx")), float(start.get("cy"))), (7, 0))
        corners_of_goal = [picture.place(*point) for point in points(goal)[0]]
        self.assertEqual([round(sum(axis) / 4, 6) for axis in zip(*corners_of_goal)], [15, 0])

    def test_many_have_no_times(self):
        rows = [f"{time},p{i},{i},{time + 2},0,1,1.57,walking,none\n"
                for time in range(3) for i in range(13)]
        self.write("run.csv", COLUMNS + "".join(rows))
        self.assertEqual(self.drawn(file="run.csv").of_class("time"), [])

    def test_across_has_an_axis_of_its_own(self):
        rows = [f"{t},p,{10 * t},{100 + 0.1 * t:.1f},0,1,1.57,walking,none\n" for t in range(6)]
        self.write("run.csv", COLUMNS + "".join(rows))
        lines = self.drawn("--kind", "across", file="run.csv").lines()
        for got, expected in ((lines["p"][0], (0, 100)), (lines["p"][-1], (50, 100.5))):
            self.assertAlmostEqual(got[0], expected[0], delta=0.5)
            self.assertAlmostEqual(got[1], expected[1], delta=0.01)

    def test_recordings_beside_each_other(self):
        self.write("other.xml", FCD.format(person="q"))
        done = self.plot("fcd.xml", "--area", "0", "-5", "40", "5", "--beside", "other.xml")
        self.assertEqual(done.returncode, 0, done.stderr)
        root = ET.parse(self.folder / "out/plot.svg").getroot()
        self.assertEqual(len(root.findall(f".//{SVG}svg")), 2)
        names = [text.text for text in root.findall(SVG + "text")]
        self.assertEqual(names, ["fcd", "other"])
        titles = "".join(title.text or "" for title in root.iter(SVG + "title"))
        self.assertIn("q at ", titles)
        # They are wide: below each other, with one legend.
        texts = "".join(root.itertext())
        self.assertEqual(texts.count("north is up"), 1)

    def test_a_median_off_the_axis_says_so(self):
        def crowd(apart):
            return "<fcd-export>" + "".join(
                f'<timestep time="{t}"><vehicle id="car" x="{8 * t}" y="0" angle="90" type="van" '
                f'speed="8"/>' + "".join(
                    f'<person id="p{i}" x="{i}" y="{apart}" angle="0" speed="1"/>'
                    for i in range(14)) + "</timestep>" for t in range(3)) + "</fcd-export>"
        for apart, told in ((60, True), (5, False)):
            self.write("crowd.xml", crowd(apart))
            picture = self.drawn("--kind", "clearance", file="crowd.xml")
            notes = [note.text for note in picture.of_class("note")]
            self.assertEqual(notes, ["median: above 15 m throughout, off the axis"] * told)

    def test_snapshots_are_of_time_plots(self):
        self.check_refused(self.plot("fcd.xml", "--kind", "path", "--at", "1"), "--kind", "path")


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
