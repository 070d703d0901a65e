#!/usr/bin/python3
"""Who is run into by a vehicle is told, and moved no faster than people step: real SUMO, read from its
outputs.

Cars that mind nobody meet people who mind no car (constant-velocity). How far anybody moves in a step,
how fast the car is and whether bodies overlap is taken from what SUMO wrote (fcd-output); shares
nothing with src/.

usage: test_run_into.py PEDZONE_PROGRAM
"""

import json
import math
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path
from unittest import mock

from tiny_scenario import EDGES, TinyScenario

PEDZONE = None  # set from the command line
STEP = 0.5           # [s] of the scenario
STEPPING = 3.0       # [m/s] nobody is moved faster by a vehicle
WALKING = 1.3        # [m/s] top speed of the walkers
ROUNDING = 0.01      # [m] SUMO writes four digits; the rest is sums
LENGTH, WIDTH = 4.0, 1.8  # [m] of the car
RADIUS = 0.24        # [m] of a walker
HARD = 9.0           # [m/s²] emergencyDecel

ROUTES = """<routes>
<vType id="car" length="4" width="1.8" maxSpeed="9" speedDev="0" decel="4.5" emergencyDecel="9">
<param key="pedzone.yield" value="{gives_way}"/></vType>
<vType id="walker" vClass="pedestrian" width="0.48" length="0.3" maxSpeed="1.3" speedFactor="1"/>
<person id="p0" depart="0" departPos="{start}" type="walker"><walk edges="shared"
 departPosLat="0" arrivalPos="{goal}"/></person>
<vehicle id="av" type="car" depart="{depart}" departPos="5" departSpeed="max">
<route edges="west shared east"/></vehicle>
</routes>"""
PATH = '<vehiclePath vehicle="av" file="av.csv"/>'


def told(folder):
    return json.loads((folder / "summary.json").read_text())


class RunInto(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.folder = Path(self.directory.name)

    def tearDown(self):
        self.directory.cleanup()

    def run_street(self, width, start="50", goal="4", depart="4", gives_way="false", path="",
                   model="constant-velocity"):
        """Runs a street of that width [m]; returns what it prints."""
        edges = EDGES.replace('speed="2.78"', 'speed="13.89"').replace('width="8"',
                                                                        f'width="{width}"')
        tiny = TinyScenario(self.folder, edges)
        tiny.config()
        tiny.write("tiny.rou.xml", ROUTES.format(start=start, goal=goal, depart=depart,
                                                 gives_way=gives_way))
        tiny.write("tiny.zone.xml", f'<zones><zone id="z"/>{path}</zones>')
        done = subprocess.run(
            [PEDZONE, "run", "tiny.sumocfg", "--zone", "tiny.zone.xml", "--model", model,
             "--summary", "summary.json", "--trajectories", "walked.csv", "--end", "90", "--",
             "--fcd-output", "fcd.xml", "--precision", "4"],
            cwd=self.folder, text=True, capture_output=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.read_outputs()
        return done.stdout

    def read_outputs(self):
        """Places by time [s]: of the person while pedzone walks it, (x, y, angle, speed) of the car."""
        rows = (self.folder / "walked.csv").read_text().splitlines()[1:]
        walked = {float(row.split(",")[0]) for row in rows}
        self.person, self.car = {}, {}
        for step in ET.parse(self.folder / "fcd.xml").iter("timestep"):
            time = float(step.get("time"))
            for node in step.iter("person"):
                if time in walked:
                    self.person[time] = (float(node.get("x")), float(node.get("y")))
            for node in step.iter("vehicle"):
                self.car[time] = tuple(float(node.get(key)) for key in ("x", "y", "angle", "speed"))

    def overlap(self, time):
        """[m] of the bodies; negative: so far apart."""
        x, y, angle, _ = self.car[time]
        dx, dy = self.person[time][0] - x, self.person[time][1] - y
        east, north = math.sin(math.radians(angle)), math.cos(math.radians(angle))
        ahead, aside = dx * east + dy * north + LENGTH / 2, abs(dy * east - dx * north)
        apart = math.hypot(max(0.0, abs(ahead) - LENGTH / 2), max(0.0, aside - WIDTH / 2))
        return RADIUS - apart

    def moved(self):
        """[m] in each step."""
        return {b: math.dist(self.person[a], self.person[b])
                for a, b in zip(self.person, list(self.person)[1:]) if b - a < 1.5 * STEP}

    def check_nobody_is_carried_along(self):
        self.assertGreater(len(self.person), 20)
        worst = max(self.moved().values())
        self.assertLessEqual(worst, (STEPPING + WALKING) * STEP + ROUNDING)

    def check_events(self, most_speed):
        """Each told event is one in SUMO's output; returns the first."""
        events = told(self.folder)["run_into"]
        self.assertGreaterEqual(len(events), 1)
        for event in events:
            self.assertEqual((event["person"], event["vehicle"], event["zone"]), ("p0", "av", "z"))
            at = event["time"]
            self.assertGreater(self.overlap(at), 0.01, event)
            # It is within the step that it happened.
            place = (event["x"], event["y"])
            self.assertLess(math.dist(place, self.person[at]), (STEPPING + WALKING) * STEP)
            speeds = [self.car[time][3] for time in (at - STEP, at) if time in self.car]
            self.assertLessEqual(event["speed_mps"], max(speeds) + 2.6 * STEP)
            self.assertGreaterEqual(event["speed_mps"], min(speeds) - HARD * STEP)
        self.assertLessEqual(events[0]["speed_mps"], most_speed + 0.01)
        return events[0]

    def check_it_stands(self, event):
        """It brakes as hard as it can from the step after, and then stands for 5 s."""
        later = [time for time in self.car if time > event["time"]]
        last = event["time"] + STEP + self.car[event["time"]][3] / HARD + STEP
        stands = next(time for time in later if self.car[time][3] < 0.1)
        self.assertLessEqual(stands, last)
        for time in later:
            if stands <= time < stands + 5.0:
                self.assertLess(self.car[time][3], 0.1, time)

    def test_a_car_that_minds_nobody_runs_into_who_minds_no_car(self):
        for width in ("2.6", "8"):
            with self.subTest(width=width):
                printed = self.run_street(width)
                self.check_nobody_is_carried_along()
                event = self.check_events(9.0)
                self.assertGreater(event["speed_mps"], STEPPING - WALKING)
                self.check_it_stands(event)
                self.assertRegex(printed, r"ran into a person +\d")
                self.assertIn(f"'p0' by 'av' at {event['time']:.1f} s", printed)
                self.assertGreater(self.car[max(self.car)][0], 150.0, "it gets on afterwards")

    def test_a_vehicle_on_a_path_drives_as_its_rows_say_and_is_told(self):
        (self.folder / "av.csv").write_text("t,x,y\n5,62,-4.2\n15,112,-4.2\n")
        self.run_street("8", path=PATH)
        self.check_nobody_is_carried_along()
        event = self.check_events(5.0)
        self.assertAlmostEqual(event["speed_mps"], 5.0, delta=0.01)
        for time, (x, _, _, _) in self.car.items():
            if 5.0 <= time <= 15.0:
                self.assertAlmostEqual(x, 62.0 + 5.0 * (time - 5.0), delta=ROUNDING)

    def test_one_that_sumo_puts_onto_somebody_is_told_apart(self):
        for route, inserted in (("west shared east", False), ("shared east", True)):
            with self.subTest(route=route):
                with mock.patch(f"{__name__}.ROUTES", ROUTES.replace("west shared east", route)
                                .replace('departSpeed="max"', 'departSpeed="9"')):
                    printed = self.run_street("2.6", start="8" if inserted else "50", depart="4")
                event = told(self.folder)["run_into"][0]
                self.assertEqual(event["just_inserted"], inserted)
                self.assertEqual("just inserted by SUMO" in printed, inserted)

    def test_who_squeezes_past_one_that_stands_is_told_apart(self):
        stop = '<stop lane="shared_0" endPos="30" duration="80"/></vehicle>'
        with mock.patch(f"{__name__}.ROUTES", ROUTES.replace("</vehicle>", stop)):
            printed = self.run_street("2.6", start="50", depart="0", model="heuristic")
        touched = [self.car[time][3] for time in self.person
                   if time in self.car and self.overlap(time) > 0.01]
        self.assertGreater(len(touched), 0, "the gap is 0.4 m")
        self.assertLess(max(touched), 0.1)
        vehicles = told(self.folder)["vehicles"]
        self.assertEqual([vehicles[key] for key in ("contacts", "insertion_contacts",
                                                    "standing_contacts")], [1, 0, 1])
        self.assertRegex(printed, r"with vehicles that stood +1\n")
        self.run_street("2.6")
        vehicles = told(self.folder)["vehicles"]
        self.assertEqual([vehicles["contacts"], vehicles["standing_contacts"]], [1, 0])

    def test_a_slow_one_has_run_into_whom_it_pushes_along(self):
        (self.folder / "av.csv").write_text("t,x,y\n5,62,-4.2\n45,102,-4.2\n")
        printed = self.run_street("8", path=PATH)
        self.check_nobody_is_carried_along()
        summary = told(self.folder)
        self.assertEqual([(event["person"], event["speed_mps"]) for event in summary["run_into"]],
                         [("p0", 1.0)])
        self.assertIn("persons pushed                    1 (longest", printed)
        pushes = summary["pushes"]
        self.assertEqual(pushes["persons"], 1)
        # Both stand against each other at their own speeds, 1.0 and 1.24 m/s: a push of a good
        # metre and more, at no more than the sum of both but for the gap that is kept.
        self.assertGreater(pushes["longest_m"], 1.0)
        self.assertLess(pushes["fastest_mps"], STEPPING)
        touched = [time for time in self.person if time in self.car and self.overlap(time) > 0.01]
        self.assertEqual(touched, [])

    def test_who_makes_way_before_one_that_gives_way_is_not_touched(self):
        self.run_street("8", gives_way="true", model="heuristic")
        summary = told(self.folder)
        self.assertEqual((summary["run_into"], summary["pushes"]["persons"]), ([], 0))


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
