#!/usr/bin/python3
"""`pedzone study` on good and bad study files: what a run gets, and what is refused before any run.

usage: test_study_input.py PEDZONE_PROGRAM
"""

import gzip
import json
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

from refusal import RefusalChecks
from tiny_scenario import TinyScenario, sumo_environment

PEDZONE = None  # set from the command line

ROUTES = """<routes>
  <vType id="slow" vClass="pedestrian" maxSpeed="0.8"><param key="pedzone.group" value="g"/></vType>
  <vType id="van" vClass="delivery" length="5" width="1.9"/>
  <personFlow id="flow" begin="0" end="40" period="10"><walk from="west" to="shared"/></personFlow>
  <person id="p1" type="slow" depart="1"><walk edges="shared" departPos="5" arrivalPos="40"/></person>
  <person id="p2" depart="2"><walk from="east" to="west"/></person>
  <trip id="van0" type="van" depart="3" from="west" to="east"/>
  <person id="p3" type="slow" depart="4"><walk from="east" to="shared"/></person>
</routes>"""


class StudyInput(RefusalChecks, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.directory.name)
        cls.tiny = TinyScenario(cls.folder)
        cls.tiny.write("tiny.rou.xml", ROUTES)
        cls.tiny.config()

    @classmethod
    def tearDownClass(cls):
        cls.directory.cleanup()

    def study(self, text, out="out/results"):
        self.tiny.write("a.study.xml", text)
        environment = {key: value for key, value in sumo_environment().items()
                       if key != "SUMO_HOME"}  # must be found by the program
        return subprocess.run([PEDZONE, "study", "run", "a.study.xml", "--out", out],
                              cwd=self.folder, text=True, capture_output=True, timeout=280,
                              env=environment)

    def refused(self, text, *fragments):
        done = self.study(text)
        self.check_refused(done, *fragments)
        self.assertFalse((self.folder / "out").exists(), "no folder is made for a bad study")

    # What is refused

    def test_missing_and_broken_files(self):
        done = subprocess.run([PEDZONE, "study", "run", "none.xml", "--out", "out/results"],
                              cwd=self.folder, text=True, capture_output=True, timeout=60)
        self.check_refused(done, "none.xml: cannot be opened")
        self.refused("<study", "a.study.xml:1: is not well-formed XML")
        self.refused("<zones/>", "a.study.xml:1: document element: 'zones' is not", "study")
        self.refused("<study/>", "a.study.xml:1: <study>: has no <scenario>")

    def test_seeds(self):
        for seeds in ("", "a", "1-", "5-1", "1-99999999", "3 3"):
            self.refused(f'<study seeds="{seeds}"><scenario file="tiny.sumocfg"/></study>',
                         "a.study.xml:1: <study> attribute seeds: ")

    def test_unknown_names(self):
        scenario = '<scenario file="tiny.sumocfg"/>'
        self.refused(f'<study models="strping">{scenario}</study>', "'strping'", "striping, ")
        self.refused(f'<study models="./no.so">{scenario}</study>', "no.so' does not exist")
        self.refused('<study><scenario file="no.sumocfg"/></study>', "no.sumocfg' does not exist")
        for factor, said in (('parameter="sigt"', "'sigt' is no parameter; allowed: sight, "),
                             ('panel="nmber"', "'nmber' is no attribute of <pedestrians>"),
                             ('zone="model"', "'model' is no attribute of <zone> that may vary"),
                             ('sumo="scle"', "'scle' is no option of SUMO"),
                             ('sumo="fcd-output"', "'fcd-output' cannot be set by a study"),
                             ('sumo="end"', "'end' cannot be set by a study")):
            self.refused(f'<study>{scenario}\n<factor id="f" {factor} values="1"/></study>',
                         "a.study.xml:2: <factor id=\"f\"> attribute", said)
        self.refused(f'<study>{scenario}\n<factor id="f" parameter="sight" values=""/></study>',
                     "a.study.xml:2: <factor id=\"f\"> attribute values: is empty")
        self.refused(f'<study>{scenario}<factor id="f" parameter="sight" values="5 10"/>\n'
                     '<combination levels="7"/></study>',
                     "a.study.xml:2: <combination> attribute levels: '7' is no level of factor f; "
                     "allowed: 5, 10")

    def test_a_panel_that_makes_nobody(self):
        self.refused('<study><scenario file="tiny.sumocfg"/>\n<factor id="f"><level name="x">'
                     '<set panel="speedMin" value="1"/></level></factor></study>',
                     "a.study.xml:2: <pedestrians> attribute number: is missing")

    # What a run gets

    def trips(self, run):
        """{id: (departure, type)} of persons and of vehicles, from SUMO's own output."""
        root = ET.parse(run / "tripinfo.xml").getroot()
        persons = {node.get("id"): (node.get("depart"), node.get("type"))
                   for node in root.iter("personinfo")}
        return persons, {node.get("id"): node.get("vType") for node in root.iter("tripinfo")}

    def test_models_get_the_same_people(self):
        done = self.study("""<study seeds="3 5" end="60" models="striping orca nonInteracting">
  <scenario file="tiny.sumocfg" options="--step-length 0.25"/>
  <factor id="people" panel="number" values="4 9"/>
</study>""", out="good results")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        runs = {}
        for record in (self.folder / "good results/runs").glob("*/record.json"):
            definition = json.loads(record.read_text())["definition"]
            self.assertEqual(definition["sumo"], {"step-length": "0.25"})
            key = definition["kind"], definition["panel"]["number"], definition["seed"]
            runs.setdefault(key, {})[definition["model"]] = record.parent
        self.assertEqual(set(runs), {(kind, number, seed) for number in "49" for kind, seed in
                                     (("study", 3), ("study", 5), ("freeSpeed", 3))})
        for (kind, number, _), models in runs.items():
            self.assertEqual(set(models), {"striping", "orca", "nonInteracting"})
            persons, vehicles = self.trips(models["striping"])
            for run in models.values():
                self.assertEqual(self.trips(run), (persons, vehicles))
            panel = [person for person in persons if person.startswith("pedestrians.")]
            if kind == "study":
                self.assertEqual(len(panel), int(number))
                self.assertEqual(vehicles, {"van0": "van"})
                self.assertEqual(set(persons) - set(panel),
                                 {"flow.0", "flow.1", "flow.2", "flow.3", "p1", "p2", "p3"})
            else:
                self.assertEqual(vehicles, {})
                for run in models.values():
                    self.check_alone(run, set(persons))

    def check_alone(self, run, persons):
        """In SUMO's own floating-car data nobody is ever beside another."""
        seen = set()
        with gzip.open(run / "fcd.xml.gz") as file:
            for step in ET.parse(file).getroot():
                here = [node.get("id") for node in step]
                self.assertLessEqual(len(here), 1, step.get("time"))
                seen.update(here)
        self.assertEqual(seen, persons)
        self.assertGreaterEqual(len(seen), 5)


if __name__ == "__main__":
    PEDZONE = str(Path(sys.argv.pop(1)).resolve())
    unittest.main()
