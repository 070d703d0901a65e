#!/usr/bin/python3
"""The edges on which SUMO has the people whom pedzone walks, as other clients of SUMO meet them: real
SUMO, SUMO's own traci.

usage: test_edges.py PEDZONE_PROGRAM
"""
import subprocess
import sys
import tempfile
import textwrap
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import attached
from attached import AttachedCase, sumo_environment

NODES = """<nodes><node id="a" x="0" y="0"/><node id="b" x="30" y="0"/><node id="c" x="60" y="0"/>
<node id="d" x="60" y="-20"/></nodes>"""
LANE = 'numLanes="1" width="4" allow="pedestrian"'
EDGES = f"""<edges><edge id="ab" from="a" to="b" {LANE}/><edge id="bc" from="b" to="c" {LANE}/>
<edge id="bd" from="b" to="d" {LANE}/></edges>"""
PEOPLE = 100
WALKS = "<routes>" + "".join(
    f'<person id="p{k}" depart="{0.6 * k:.1f}"><walk edges="ab bc" arrivalPos="20"/></person>'
    for k in range(PEOPLE)) + "</routes>"

CLIENT = """
import math, sys
sys.path.append("/usr/share/sumo/tools")
import traci, traci.constants as tc
traci.init(int(sys.argv[1]), numRetries=300)
traci.setOrder(1)
done, hits, near = set(), 0, 0
{before}
while traci.simulation.getMinExpectedNumber() > 0 and traci.simulation.getTime() < 200:
    traci.simulationStep()
    for person in traci.person.getIDList():
        x, y = traci.person.getPosition(person)
{each}
{after}
traci.close()
"""

# Each person gets it at a place of its own, around where it comes to its second edge.
REPLANNED = """
if person not in done and x > 28 + 0.15 * int(person[1:]):
    done.add(person)
    {new_plan}
"""
REPLACED = """traci.person.replaceStage(person, 0, traci.simulation.Stage(
        type=tc.STAGE_WALKING, edges=["ab", "bd"], arrivalPos=15.0))"""
REMOVED = """traci.person.removeStages(person)
    traci.person.appendWalkingStage(person, ["ab", "bd"], 15.0)"""
WAITS = """traci.person.removeStages(person)
    traci.person.appendWaitingStage(person, 5.0)"""


class Edges(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)
        for name, text in (("n.nod.xml", NODES), ("n.edg.xml", EDGES), ("n.rou.xml", WALKS),
                           ("n.zone.xml", '<zones><zone id="all" edges="ab bc bd"/></zones>'),
                           ("n.sumocfg", '<configuration><net-file value="n.net.xml"/>'
                                         '<route-files value="n.rou.xml"/></configuration>')):
            (self.folder / name).write_text(text)
        subprocess.run(["netconvert", "-n", "n.nod.xml", "-e", "n.edg.xml", "-o", "n.net.xml"],
                       cwd=self.folder, check=True, capture_output=True, env=sumo_environment())

    def run_with(self, each, before="", after="", step=0.1):
        """What a client prints that runs `each` for every person after every step."""
        script = CLIENT.format(before=before, after=after,
                               each=textwrap.indent(textwrap.dedent(each), " " * 8))
        (self.folder / "client.py").write_text(script)
        done = subprocess.run(
            [AttachedCase.pedzone, "run", "n.sumocfg", "--zone", "n.zone.xml", "--quiet", "--client",
             f"{sys.executable} client.py {{port}}", "--", "--step-length", str(step),
             "--tripinfo-output", "trips.xml"],
            cwd=self.folder, text=True, capture_output=True, timeout=attached.LONG,
            env=sumo_environment())
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def people(self):
        return list(ElementTree.parse(self.folder / "trips.xml").getroot().iter("personinfo"))

    def test_another_plan_while_it_comes_to_its_next_edge(self):
        for new_plan in (REPLACED, REMOVED, WAITS):
            with self.subTest(new_plan):
                self.run_with(REPLANNED.format(new_plan=new_plan))
                self.assertEqual(len(self.people()), PEOPLE)

    def test_context_subscriptions_find_who_is_near(self):
        out = self.run_with("""
            if math.dist((x, y), c) < 15:
                near += 1
                hits += person in traci.junction.getContextSubscriptionResults("c")
            """, before="""
c = traci.junction.getPosition("c")
traci.junction.subscribeContext("c", tc.CMD_GET_PERSON_VARIABLE, 15, [tc.VAR_POSITION])
""", after='print("found", hits, near, flush=True)')
        _, hits, near = out.split()[-3:]
        self.assertGreater(int(near), 5000)
        self.assertGreater(int(hits), 0.98 * int(near))

    def test_road_ids(self):
        out = self.run_with("""
            if x < 20 or x > 40:  # in between is the junction
                near += 1
                hits += traci.person.getRoadID(person) == ("ab" if x < 30 else "bc")
            """, after='print("right", hits, near, flush=True)')
        _, hits, near = out.split()[-3:]
        self.assertGreater(int(near), 10000)
        self.assertGreater(int(hits), 0.98 * int(near))


if __name__ == "__main__":
    attached.main(__doc__)
