#!/usr/bin/python3
"""`pedzone run --trajectories` for JuPedSim and PedPy: the same people at the same places.

usage: test_trajectory_files.py PEDZONE_PROGRAM
"""

import os
import re
import signal
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy
from shapely.geometry import MultiPoint, MultiPolygon, Polygon

from tiny_scenario import EDGES, TinyCase, TinyScenario, sumo_environment
from trajectory_files import JUPEDSIM, Database, Text, table_rows

PEDZONE = None  # set from the command line
BEGIN, STEP = 30.0, 0.5  # s
HOSTILE = "ü$(x)--%s{}#1"  # SUMO refuses quotes and the like
WALKS = f"""<routes>
  <person id="{HOSTILE}" depart="30"><walk edges="west shared east"/></person>
  <person id="back" depart="31"><walk from="east" to="west"/></person>
  <person id="outside" depart="32"><walk edges="west" arrivalPos="30"/></person>
</routes>"""
# A zone at either end, SUMO's street between them.
TWO_ZONES = re.sub('"shared"', '"middle"', EDGES)
TWO_ZONES = re.sub('speed="13.89" sidewalkWidth="2"', 'speed="2.78" type="highway.living_street" '
                   'disallow="tram" width="8"', TWO_ZONES)
TWO_ZONES = re.sub('(id="middle".*?)speed="2.78".*?/>', r'\1speed="13.89" sidewalkWidth="2"/>',
                   TWO_ZONES, flags=re.DOTALL)


class Files(TinyCase):
    def setUp(self):
        super().setUp()
        self.tiny.write("tiny.rou.xml", WALKS)
        self.config = self.tiny.config()

    def run_with(self, *words, code=0):
        words = [*map(str, words)]
        sumo = [] if "--" in words else ["--"]
        done = subprocess.run([PEDZONE, "run", self.config, "--quiet", *words, *sumo, "--begin",
                               str(BEGIN)], cwd=self.folder, capture_output=True, text=True,
                              timeout=120, env=sumo_environment())
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr

    def table(self):
        """{(person, frame): place} of the CSV form."""
        self.run_with("--trajectories", "t.csv")
        return {(row["id"], round((float(row["time"]) - BEGIN) / STEP)):
                (float(row["x"]), float(row["y"])) for row in table_rows(self.folder / "t.csv")}

    def check_same(self, table, found, tolerance):
        self.assertEqual(found.keys(), table.keys())
        for key, place in found.items():
            numpy.testing.assert_allclose(place, table[key], atol=tolerance)

    def check_numbers(self, persons):
        self.assertEqual(persons, {1: "back", 2: HOSTILE})

    def test_the_database_of_jupedsim(self):
        table = self.table()
        self.run_with("--trajectories", "x.sqlite")
        data = Database(self.folder / "x.sqlite")
        for name, columns in JUPEDSIM.items():
            self.assertEqual(data.columns(name), columns, name)
        self.assertEqual(data.metadata["version"], "2")
        self.assertEqual(float(data.metadata["begin"]), BEGIN)
        self.assertEqual(data.rate, 1.0 / STEP)
        self.check_numbers(data.persons)
        frame, number, x, y, ori_x, ori_y = data.rows.T
        self.check_same(table, {(data.persons[n], f): (a, b)
                                for f, n, a, b in zip(frame, number, x, y)}, 0.00051)
        numpy.testing.assert_allclose(numpy.hypot(ori_x, ori_y), 1.0)
        for key, value in (("xmin", x.min()), ("xmax", x.max()), ("ymin", y.min()),
                           ("ymax", y.max())):
            self.assertEqual(float(data.metadata[key]), value, key)
        self.assertEqual(data.connection.execute("PRAGMA integrity_check").fetchone(), ("ok",))

    def test_every_frame_has_the_ground_that_people_walk_on(self):
        self.run_with("--trajectories", "x.sqlite")
        data = Database(self.folder / "x.sqlite")
        last = int(data.rows[:, 0].max())
        for frame in range(last + 1):
            self.assertEqual(len(data.geometry_of(frame)), 1)
        ground = data.ground()
        self.assertTrue(ground.is_valid)
        self.assertIsInstance(ground, Polygon)  # PedPy takes no other
        self.assertTrue(ground.buffer(0.001).covers(MultiPoint(data.rows[:, 2:4])))
        self.assertLess(ground.area, 2000.0)  # m²: not everything

    def test_frames_lead_from_one_place_to_the_next(self):
        self.run_with("--trajectories", "x.sqlite")
        data = Database(self.folder / "x.sqlite")
        for number in data.persons:
            rows = data.rows[data.rows[:, 1] == number]
            self.check_no_gap(rows)
            speeds = numpy.hypot(*numpy.diff(rows[:, 2:4], axis=0).T) * data.rate
            self.assertLess(speeds.max(), 3.0)  # m/s
            self.assertGreater(speeds.mean(), 0.8)

    def check_no_gap(self, rows):
        self.assertGreater(len(rows), 30)
        self.assertTrue((numpy.diff(rows[:, 0]) == 1).all())

    def test_who_comes_back_has_another_number(self):
        (self.folder / "two").mkdir()
        two = TinyScenario(self.folder / "two", edges=TWO_ZONES)
        two.write("tiny.rou.xml", """<routes><person id="p" depart="30">
          <walk edges="west middle east"/></person></routes>""")
        self.config = two.config()
        self.run_with("--trajectories", "x.sqlite")
        data = Database(self.folder / "x.sqlite")
        self.assertEqual(data.persons, {1: "p", 2: "p"})
        first, second = (data.rows[data.rows[:, 1] == number] for number in data.persons)
        self.check_no_gap(first)
        self.check_no_gap(second)
        self.assertGreater(second[0, 0], first[-1, 0] + 30)
        self.assertIsInstance(data.ground(), MultiPolygon)

    def test_the_text_of_pedpy(self):
        table = self.table()
        self.run_with("--trajectories", "x.txt")
        text = Text(self.folder / "x.txt")
        self.assertEqual((text.rate, text.unit), (1.0 / STEP, "m"))
        persons = {int(row["id"]): row["person"] for row in table_rows(self.folder / "x.ids.csv")}
        self.check_numbers(persons)
        self.assertEqual(text.rows.shape[1], 5)
        self.check_same(table, {(persons[int(row[0])], int(row[1])): (row[2], row[3])
                                for row in text.rows}, 0.00056)
        self.assertFalse(text.rows[:, 4].any())

    def test_the_text_compressed(self):
        self.run_with("--trajectories", "plain.txt")
        self.run_with("--trajectories", "packed.txt.gz")
        numpy.testing.assert_array_equal(Text(self.folder / "plain.txt").rows,
                                         numpy.loadtxt(self.folder / "packed.txt.gz"))
        self.assertTrue((self.folder / "packed.ids.csv").exists())

    def test_everybody_is_where_sumo_says(self):
        self.run_with("--trajectories", "x.sqlite", "--trajectories-of", "all", "--",
                      "--fcd-output", "fcd.xml", "--precision", "4")
        data = Database(self.folder / "x.sqlite")
        found = {(data.persons[n], f): (x, y) for f, n, x, y in data.rows[:, :4]}
        said = {(person.get("id"), round((float(step.get("time")) - BEGIN) / STEP)):
                (float(person.get("x")), float(person.get("y")))
                for step in ElementTree.parse(self.folder / "fcd.xml").getroot()
                for person in step.findall("person")}
        self.check_same(said, found, 0.0001)
        self.assertIn("outside", data.persons.values())
        # m: SUMO walks people over the corners of its lanes, by 0.8 m with 1.15 and 1.4 m with 1.18.
        ground = data.ground().buffer(1.5)
        self.assertTrue(ground.covers(MultiPoint(data.rows[:, 2:4])))
        self.run_with("--trajectories", "own.sqlite")
        own = Database(self.folder / "own.sqlite")
        self.assertTrue(own.ground().buffer(1.0).covers(MultiPoint(own.rows[:, 2:4])))

    def test_nobody_at_all(self):
        self.tiny.write("tiny.rou.xml", "<routes/>")
        self.run_with("--trajectories", "x.sqlite")
        self.run_with("--trajectories", "x.txt")
        data = Database(self.folder / "x.sqlite")
        self.assertEqual((len(data.rows), data.persons), (0, {}))
        self.assertFalse(data.ground().is_empty)
        self.assertEqual(table_rows(self.folder / "x.ids.csv"), [])

    def test_interrupted_they_hold_what_was_simulated(self):
        self.tiny.write("tiny.rou.xml", """<routes><personFlow id="f" begin="0" end="1000"
          period="5"><walk edges="west shared east"/></personFlow></routes>""")
        process = subprocess.Popen([PEDZONE, "run", self.config, "--end", "100000000",
                                    "--trajectories", "x.sqlite", "--", "--fcd-output", "fcd.xml"],
                                   cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, env=sumo_environment())
        self.addCleanup(process.kill)
        while not ((self.folder / "fcd.xml").exists() and
                   (self.folder / "fcd.xml").stat().st_size > 200_000):
            self.assertIsNone(process.poll())
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=60), 130)
        self.assertGreater(len(Database(self.folder / "x.sqlite").rows), 100)
        self.assertEqual(list(self.folder.glob("*.partial*")), [])

    def test_killed_they_leave_nothing(self):
        process = subprocess.Popen([PEDZONE, "run", self.config, "--end", "100000000",
                                    "--trajectories", "x.txt"], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   env=sumo_environment())
        self.addCleanup(process.kill)
        while len(list(self.folder.glob("*.partial"))) < 2:  # x.txt and x.ids.csv
            self.assertIsNone(process.poll())
            time.sleep(0.01)
        children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
        os.kill(int(children[0]), signal.SIGKILL)
        self.assertEqual(process.wait(timeout=60), 128 + signal.SIGKILL)
        self.assertEqual(list(self.folder.glob("x.*")), [])

    def test_what_is_refused(self):
        (self.folder / "folder.sqlite").mkdir()
        os.mkfifo(self.folder / "fifo.sqlite")
        (self.folder / "null.sqlite").symlink_to("/dev/null")
        for words, parts in (
                (["x.parquet"], ["option --trajectories: 'x.parquet'", "allowed:", "NAME.sqlite"]),
                (["x.sqlite.gz"], ["x.sqlite.gz", "cannot be written compressed"]),
                (["folder.sqlite"], ["folder.sqlite", "it is a folder"]),
                (["fifo.sqlite"], ["fifo.sqlite", "no plain file"]),
                (["null.sqlite"], ["null.sqlite", "no plain file"]),
                (["x.csv", "--trajectories-of", "all"], ["--trajectories-of: 'all'", "allowed:"]),
                (["x.txt", "--summary", "x.ids.csv"], ["same file"])):
            with self.subTest(words):
                message = self.run_with("--trajectories", *words, code=2)
                for part in parts:
                    self.assertIn(part, message)
                self.assertEqual(message.count("\n"), 1, message)
        self.assertEqual(list(self.folder.glob("*.partial")) + list(self.folder.glob("x.*")), [])


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
