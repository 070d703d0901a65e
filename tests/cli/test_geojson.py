#!/usr/bin/python3
"""`pedzone geojson`: valid by RFC 7946, and where SUMO's own tools put the same places.

usage: test_geojson.py PEDZONE_PROGRAM PROJECT_FOLDER
"""

import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy
from shapely.geometry import Point, shape

from tiny_scenario import TinyScenario, sumo_environment

sys.path.append(os.path.join(sumo_environment()["SUMO_HOME"], "tools"))
import sumolib  # noqa: E402

PEDZONE = PROJECT = None  # set from the command line
NEAR = 1e-6  # °
DIMENSIONS = {"Point": 0, "LineString": 1, "MultiPolygon": 3}  # of nested lists of positions
HOSTILE = "ü$(x)--%s{}#1"
WALKS = f"""<routes>
  <person id="{HOSTILE}" depart="0"><walk edges="west shared east"/></person>
  <person id="back" depart="1"><walk from="east" to="west"/></person>
  <vehicle id="v" depart="2"><route edges="west shared east"/></vehicle>
</routes>"""


def positions(coordinates, dimensions):
    if dimensions == 0:
        yield coordinates
        return
    for inner in coordinates:
        yield from positions(inner, dimensions - 1)


def turn(ring):
    """Twice the signed area: positive where the ring runs counter-clockwise."""
    x, y = numpy.array(ring).T
    x, y = x - x[0], y - y[0]  # or the digits are lost
    return (x[:-1] * y[1:] - x[1:] * y[:-1]).sum()


class GeoJsonCase(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="pedzone-geojson-")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def command(self, *words, code=0):
        done = subprocess.run([PEDZONE, *map(str, words)], cwd=self.folder, text=True,
                              capture_output=True, timeout=300, env=sumo_environment())
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def layers(self):
        return {path.stem: self.check_valid(json.loads(path.read_text(encoding="utf-8")))
                for path in (self.folder / "gis").iterdir()}

    def check_valid(self, collection):
        """RFC 7946, sections 2 to 4; its features."""
        self.assertEqual(collection.keys(), {"type", "features"})  # crs is forbidden (section 4)
        self.assertEqual(collection["type"], "FeatureCollection")
        for feature in collection["features"]:
            self.assertEqual(feature.keys(), {"type", "geometry", "properties"})
            self.assertEqual(feature["type"], "Feature")
            geometry = feature["geometry"]
            self.assertEqual(geometry.keys(), {"type", "coordinates"})
            dimensions = DIMENSIONS[geometry["type"]]
            for lon, lat in positions(geometry["coordinates"], dimensions):
                self.assertTrue(-180.0 <= lon <= 180.0 and -90.0 <= lat <= 90.0, (lon, lat))
            if geometry["type"] == "LineString":
                self.assertGreaterEqual(len(geometry["coordinates"]), 2)
            if geometry["type"] == "MultiPolygon":
                self.check_rings(geometry["coordinates"])
        return collection["features"]

    def check_rings(self, polygons):
        for outer, *holes in polygons:
            for ring in (outer, *holes):
                self.assertGreaterEqual(len(ring), 4)
                self.assertEqual(ring[0], ring[-1])
            self.assertGreater(turn(outer), 0.0)
            for hole in holes:
                self.assertLess(turn(hole), 0.0)


class OldTown(GeoJsonCase):
    """Bad Hersfeld: a network from OpenStreetMap."""

    def test_every_layer_lies_where_sumo_says(self):
        scenario = PROJECT / "scenarios/bad-hersfeld/centre-shuttle.sumocfg"
        net = sumolib.net.readNet(str(PROJECT / "networks/bad-hersfeld/centre-shuttle.net.xml.gz"))
        self.command("run", scenario, "--end", 90, "--seed", 1, "--quiet", "--trajectories",
                     "run.csv", "--conflict-csv", "conflicts.csv", "--conflicts-of", "all")
        said = self.command("geojson", scenario, "--recording", "run.csv", "--conflicts",
                            "conflicts.csv", "--out", "gis").stdout
        layers = self.layers()
        self.assertEqual(layers.keys(), {"zones", "walls", "paths", "density", "conflicts"})
        self.assertEqual({Path(line).stem for line in said.split()}, layers.keys())
        self.check_paths(net, layers["paths"])
        self.check_zones(layers)
        self.check_conflicts(net, layers["conflicts"])
        self.check_density(net, layers["density"])

    def rows(self, name):
        with open(self.folder / name, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def check_paths(self, net, paths):
        """Each begins and ends where the person was first and last."""
        first, last = {}, {}
        for row in self.rows("run.csv"):
            first.setdefault((row["id"], float(row["time"])), row)
            last[row["id"], float(row["time"])] = row
        self.assertGreater(len(paths), 20)
        for path in paths:
            properties, line = path["properties"], path["geometry"]["coordinates"]
            for row, place in ((first[properties["person"], properties["begin"]], line[0]),
                               (last[properties["person"], properties["end"]], line[-1])):
                lon_lat = net.convertXY2LonLat(float(row["x"]), float(row["y"]))
                numpy.testing.assert_allclose(place, lon_lat, atol=NEAR, rtol=0)
            self.assertGreater(properties["length"], 0.0)

    def check_zones(self, layers):
        ground = [shape(feature["geometry"]) for feature in layers["zones"]]
        self.assertTrue(all(polygons.is_valid for polygons in ground))
        rings = [ring for polygons in ground for polygon in polygons.geoms
                 for ring in (polygon.exterior, *polygon.interiors)]
        walls = [shape(feature["geometry"]) for feature in layers["walls"]]
        self.assertEqual(len(walls), len(rings))
        self.assertTrue(all(wall.is_ring for wall in walls))
        self.assertAlmostEqual(sum(wall.length for wall in walls),
                               sum(ring.length for ring in rings), places=9)
        # Area: a degree is 111.3 km, one of longitude less by the cosine of 50.86° north.
        for feature, polygons in zip(layers["zones"], ground):
            metres = polygons.area * 111_320.0 ** 2 * numpy.cos(numpy.radians(50.86))
            self.assertAlmostEqual(metres / feature["properties"]["area"], 1.0, delta=0.01)

    def check_conflicts(self, net, conflicts):
        rows = self.rows("conflicts.csv")
        self.assertGreater(len(rows), 2)
        self.assertEqual(len(conflicts), len(rows))
        for row, conflict in zip(rows, conflicts):
            measure = next(name for name in ("contact", "minTTC", "PET", "maxDRAC", "minClearance")
                           if row[name])
            place = net.convertXY2LonLat(float(row[measure + "_x"]), float(row[measure + "_y"]))
            numpy.testing.assert_allclose(conflict["geometry"]["coordinates"], place, atol=NEAR,
                                          rtol=0)
            for name in ("person", "vehicle", "type"):
                self.assertEqual(conflict["properties"][name], row[name])
            for name in ("minTTC", "PET"):
                value = conflict["properties"][name]
                self.assertEqual("" if value is None else f"{value:.2f}", row[name])

    def check_density(self, net, cells):
        rows = self.rows("run.csv")
        total = sum(cell["properties"]["personSeconds"] for cell in cells)
        self.assertAlmostEqual(total, 0.1 * len(rows), delta=0.1)
        duration = float(rows[-1]["time"]) - float(rows[0]["time"]) + 0.1
        row = rows[len(rows) // 2]
        at = Point(net.convertXY2LonLat(float(row["x"]), float(row["y"])))
        cell, = (cell for cell in cells if shape(cell["geometry"]).buffer(1e-9).covers(at))
        self.assertAlmostEqual(cell["properties"]["density"],
                               cell["properties"]["personSeconds"] / (4.0 * duration), places=9)
        x, y = numpy.floor(float(row["x"]) / 2) * 2, numpy.floor(float(row["y"]) / 2) * 2
        numpy.testing.assert_allclose(cell["geometry"]["coordinates"][0][0][0],
                                      net.convertXY2LonLat(x, y), atol=NEAR, rtol=0)


class TinyStreet(GeoJsonCase):
    def setUp(self):
        super().setUp()
        self.tiny = TinyScenario(self.folder)
        self.set_location("+proj=utm +zone=33 +datum=WGS84", "-500000.00,-5600000.00")
        self.tiny.write("tiny.rou.xml", WALKS)
        self.config = self.tiny.config()

    def set_location(self, projection, offset):
        net = self.folder / "tiny.net.xml"
        text = net.read_text()
        begin = text.index("<location")
        end = text.index("/>", begin)
        net.write_text(f'{text[:begin]}<location netOffset="{offset}" convBoundary="0,0,180,0" '
                       f'origBoundary="0,0,1,1" projParameter="{projection}"{text[end:]}')

    def test_an_offset_and_ids_that_want_escaping(self):
        self.command("run", self.config, "--quiet", "--trajectories", "run.csv")
        self.command("geojson", self.config, "--recording", "run.csv", "--out", "gis")
        layers = self.layers()
        self.assertEqual({path["properties"]["person"] for path in layers["paths"]},
                         {HOSTILE, "back"})
        net = sumolib.net.readNet(str(self.folder / "tiny.net.xml"))
        west, south, east, north = shape(layers["zones"][0]["geometry"]).bounds
        for (x, y), place in (((60.0, -8.0), (west, south)), ((120.0, 0.0), (east, north))):
            numpy.testing.assert_allclose(place, net.convertXY2LonLat(x, y), atol=1e-4, rtol=0)
        self.assertAlmostEqual(west, 15.0, delta=0.01)  # the zone's middle meridian

    def test_sumos_recordings_and_times(self):
        self.command("run", self.config, "--quiet", "--", "--fcd-output", "fcd.xml")
        self.command("geojson", self.config, "--recording", "fcd.xml", "--begin", 20, "--end", 40,
                     "--out", "gis")
        paths = self.layers()["paths"]
        self.assertEqual({(path["properties"]["begin"], path["properties"]["end"])
                          for path in paths}, {(20.0, 40.0)})

    def test_waypoints(self):
        self.tiny.write("tiny.add.xml", """<additional>
          <poi id="a" type="pedzone.waypoint" x="80" y="-4"/>
          <poi id="b" type="pedzone.waypoint" x="100" y="-5"/></additional>""")
        self.tiny.write("p.zone.xml", '<zones><path id="x" waypoints="b a"/></zones>')
        self.command("geojson", self.config, "--zone", "p.zone.xml", "--out", "gis")
        points = [feature["properties"] for feature in self.layers()["waypoints"]]
        self.assertEqual([(p["path"], p["order"], p["poi"]) for p in points],
                         [("x", 1, "b"), ("x", 2, "a")])

    def test_shapes_by_longitude_and_latitude(self):
        """A building is as in the way, and a waypoint where it is, as with the same places in m."""
        net = sumolib.net.readNet(str(self.folder / "tiny.net.xml"))
        building, waypoint = [(80, -6), (90, -6), (90, -3), (80, -3)], (100, -5)
        shape_in = {"false": building, "true": [net.convertXY2LonLat(*corner) for corner in building]}
        lon, lat = net.convertXY2LonLat(*waypoint)
        seen = {}
        for geo, place in (("false", 'x="100" y="-5"'), ("true", f'lon="{lon:.9f}" lat="{lat:.9f}"')):
            corners = " ".join(f"{a:.9f},{b:.9f}" for a, b in shape_in[geo])
            self.tiny.write("tiny.add.xml", f"""<additional>
              <poly id="house" type="building" geo="{geo}" shape="{corners}"/>
              <poi id="a" type="pedzone.waypoint" {place}/></additional>""")
            self.tiny.write("p.zone.xml", '<zones><path id="x" waypoints="a"/></zones>')
            told = json.loads(self.command("inspect", self.config, "--json").stdout)
            self.assertEqual(told["zones"][0]["warnings"], [])
            self.command("geojson", self.config, "--zone", "p.zone.xml", "--out", "gis")
            point, = self.layers()["waypoints"]
            numpy.testing.assert_allclose(point["geometry"]["coordinates"], (lon, lat), atol=1e-8,
                                          rtol=0)
            seen[geo] = told["zones"][0]["walkable_m2"]
        self.assertAlmostEqual(seen["true"], seen["false"], delta=0.05)
        self.tiny.write("tiny.add.xml", "<additional/>")
        free = json.loads(self.command("inspect", self.config, "--json").stdout)["zones"][0]
        self.assertAlmostEqual(free["walkable_m2"] - seen["true"], 30, delta=0.1)

    def check_refused(self, *parts, words=()):
        error = self.command("geojson", self.config, "--out", "gis", *words, code=2).stderr
        for part in parts:
            self.assertIn(part, error)
        self.assertEqual(error.count("\n"), 1, error)
        self.assertEqual(list(self.folder.glob("gis/*")), [])

    def test_networks_that_lie_nowhere(self):
        for projection in ("!", "", "-", "+proj=nonsense"):
            with self.subTest(projection):
                self.set_location(projection, "0.00,0.00")
                self.check_refused("tiny.net.xml", "projParameter", "+proj=utm")
        self.set_location("+proj=utm +zone=33", "0.00")
        self.check_refused("tiny.net.xml", "netOffset", "'0.00'", "x,y in m")
        self.set_location("+proj=utm +zone=33", "-1e30,0")
        self.check_refused("not on Earth")

    def test_recordings_that_are_none(self):
        self.tiny.write("bad.csv", "time,id\n")
        self.check_refused("bad.csv", words=("--recording", "bad.csv"))
        self.check_refused("none.csv", words=("--conflicts", "none.csv"))


if __name__ == "__main__":
    PROJECT = Path(sys.argv.pop(2)).resolve()
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
