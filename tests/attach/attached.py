"""SUMO with a port, pedzone attached to it and other clients: real processes, ended with the test."""

import csv
import os
import socket
import subprocess
import sys
import tempfile
import threading
import unittest
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


def main(module_doc):
    """Runs the tests of the calling module; the program is the first word."""
    AttachedCase.pedzone = os.path.abspath(sys.argv.pop(1))
    unittest.main(module="__main__")
