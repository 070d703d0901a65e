#!/usr/bin/python3
"""What the animation shows on top of who is where: who stands for long, names of streets, trails,
density. In Chromium, of recordings made here.

usage: test_layers.py PEDZONE_PROGRAM SCENARIOS_FOLDER
"""

import gzip
import math
import re
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

from browser import Browser
from recorded_page import SET_TIME, SETTLED, call, enter, open_page

PEDZONE = SCENARIOS = None  # set from the command line

SECONDS = 80
# Reads colours of a panel's canvas at places in metres.
PIXELS = """
const panel = pedzone.panels[0];
const copy = Object.assign(document.createElement("canvas"),
                           {width: panel.canvas.width, height: panel.canvas.height});
const context = copy.getContext("2d", {willReadFrequently: true});
context.drawImage(panel.canvas, 0, 0);
const colour = ([x, y]) => [...context.getImageData(
  x * panel.ratio, y * panel.ratio, 1, 1).data].slice(0, 3).join();
"""


def queue():
    """One stands at (0, 0) and shuffles, one walks east along y = 5, two stand close together."""
    steps = []
    for t in range(SECONDS + 1):
        shuffle = 0.1 * (t % 2)
        people = [("stands", shuffle, 0.0, 0.1), ("walks", -20.0 + t, 5.0, 1.0),
                  ("one", 10.0, -8.0, 0.0), ("other", 10.5, -8.0, 0.0)]
        rows = "".join(f'<person id="{name}" x="{x}" y="{y}" angle="90" speed="{speed}"/>'
                       for name, x, y, speed in people)
        steps.append(f'<timestep time="{t}">{rows}</timestep>\n')
    return "<fcd-export>\n" + "".join(steps) + "</fcd-export>\n"


def walker_in(box):
    west, south, east, north = box
    rows = "".join(
        f'<timestep time="{t}"><person id="p" x="{west + (east - west) * t / 10}" '
        f'y="{south + (north - south) * t / 10}" angle="0" speed="1"/></timestep>'
        for t in range(11))
    return f"<fcd-export>{rows}</fcd-export>"


class Layers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.folder = Path(directory.name)
        (cls.folder / "queue.xml").write_text(queue())
        call(PEDZONE, "animate", "queue.xml", "--out", "queue.html", folder=cls.folder)
        cls.town = SCENARIOS / "bad-hersfeld/centre.sumocfg"
        (cls.folder / "town.xml").write_text(walker_in((6400, 7600, 6900, 8000)))
        call(PEDZONE, "animate", "town.xml", "--scenario", cls.town, "--out", "town.html",
             folder=cls.folder)
        cls.browser = enter(cls, Browser())

    def open(self, page, **size):
        return open_page(self.browser, self.folder / page, **size)

    def tearDown(self):
        self.assertEqual(self.browser.messages(), [], "the console stays empty")

    def test_who_stands_for_long_has_a_halo(self):
        self.open("queue.html")
        for time, expected in ((5, -1), (15, 0), (40, 1), (70, 2)):
            self.browser.run(SET_TIME, time)
            standing = self.browser.run("""const panel = pedzone.panels[0];
                return Object.fromEntries(panel.persons.map(
                    (pose) => [pose.track.id, panel.standing(pose)]));""")
            self.assertEqual(standing, {"stands": expected, "walks": -1, "one": expected,
                                        "other": expected}, time)

    def test_halos_are_seen_and_told(self):
        self.open("queue.html")
        # Just outside the body of the one who stands.
        beside = PIXELS + """
            const pose = panel.persons.find((one) => one.track.id === "stands");
            const [x, y] = panel.to_screen(pose.x, pose.y);
            const [, across] = extent(pose.track, kShapes.circle, panel.camera.scale);
            return colour([x, y + across + 3]);"""
        caption = "return document.querySelector('figcaption span').textContent"
        self.browser.run(SET_TIME, 5)
        before, told = self.browser.run(beside), self.browser.run(caption)
        self.browser.run(SET_TIME, 70)
        self.assertNotEqual(self.browser.run(beside), before)
        self.assertNotIn("stood", told)
        self.assertIn("3 stood 30 s", self.browser.run(caption))
        legend = self.browser.run("return document.getElementById('legend').textContent")
        self.assertIn("for 1 min or longer", legend)

    def toggle(self, name):
        self.browser.click("#show-" + name)
        self.browser.run(SETTLED)

    def test_trails(self):
        self.open("queue.html")
        self.browser.run(SET_TIME, 40)
        behind = PIXELS + "return [colour(panel.to_screen(15, 5)), colour(panel.to_screen(5, 5))];"
        plain = self.browser.run(behind)
        self.toggle("trails")
        near, far = self.browser.run(behind)
        self.assertNotEqual(near, plain[0], "where it was 5 s ago")
        self.assertEqual(far, plain[1], "where it was 15 s ago")
        self.toggle("trails")
        self.assertEqual(self.browser.run(behind), plain)

    def test_density(self):
        self.open("queue.html")
        self.browser.run(SET_TIME, 40)
        hidden = """return [...document.querySelectorAll("#legend h3")].find(
            (one) => one.textContent === "Persons per m²").hidden;"""
        self.assertTrue(self.browser.run(hidden))
        places = PIXELS + """return [[11.2, -8], [-15, -8]].map(
            ([x, y]) => colour(panel.to_screen(x, y)));"""
        plain = self.browser.run(places)
        self.toggle("density")
        self.assertFalse(self.browser.run(hidden))
        near, far = self.browser.run(places)
        self.assertNotEqual(near, plain[0])
        self.assertEqual(far, plain[1], "nobody is there")
        # Everybody is counted once: the field's integral is the number of persons.
        people = self.browser.run("""
            const panel = pedzone.panels[0], {cell, values} = new Density([]).measure(panel);
            return values.reduce((sum, one) => sum + one, 0) * cell * cell;""")
        inside = self.browser.run("""const panel = pedzone.panels[0];
            return panel.persons.length;""")
        self.assertAlmostEqual(people, inside, delta=0.08 * inside)

    def names_of_network(self):
        with gzip.open(SCENARIOS.parent / "networks/bad-hersfeld/centre.net.xml.gz") as file:
            return {edge.get("name") for edge in ET.parse(file).iter("edge")} - {None}

    def test_street_names_are_the_networks_and_touch_none(self):
        self.open("town.html", width=1400, height=900)
        placed = self.browser.run("""
            return pedzone.panels[0].scenery.streets.placed.map(
                ({name, x, y, angle, half}) => ({name, x, y, angle, half}));""")
        self.assertGreater(len(placed), 5)
        self.assertLessEqual({one["name"] for one in placed}, self.names_of_network())
        corners = [self.corners(one) for one in placed]
        for i, one in enumerate(placed):
            self.assertLessEqual(abs(one["angle"]), math.pi / 2 + 1e-9, "not upside down")
            for k in range(i):
                self.assertTrue(self.apart(corners[i], corners[k]), (one, placed[k]))

    def corners(self, label, height=12):
        c, s = math.cos(label["angle"]), math.sin(label["angle"])
        return [(label["x"] + a * c - b * s, label["y"] + a * s + b * c)
                for a, b in ((-label["half"], -height / 2), (label["half"], -height / 2),
                             (label["half"], height / 2), (-label["half"], height / 2))]

    def apart(self, first, second):
        """Two rectangles, by their separating axes."""
        for shape in (first, second):
            for (ax, ay), (bx, by) in ((shape[0], shape[1]), (shape[1], shape[2])):
                ux, uy = bx - ax, by - ay
                spans = [[ux * x + uy * y for x, y in one] for one in (first, second)]
                if max(spans[0]) <= min(spans[1]) or max(spans[1]) <= min(spans[0]):
                    return True
        return False

    def test_street_names_can_be_switched_off(self):
        self.open("town.html", width=1400, height=900)
        picture = "return pedzone.panels[0].canvas.toDataURL();"
        with_names = self.browser.run(picture)
        self.toggle("names")
        self.assertNotEqual(self.browser.run(picture), with_names)
        self.toggle("names")
        self.assertEqual(self.browser.run(picture), with_names)

    def test_a_network_without_names_has_no_box_for_them(self):
        self.open("queue.html")
        self.assertTrue(self.browser.run("return document.getElementById('names-box').hidden"))
        text = (self.folder / "queue.html").read_text()
        self.assertTrue(re.search(r'"streets":\[\]', text))


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv[1]).resolve())
    SCENARIOS = Path(sys.argv[2]).resolve()
    del sys.argv[1:3]
    unittest.main()
