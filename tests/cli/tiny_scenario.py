"""A tiny real SUMO scenario for command-line tests: a shared street between two ordinary ones."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

NODES = """<nodes>
  <node id="A" x="0" y="0"/><node id="B" x="60" y="0"/>
  <node id="C" x="120" y="0"/><node id="D" x="180" y="0"/>
</nodes>"""

EDGES = """<edges>
  <edge id="west" from="A" to="B" numLanes="1" speed="13.89" sidewalkWidth="2"/>
  <edge id="shared" from="B" to="C" numLanes="1" speed="2.78" type="highway.living_street"
        disallow="tram" width="8"/>
  <edge id="east" from="C" to="D" numLanes="1" speed="13.89" sidewalkWidth="2"/>
</edges>"""

# netconvert keeps an edge's type only when it is defined.
TYPES = """<types><type id="highway.living_street" speed="2.78" numLanes="1"/></types>"""

WALKS = """<routes>
  <person id="p0" depart="0"><walk edges="west shared east"/></person>
  <person id="p1" depart="1"><walk edges="shared" departPos="5" arrivalPos="40"/></person>
  <person id="p2" depart="2"><walk from="east" to="west"/></person>
</routes>"""

CONFIG = """<configuration>
  <input><net-file value="{net}"/><route-files value="{routes}"/>
         <additional-files value="{additional}"/></input>
  <time><step-length value="0.5"/><end value="200"/></time>
{more}
</configuration>"""

# A person called {person} beside a van that drives.
FCD = """<fcd-export>
<timestep time="0.00">
  <vehicle id="car" x="10.00" y="0.00" angle="90.00" type="van" speed="8.00"/>
  <person id="{person}" x="30.00" y="2.00" angle="0.00" speed="0.00"/></timestep>
<timestep time="1.00">
  <vehicle id="car" x="18.00" y="0.00" angle="90.00" type="van" speed="8.00"/>
  <person id="{person}" x="30.00" y="3.00" angle="0.00" speed="1.00"/></timestep>
</fcd-export>
"""


def sumo_environment():
    return {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}


class TinyScenario:
    """Writes the files into a folder; any of them can be replaced before `config` is called."""

    def __init__(self, folder, edges=EDGES, netconvert=()):
        self.folder = Path(folder)
        for name, text in (("tiny.nod.xml", NODES), ("tiny.edg.xml", edges),
                           ("tiny.typ.xml", TYPES), ("tiny.rou.xml", WALKS),
                           ("tiny.add.xml", "<additional/>")):
            (self.folder / name).write_text(text)
        self.convert(*netconvert)

    def convert(self, *options):
        """Makes the network of the nodes, edges and types as they are now."""
        subprocess.run(
            ["netconvert", "-n", "tiny.nod.xml", "-e", "tiny.edg.xml", "-t", "tiny.typ.xml",
             "-o", "tiny.net.xml", "--walkingareas", "true", "--crossings.guess", "false",
             *options],
            cwd=self.folder, check=True, capture_output=True, env=sumo_environment())

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name

    def config(self, net="tiny.net.xml", routes="tiny.rou.xml", additional="tiny.add.xml", more=""):
        return self.write("tiny.sumocfg", CONFIG.format(net=net, routes=routes,
                                                        additional=additional, more=more))


class TinyCase(unittest.TestCase):
    """A test with a tiny scenario `tiny` in a new folder `folder`."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)
        self.tiny = TinyScenario(self.folder)
