#!/usr/bin/python3
"""Studies whose runs start a client of SUMO's: what it is told, and what goes wrong.

usage: test_client.py PEDZONE_PROGRAM
"""

import json

import study_case
from study_case import StudyCase

# Drives a vehicle at --speed through the shared street, and notes what it was told.
CLIENT = """
import argparse, sys
sys.path.append("/usr/share/sumo/tools")
import traci
parser = argparse.ArgumentParser()
parser.add_argument("--port", type=int)
parser.add_argument("--speed", type=float)
parser.add_argument("--out")
parser.add_argument("--fail", action="store_true")
options = parser.parse_args()
traci.init(options.port, numRetries=300)
traci.setOrder(1)
traci.vehicle.add("v", "through")
while traci.simulation.getTime() < 20:
    if options.fail and traci.simulation.getTime() > 5:
        sys.exit("the sensor is broken")
    if "v" in traci.vehicle.getIDList():
        traci.vehicle.setSpeed("v", options.speed)
    traci.simulationStep()
open(options.out, "w").write(str(options.speed))
traci.close()
"""
ROUTES = """<routes>
  <route id="through" edges="west shared east"/>
  <person id="p0" depart="0"><walk edges="west shared east"/></person>
  <person id="p1" depart="1"><walk edges="shared" departPos="5" arrivalPos="40"/></person>
</routes>"""
STUDY = """<study id="tiny" seeds="1-2" models="{models}" end="20">
  <scenario file="tiny.sumocfg" client="python3 client.py --port {{port}} --out {{folder}}/v.txt{more}"/>
  <factor id="speed" client="--speed" values="2 4"/>
</study>"""


class Clients(StudyCase):
    FOLDER = "a study"  # a shell is given it, too

    def setUp(self):
        super().setUp()
        self.tiny.write("tiny.rou.xml", ROUTES)
        self.tiny.write("client.py", CLIENT)

    def write(self, models="heuristic", more=""):
        return self.tiny.write("study.xml", STUDY.format(models=models, more=more))

    def test_each_run_has_its_own(self):
        study = self.write()
        self.make(study, "--jobs", 2)
        told = {}
        for name, record in self.records().items():
            free = record["definition"]["kind"] == "freeSpeed"
            note = self.results / "runs" / name / "v.txt"
            self.assertEqual(note.exists(), not free)
            self.assertEqual(str(self.folder / "client.py") in record["inputs"], not free)
            if not free:
                speed = record["definition"]["client"]["--speed"]
                self.assertEqual(float(note.read_text()), float(speed))
                told.setdefault(speed, set()).add(record["measures"]["vehicle.count"])
        self.assertEqual(told, {"2": {1.0}, "4": {1.0}})
        self.assertEqual(len(self.run_names()), 1 + 4, "one free-speed run for both speeds")
        summary = json.loads((self.results / "summary.json").read_text())
        self.assertIn("client.py", summary["study"]["scenarios"][0]["client"])

    def test_another_client_makes_other_runs(self):
        study = self.write()
        self.make(study)
        before = self.records()
        self.tiny.write("client.py", CLIENT.replace("< 20", "< 19"))
        self.make(study)
        for name, record in self.records().items():
            same = record == before[name]
            self.assertEqual(same, record["definition"]["kind"] == "freeSpeed")

    def test_one_that_fails(self):
        done = self.make(self.write(more=" --fail"), code=4)
        self.assertEqual(self.statuses(), {"heuristic": ["failed"] * 4})
        self.assertIn("the sensor is broken", done.stdout + done.stderr +
                      "".join(path.read_text() for path in self.results.glob("runs/*/log.txt")))

    def test_one_that_is_not_there(self):
        (self.folder / "client.py").unlink()
        self.make(self.write(), code=4)
        log = next(path.read_text() for path in self.results.glob("runs/*/log.txt")
                   if "client.py" in path.read_text())
        self.assertIn("The client that was started ended with exit code 2", log)

    def test_sumo_does_not_start_it(self):
        done = self.make(self.write(models="striping heuristic"), code=2)
        self.assertIn("is started by pedzone's models only, and the study has striping", done.stderr)

    def test_an_option_for_nobody(self):
        study = self.write()
        study.write_text(study.read_text().replace(" client=\"python3", " id=\"python3"))
        done = self.make(study, code=2)
        self.assertIn("is an option of a client, and there is none", done.stderr)


if __name__ == "__main__":
    study_case.main()
