#!/usr/bin/python3
"""`pedzone plot`: pictures of real runs of pedzone and of plain SUMO show what SUMO's floating-car
data say, whatever the ids are; and every kind of bad input.

usage: test_plot.py PEDZONE_PROGRAM SCENARIOS_FOLDER
"""

import csv
import gzip
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy
from shapely.geometry import Point, Polygon, box

from drawn import SVG, Picture, Recorded, corners, lightness, numbers, points
from refusal import RefusalChecks
from tiny_scenario import FCD, sumo_environment

PEDZONE = SCENARIOS = None  # set from the command line
ROUNDED = 0.02  # [m] positions in files and pictures are rounded to 0.01 m, twice
RADIUS = 0.239  # [m] of SUMO's default pedestrian: half its width of 0.478 m
SHUTTLE = (3.93, 1.98)  # [m] length and width
SHOWN = ("--begin", "60", "--end", "110")

ROWS = """time,id,x,y,vx,vy,heading,motion,activity
0.00,p,1,2,0,1,1.57,walking,none
1.00,p,1,3,0,1,1.57,walking,none
"""
TYPES = '<routes><vType id="van" length="6" width="2"/></routes>'


def call(folder, *words, env=None):
    return subprocess.run(list(map(str, words)), cwd=folder, text=True, capture_output=True,
                          timeout=250, env=env or sumo_environment())


class Runs(unittest.TestCase):
    """Pictures of the scenario `waypoints`, walked by pedzone and by SUMO."""

    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.directory.name)
        home = SCENARIOS / "waypoints"
        cls.config, cls.zone = home / "waypoints.sumocfg", home / "waypoints.zone.xml"
        done = call(cls.folder, PEDZONE, "run", cls.config, "--zone", cls.zone, "--end", "120",
                    "--trajectories", "run.csv", "--", "--xml-validation", "never",
                    "--fcd-output", cls.folder / "run.fcd.xml.gz")
        assert done.returncode == 0, done.stderr
        done = call(cls.folder, "sumo", "-c", cls.config, "--end", "120", "--no-step-log",
                    "--xml-validation", "never", "--fcd-output", cls.folder / "sumo.fcd.xml")
        assert done.returncode == 0, done.stderr
        with gzip.open(cls.folder / "run.fcd.xml.gz") as file:
            cls.run_fcd = Recorded(file)
        cls.sumo_fcd = Recorded(cls.folder / "sumo.fcd.xml")

    @classmethod
    def tearDownClass(cls):
        cls.directory.cleanup()

    def plot(self, name, *words, out="out.svg"):
        done = call(self.folder, PEDZONE, "plot", name, "--scenario", self.config, "--zone",
                    self.zone, "--out", out, *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return Picture(self.folder / out) if out.endswith(".svg") else self.folder / out

    def check_time_plot(self, picture, recorded, times, least=5):
        """Exactly those who are in the picture, where the recording has them."""
        discs, outlines = picture.discs(), picture.outlines()
        map_box = box(*picture.box)
        for time in times:
            for who, row in recorded.persons[time].items():
                if picture.holds(row["x"], row["y"], -ROUNDED):
                    x, y, _ = discs[who, time]
                    self.assertAlmostEqual(x, row["x"], delta=ROUNDED)
                    self.assertAlmostEqual(y, row["y"], delta=ROUNDED)
            for who, row in recorded.vehicles[time].items():
                body = corners(row, *SHUTTLE)
                if Polygon(body).distance(map_box) == 0:
                    drawn = Polygon(outlines[who, time][0])
                    self.assertLess(drawn.symmetric_difference(Polygon(body)).area, 0.2)
        for who, time in discs:
            self.assertIn(who, recorded.persons[time])
        for who, time in outlines:
            self.assertIn(who, recorded.vehicles[time])
        self.assertEqual({time for _, time in discs}, set(times))
        self.assertGreater(len(discs), least * len(times))
        self.assertGreater(len(outlines), 3)

    def test_time_plot_of_a_run_shows_everybody_at_even_moments(self):
        picture = self.plot("run.fcd.xml.gz", *SHOWN, "--every", "5")
        times = [5.0 * k for k in range(12, 23)]
        self.check_time_plot(picture, self.run_fcd, times)

    def test_time_plot_of_plain_sumo_is_drawn_alike(self):
        picture = self.plot("sumo.fcd.xml", *SHOWN, "--every", "10")
        self.check_time_plot(picture, self.sumo_fcd, [60.0, 70.0, 80.0, 90.0, 100.0, 110.0])

    def test_time_plot_of_trajectories_with_everybody_else_of_floating_car_data(self):
        picture = self.plot("run.csv", "--fcd", "run.fcd.xml.gz", *SHOWN, "--every", "10")
        discs = picture.discs()
        with open(self.folder / "run.csv", newline="") as file:
            rows = {(row["id"], float(row["time"])): row for row in csv.DictReader(file)}
        self.assertGreater(len(discs), 30)
        walked_by_sumo = 0
        for key, (x, y, _) in discs.items():
            who, time = key
            row = rows[key] if key in rows else self.run_fcd.persons[time][who]
            walked_by_sumo += key not in rows
            self.assertAlmostEqual(x, float(row["x"]), delta=ROUNDED)
            self.assertAlmostEqual(y, float(row["y"]), delta=ROUNDED)
        self.assertGreater(walked_by_sumo, 0)
        self.assertGreater(len(picture.outlines()), 3)
        self.assertEqual(picture.pale(), {key for key in discs if key not in rows})

    def test_ways_of_people_whom_sumo_walks_are_paler(self):
        self.plot("run.csv", "--fcd", "run.fcd.xml.gz", *SHOWN, "--kind", "path")
        with_everybody = (self.folder / "out.svg").read_text()
        self.plot("run.csv", *SHOWN, "--kind", "path")
        self.assertIn('opacity="0.4"', with_everybody)
        self.assertIn("walked by SUMO", with_everybody)
        self.assertNotIn("walked by SUMO", (self.folder / "out.svg").read_text())

    def test_snapshots(self):
        done = call(self.folder, PEDZONE, "plot", "run.fcd.xml.gz", "--scenario", self.config,
                    "--zone", self.zone, "--at", "70", "90", "--out", "out.svg")
        self.assertEqual(done.returncode, 0, done.stderr)
        root = ET.parse(self.folder / "out.svg").getroot()
        pictures = root.findall(".//{http://www.w3.org/2000/svg}svg")
        self.assertEqual(len(pictures), 2)
        for picture, time in zip(pictures, ("70", "90")):
            titles = [one.text for one in picture.iter("{http://www.w3.org/2000/svg}title")]
            persons = [one for one in titles if one and re.search(r" at \S+ s$", one)]
            self.assertGreater(len(persons), 3)
            self.assertTrue(all(one.endswith(f" at {time} s") for one in persons), persons[:3])

    def test_colours_get_lighter_with_time_for_persons_and_vehicles_alike(self):
        picture = self.plot("run.fcd.xml.gz", *SHOWN)
        colours = {}
        for (_, time), (*_, colour) in [*picture.discs().items(), *picture.outlines().items()]:
            colours.setdefault(time, set()).add(colour)
        times = sorted(colours)
        self.assertTrue(10 <= len(times) <= 21, times)
        self.assertEqual({len(same) for same in colours.values()}, {1})
        rising = [lightness(*colours[time]) for time in times]
        self.assertEqual(rising, sorted(rising))
        self.assertEqual(len(set(rising)), len(rising))
        bar = [lightness(piece.get("fill")) for piece in picture.of_class("scale")]
        self.assertEqual(bar, sorted(bar))
        ticks = [float(text.text) for text in picture.of_class("tick")]
        self.assertGreater(len(ticks), 3)
        self.assertTrue(all(60 <= tick <= 110 for tick in ticks), ticks)

    def test_waypoints_are_stars_and_obstacles_and_the_zone_are_there(self):
        picture = self.plot("run.fcd.xml.gz", *SHOWN)
        drawn = {}
        for path in picture.of_class("star"):
            drawn[path.find(SVG + "title").text] = Polygon(
                [picture.place(*point) for point in points(path)[0]]).centroid
        pois = ET.parse(SCENARIOS / "waypoints" / "waypoints.add.xml").getroot().findall("poi")
        placed = {f"waypoint {poi.get('id')}": Point(float(poi.get("x")), float(poi.get("y")))
                  for poi in pois if poi.get("x") is not None}
        self.assertEqual(len(placed), 4)
        for name, place in placed.items():
            self.assertLess(drawn[name].distance(place), 0.1)
        titles = [title.text for title in picture.root.iter(SVG + "title")]
        self.assertIn("zone plaza", titles)
        legend = [text.text for text in picture.root.iter(SVG + "text")]
        for name in ("zone plaza", "obstacle", "waypoint with its radius", "time [s]",
                     "vehicle at the same times"):
            self.assertIn(name, legend)

    def test_maps_have_one_scale(self):
        for kind in ("time", "path"):
            picture = self.plot("run.fcd.xml.gz", *SHOWN, "--kind", kind)
            width, height = float(picture.root.get("width")), float(picture.root.get("height"))
            self.assertAlmostEqual(picture.page[0] / width, picture.page[1] / height, delta=0.001)
            self.assertAlmostEqual(picture.page[0], picture.box[2] - picture.box[0], delta=ROUNDED)

    def test_area_asked_for_is_shown(self):
        picture = self.plot("run.fcd.xml.gz", "--begin", "80", "--end", "110", "--every", "2",
                            "--area", "-20", "-18", "20", "17")
        self.assertEqual(picture.box, [-20.0, -18.0, 20.0, 17.0])
        self.check_time_plot(picture, self.run_fcd, [2.0 * k for k in range(40, 56)], least=2)

    def test_path_plot_follows_everybody(self):
        picture = self.plot("run.fcd.xml.gz", *SHOWN, "--kind", "path")
        ways = {}
        for path in picture.group("persons").iter(SVG + "path"):
            ways.setdefault(path.find(SVG + "title").text, []).extend(points(path)[0])
        shown = {}
        for time, persons in self.run_fcd.persons.items():
            if 60 <= time <= 110:
                for who, row in persons.items():
                    shown.setdefault(who, []).append((row["x"], row["y"]))
        for who, places in shown.items():
            if sum(picture.holds(*place, -1.0) for place in places) > 1:
                self.assertIn(who, ways)
        self.assertGreater(len(ways), 12)
        for who, way in ways.items():
            places = numpy.array(shown[who])
            for point in way:
                gaps = numpy.hypot(*(places - picture.place(*point)).T)
                self.assertLess(gaps.min(), ROUNDED)

    def few(self):
        """Three who are there throughout."""
        times = [time for time in self.run_fcd.persons if 60 <= time <= 110]
        there = set.intersection(*(set(self.run_fcd.persons[time]) for time in times))
        return sorted(there)[:3]

    def test_few_persons_have_a_line_and_a_name_each(self):
        few = self.few()
        for kind in ("path", "speed", "clearance"):
            picture = self.plot("run.fcd.xml.gz", *SHOWN, "--kind", kind, "--persons", *few)
            legend = [text.text for text in picture.root.iter(SVG + "text")]
            for who in few:
                self.assertIn(who, legend)

    def test_speed_chart_has_the_recorded_speeds(self):
        few = self.few()
        lines = self.plot("run.fcd.xml.gz", *SHOWN, "--kind", "speed", "--persons", *few).lines()
        self.assertEqual(sorted(lines), few)
        for who, line in lines.items():
            self.assertAlmostEqual(line[0][0], 60.0, delta=0.1)
            self.assertAlmostEqual(line[-1][0], 110.0, delta=0.1)
            for time, speed in line:
                recorded = self.run_fcd.persons[round(time, 1)][who]["speed"]
                self.assertAlmostEqual(speed, recorded, delta=0.02)

    def test_clearance_chart_has_the_room_to_the_nearest_moving_vehicle(self):
        few = self.few()
        lines = self.plot("run.fcd.xml.gz", *SHOWN, "--kind", "clearance", "--persons",
                          *few).lines()
        self.assertEqual(sorted(lines), few)
        compared = 0
        for who, line in lines.items():
            for time, clearance in line:
                time = round(time, 1)
                row = self.run_fcd.persons[time][who]
                rooms = [Polygon(corners(car, *SHUTTLE)).distance(Point(row["x"], row["y"]))
                         for car in self.run_fcd.vehicles[time].values() if car["speed"] >= 0.1]
                self.assertAlmostEqual(clearance, min(rooms) - RADIUS, delta=0.05)
                compared += 1
        self.assertGreater(compared, 30)

    def test_many_persons_are_summed_up(self):
        lines = self.plot("run.fcd.xml.gz", *SHOWN, "--kind", "speed").lines()
        self.assertEqual(list(lines), ["median"])
        for time, speed in lines["median"]:
            speeds = [row["speed"] for row in self.run_fcd.persons[round(time, 1)].values()]
            self.assertAlmostEqual(speed, numpy.median(speeds), delta=0.02)
        lines = self.plot("run.fcd.xml.gz", *SHOWN, "--kind", "clearance").lines()
        self.assertEqual(sorted(lines), ["least", "median"])

    def test_png_has_the_width_asked_for(self):
        file = self.plot("run.fcd.xml.gz", *SHOWN, "--width", "800", out="out.png")
        data = file.read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        picture = self.plot("run.fcd.xml.gz", *SHOWN)
        width, height = struct.unpack(">II", data[16:24])
        self.assertEqual(width, 800)
        self.assertAlmostEqual(height, 800 * picture.page[1] / picture.page[0], delta=1.5)


class SmallFiles(RefusalChecks, unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.folder = Path(self.directory.name)
        self.write("types.rou.xml", TYPES)
        self.write("fcd.xml", FCD.format(person="p"))
        self.write("run.csv", ROWS)

    def tearDown(self):
        self.directory.cleanup()

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def plot(self, file, *words, env=None):
        words = list(words) if "--out" in words else ["--out", "out/plot.svg", *words]
        return call(self.folder, PEDZONE, "plot", file, "--vtypes", "types.rou.xml", *words, env=env)

    def refused(self, name, text, *fragments, words=()):
        self.write(name, text)
        self.check_refused(self.plot(name, *words), name, *fragments)

    # What is drawn

    def test_without_a_scenario(self):
        for kind in ("time", "path", "speed", "clearance"):
            done = self.plot("fcd.xml", "--kind", kind)
            self.assertEqual(done.returncode, 0, done.stderr)
            Picture(self.folder / "out/plot.svg")

    def test_hostile_ids_are_text(self):
        hostile = "&lt;/title&gt;&lt;script&gt;alert(1)&lt;/script&gt; \" onload=&quot;x,&#10;&amp;'"
        self.write("fcd.xml", FCD.replace('id="{person}"', "id='{person}'").format(
            person=hostile.replace("'", "&apos;")))
        for kind in ("time", "path", "speed"):
            done = self.plot("fcd.xml", "--kind", kind)
            self.assertEqual(done.returncode, 0, done.stderr)
            picture = Picture(self.folder / "out/plot.svg")
            tags = {element.tag.removeprefix(SVG) for element in picture.root.iter()}
            self.assertLessEqual(tags, {"svg", "title", "rect", "path", "circle", "g", "text",
                                        "clipPath"})
            self.assertTrue(all("onload" not in element.attrib for element in picture.root.iter()))
            texts = "".join(picture.root.itertext())
            self.assertIn("</title><script>alert(1)</script> \" onload=\"x,&'", texts)

    def test_groups_have_a_colour_each(self):
        people = "".join(f'<person id="p{i}" depart="0"><param key="pedzone.group" '
                         f'value="team {i % 3}"/></person>' for i in range(15))
        self.write("types.rou.xml", f"<routes>{people}</routes>")
        rows = [f"{time},p{i},{i},{time + 2},0,1,1.57,walking,none\n"
                for time in range(3) for i in range(15)]
        self.write("run.csv", ROWS.splitlines()[0] + "\n" + "".join(rows))
        done = self.plot("run.csv", "--kind", "path")
        self.assertEqual(done.returncode, 0, done.stderr)
        groups = Picture(self.folder / "out/plot.svg").group("persons").findall(SVG + "g")
        self.assertEqual([len(group) for group in groups], [5, 5, 5])
        self.assertEqual(len({group.get("stroke") for group in groups}), 3)
        texts = "".join(Picture(self.folder / "out/plot.svg").root.itertext())
        self.assertIn("group team 2 (5)", texts)

    def test_help_has_examples(self):
        done = call(self.folder, PEDZONE, "plot", "--help")
        self.assertEqual(done.returncode, 0)
        for fragment in ("Examples:", "--kind clearance", "sumo -c", "median"):
            self.assertIn(fragment, done.stdout)

    # Bad input

    def test_missing_file(self):
        self.check_refused(self.plot("gone.csv"), "gone.csv", "cannot be opened")

    def test_empty_files(self):
        self.refused("none.xml", "", "is empty", "fcd-output")
        self.refused("none.csv", " \n", "is empty")
        self.refused("none.fcd.xml", "<fcd-export/>", "has no person")
        self.refused("header.csv", ROWS.splitlines()[0] + "\n", "has no person")

    def test_files_of_others(self):
        self.refused("trips.xml", "<tripinfos>\n</tripinfos>", "trips.xml:1", "tripinfos",
                     "fcd-export")
        self.refused("other.csv", "t,x,y\n0,1,2\n", "other.csv:1", "t,x,y", "time,id,x,y")

    def test_cut_off(self):
        self.refused("cut.xml", FCD.format(person="p")[:-20], "cut.xml:", "not well-formed")
        self.refused("cut.csv", ROWS[:-12], "cut.csv:3", "cut off")
        data = gzip.compress(("".join(FCD.format(person=i) for i in range(200))).encode())
        (self.folder / "cut.xml.gz").write_bytes(data[:len(data) // 2])
        self.check_refused(self.plot("cut.xml.gz"), "cut.xml.gz")
        data = gzip.compress((ROWS + "".join(f"{i}.5,p,{i * 37 % 101},3,0,1,0,walking,none\n"
                                             for i in range(2, 4000))).encode())
        (self.folder / "cut.csv.gz").write_bytes(data[:len(data) // 2])
        self.check_refused(self.plot("cut.csv.gz"), "cut.csv.gz")

    def test_no_numbers(self):
        self.refused("words.csv", ROWS.replace(",3,", ",three,"), "words.csv:3", "column y",
                     "'three'", "number")
        self.refused("words.xml", FCD.format(person="p").replace('y="3.00"', 'y="north"'),
                     "words.xml:7", 'id="p"', "y", "north", "number")
        self.refused("far.csv", ROWS.replace(",3,", ",1e300,"), "far.csv:3", "out of range")

    def test_other_words(self):
        self.refused("run.csv", ROWS.replace("walking", "flying", 1), "run.csv:2", "column motion",
                     "'flying'", "waiting")

    def test_type_whose_size_is_not_known(self):
        self.write("types.rou.xml", "<routes/>")
        self.check_refused(self.plot("fcd.xml"), "fcd.xml:3", "van", "--vtypes")

    def test_persons_who_are_not_there(self):
        self.check_refused(self.plot("fcd.xml", "--persons", "p", "q"), "--persons", "'q'", "nobody")

    def test_time_when_nobody_is_there(self):
        self.check_refused(self.plot("fcd.xml", "--begin", "5"), "no person in the time shown")

    def test_vehicles_that_are_not_there(self):
        self.check_refused(self.plot("run.csv", "--kind", "clearance"), "no vehicle", "--fcd")

    def test_vehicles_twice(self):
        self.check_refused(self.plot("fcd.xml", "--fcd", "fcd.xml"), "--fcd", "of its own")

    def test_options_out_of_range(self):
        self.check_refused(self.plot("fcd.xml", "--kind", "colourful"), "--kind", "clearance")
        self.check_refused(self.plot("fcd.xml", "--every", "0"), "--every")
        self.check_refused(self.plot("fcd.xml", "--width", "1"), "--width")
        self.check_refused(self.plot("fcd.xml", "--area", "0", "0", "-5", "5"), "--area", "LEFT")
        self.check_refused(self.plot("fcd.xml", "--area", "0", "0", "5"), "--area")
        self.check_refused(self.plot("fcd.xml", "--area", "5000", "5000", "5010", "5010"), "--area",
                           "shows nobody")
        self.check_refused(self.plot("fcd.xml", "--at", "0", "5000"), "--at", "'5000'", "0 to ")
        self.check_refused(self.plot("fcd.xml", "--begin", "2", "--end", "1"), "--begin", "at most 1")
        self.check_refused(self.plot("fcd.xml", "--zone", "x.zone.xml"), "--scenario")
        self.check_refused(self.plot("fcd.xml", "--scenario", "gone.sumocfg"), "gone.sumocfg")
        self.check_refused(self.plot("fcd.xml", "--out", "out/plot.jpg"), "--out", "plot.jpg",
                           ".svg or .png")

    def test_output_that_cannot_be_written(self):
        self.write("out", "a file, not a folder")
        done = self.plot("fcd.xml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--out", done.stderr)

    def test_png_without_its_converter(self):
        env = {**os.environ, "PATH": str(self.folder)}
        self.check_refused(self.plot("fcd.xml", "--out", "out/plot.png", env=env), "rsvg-convert",
                           "librsvg2-bin")


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    SCENARIOS = Path(sys.argv.pop(1)).resolve()
    unittest.main()
