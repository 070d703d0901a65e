"""SUMO with a port, pedzone attached to it and other clients: real processes, ended with the test."""

import csv
import os
import socket
import subprocess
import sys
import tempfile
import textwrap
import threading
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "cli"))
from tiny_scenario import TinyScenario, sumo_environment  # noqa: E402

LONG = 300  # s; nothing takes that long, on a busy machine either, unless it hangs

FLOW = """<routes>
  <personFlow id="f" begin="0" end="1000" period="5"><walk edges="west shared east"/></personFlow>
</routes>"""


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class AttachedCase(unittest.TestCase):
    """`self.pedzone` is the program."""

    pedzone = None  # set from the command line
    routes = FLOW

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name)
        self.tiny = TinyScenario(self.folder)
        self.tiny.write("tiny.rou.xml", self.routes)
        self.config = self.tiny.config()
        self.port = free_port()

    def start(self, *words, **more):
        process = subprocess.Popen([str(word) for word in words], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   env=sumo_environment(), **more)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        process.kill()
        process.communicate()

    def start_sumo(self, clients, *words, config=None):
        return self.start("sumo", "-c", config or self.config, "--remote-port", self.port,
                          "--num-clients", clients, "--no-step-log", *words)

    def attach(self, *words, config=None, patience=LONG):
        return self.start(self.pedzone, "attach", config or self.config, "--port", self.port,
                          "--patience", patience, *words)

    def hear(self, process, text):
        """Everything up to the line with `text` that a process says on its standard error."""
        too_long = threading.Timer(LONG, process.kill)
        too_long.start()
        said = ""
        for line in process.stderr:
            said += line
            if text in line:
                break
        too_long.cancel()
        self.assertIn(text, said)
        return said

    def client(self, *words):
        return self.start("/usr/bin/python3", HERE / "client.py", "--port", self.port, *words)

    def together(self, program, end=120, order=1, routes=None, leaves=None):
        """pedzone, until it leaves, beside a client that runs `program` before each of its steps (t:
        time)."""
        if routes is not None:
            self.tiny.write("tiny.rou.xml", routes)
        script = self.folder / "other.py"
        script.write_text(textwrap.dedent(f"""
            import sys
            sys.path.append("/usr/share/sumo/tools")
            import traci
            traci.init({self.port}, numRetries=300)
            traci.setOrder({order})
            t, seen = 0.0, []
            while t < {end}:
                vehicles, persons = traci.vehicle.getIDList(), traci.person.getIDList()
            """) + textwrap.indent(textwrap.dedent(program), "    ") + textwrap.dedent("""
                traci.simulationStep()
                t = traci.simulation.getTime()
            traci.close()
            """))
        sumo = self.start_sumo(2, "--fcd-output", "fcd.xml", "--tripinfo-output", "trips.xml",
                               "--collision.check-junctions")
        client = self.start(sys.executable, script)
        pedzone = self.attach("--order", 3 - order, "--end", leaves or end, "--trajectories", "t.csv",
                              "--summary", "s.json")
        output, errors = pedzone.communicate(timeout=LONG)
        _, complaint = client.communicate(timeout=LONG)
        self.assertEqual(client.returncode, 0, complaint)
        self.assertEqual(pedzone.returncode, 0, errors)
        sumo.communicate(timeout=LONG)
        self.assertEqual(sumo.returncode, 0)
        return errors

    def speeds(self, vehicle="v"):
        """{time [s]: (speed [m/s], x [m])}"""
        found = {}
        for step in ElementTree.parse(self.folder / "fcd.xml").iter("timestep"):
            for one in step.iter("vehicle"):
                if one.get("id") == vehicle:
                    found[float(step.get("time"))] = (float(one.get("speed")),
                                                      float(one.get("x")))
        return found


def main(module_doc):
    """Runs the tests of the calling module; the program is the first word."""
    AttachedCase.pedzone = os.path.abspath(sys.argv.pop(1))
    unittest.main(module="__main__")
