#!/usr/bin/python3
"""Conflict measures as SUMO's own SSM device has them: TTC, DRAC and PET of a car and a vehicle as
large as a person, following and crossing at a right angle, both at constant speed.

Plain SUMO runs them with the device and writes floating-car data, which `pedzone conflicts` measures
with the small vehicle as the person. A run ends before the car would brake, so that the extremes
are those of its last step. The device lets either of two that cross brake and tells the smaller
deceleration; here the car's is the smaller one. Its types of cars ignore each other at junctions.

usage: ssm_comparison.py PEDZONE
"""

import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

PEDZONE = None  # set from the command line
ENV = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
TOLERANCE = 0.1  # [s] our disc is as large as the small vehicle's square, so a bit longer
CAR_WIDTH, SMALL = 1.8, 0.478  # [m]
LONG = "1000"          # [s] a threshold that every encounter is below

NODES = """<nodes>
  <node id="W" x="-200" y="0"/><node id="E" x="200" y="0"/><node id="S" x="0" y="-200"/>
  <node id="N" x="0" y="200"/><node id="C" x="0" y="0" type="priority"/>
</nodes>"""
EDGES = """<edges>
  <edge id="we" from="W" to="C" speed="30"/><edge id="ce" from="C" to="E" speed="30"/>
  <edge id="sn" from="S" to="C" speed="30"/><edge id="cn" from="C" to="N" speed="30"/>
</edges>"""
STEADY = ('accel="9" decel="9" sigma="0" speedDev="0" minGap="0" tau="0.1" jmIgnoreFoeProb="1" '
          'jmIgnoreFoeSpeed="1000" jmIgnoreJunctionFoeProb="1"')
ROUTES = """<routes>
  <vType id="car" length="5" width="1.8" maxSpeed="{car}" {steady}>
    <param key="has.ssm.device" value="true"/></vType>
  <vType id="small" length="0.478" width="0.478" maxSpeed="{small}" {steady}/>
  <vehicle id="p" type="small" depart="0" departPos="{small_pos}" departSpeed="max">
    <route edges="{small_route}"/></vehicle>
  <vehicle id="c" type="car" depart="0" departPos="{car_pos}" departSpeed="max">
    <route edges="we ce"/></vehicle>
</routes>"""


class SsmComparison(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.directory.name)
        (cls.folder / "n.nod.xml").write_text(NODES)
        (cls.folder / "e.edg.xml").write_text(EDGES)
        cls.call("netconvert", "-n", "n.nod.xml", "-e", "e.edg.xml", "-o", "n.net.xml")

    @classmethod
    def tearDownClass(cls):
        cls.directory.cleanup()

    @classmethod
    def call(cls, *words):
        done = subprocess.run(list(map(str, words)), cwd=cls.folder, env=ENV, text=True,
                              capture_output=True, timeout=120)
        if done.returncode:
            raise AssertionError(f"{words}: {done.stdout}{done.stderr}")

    def measure(self, end, **demand):
        """The measures of both: {measure: value}, SUMO's and ours."""
        (self.folder / "r.rou.xml").write_text(ROUTES.format(steady=STEADY, **demand))
        self.call("sumo", "-n", "n.net.xml", "-r", "r.rou.xml", "--step-length", "0.1", "--end", end,
                  "--fcd-output", "fcd.xml", "--precision", "4", "--collision.action", "none",
                  "--no-step-log", "--device.ssm.measures", "TTC DRAC PET",
                  "--device.ssm.thresholds", f"{LONG} 0 {LONG}", "--device.ssm.range", "100",
                  "--device.ssm.file", "ssm.xml")
        self.call(PEDZONE, "conflicts", "fcd.xml", "--vtypes", "r.rou.xml", "--treat-as-person",
                  "small", "--conflict-output", "ours.xml", "--conflict-ttc", "60",
                  "--conflict-pet", "60", "--conflict-horizon", "60", "--conflict-range", "100")
        theirs, ours = self.values("ssm.xml"), self.values("ours.xml")
        print(f"{demand} until {end} s: SUMO {theirs}, pedzone {ours}")
        return theirs, ours

    def values(self, file):
        conflicts = ET.parse(self.folder / file).getroot().findall("conflict")
        self.assertEqual(len(conflicts), 1, file)
        return {element.tag: float(element.get("value")) for element in conflicts[0]
                if element.get("value") not in (None, "NA")}

    def test_following(self):
        for car, small, gap, end in ((8, 1.4, 40, 4), (8, 1.4, 40, 3), (13.9, 0.8, 60, 2.5),
                                     (3, 2, 10, 5)):
            with self.subTest(car=car, small=small, gap=gap, end=end):
                theirs, ours = self.measure(end, car=car, small=small, car_pos=50,
                                            small_pos=50 + gap + 0.478, small_route="we ce")
                # The last step is the one before the end.
                left = gap - (car - small) * (end - 0.1)
                self.assertAlmostEqual(theirs["minTTC"], left / (car - small), delta=0.01)
                self.assertAlmostEqual(ours["minTTC"], theirs["minTTC"], delta=TOLERANCE)
                self.assertAlmostEqual(ours["maxDRAC"], theirs["maxDRAC"], delta=0.01)

    def crossing(self, car, small, late, end):
        """The front of the small vehicle enters the car's way after 8 s, the car's that of the small
        one `late` s later."""
        # The lanes' middles meet at (201.6, 198.4).
        return self.measure(end, car=car, small=small, small_route="sn cn",
                            small_pos=198.4 - CAR_WIDTH / 2 - 8 * small,
                            car_pos=201.6 - SMALL / 2 - (8 + late) * car)

    def test_right_angle(self):
        for car, small, late, end in ((8, 1.4, 1.4, 8), (8, 1.4, 1.2, 8.5), (5, 2, 0.9, 7.5),
                                      (10, 1, 1.9, 8.5)):
            with self.subTest(car=car, small=small, late=late, end=end):
                theirs, ours = self.crossing(car, small, late, end)
                now = end - 0.1
                ttc, leaves = 8 + late - now, 8 + (CAR_WIDTH + SMALL) / small - now
                self.assertAlmostEqual(theirs["minTTC"], ttc, delta=0.01)
                self.assertAlmostEqual(ours["minTTC"], theirs["minTTC"], delta=TOLERANCE)

                def deceleration(time):
                    """So that the car arrives when the other has left."""
                    return 2 * (car - car * ttc / time) / time

                self.assertAlmostEqual(theirs["maxDRAC"], deceleration(leaves), delta=0.01)
                self.assertGreater(ours["maxDRAC"], deceleration(leaves - TOLERANCE))
                self.assertLess(ours["maxDRAC"], deceleration(leaves + TOLERANCE))

    def test_post_encroachment_time(self):
        for late in (3, 4, -2, -3.5):
            with self.subTest(late=late):
                theirs, ours = self.crossing(car=8, small=1.4, late=late, end=30)
                self.assertAlmostEqual(ours["PET"], theirs["PET"], delta=TOLERANCE)


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
