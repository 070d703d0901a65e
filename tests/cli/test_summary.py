#!/usr/bin/python3
"""What a run tells of those who do not get on, and of what SUMO counts: compared with SUMO's outputs.

A street ends at a crossing whose lights are red for ever. Who stands there is taken from what SUMO wrote
(fcd-output, statistic-output); shares nothing with src/.

usage: test_summary.py PEDZONE_PROGRAM
"""

import json
import math
import os
import pty
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import tiny_scenario
from tiny_scenario import EDGES, TinyScenario

PEDZONE = None  # set from the command line
LONG, VERY_LONG = 60.0, 120.0  # [s] without moving: counted, warned of
LOOKS = 5.0                    # [s] between two looks at everybody
STEP = 0.5                     # [s] of the scenario
NOWHERE = 1.5                  # [m] who stays so near has not moved
NODES = """<nodes>
  <node id="A" x="0" y="0"/><node id="B" x="60" y="0"/>
  <node id="C" x="120" y="0" type="traffic_light"/><node id="D" x="180" y="0"/>
  <node id="N" x="120" y="60"/><node id="S" x="120" y="-60"/>
</nodes>"""
SIDE_STREETS = """
  <edge id="sn" from="S" to="C" numLanes="1" speed="13.89" sidewalkWidth="2"/>
  <edge id="cn" from="C" to="N" numLanes="1" speed="13.89" sidewalkWidth="2"/>
</edges>"""
CROSSINGS = """<connections>
  <crossing node="C" edges="cn"/><crossing node="C" edges="sn"/></connections>"""
RED = """<additional><tlLogic id="C" type="static" programID="red" offset="0">
  <phase duration="10000" state="rrrrrr"/></tlLogic>{}</additional>"""
PATIENT = ("--pedestrian.striping.jamtime", "-1", "--pedestrian.striping.jamtime.narrow", "-1",
           "--time-to-teleport", "-1")


def walkers(count):
    return "".join(f'<person id="p{k:02}" depart="{k}"><walk edges="west shared east"/></person>'
                   for k in range(count))


def cars(count):
    return "".join(f'<vehicle id="v{k}" depart="{40 + k}"><route edges="sn cn"/></vehicle>'
                   for k in range(count))


class RedLightCase(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)
        self.addCleanup(setattr, tiny_scenario, "NODES", tiny_scenario.NODES)
        tiny_scenario.NODES = NODES
        (self.folder / "tiny.con.xml").write_text(CROSSINGS)
        self.tiny = TinyScenario(self.folder, EDGES.replace("</edges>", SIDE_STREETS),
                                 ("-x", "tiny.con.xml"))

    def write(self, routes, additional=""):
        self.tiny.write("tiny.add.xml", RED.format(additional))
        # SUMO leaves out whom it reads too late.
        elements = sorted(ElementTree.fromstring(f"<routes>{routes}</routes>"),
                          key=lambda one: float(one.get("depart", one.get("begin", -1))))
        self.tiny.write("tiny.rou.xml", "<routes>" + "".join(
            ElementTree.tostring(one, encoding="unicode") for one in elements) + "</routes>")
        self.tiny.config()

    def run_for(self, seconds, *sumo_options, words=()):
        self.done = subprocess.run(
            [PEDZONE, "run", "tiny.sumocfg", "--end", str(seconds), "--summary", "s.json", *words,
             "--", "--fcd-output", "fcd.xml", "--statistic-output", "statistics.xml",
             "--precision", "4", *sumo_options],
            cwd=self.folder, text=True, capture_output=True, timeout=120)
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.summary = json.loads((self.folder / "s.json").read_text())
        self.stuck = self.summary["not_moved_for_60_s"]

    def tracks(self, kind):
        """{id: [(time [s], place)]} by SUMO's output."""
        found = {}
        for step in ElementTree.parse(self.folder / "fcd.xml").iter("timestep"):
            for node in step.iter(kind):
                place = (float(node.get("x")), float(node.get("y")))
                found.setdefault(node.get("id"), []).append((float(step.get("time")), place))
        return found

    def stands_since(self, track, within):
        """[s] Since when it has been no farther [m] than that from where it is last."""
        since = track[-1][0]
        for time_, place in reversed(track):
            if math.dist(place, track[-1][1]) > within:
                break
            since = time_
        return since

    def warnings(self):
        return [line for line in self.done.stderr.splitlines() if "people have stood" in line]


class RedLight(RedLightCase):
    def test_those_who_stand_at_the_end_are_named_where_they_stand(self):
        parked = ('<vehicle id="parked" depart="40"><route edges="sn cn"/>'
                  '<stop lane="sn_1" startPos="5" endPos="20" duration="900" parking="true"/>'
                  '</vehicle>')
        self.write(walkers(14) + cars(2) + parked)
        self.run_for(300, *PATIENT)
        for kind in ("person", "vehicle"):
            told, tracks = self.stuck[kind + "s"], self.tracks(kind)
            # Nobody comes NOWHERE from any of its places; or from where it is last.
            surely = {one for one, track in tracks.items() if one != "parked"
                      and self.stands_since(track, NOWHERE / 2) < 300.0 - LONG - LOOKS}
            perhaps = {one for one, track in tracks.items()
                       if self.stands_since(track, 2 * NOWHERE) <= 300.0 - LONG}
            self.assertGreaterEqual(len(surely), 2)
            self.assertLessEqual(len(surely), told["at_end"])
            self.assertLessEqual(told["at_end"], len(perhaps - {"parked"}))
            self.assertGreaterEqual(told["most"], told["at_end"])
            self.assertEqual(len(told["first"]), min(10, told["at_end"]))
            for one in told["first"]:
                self.assertIn(one["id"], perhaps - {"parked"})
                track = tracks[one["id"]]
                self.assertEqual([round(one[axis], 4) for axis in "xy"], list(track[-1][1]))
                self.assertGreaterEqual(one["since"], self.stands_since(track, 2 * NOWHERE))
                self.assertLessEqual(one["since"], self.stands_since(track, NOWHERE / 2) + LOOKS + STEP)
        self.assertGreater(self.stuck["persons"]["at_end"], 10)
        self.assertRegex(self.done.stdout, r"persons +1\d at the end, at most 1\d \(at \d+ s\)")
        self.assertIn("on edge ':C_w", self.done.stdout)
        self.assertRegex(self.done.stdout, r"and \d more")

    def test_more_than_ten_who_stand_are_warned_of_once(self):
        self.write(walkers(14))
        self.run_for(400, *PATIENT)
        self.assertEqual(len(self.warnings()), 1, self.done.stderr)
        found = re.match(r"Warning: at (\d+) s (\d+) people have stood for 120 s, (\d+) of them "
                         r"within 10 m of '(\w+)' at \(([\d.]+), (-?[\d.]+)\) on edge ':C_w\d'\.$",
                         self.warnings()[0])
        self.assertIsNotNone(found, self.warnings())
        tracks = {name: [row for row in track if row[0] <= float(found[1])]
                  for name, track in self.tracks("person").items()}
        stood = [self.stands_since(track, 2 * NOWHERE) for track in tracks.values()]
        self.assertGreaterEqual(sum(float(found[1]) - since >= VERY_LONG for since in stood),
                                int(found[2]))
        stood = [self.stands_since(track, NOWHERE / 2) for track in tracks.values()]
        earlier = float(found[1]) - 2 * LOOKS  # at the look before it was not so yet
        self.assertLessEqual(sum(earlier - since >= VERY_LONG for since in stood), 10)
        self.assertGreater(int(found[2]), 10)
        self.assertGreater(int(found[3]), 10)
        place = (float(found[5]), float(found[6]))
        self.assertLess(math.dist(place, tracks[found[4]][-1][1]), 0.51)

    def test_ten_are_not_warned_of(self):
        self.write(walkers(10))
        self.run_for(300, *PATIENT)
        self.assertGreaterEqual(self.stuck["persons"]["at_end"], 9)
        self.assertEqual(self.warnings(), [])

    def test_who_rests_does_not_count(self):
        waits = "".join(
            f'<person id="stop{k:02}" depart="{k}"><walk from="west" to="shared" arrivalPos="30"/>'
            '<stop lane="shared_0" endPos="30" duration="900"/></person>'
            f'<person id="bus{k:02}" depart="{k}"><walk from="west" to="west" arrivalPos="30"/>'
            '<ride from="west" to="east" lines="never"/></person>'
            f'<person id="sit{k:02}" depart="{k}" departPos="{5 * k}"><param key="pedzone.activities" '
            'value="sitting=20"/><walk edges="shared"/></person>' for k in range(11))
        seats = "".join(f'<poi id="s{k}" type="pedzone.seat" x="{65 + 4 * k}" y="53"/>'
                        for k in range(11))
        self.write(waits, seats)
        self.run_for(300, *PATIENT)
        for name, track in self.tracks("person").items():
            if name.startswith(("stop", "bus")):
                self.assertLess(self.stands_since(track, NOWHERE / 2), 150.0, "they do stand")
        sat = [name for name, track in self.tracks("person").items() if name.startswith("sit")
               if any(self.stands_since(track[:end], NOWHERE / 2)
                      <= track[end - 1][0] - LONG - 2 * LOOKS
                      for end in range(1, len(track)))]
        self.assertGreater(len(sat), 3)
        self.assertEqual((self.stuck["persons"]["at_end"], self.stuck["persons"]["most"]), (0, 0))
        self.assertEqual(self.warnings(), [])

    def test_what_sumo_counts(self):
        crash = ('<vType id="blind" tau="0.1" sigma="0" decel="2" emergencyDecel="9"/>'
                 '<vehicle id="ahead" depart="0" departPos="30"><route edges="cn"/>'
                 '<stop lane="cn_1" endPos="40" duration="20"/></vehicle>'
                 '<vehicle id="behind" type="blind" depart="2" departPos="26" departSpeed="13.8" '
                 'insertionChecks="none"><route edges="cn"/></vehicle>')
        self.write(crash + walkers(14) + cars(2))
        self.run_for(360, "--pedestrian.striping.jamtime", "60", "--time-to-teleport", "100")
        root = ElementTree.parse(self.folder / "statistics.xml").getroot()
        teleports, safety = root.find("teleports"), root.find("safety")
        told = self.summary["sumo"]
        self.assertEqual(
            [told[key] for key in ("teleports", "jam_teleports", "yield_teleports",
                                   "wrong_lane_teleports")],
            [int(teleports.get(key)) for key in ("total", "jam", "yield", "wrongLane")])
        self.assertEqual([told["collisions"], told["emergency_stops"]],
                         [int(safety.get("collisions")), int(safety.get("emergencyStops"))])
        self.assertEqual(told["jammed_persons"], int(root.find("persons").get("jammed")))
        self.assertEqual(told["emergency_brakings"],
                         self.done.stderr.count("performs emergency braking"))
        for key in ("teleports", "collisions", "jammed_persons", "emergency_brakings"):
            self.assertGreater(told[key], 0, key)

    def test_what_sumo_is_told_not_to_print_is_not_known(self):
        self.write(walkers(14))
        for silent in (["--no-warnings"], ["--aggregate-warnings", "0"]):
            with self.subTest(silent):
                self.run_for(250, "--pedestrian.striping.jamtime", "60", *silent)
                self.assertIsNone(self.summary["sumo"]["jammed_persons"])
                self.assertIsNone(self.summary["sumo"]["emergency_brakings"])
                self.assertEqual(self.summary["sumo"]["teleports"], 0)
                self.assertRegex(self.done.stdout, r"jammed persons +not known")

    def test_how_often_people_are_taken_over(self):
        there_and_back = '<walk edges="west shared"/><stop lane="shared_0" duration="5"/>'
        self.write(f'<person id="twice" depart="0">{there_and_back}<walk from="shared" to="west"/>'
                   '</person><person id="once" depart="0"><walk edges="west shared"/></person>')
        self.run_for(300)
        persons = self.summary["persons"]
        self.assertEqual([persons[key] for key in ("controlled", "takeovers", "given_back",
                                                   "returns")], [2, 3, 2, 3])
        self.assertRegex(self.done.stdout, r"taken over by pedzone +2 \(3 times\)")
        self.assertRegex(self.done.stdout, r"given back to SUMO +2 \(3 times\)")


class Terminal(RedLightCase):
    """What a terminal shows: a program that reads one sees every byte."""

    def shown(self, *words, sumo_options=(), stop_after=rb"left:"):
        """Everything that was written to a terminal; ended once `stop_after` has been seen."""
        flow = '<flow id="f" begin="0" end="10000000" period="30"><route edges="sn cn"/></flow>'
        self.write(flow + walkers(14))
        reader, terminal = pty.openpty()
        process = subprocess.Popen(
            [PEDZONE, "run", "tiny.sumocfg", *words, "--", *sumo_options], cwd=self.folder,
            stdout=subprocess.DEVNULL, stderr=terminal, env={**os.environ, "NO_COLOR": "1"})
        self.addCleanup(process.kill)
        os.close(terminal)
        text, stopped, begin = b"", False, time.monotonic()
        while True:
            try:
                text += os.read(reader, 65536)
            except OSError:  # nobody writes any more
                break
            if not stopped and re.search(stop_after, text, re.DOTALL):
                process.send_signal(signal.SIGINT)
                stopped = True
            self.assertLess(time.monotonic() - begin, 60.0, text[-500:])
        os.close(reader)
        process.wait(timeout=60)
        return text.decode()

    def lines_left(self, text):
        """What stays on the terminal: a line is what follows its last erasure."""
        return [line.split("\r\x1b[K")[-1] for line in text.replace("\r\n", "\n").split("\n")]

    def test_a_bar_with_the_time_left_and_warnings_line_by_line(self):
        text = self.shown("--end", "10000000", sumo_options=("--time-to-teleport", "20"),
                          stop_after=rb"left:.*Warning")
        self.assertRegex(text, r"\[[#.]{30}\] +\d+ %, [\d:]+ left: \d+ of 10000000 s, ")
        lines = [line for line in self.lines_left(text) if line]
        self.assertTrue(any("waited too long" in line for line in lines), lines)
        for line in lines:
            self.assertRegex(line, r"^(Warning: .*\.|Interrupted at .*)$")

    def test_quiet(self):
        text = self.shown("--end", "400", "--quiet",
                          sumo_options=("--pedestrian.striping.jamtime", "60"))
        self.assertNotIn("\x1b", text)
        self.assertNotIn("left:", text)
        self.assertIn("is jammed on edge", text)

    def test_quiet_prints_no_summary(self):
        self.write(walkers(2))
        self.run_for(100, words=("--quiet",))
        self.assertEqual(self.done.stdout, "")

    def test_no_bar_elsewhere(self):
        self.write(walkers(2))
        self.run_for(100)
        self.assertNotIn("\x1b", self.done.stderr)
        self.assertNotIn("real time", self.done.stderr)


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
