#!/usr/bin/python3
"""What `pedzone run` and `pedzone conflicts` tell of people who cross a street anywhere.

usage: test_crossings.py PEDZONE_PROGRAM PROJECT_FOLDER
"""
import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

PEDZONE = PROJECT = None
HOSTILE = 'p#%(]=ö'  # what SUMO allows


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Crossings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        sys.path.append(str(PROJECT / "tests/scenario/crossing"))
        import street
        cls.street = street
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.folder = Path(directory.name)
        routes = street.demand(1, 1200, 300, 400)
        first = f'<person id="{HOSTILE}" type="person" depart="0" departPos="50"><walk ' \
                'edges="eastward westward" arrivalPos="150"/></person>'
        street.write_scenario(cls.folder, routes.replace("\n", "\n" + first + "\n", 1), 600)
        street.run_pedzone(cls.folder, PEDZONE, 1, "--crossing-output", "crossings.csv")

    def pedzone(self, *words, code=0):
        done = subprocess.run([PEDZONE, *words], cwd=self.folder, env=self.street.ENV, text=True,
                              capture_output=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout + done.stderr

    def observed(self, *words):
        return self.pedzone("conflicts", "pedzone.fcd.xml", "--scenario", "s.sumocfg", "--zone",
                            "s.zone.xml", *words)

    def test_the_table_has_who_stepped_out_where_and_when(self):
        crossings = rows(self.folder / "crossings.csv")
        self.assertIn(HOSTILE, {row["person"] for row in crossings})
        self.assertGreater(len(crossings), 20)
        seen = self.street.read_fcd(self.folder / "pedzone.fcd.xml")
        for row in crossings:
            track = {round(time, 2): (x, y) for time, x, y in seen.walks[row["person"]].track}
            x, y = track[round(float(row["time"]), 2)]
            self.assertAlmostEqual(x, float(row["x"]), delta=0.2)
            self.assertAlmostEqual(y, float(row["y"]), delta=0.2)
            self.assertEqual((row["zone"], float(row["width"])), ("street", 7.0))
            self.assertEqual(row["looked"], "true")

    def test_the_summary_counts_them(self):
        crossings = rows(self.folder / "crossings.csv")
        summary = json.loads((self.folder / "pedzone.json").read_text())["crossings"]
        self.assertEqual(summary["stepped_out"], len(crossings))
        waited = sum(float(row["waited"]) for row in crossings) / len(crossings)
        self.assertAlmostEqual(summary["mean_wait_s"], waited, delta=0.01)
        taken = sum(row["gap"] != "" for row in crossings)
        left = sum(len(row["rejected"].split()) for row in crossings)
        self.assertEqual((summary["median_gap"]["taken"], summary["median_gap"]["let_pass"]),
                         (taken, left))

    def test_an_observer_counts_the_same_people(self):
        told = self.observed("--crossing-csv", "seen.csv", "--crossing-svg", "seen.svg")
        self.assertRegex(told, r"Streets were crossed \d+ times, \d+ of them between the junctions")
        seen = {row["person"] for row in rows(self.folder / "seen.csv") if row["place"] == "between"}
        stepped_out = {row["person"] for row in rows(self.folder / "crossings.csv")}
        # Who is still on its way at the end has not crossed yet.
        self.assertLessEqual(seen, stepped_out)
        self.assertGreater(len(seen), 0.9 * len(stepped_out))
        self.assertTrue(xml.parse(self.folder / "seen.svg").getroot().tag.endswith("svg"))

    def test_conflicts_are_told_by_the_half_of_the_street(self):
        told = self.observed("--crossing-csv", "seen.csv", "--conflict-csv", "conflicts.csv")
        crossings = [row for row in rows(self.folder / "seen.csv") if row["place"] == "between"]
        begins = {(row["person"], float(row["begin"])): row for row in crossings}
        self.assertEqual(len(begins), len(crossings))
        seen = self.street.read_fcd(self.folder / "pedzone.fcd.xml")
        found = {key: [0, 0] for key in begins}
        for row in rows(self.folder / "conflicts.csv"):
            moment = next(name for name in ("contact", "minTTC", "PET") if row[name])
            put = row["contact"] and float(row["contact_time"]) <= float(row["begin"])
            x, y, time, speed = (float(row[f"{moment}_{what}"])
                                 for what in ("x", "y", "time", "vehicleSpeed"))
            if put or speed <= 0.5 or not 0 <= x <= self.street.LENGTH or abs(y) > 3.5:
                continue
            if moment == "PET" and row["first"] == "person":
                time -= float(row["PET"])  # when the person was there
            for (person, begin), crossing in begins.items():
                if person != row["person"] or not begin <= time <= float(crossing["end"]):
                    continue
                came_from = min(seen.walks[person].track, key=lambda one: abs(one[0] - begin))[2]
                found[person, begin][y * came_from < 0] += 1
        self.assertEqual(found, {key: [int(row["near_conflicts"]), int(row["far_conflicts"])]
                                 for key, row in begins.items()})
        near, far = (sum(one[half] for one in found.values()) for half in (0, 1))
        self.assertGreater(min(near, far), 0)
        self.assertNotEqual(near, far)  # else nobody would see them swapped
        self.assertIn(f"{near} on the near half", told)
        self.assertIn(f"{far} on the far one", told)
        printed = subprocess.run([PEDZONE, "conflicts", "pedzone.fcd.xml", "--scenario", "s.sumocfg",
                                  "--zone", "s.zone.xml", "--json"], cwd=self.folder, check=True,
                                 env=self.street.ENV, text=True, capture_output=True).stdout
        numbers = json.loads(printed)["crossings"]
        self.assertEqual((numbers["near_conflicts"], numbers["far_conflicts"]), (near, far))
        self.assertEqual(numbers["between"], len(crossings))
        self.assertIn(f"{numbers['all']} times, {numbers['between']} of them", told)

    def test_plain_sumo_crosses_at_the_junctions(self):
        self.street.run_sumo(self.folder, 1)
        told = self.pedzone("conflicts", "sumo.fcd.xml", "--scenario", "s.sumocfg", "--zone",
                            "s.zone.xml")
        self.assertRegex(told, r"Streets were crossed \d+ times, 0 of them between")

    def test_zone_needs_a_street_and_a_scenario(self):
        (self.folder / "plain.zone.xml").write_text(
            '<zones><zone id="z" edges="eastward westward"/></zones>')
        told = self.pedzone("conflicts", "pedzone.fcd.xml", "--scenario", "s.sumocfg", "--zone",
                            "plain.zone.xml", code=2)
        self.assertIn("has no street to watch", told)
        self.assertIn('crossing="anywhere"', told)
        told = self.pedzone("conflicts", "pedzone.fcd.xml", "--zone", "s.zone.xml", code=2)
        self.assertIn("needs --scenario", told)

    def test_another_crossing_is_refused(self):
        (self.folder / "wrong.zone.xml").write_text(
            '<zones><zone id="z" edges="eastward westward" crossing="sometimes"/></zones>')
        told = self.pedzone("run", "s.sumocfg", "--zone", "wrong.zone.xml", code=2)
        self.assertRegex(told, r"wrong.zone.xml:1: .*crossing.*'sometimes'.*nodes, anywhere")

    def test_where_it_changes_nothing_a_warning_says_so(self):
        (self.folder / "one.zone.xml").write_text(
            '<zones><zone id="z" edges="eastward" crossing="anywhere"/></zones>')
        told = self.pedzone("inspect", "s.sumocfg", "--zone", "one.zone.xml")
        self.assertIn("changes nothing", told)

    def test_trajectories_lie_on_the_ground_that_is_told(self):
        self.street.run_pedzone(self.folder, PEDZONE, 1, "--trajectories", "t.sqlite")
        from shapely import wkt
        import sqlite3
        base = sqlite3.connect(self.folder / "t.sqlite")
        ground = wkt.loads(base.execute("select wkt from geometry").fetchone()[0])
        from shapely.geometry import Point
        places = base.execute("select pos_x, pos_y from trajectory_data where frame % 10 = 0")
        outside = [place for place in places if ground.distance(Point(place)) > 0.05]
        self.assertEqual(outside, [])


if __name__ == "__main__":
    PEDZONE, PROJECT = os.path.abspath(sys.argv.pop(1)), Path(sys.argv.pop(1)).resolve()
    unittest.main()
