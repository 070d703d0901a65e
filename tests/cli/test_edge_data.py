#!/usr/bin/python3
"""`pedzone run --edge-data`: read by SUMO's own tools, and the same numbers as elsewhere.

usage: test_edge_data.py PEDZONE_PROGRAM PROJECT_FOLDER
"""

import csv
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest
from collections import defaultdict
from pathlib import Path

from shapely.geometry import LineString, Point, Polygon

from tiny_scenario import TinyScenario, sumo_environment

HOME = sumo_environment()["SUMO_HOME"]
sys.path.append(os.path.join(HOME, "tools"))
import sumolib  # noqa: E402

PEDZONE = PROJECT = None  # set from the command line
SCHEMA = Path(HOME) / "data/xsd/meandata_file.xsd"
STEP = 0.1  # s, of the plaza


class EdgeDataCase(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="pedzone-edge-data-")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def command(self, *words, code=0):
        done = subprocess.run([*map(str, words)], cwd=self.folder, text=True, capture_output=True,
                              timeout=300, env=sumo_environment())
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def read(self, name="edges.xml"):
        """{begin: {edge: attributes}}, by SUMO's own reader."""
        return {float(interval.begin): {edge.id: edge for edge in interval.edge}
                for interval in sumolib.xml.parse(str(self.folder / name), ["interval"])}


class Plaza(EdgeDataCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="pedzone-edge-data-")
        cls.addClassCleanup(temporary.cleanup)
        cls.run_folder = Path(temporary.name)
        subprocess.run([PEDZONE, "run", PROJECT / "scenarios/plaza/plaza-high.sumocfg", "--end",
                        "100", "--quiet", "--edge-data", "edges.xml", "--edge-data-period", "40",
                        "--trajectories", "t.csv", "--summary", "s.json"], cwd=cls.run_folder,
                       check=True, capture_output=True, env=sumo_environment())

    def setUp(self):
        self.folder = self.run_folder
        self.net_file = PROJECT / "networks/plaza/plaza.net.xml"

    def test_it_follows_sumos_schema(self):
        self.command("xmllint", "--noout", "--nonet", "--schema", SCHEMA, "edges.xml")

    def test_plot_net_dump_draws_it(self):
        self.command("/usr/bin/python3", Path(HOME) / "tools/visualization/plot_net_dump.py", "-n",
                     self.net_file, "-i", "edges.xml,edges.xml", "-m", "speed,density", "-o",
                     "plot-%s.png", "-b")
        pictures = sorted(path.name for path in self.folder.glob("plot-*.png"))
        self.assertEqual(pictures, ["plot-0.0.png", "plot-40.0.png", "plot-80.0.png"])

    def test_the_numbers_are_those_of_the_trajectories(self):
        """Each row is on the edge in whose lanes it lies deepest: by shapely."""
        areas = self.areas()
        sums = defaultdict(lambda: [0.0, 0.0])
        with open(self.folder / "t.csv", newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                if not float(row["time"]).is_integer():
                    continue  # once a second will do
                at = Point(float(row["x"]), float(row["y"]))
                edge = min(areas, key=lambda lane: lane[1](at))[0]
                one = sums[float(row["time"]) // 40 * 40, edge]
                one[0] += 1.0
                one[1] += math.hypot(float(row["vx"]), float(row["vy"]))
        compared = 0
        for begin, edges in self.read().items():
            length = min(40.0, 100.0 - begin)
            for name, edge in edges.items():
                time, walked = sums[begin, name]
                told = float(edge.sampledSeconds)
                self.assertAlmostEqual(told, time, delta=0.02 * time + 5.0, msg=(begin, name))
                if time < 100.0:
                    continue
                compared += 1
                self.assertAlmostEqual(float(edge.speed), walked / time, delta=0.05)
                lane = sumolib.net.readNet(str(self.net_file), withInternal=True).getEdge(name)
                self.assertAlmostEqual(float(edge.density),
                                       told / length / lane.getLength() * 1000.0, delta=0.01)
                self.assertAlmostEqual(float(edge.traveltime),
                                       lane.getLength() / float(edge.speed), delta=0.05)
        self.assertGreater(compared, 5)

    def areas(self):
        """[(edge, function that tells how far a point is out of one of its lanes)]"""
        net = sumolib.net.readNet(str(self.net_file), withInternal=True)
        told = set(self.read()[0.0])
        found = []
        for edge in net.getEdges():
            if edge.getID() not in told:
                continue
            for lane in edge.getLanes():
                if not lane.allows("pedestrian"):
                    continue
                if edge.getFunction() == "walkingarea":
                    found.append((edge.getID(), lambda at, area=Polygon(lane.getShape()):
                                  area.exterior.distance(at) * (-1 if area.contains(at) else 1)))
                else:
                    found.append((edge.getID(), lambda at, line=LineString(lane.getShape()),
                                  half=lane.getWidth() / 2: line.distance(at) - half))
        return found

    def test_sums_are_those_of_the_summary(self):
        persons = json.loads((self.folder / "s.json").read_text())["persons"]
        edges = [edge for interval in self.read().values() for edge in interval.values()]
        loss = sum(float(edge.timeLoss) for edge in edges if edge.hasAttribute("timeLoss"))
        self.assertAlmostEqual(loss, persons["mean_delay_s"] * persons["controlled"],
                               delta=0.02 * abs(loss) + 5.0)
        with open(self.folder / "t.csv", encoding="utf-8") as file:
            rows = sum(1 for _ in file) - 1
        self.assertAlmostEqual(sum(float(edge.sampledSeconds) for edge in edges), rows * STEP,
                               delta=0.01 * len(edges))

    def test_who_comes_also_goes(self):
        edges = [edge for interval in self.read().values() for edge in interval.values()]
        entered = sum(int(edge.entered) for edge in edges)
        left = sum(int(edge.left) for edge in edges)
        with open(self.folder / "t.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        there = sum(row["time"] == rows[-1]["time"] for row in rows)  # when the run ends
        self.assertEqual(entered - left, there)
        self.assertGreater(left, 50)


class BesideSumo(EdgeDataCase):
    """One person on a street: by pedzone, and by SUMO's own edgeData of people whom SUMO walks."""

    def setUp(self):
        super().setUp()
        self.tiny = TinyScenario(self.folder)
        self.tiny.write("tiny.rou.xml", """<routes><person id="p" depart="3">
          <walk edges="west shared east"/></person></routes>""")
        self.tiny.write("tiny.add.xml", """<additional>
          <edgeData id="own" file="own.xml" detectPersons="walk"/></additional>""")
        self.config = self.tiny.config()

    def test_time_density_and_speed_are_as_sumo_counts_them(self):
        self.command("sumo", "-c", self.config)
        own = self.read("own.xml")[0.0]["shared"]
        self.command(PEDZONE, "run", self.config, "--quiet", "--edge-data", "edges.xml")
        edges = self.read()[0.0]
        ours = edges["shared"]
        for name in ("sampledSeconds", "density", "traveltime", "speed"):
            told, said = float(ours.getAttribute(name)), float(own.getAttribute(name))
            self.assertAlmostEqual(told / said, 1.0, delta=0.06, msg=name)
        self.assertEqual((ours.entered, ours.left), ("1", "1"))
        self.assertNotIn("west", edges)

    def test_a_name_gives_the_whole_run_one_interval(self):
        self.command(PEDZONE, "run", self.config, "--quiet", "--edge-data", "edges.xml.gz")
        root = sumolib.xml.parse(str(self.folder / "edges.xml.gz"), ["interval"])
        intervals = [(float(one.begin), float(one.end)) for one in root]
        self.assertEqual(intervals, [(0.0, 200.0)])

    def test_what_is_refused(self):
        for words, part in ((("--edge-data-period", "60"), "--edge-data"),
                            (("--edge-data", "e.xml", "--edge-data-period", "0"), "0.1"),
                            (("--edge-data", "e.xml", "--summary", "e.xml"), "same file"),
                            (("--edge-data", "."), "it is a folder")):
            with self.subTest(words):
                error = self.command(PEDZONE, "run", self.config, *words, code=2).stderr
                self.assertIn(part, error)
                self.assertFalse((self.folder / "e.xml").exists())


if __name__ == "__main__":
    PROJECT = Path(sys.argv.pop(2)).resolve()
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
