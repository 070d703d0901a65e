#!/usr/bin/python3
"""Paths of waypoints: what is refused, and what --debug-shapes writes.

usage: test_waypoints.py PEDZONE_PROGRAM
"""

import math
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

from refusal import RefusalChecks
from tiny_scenario import TinyCase, sumo_environment

PEDZONE = None  # set from the command line

# The shared street leads from (60, 0) to (120, 0) and is 8 m wide.
POIS = """<additional>
<poi id="first" type="pedzone.waypoint" x="80" y="-3"><param key="pedzone.radius" value="1.5"/></poi>
<poi id="second" type="pedzone.waypoint" lane="shared_0" pos="30" posLat="2"/>
<poi id="far" type="pedzone.waypoint" x="80" y="50"/>
<poi id="shop" type="other" x="80" y="-3"/>
{more}</additional>"""

ZONES = """<zones>
<path id="tour" waypoints="{waypoints}"/>
<zone id="z"><param key="waypointRadius" value="1.2"/></zone>
</zones>"""

WALKS = """<routes>
<vType id="tourist" vClass="pedestrian"><param key="pedzone.path" value="{path}"/></vType>
<person id="p0" depart="0" type="tourist"><walk edges="west shared east"/></person>
<person id="p1" depart="1"><walk edges="shared" departPos="5" arrivalPos="50"/></person>
</routes>"""


class Waypoints(RefusalChecks, TinyCase):
    def run_tour(self, waypoints="first second", path="tour", more="", words=(), zones=ZONES):
        """`pedzone run` with outputs into out/; returns the finished process."""
        self.tiny.config()
        self.tiny.write("tiny.add.xml", POIS.format(more=more))
        self.tiny.write("tiny.rou.xml", WALKS.format(path=path))
        self.tiny.write("tiny.zone.xml", zones.format(waypoints=waypoints))
        return subprocess.run(
            [PEDZONE, "run", "tiny.sumocfg", "--zone", "tiny.zone.xml", "--debug-shapes",
             "out/shapes.xml", "--trajectories", "out/trajectories.csv", *words],
            cwd=self.folder, text=True, capture_output=True, timeout=120)

    def circles(self):
        """Of the tour: x, y, radius."""
        net = ET.parse(self.folder / "tiny.net.xml").getroot()
        lane = next(node for node in net.iter("lane") if node.get("id") == "shared_0")
        x, y = map(float, lane.get("shape").split()[0].split(","))  # it leads due east
        return [(80, -3, 1.5), (x + 30, y + 2, 1.2)]

    def shapes(self):
        return ET.parse(self.folder / "out/shapes.xml").getroot()

    # What works

    def test_a_tourist_comes_by(self):
        done = self.run_tour()
        self.assertEqual(done.returncode, 0, done.stderr)
        left = self.circles()
        for row in (self.folder / "out/trajectories.csv").read_text().splitlines()[1:]:
            _, person, x, y, *_ = row.split(",")
            if person == "p0" and left:
                px, py, radius = left[0]
                if math.hypot(float(x) - px, float(y) - py) <= radius:
                    left.pop(0)
        self.assertEqual(left, [])

    def test_shapes_show_paths_and_people(self):
        done = self.run_tour(words=("--debug-time", "10"))
        self.assertEqual(done.returncode, 0, done.stderr)
        of_type = {}
        for node in self.shapes():
            of_type.setdefault((node.tag, node.get("type")), []).append(node)
        points = of_type["poi", "pedzone.debug.waypoint"]
        self.assertEqual([(float(p.get("x")), float(p.get("y"))) for p in points],
                         [(x, y) for x, y, _ in self.circles()])
        for poly, (x, y, radius) in zip(of_type["poly", "pedzone.debug.radius"], self.circles()):
            for point in poly.get("shape").split():
                px, py = map(float, point.split(","))
                self.assertAlmostEqual(math.hypot(px - x, py - y), radius, delta=0.011)
        self.assertEqual(len(of_type["poly", "pedzone.debug.path"]), 1)
        # p1 walks in the zone at that time; it stands where its lines begin.
        rows = [row.split(",") for row in
                (self.folder / "out/trajectories.csv").read_text().splitlines()[1:]]
        place = next((float(row[2]), float(row[3])) for row in rows
                     if row[1] == "p1" and float(row[0]) == 10.0)
        for kind in ("rays", "aim", "direction"):
            shape = next(p.get("shape") for p in of_type["poly", f"pedzone.debug.{kind}"]
                         if p.get("id") == f"pedzone.debug.{kind}.p1")
            x, y = map(float, shape.split()[0].split(","))
            self.assertAlmostEqual(x, place[0], delta=0.011)
            self.assertAlmostEqual(y, place[1], delta=0.011)

    def test_sumo_loads_the_shapes(self):
        self.run_tour(words=("--debug-time", "10"))
        schema = ('xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" '
                  'xsi:noNamespaceSchemaLocation="http://sumo.dlr.de/xsd/additional_file.xsd"')
        text = (self.folder / "out/shapes.xml").read_text()
        self.assertIn("pedzone.debug.rays.p1", text)
        # Naming the schema makes SUMO check against it.
        self.tiny.write("shapes.add.xml", text.replace("<additional>", f"<additional {schema}>"))
        done = subprocess.run(
            ["sumo", "-c", "tiny.sumocfg", "-a", "tiny.add.xml,shapes.add.xml", "--end", "1"],
            cwd=self.folder, text=True, capture_output=True, timeout=60, env=sumo_environment())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("Error", done.stderr)
        self.assertNotIn("pedzone.debug", done.stderr)

    def test_at_the_end_nobody_is_left(self):
        self.assertEqual(self.run_tour().returncode, 0)
        types = {node.get("type") for node in self.shapes()}
        self.assertEqual(types, {"pedzone.debug.path", "pedzone.debug.waypoint",
                                 "pedzone.debug.radius"})

    # What is refused

    def test_unknown_path(self):
        self.check_refused(self.run_tour(path="tuor"), "tiny.rou.xml:2: <param", "'tuor'",
                           "is no path", "allowed: tour")

    def test_path_without_a_zone_file(self):
        self.run_tour()
        (self.folder / "out/shapes.xml").unlink()
        (self.folder / "out/trajectories.csv").unlink()
        done = subprocess.run([PEDZONE, "run", "tiny.sumocfg"], cwd=self.folder, text=True,
                              capture_output=True, timeout=120)
        self.check_refused(done, "tiny.rou.xml:2", "'tour'", "allowed: none")

    def test_unknown_poi(self):
        self.check_refused(self.run_tour("first third"), "tiny.zone.xml:2: <path id=\"tour\">",
                           "'third' is no POI", "allowed: first, second, far")

    def test_poi_of_another_type(self):
        self.check_refused(self.run_tour("shop"), "tiny.zone.xml:2", "'shop' is no POI")

    def test_empty_path(self):
        self.check_refused(self.run_tour(" "), "tiny.zone.xml:2: <path", "is empty")

    def test_waypoint_outside(self):
        self.check_refused(self.run_tour("first far"), "tiny.zone.xml:2: <path",
                           "'far' lies outside every zone", "allowed: ")

    def test_waypoint_in_a_building(self):
        more = """<poly id="house" type="building" shape="78,-5 82,-5 82,-1 78,-1"/>"""
        self.check_refused(self.run_tour(more=more), "tiny.zone.xml:2", "'first' lies outside")

    def test_waypoint_in_a_yard_without_a_door(self):
        more = """<poly id="yard" type="pedzone.walkable" shape="75,20 85,20 85,30 75,30"/>
<poi id="in_yard" type="pedzone.waypoint" x="80" y="25"/>"""
        zones = ZONES.replace('<zone id="z">', '<zone id="z" polygons="yard" openSpace="0">')
        self.check_refused(self.run_tour("first in_yard", more=more, zones=zones),
                           "tiny.zone.xml:2", "'in_yard' lies outside")

    def test_radii(self):
        for radius in ("0", "-1", "20.5", "wide", "nan"):
            more = f"""<poi id="bad" type="pedzone.waypoint" x="80" y="-3">
<param key="pedzone.radius" value="{radius}"/></poi>"""
            self.check_refused(self.run_tour(more=more), "tiny.add.xml:7: <param", f"'{radius}'",
                               "20")

    def test_other_faults_of_pois(self):
        for more, *fragments in (
                ('<poi id="first" type="pedzone.waypoint" x="1" y="1"/>', "'first' is used twice"),
                ('<poi id="b" type="pedzone.waypoint" x="1"/>', "attribute y"),
                ('<poi id="b" type="pedzone.waypoint" lon="1" lat="2"/>', "'1'", "x and y"),
                ('<poi id="b" type="pedzone.waypoint" lane="nowhere" pos="1"/>', "'nowhere'"),
                ('<poi id="b" type="pedzone.waypoint" lane="shared_0" pos="900"/>', "'900'"),
                ('<poi id="b" type="pedzone.waypoint" x="1" y="1"><param key="pedzone.radios"'
                 ' value="1"/></poi>', "'pedzone.radios'", "allowed: pedzone.radius")):
            self.check_refused(self.run_tour(more=more), "tiny.add.xml:6", *fragments)

    def test_time_without_shapes(self):
        self.tiny.config()
        done = subprocess.run([PEDZONE, "run", "tiny.sumocfg", "--debug-time", "3"],
                              cwd=self.folder, text=True, capture_output=True, timeout=120)
        self.check_refused(done, "--debug-shapes")


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
