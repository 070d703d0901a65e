#!/usr/bin/python3
"""JSON for other programs: a run's summary against its schema, --json against the text and files.

usage: test_json.py PEDZONE_PROGRAM SUMMARY_SCHEMA
"""

import copy
import csv
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import jsonschema

from tiny_scenario import TinyScenario, sumo_environment

PEDZONE, SCHEMA = None, None  # set from the command line
ROUTES = """<routes><vType id="van" length="6" width="2" maxSpeed="4"/>{}</routes>"""


def routes():
    people = "".join(
        f'<person id="p{k:02}" depart="{k}"><walk from="west" to="east"/></person>'
        + (f'<vehicle id="v{k:02}" type="van" depart="{k}"><route edges="west shared east"/></vehicle>'
           if k % 8 == 6 else "") for k in range(40))
    return ROUTES.format(people)


class JsonCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.folder = Path(directory.name)
        tiny = TinyScenario(cls.folder)
        tiny.write("tiny.rou.xml", routes())
        tiny.config()
        cls.call("run", "tiny.sumocfg", "--summary", "s.json", "--", "--fcd-output", "fcd.xml")

    @classmethod
    def call(cls, *words, code=0):
        done = subprocess.run([PEDZONE, *words], cwd=cls.folder, text=True, capture_output=True,
                              timeout=250, env=sumo_environment())
        assert done.returncode == code, done
        return done.stdout

    def json(self, *words, code=0):
        read = json.loads(self.call(*words, "--json", code=code))
        self.assertEqual(read["version"], 1)
        self.assertEqual(json.loads(self.call(*words, "--json", "--quiet", code=code)), read)
        return read


class Summary(JsonCase):
    def test_a_real_one_is_as_the_schema_says(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)
        summary = json.loads((self.folder / "s.json").read_text())
        self.assertEqual(summary["version"], 1)
        self.assertGreater(summary["persons"]["controlled"], 0)
        jsonschema.validate(summary, SCHEMA)
        self.call("run", "tiny.sumocfg", "--summary", "few.json", "--end", "1", "--",
                  "--no-warnings")
        jsonschema.validate(json.loads((self.folder / "few.json").read_text()), SCHEMA)

    def test_the_schema_refuses_another(self):
        good = json.loads((self.folder / "s.json").read_text())

        def without(*keys):
            bad = copy.deepcopy(good)
            part = bad
            for key in keys[:-1]:
                part = part[key]
            del part[keys[-1]]
            return bad
        for bad in (without("version"), {**good, "version": 2}, {**good, "more": 1},
                    without("persons", "lost"), without("not_moved_for_60_s", "persons", "most"),
                    {**good, "jams": [{}]}, {**good, "interrupted": 0}):
            with self.assertRaises(jsonschema.ValidationError):
                jsonschema.validate(bad, SCHEMA)


class Printed(JsonCase):
    def test_inspect(self):
        told, text = self.json("inspect", "tiny.sumocfg"), self.call("inspect", "tiny.sumocfg")
        (zone,) = told["zones"]
        self.assertEqual(zone["id"], re.search('^Zone "(.*?)"', text)[1])
        self.assertIn(f"{zone['edges']} of {zone['length_m']:.1f} m together", text)
        self.assertIn(f"{zone['walkable_m2']:.0f} m² in {zone['parts']} part", text)
        self.assertIn(f"walls        {zone['walls']}\n", text)
        self.assertEqual([one["type"] for one in zone["types"]], ["highway.living_street"])
        self.assertGreater(len(told["left_to_sumo"]), 0)
        for one in told["left_to_sumo"]:
            self.assertRegex(text, rf"{one['length_m']:.1f} m +{one['edges']} edge")

    def test_conflicts(self):
        measure = ["conflicts", "fcd.xml", "--vtypes", "tiny.rou.xml", "--conflict-csv", "c.csv",
                   "--conflict-ttc", "20"]
        told = self.json(*measure)["conflicts"]
        with open(self.folder / "c.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertGreater(len(rows), 0)
        self.assertEqual([(one["person"], one["vehicle"], one["type"]) for one in told],
                         [(row["person"], row["vehicle"], row["type"]) for row in rows])
        for one, row in zip(told, rows):
            for measure in ("minTTC", "PET", "minClearance", "PCT", "TBT"):
                self.assertEqual(measure in one, row[measure] != "")
                if measure in one:
                    self.assertAlmostEqual(one[measure]["value"], float(row[measure]), delta=0.0051)
                    self.assertAlmostEqual(one[measure]["time"], float(row[measure + "_time"]),
                                           delta=0.0051)
                if measure in one and measure + "_closingSpeed" in row:
                    self.assertAlmostEqual(one[measure]["closingSpeed"],
                                           float(row[measure + "_closingSpeed"]), delta=0.0051)

    def test_study_status(self):
        (self.folder / "a.study.xml").write_text(
            '<study seeds="1-2" end="20"><scenario file="tiny.sumocfg"/></study>')
        self.call("study", "run", "a.study.xml", "--out", "r", "--quiet")
        told = self.json("study", "status", "r")
        text = self.call("study", "status", "r")
        self.assertIn(f"{told['study']}: {told['runs']} runs\n", text)
        for key in ("done", "failed", "killed", "missing"):
            self.assertRegex(text, rf"\n  {key} +{told[key]}\n")
        self.assertGreater(told["done"], 3)
        self.assertEqual(told["done"], told["runs"])
        self.assertEqual((told["troubles"], told["slurm"], told["at_work"]), ([], [], None))
        self.addCleanup((self.folder / "tiny.rou.xml").write_text, routes())
        (self.folder / "tiny.rou.xml").write_text(routes().replace(  # what SUMO refuses
            'edges="west shared east"', 'edges="east west"'))
        self.call("study", "run", "a.study.xml", "--out", "r2", "--quiet", code=4)
        told = self.json("study", "status", "r2", code=4)
        self.assertGreater(told["failed"], 3)
        self.assertEqual(len(told["troubles"]), told["failed"])
        for one in told["troubles"]:
            self.assertEqual(one["status"], "failed")
            self.assertTrue(Path(one["log"]).exists() and one["failure"], one)


if __name__ == "__main__":
    SCHEMA = json.loads(Path(sys.argv.pop()).read_text())
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
