#!/usr/bin/python3
"""Vehicles that SUMO puts on a street where people walk: real SUMO, whatever way the route file says
where and when, and where it is a teleport that ends there.

How often a vehicle comes down on somebody is read from SUMO's own fcd-output, by code that shares
nothing with src/. Where nobody can know of it (a flow with a probability) it happens: else these tests
could not fail.

usage: test_inserted.py PEDZONE_PROGRAM
"""

import json
import math
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ET

from tiny_scenario import TinyCase, sumo_environment

PEDZONE = None  # set from the command line
LENGTH, WIDTH = 10.0, 2.4  # [m] of the lorries
RADIUS = 0.24              # [m] of people

NODES = """<nodes><node id="0" x="0" y="0"/><node id="1" x="100" y="0"/><node id="2" x="200" y="0"/>
<node id="3" x="300" y="0"/></nodes>"""
EDGES = """<edges><edge id="a" from="0" to="1" width="5" speed="8"/>
<edge id="b" from="1" to="2" width="5" speed="8" {b}/>
<edge id="c" from="2" to="3" width="5" speed="8"/></edges>"""
TYPE = '<vType id="lorry" vClass="truck" length="10" width="2.4"/>'
PEOPLE = """<vType id="walker" vClass="pedestrian" width="0.48"/><personFlow id="p" type="walker"
begin="105" end="250" period="1.5"><walk from="a" to="c" departPosLat="random"/></personFlow>"""
ROUTE = '<route id="r" edges="b c"/>'
FLOW = '<flow id="f" type="lorry" departSpeed="0" {how}/>'
EVERY_20_S = 'route="r" begin="105" end="250" period="20" '
MIDDLE = 'departPos="60"'


class Inserted(TinyCase):
    def run_street(self, routes, edge="", begin=105, end=300, options=()):
        tiny = self.tiny
        tiny.write("tiny.nod.xml", NODES)
        tiny.write("tiny.edg.xml", EDGES.format(b=edge))
        tiny.convert()
        tiny.config()
        tiny.write("tiny.rou.xml", f"<routes>{TYPE}{ROUTE}{routes}</routes>")
        tiny.write("tiny.zone.xml", '<zones><zone id="z" edges="a b c"/></zones>')
        done = subprocess.run(
            [PEDZONE, "run", "tiny.sumocfg", "--zone", "tiny.zone.xml", "--summary", "summary.json",
             "--end", str(end), "--", "--begin", str(begin), "--fcd-output", "fcd.xml",
             "--precision", "4", "--statistic-output", "statistics.xml", "--tripinfo-output",
             "trips.xml", *options],
            cwd=self.folder, text=True, capture_output=True, timeout=120, env=sumo_environment())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.summary = json.loads((self.folder / "summary.json").read_text())

    def hit_at_first_sight(self):
        """(vehicle, person) whose bodies overlap in the step in which a vehicle is there first, or
        is back from elsewhere."""
        pairs, before = set(), {}
        for step in ET.parse(self.folder / "fcd.xml").getroot():
            people = [(one.get("id"), float(one.get("x")), float(one.get("y")))
                      for one in step.findall("person")]
            now = {}
            for one in step.findall("vehicle"):
                x, y, angle = (float(one.get(key)) for key in ("x", "y", "angle"))
                now[one.get("id")] = (x, y)
                old = before.get(one.get("id"))
                if old is not None and math.dist(old, (x, y)) < 10.0:
                    continue
                ahead = (math.sin(math.radians(angle)), math.cos(math.radians(angle)))
                for person, px, py in people:
                    along = (px - x) * ahead[0] + (py - y) * ahead[1] + 0.5 * LENGTH
                    beside = (px - x) * ahead[1] - (py - y) * ahead[0]
                    gap = math.hypot(max(0.0, abs(along) - 0.5 * LENGTH),
                                     max(0.0, abs(beside) - 0.5 * WIDTH))
                    if gap < RADIUS - 0.01:
                        pairs.add((one.get("id"), person))
            before = now
        return pairs

    def test_people_keep_away_however_the_file_says_it(self):
        for how in (EVERY_20_S + MIDDLE,
                    f'route="r" end="250" period="20" {MIDDLE}',  # SUMO's begin
                    f'route="r" begin="105" end="250" perHour="180" {MIDDLE}',
                    f'route="r" begin="105" number="10" {MIDDLE}',  # until SUMO's end
                    EVERY_20_S + 'departPos="-40"',
                    EVERY_20_S + MIDDLE + ' departPosLat="left"',
                    EVERY_20_S.replace('"r"', '"two"') + MIDDLE + ' departEdge="1"',
                    EVERY_20_S.replace('"r"', '"either"') + MIDDLE):
            with self.subTest(how):
                self.run_street(
                    PEOPLE + '<route id="two" edges="a b c"/><route id="s" edges="b"/>'
                    '<routeDistribution id="either" routes="r s" probabilities="1 1"/>' +
                    FLOW.format(how=how))
                self.assertGreater(self.summary["vehicles"]["seen"], 5)
                self.assertEqual(self.hit_at_first_sight(), set())

    def test_and_where_sumo_counts_a_lane_shorter_than_it_is(self):
        self.run_street(PEOPLE + FLOW.format(how=EVERY_20_S + 'departPos="30"'), 'length="50"')
        self.assertGreater(self.summary["vehicles"]["seen"], 5)
        self.assertEqual(self.hit_at_first_sight(), set())

    def test_but_not_where_nobody_knows(self):
        self.run_street(PEOPLE + FLOW.format(
            how='route="r" begin="105" end="250" probability="0.05" ' + MIDDLE))
        hit = self.hit_at_first_sight()
        self.assertGreater(len(hit), 3)
        self.assertEqual(self.summary["vehicles"]["insertion_contacts"], len(hit))

    def test_teleports_that_end_among_people_are_told_as_such(self):
        """They begin and end in one step: no step in between is without the vehicle."""
        self.run_street(
            PEOPLE.replace('begin="105"', 'begin="0"').replace('from="a"', 'from="b"') +
            '<vehicle id="block" type="lorry" depart="0"><route edges="a b c"/>'
            '<stop lane="a_0" endPos="90" duration="2000"/></vehicle>' + FLOW.format(
                how='begin="10" end="250" period="30"').replace("/>", '><route edges="a b c"/></flow>'),
            begin=0, options=("--time-to-teleport", "10"))
        teleports = ET.parse(self.folder / "statistics.xml").getroot().find("teleports")
        self.assertGreater(int(teleports.get("jam")), 3)
        told = self.summary["sumo"]
        self.assertEqual([told["teleports"], told["jam_teleports"]],
                         [int(teleports.get("total")), int(teleports.get("jam"))])
        hit = self.hit_at_first_sight()
        self.assertGreater(len(hit), 5)
        # Some have been met by that vehicle before.
        self.assertGreater(self.summary["vehicles"]["insertion_contacts"], 0.8 * len(hit))
        self.assertTrue(self.summary["run_into"])
        for one in self.summary["run_into"]:
            self.assertTrue(one["just_inserted"], one)

    def test_two_vehicles_of_one_id_are_two(self):
        """The first loses minutes behind one at 1 m/s, the second nothing."""
        car = '<vehicle id="car" depart="{}"><route edges="a b c"/></vehicle>'
        walk = '<person id="{0}" depart="{0}"><walk edges="c" speed="0.5"/></person>'
        self.run_street(  # SUMO reads ahead: persons keep the second car from coming too early
            '<vType id="slow" maxSpeed="1"/><vehicle id="lead" type="slow" depart="0">'
            '<route edges="a"/></vehicle>' + car.format(10) + walk.format(300) + walk.format(600) +
            car.format(650), begin=0, end=800)
        losses = [float(trip.get("timeLoss"))
                  for trip in ET.parse(self.folder / "trips.xml").getroot().findall("tripinfo")]
        self.assertEqual(len(losses), 3)
        vehicles = self.summary["vehicles"]
        self.assertEqual(vehicles["seen"], 3)
        self.assertGreater(max(losses), 50.0)
        self.assertAlmostEqual(vehicles["mean_delay_s"], sum(losses) / 3, delta=2.0)

    def test_the_time_simulated_is_from_the_begin_on(self):
        self.run_street(PEOPLE, begin=105, end=145)
        self.assertAlmostEqual(self.summary["time"]["simulated_s"], 40.0)


if __name__ == "__main__":
    PEDZONE = sys.argv.pop(1)
    unittest.main()
