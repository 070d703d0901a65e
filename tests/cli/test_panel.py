#!/usr/bin/python3
"""People that pedzone makes: `pedzone run --pedestrians`, `pedzone demand`, and every kind of bad
input.

usage: test_panel.py PEDZONE_PROGRAM FOLDER_OF_THE_PANEL_SCENARIO
"""

import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

from refusal import RefusalChecks
from tiny_scenario import TinyScenario, sumo_environment

PEDZONE, SCENARIO = None, None  # set from the command line
DAWDLING = 0.2  # SUMO's default: striping takes up to so much off, half of it in the mean


class Caller(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.folder = Path(self.directory.name)

    def tearDown(self):
        self.directory.cleanup()

    def call(self, *words):
        return subprocess.run(list(map(str, words)), cwd=self.folder, text=True,
                              capture_output=True, timeout=200, env=sumo_environment())

    def succeed(self, *words):
        done = self.call(*words)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def persons(self, name):
        """SUMO's <personinfo> elements by id."""
        root = ET.parse(self.folder / name).getroot()
        return {person.get("id"): person for person in root.iter("personinfo")}


class People(Caller):
    """On the plaza of networks/, with vehicles and without persons of its own."""

    def run_pedzone(self, name, *words):
        self.succeed(PEDZONE, "run", SCENARIO / "panel.sumocfg", "--trajectories", f"{name}.csv",
                     *words, "--", "--tripinfo-output", f"{name}.xml",
                     "--tripinfo-output.write-unfinished")
        return (self.folder / f"{name}.csv").read_bytes()

    def walked(self, name):
        """What each person did: speed, where from and to, by SUMO's tripinfo."""
        return {person: (info.find("walk").get("maxSpeed"), info.get("depart"),
                         info.find("walk").get("departPos"), info.find("walk").get("arrivalPos"))
                for person, info in self.persons(name).items()}

    def plain_sumo(self, route_file, name):
        self.succeed("sumo", "-c", SCENARIO / "panel.sumocfg", "--additional-files", route_file,
                     "--tripinfo-output", name, "--tripinfo-output.write-unfinished")

    def test_one_number(self):
        first = self.run_pedzone("first", "--pedestrians", "200")
        again = self.run_pedzone("again", "--pedestrians", "200", "--threads", "2")
        other = self.run_pedzone("other", "--pedestrians", "200", "--seed", "5")
        self.assertEqual(first, again, "the same seed, the same bytes")
        self.assertNotEqual(first, other)
        people, others = self.walked("first.xml"), self.walked("other.xml")
        self.assertEqual(len(people), 200)
        for info in self.persons("first.xml").values():
            self.assertGreater(float(info.find("walk").get("arrival")), 0, "everybody arrives")
        self.assertGreater(len({speed for speed, *_ in people.values()}), 60, "they are varied")
        self.assertEqual(set(people), set(others))
        same = sum(people[person] == others[person] for person in people)
        self.assertLess(same, 10, "another seed, other people")

    def test_striping_walks_the_same_demand(self):
        self.run_pedzone("ours", "--pedestrians", "100", "--seed", "7")
        self.succeed(PEDZONE, "demand", SCENARIO / "panel.sumocfg", "--pedestrians", "100",
                     "--seed", "7", "--out", "people.rou.xml")
        self.plain_sumo("people.rou.xml", "striping.xml")
        ours, striping = self.walked("ours.xml"), self.walked("striping.xml")
        self.assertEqual(len(ours), 100)
        self.assertEqual(set(ours), set(striping))
        for person, (speed, depart, begin, _) in ours.items():
            self.assertEqual((speed, depart), striping[person][:2])
            self.assertEqual(begin, striping[person][2])
        for info in self.persons("striping.xml").values():
            self.assertGreater(float(info.find("walk").get("arrival")), 0)

    def test_zone_file(self):
        zones = SCENARIO / "panel.zone.xml"
        self.run_pedzone("run", "--zone", zones)
        self.succeed(PEDZONE, "demand", SCENARIO / "panel.sumocfg", "--zone", zones, "--out",
                     "people.rou.xml")
        root = ET.parse(self.folder / "people.rou.xml").getroot()
        types = {kind.get("id"): kind for kind in root.iter("vType")}
        self.assertEqual(set(self.persons("run.xml")), set(types))
        groups, counts, talking = {}, {}, 0
        for person in root.iter("person"):
            flow = person.get("id").split(".")[0]
            counts[flow] = counts.get(flow, 0) + 1
            keys = {param.get("key"): param.get("value") for param in person.iter("param")}
            if "pedzone.group" in keys:
                groups.setdefault(keys["pedzone.group"], []).append(person)
            kind = types[person.get("type")]
            profile = kind.find("param").get("value")
            speed = float(kind.get("maxSpeed")) * (1 - DAWDLING / 2)
            if flow == "commuters":
                self.assertGreaterEqual(speed, 1.3 - 1e-9)
                self.assertIn(profile, ("adult", "middle-aged"))
                self.assertEqual(person.find("walk").get("from"), "west_path")
                self.assertLess(float(person.get("depart")), 300)
                talking += "pedzone.activities" in keys
            if flow == "residents":
                self.assertNotIn("pedzone.group", keys)
                self.assertIsNotNone(person.find("stop"))
                self.assertIn(profile, ("senior", "wheelchair", "pram"))
        self.assertEqual((counts["visitors"], counts["class"], counts["residents"]), (60, 24, 20))
        self.assertGreater(talking, 5)
        classes = [members for group, members in groups.items() if group.startswith("class")]
        self.assertEqual([len(members) for members in classes], [6] * 4)
        stays = [info for person, info in self.persons("run.xml").items()
                 if person.startswith("residents")]
        self.assertEqual(len(stays), 20)

    def test_free_walkers_have_their_preferred_speed_in_the_mean(self):
        """Alone on the square, by pedzone and by striping."""
        words = ("--pedestrians", "12", "--pedestrians-alone", "1", "--pedestrians-per-hour", "60",
                 "--pedestrians-from", "north", "--pedestrians-to", "south",
                 "--pedestrians-speed-min", "1.2", "--pedestrians-speed-max", "1.25",
                 "--pedestrians-profiles", "adult=1")
        self.succeed(PEDZONE, "demand", SCENARIO / "panel.sumocfg", *words, "--out", "p.rou.xml")
        (self.folder / "no-vehicles.rou.xml").write_text("<routes/>")
        self.succeed("sumo", "-c", SCENARIO / "panel.sumocfg", "--route-files", "p.rou.xml",
                     "--tripinfo-output", "striping.xml")
        self.succeed(PEDZONE, "run", SCENARIO / "panel.sumocfg", *words, "--", "--route-files",
                     "no-vehicles.rou.xml", "--tripinfo-output", "ours.xml")
        for name in ("striping.xml", "ours.xml"):
            speeds = []
            for info in self.persons(name).values():
                walk = info.find("walk")
                speeds.append(float(walk.get("routeLength")) / float(walk.get("duration")))
            self.assertEqual(len(speeds), 12)
            self.assertAlmostEqual(sum(speeds) / len(speeds), 1.225, delta=0.04, msg=name)


class BadInput(RefusalChecks, Caller):
    """Each in the zone file and as an option: one error, and nothing is written."""

    def setUp(self):
        super().setUp()
        self.tiny = TinyScenario(self.folder)
        self.tiny.write("empty.rou.xml", "<routes/>")
        self.config = self.tiny.config(routes="empty.rou.xml")

    def outputs(self):
        return ["--trajectories", "out/t.csv", "--summary", "out/s.json"]

    def refused(self, attributes, *fragments):
        """`attributes`: of <pedestrians>, also given as options."""
        options = []
        for name, value in attributes.items():
            kebab = "".join("-" + c.lower() if c.isupper() else c for c in name)
            options += ["--pedestrians" + ("" if name == "number" else "-" + kebab) + "=" + value]
        text = " ".join(f'{name}="{value}"' for name, value in attributes.items())
        zones = self.tiny.write("z.zone.xml", f"<zones>\n  <pedestrians {text}/>\n</zones>")
        for words in (["run", self.config, *self.outputs()],
                      ["demand", self.config, "--out", "out/p.rou.xml"]):
            self.check_refused(self.call(PEDZONE, *words, *options), "--pedestrians", *fragments)
            self.check_refused(self.call(PEDZONE, *words, "--zone", zones), "z.zone.xml:2",
                               "<pedestrians>", *fragments)

    def test_it_would_run(self):
        self.succeed(PEDZONE, "run", self.config, "--pedestrians", "5", *self.outputs())

    def test_no_number(self):
        self.refused({"alone": "0.5"}, "number", "missing")

    def test_nobody(self):
        self.refused({"number": "0"}, "'0'", "1 to 1000000")

    def test_unknown_profile(self):
        self.refused({"number": "9", "profiles": "adult=0.5 wizard=0.1"}, "profiles", "'wizard'",
                     "infant, child")

    def test_unknown_activity(self):
        self.refused({"number": "9", "activities": "flying=0.1"}, "activities", "'flying'",
                     "texting, phoning")

    def test_unknown_edge(self):
        self.refused({"number": "9", "from": "shared nowhere"}, "from", "'nowhere'", "tiny.net.xml")

    def test_unknown_zone(self):
        self.refused({"number": "9", "zone": "park"}, "zone", "'park'", "shared-space")

    def test_unknown_path(self):
        self.refused({"number": "9", "path": "loop"}, "path", "'loop'", "no path")

    def test_shares_of_more_than_one(self):
        self.refused({"number": "9", "profiles": "adult=0.7 senior=0.4"}, "add to more than 1")
        self.refused({"number": "9", "activities": "texting=0.7 phoning=0.4"}, "add to more than 1")

    def test_group_of_one(self):
        self.refused({"number": "9", "groupSize": "1"}, "group", "'1'", "2 to 50")

    def test_child_alone(self):
        self.refused({"number": "9", "profiles": "infant=1"}, "'infant'", "walk alone")

    def test_no_number_at_all(self):
        self.refused({"number": "many"}, "'many'", "not a number")

    def test_nobody_asked_for(self):
        self.check_refused(self.call(PEDZONE, "demand", self.config, "--out", "out/p.rou.xml"),
                           "--pedestrians")
        self.check_refused(self.call(PEDZONE, "run", self.config, "--strict", *self.outputs()),
                           "names no person")

    def test_out_that_cannot_be_written(self):
        self.tiny.write("out", "a file, not a folder")
        done = self.call(PEDZONE, "demand", self.config, "--pedestrians", "5", "--out",
                         "out/p.rou.xml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--out", done.stderr)


if __name__ == "__main__":
    SCENARIO = Path(sys.argv.pop()).resolve()
    PEDZONE = str(Path(sys.argv.pop()).resolve())
    unittest.main()
