#!/usr/bin/python3
"""A run in a real sumo-gui under Xvfb: the same walks as without, and pictures of what people do.

usage: test_gui.py PEDZONE_PROGRAM SCENARIOS_FOLDER [--keep PICTURE.png]
"""

import os
import re
import subprocess
import sys
import textwrap
import unittest
from pathlib import Path

import attached
from attached import AttachedCase

LONG = 1500  # s; pictures take a minute, on a busy machine many
SCENARIOS = Path(os.path.abspath(sys.argv.pop(2)))
KEEP = os.path.abspath(sys.argv.pop()) if sys.argv[2:3] == ["--keep"] and sys.argv.pop(2) else None
LEGEND = {"walking": (60, 160, 75), "waiting": (220, 50, 40), "rays": (230, 90, 20),
          "zone": (109, 156, 233)}  # its edge, before the background

SELECTING = """
    import sys
    sys.path.append("/usr/share/sumo/tools")
    import traci
    traci.init({port}, numRetries=300)
    traci.setOrder(1)
    chosen = None
    for _ in range({steps}):
        if chosen is None and traci.simulation.getTime() > {after}:
            near = [p for p in traci.person.getIDList()
                    if max(map(abs, traci.person.getPosition(p))) < 18]
            if near:
                chosen = near[0]
                traci.gui.toggleSelection(chosen, "person")
        traci.simulationStep()
    traci.close()
"""


def pixels(picture):
    """Red, green, blue of each pixel."""
    found = subprocess.run(["pngtopnm", picture], capture_output=True, check=True).stdout
    head = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", found)
    body = found[head.end():]
    return [tuple(body[k:k + 3]) for k in range(0, len(body) - 2, 3)]


class Gui(AttachedCase):
    def gui(self, config, end, *words):
        return self.start("xvfb-run", "-a", "-s", "-screen 0 1400x900x24", self.pedzone, "run",
                          config, "--end", end, "--gui", "--delay", "0", *words, "--",
                          "--gui-settings-file", SCENARIOS / "av-in-the-loop/view.xml")

    def test_walks_and_pictures(self):
        config = SCENARIOS / "plaza/plaza-high.sumocfg"
        client = self.folder / "selecting.py"
        client.write_text(textwrap.dedent(SELECTING.format(port=self.port, steps=610, after=57)))
        with_gui = self.gui(config, 60, "--trajectories", "gui.csv", "--screenshots", "shots",
                            "--clients", "1", "--port", self.port)
        selecting = self.start(sys.executable, client)
        _, errors = with_gui.communicate(timeout=LONG)
        self.assertEqual(with_gui.returncode, 0, errors)
        selecting.communicate(timeout=LONG)
        without = self.start(self.pedzone, "run", config, "--end", 60, "--trajectories", "run.csv")
        without.communicate(timeout=LONG)
        self.assertEqual((self.folder / "gui.csv").read_bytes(),
                         (self.folder / "run.csv").read_bytes())
        pictures = sorted((self.folder / "shots").glob("step-*.png"))
        self.assertGreater(len(pictures), 590)
        if KEEP:
            Path(KEEP).write_bytes(pictures[598].read_bytes())
        last = pixels(pictures[598])
        self.assertGreater(len(last), 500_000, "a picture as large as the window")
        for what in ("walking", "rays"):
            seen = sum(1 for pixel in last if pixel == LEGEND[what])
            self.assertGreater(seen, 20, what)
        self.assertEqual(sum(1 for pixel in pixels(pictures[300]) if pixel == LEGEND["rays"]), 0,
                         "nobody was selected then")

    def test_a_joined_sumo_gui_is_drawn_in(self):
        config = SCENARIOS / "plaza/plaza-high.sumocfg"
        self.start("xvfb-run", "-a", "-s", "-screen 0 1400x900x24", "sumo-gui", "-c", config,
                   "--remote-port", self.port, "--start", "--quit-on-end", "--window-size",
                   "1400,900", "--gui-settings-file", SCENARIOS / "av-in-the-loop/view.xml")
        pedzone = self.attach("--order", 1, "--end", 5, "--screenshots", "shots", config=config)
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 0, errors)
        pictures = sorted((self.folder / "shots").glob("step-*.png"))
        self.assertGreater(len(pictures), 40)
        seen = sum(1 for pixel in pixels(pictures[40]) if pixel == LEGEND["zone"])
        self.assertGreater(seen, 1000)

    def test_a_joined_sumo_without_a_window_takes_no_pictures(self):
        self.start_sumo(1)
        pedzone = self.attach("--order", 1, "--screenshots", "shots")
        _, errors = pedzone.communicate(timeout=LONG)
        self.assertEqual(pedzone.returncode, 2)
        self.assertIn("the SUMO that runs has no window", errors)

    def test_without_a_display_it_says_so(self):
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        done = subprocess.run([self.pedzone, "run", str(self.config), "--gui"], cwd=self.folder,
                              capture_output=True, text=True, timeout=LONG, env=environment)
        self.assertEqual(done.returncode, 3)
        self.assertIn("SUMO ended while it was starting", done.stderr)


if __name__ == "__main__":
    attached.main(__doc__)
