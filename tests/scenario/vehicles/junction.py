#!/usr/bin/python3
"""A junction without signals inside a zone, 60 persons and 60 cars: with pedzone and in plain SUMO.

usage: junction.py PEDZONE [--seeds N,N-N] [--steps S,S] [--footways yes,no] [--keep FOLDER]
                   [--model M]

Network and demand are made by netconvert and randomTrips.py with their defaults. Everything is read
from SUMO's own messages and outputs:
- emergency brakings, summed over all runs: at most plain SUMO's + 10 %
- no vehicle collides with another, and none is teleported that plain SUMO does not teleport
- everybody arrives, and nobody walks longer than 3 times plain SUMO's time + 20 s
- nobody whom pedzone walks is touched, but at a vehicle's insertion or, with turned shoulders, by one
  that stands
In one run of twenty something of this may be wrong. Of 140 runs with one lane in steps of 1 s (seeds
1 to 140) one is: two cars meet. With footways (seeds 1 to 40) one is: somebody is touched.
"""
import argparse
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

CHECK = Path(__file__).resolve().parents[2] / "check" / "check_run.py"
SUMO_HOME = os.environ.get("SUMO_HOME", "/usr/share/sumo")
ENV = {**os.environ, "SUMO_HOME": SUMO_HOME}
ARM = 80  # [m]
PEOPLE, CARS, WINDOW, END = 60, 60, 120, 900  # numbers; [s]
LONGER, MORE = 3.0, 20.0
WRONG = 1 / 20  # of the runs, at most
ARMS = {"east": (ARM, 0), "north": (0, ARM), "west": (-ARM, 0), "south": (0, -ARM)}


def call(*command, folder=None):
    done = subprocess.run([str(word) for word in command], env=ENV, cwd=folder, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        raise SystemExit(f"{command[0]} ends with code {done.returncode}:\n{done.stdout[-2000:]}")
    return done.stdout


def zone_of_all(folder):
    """A zone of all edges with a lane for pedestrians."""
    edges = [edge.get("id") for edge in xml.parse(folder / "n.net.xml").getroot().iter("edge")
             if edge.get("function") is None
             and any(lane.get("allow") is None or "pedestrian" in lane.get("allow")
                     for lane in edge.iter("lane"))]
    (folder / "all.zone.xml").write_text(f'<zones><zone id="all" edges="{" ".join(edges)}"/></zones>')


def make_scene(folder, seed, step, footways):
    folder.mkdir(parents=True, exist_ok=True)
    nodes = "".join(f'<node id="{arm}" x="{x}" y="{y}"/>' for arm, (x, y) in ARMS.items())
    (folder / "n.nod.xml").write_text(f'<nodes><node id="c" x="0" y="0"/>{nodes}</nodes>')
    width = 'sidewalkWidth="2"' if footways else ""
    edges = "".join(f'<edge id="{arm}_in" from="{arm}" to="c" numLanes="1" {width}/>'
                    f'<edge id="{arm}_out" from="c" to="{arm}" numLanes="1" {width}/>'
                    for arm in ARMS)
    (folder / "e.edg.xml").write_text(f"<edges>{edges}</edges>")
    call("netconvert", "-n", "n.nod.xml", "-e", "e.edg.xml", "-o", "net.net.xml",
         *(["--crossings.guess"] if footways else []), folder=folder)
    trips = [sys.executable, f"{SUMO_HOME}/tools/randomTrips.py", "-n", "net.net.xml", "-e", WINDOW]
    call(*trips, "--pedestrians", "-p", WINDOW / PEOPLE, "--seed", seed, "--prefix", "p",
         "-o", "p.trips.xml", "-r", "p.rou.xml", folder=folder)
    call(*trips, "-p", WINDOW / CARS, "--seed", 1000 + seed, "--prefix", "c",
         "-o", "c.trips.xml", "-r", "c.rou.xml", folder=folder)
    names = " ".join(f"{arm}_in {arm}_out" for arm in ARMS)
    (folder / "all.zone.xml").write_text(f'<zones><zone id="all" edges="{names}"/></zones>')
    (folder / "s.sumocfg").write_text(
        f'<configuration><net-file value="net.net.xml"/><route-files value="c.rou.xml,p.rou.xml"/>'
        f'<end value="{END}"/><step-length value="{step}"/><seed value="{seed}"/>'
        f'<collision.check-junctions value="true"/></configuration>')


class Run:
    """What SUMO tells of one run."""

    def __init__(self, folder, command):
        folder.mkdir(exist_ok=True)
        log = call(*command, "--fcd-output", folder / "fcd.xml",
                   "--tripinfo-output", folder / "tripinfo.xml",
                   "--tripinfo-output.write-unfinished", "true",
                   "--collision-output", folder / "collisions.xml")
        (folder / "log.txt").write_text(log)
        self.brakings = log.count("performs emergency braking")
        self.teleports = set(re.findall(r"Warning: Teleporting vehicle '([^']*)'", log))
        trips = xml.parse(folder / "tripinfo.xml").getroot()
        cars = {trip.get("id") for trip in trips.iter("tripinfo")}
        self.driven = [float(trip.get("duration")) for trip in trips.iter("tripinfo")]
        self.collisions = [collision.attrib for collision in
                           xml.parse(folder / "collisions.xml").getroot()
                           if collision.get("victim") in cars]
        self.walks = {}
        for trip in trips.iter("personinfo"):
            walks = list(trip.iter("walk"))
            arrived = all(float(walk.get("arrival")) >= 0 for walk in walks)
            self.walks[trip.get("id")] = (sum(float(walk.get("duration")) for walk in walks)
                                          if arrived else math.inf)


def run_both(pedzone, folder, *options):
    """The scene of that folder in plain SUMO, and with pedzone and its options."""
    config = folder / "s.sumocfg"
    plain = Run(folder / "plain", ["sumo", "-c", config, "--no-step-log", "true"])
    ours = Run(folder / "ours", [
        pedzone, "run", config, "--zone", folder / "all.zone.xml",
        "--trajectories", folder / "ours" / "trajectories.csv", *options, "--"])
    return plain, ours


def arguments(text, seeds):
    """What such a test understands; `text`: its docstring, `seeds`: by default."""
    parser = argparse.ArgumentParser(description=text,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone")
    parser.add_argument("--seeds", default=seeds)
    parser.add_argument("--keep", help="folder for networks and outputs")
    return parser


def judge(cases, keep, compare):
    """Exit code of a test: 1 where compare(folder, *case) finds something wrong. `cases`: by the name of
    a folder each, in `keep` or one that is removed."""
    failed = False
    with tempfile.TemporaryDirectory() as work:
        for name, case in cases.items():
            for line in compare(Path(keep or work).resolve() / name, *case):
                failed = True
                print(f"  WRONG: {line}")
    return 1 if failed else 0


def all_contacts(folder):
    """What check_run.py finds of them."""
    done = subprocess.run([sys.executable, str(CHECK), str(folder / "s.sumocfg"),
                           str(folder / "ours"), "--zone", str(folder / "all.zone.xml"),
                           "--json", "-"], env=ENV, stdout=subprocess.PIPE, text=True)
    if done.returncode == 2:
        raise SystemExit("check_run.py could not check")
    return json.loads(done.stdout)["contacts"]


def contacts(folder):
    """(pairs that a vehicle's insertion made, all others)."""
    found = all_contacts(folder)
    return found["at_insertion"]["pairs"], found["all"]["pairs"] - found["at_insertion"]["pairs"]


def contacts_but_turned(folder):
    """The others only of people whom pedzone walks, without those who go past a vehicle that stands
    or crawls with turned shoulders."""
    found = all_contacts(folder)
    return found["at_insertion"]["pairs"], found["controlled"]["pairs"]


def compare(pedzone, folder, seed, step, footways, model):
    """(our emergency brakings, plain SUMO's, what is wrong)."""
    make_scene(folder, seed, step, footways)
    plain, ours = run_both(pedzone, folder, *(["--model", model] if model else []))
    wrong = []
    for collision in ours.collisions:
        wrong.append(f"{collision['collider']} meets {collision['victim']} at {collision['time']}")
    for name in sorted(ours.teleports - plain.teleports):
        wrong.append(f"{name} is teleported")
    for name, walk in sorted(ours.walks.items()):
        if walk > LONGER * plain.walks[name] + MORE:
            wrong.append(f"{name} walks {walk:.0f} s instead of {plain.walks[name]:.0f}")
    inserted, touched = contacts_but_turned(folder)
    if touched:
        wrong.append(f"people touched: {touched}")
    mean = [sum(run.driven) / max(1, len(run.driven)) for run in (plain, ours)]
    print(f"seed {seed}, step {step} s, {'footways' if footways else 'one lane'}: emergency brakings"
          f" {plain.brakings} -> {ours.brakings}, drives {mean[0]:.0f} -> {mean[1]:.0f} s, contacts"
          f" {touched} and {inserted} at insertions{''.join('; ' + one for one in wrong)}",
          flush=True)
    return ours.brakings, plain.brakings, wrong


def numbers(text):
    """1,4-6 -> 1, 4, 5, 6"""
    for part in text.split(","):
        first, _, last = part.partition("-")
        yield from range(int(first), int(last or first) + 1)


def main():
    parser = arguments(__doc__, "1,2,3")
    parser.add_argument("--steps", default="0.1,1")
    parser.add_argument("--footways", default="yes,no")
    parser.add_argument("--model", help="walking model")
    options = parser.parse_args()
    ours, plain, runs, wrong = 0, 0, 0, 0
    with tempfile.TemporaryDirectory() as temporary:
        for footways in options.footways.split(","):
            for step in options.steps.split(","):
                for seed in numbers(options.seeds):
                    folder = Path(options.keep or temporary).resolve() / f"{footways}-{step}-{seed}"
                    figures = compare(Path(options.pedzone).resolve(), folder, seed,
                                      float(step), footways == "yes", options.model)
                    ours, plain = ours + figures[0], plain + figures[1]
                    runs, wrong = runs + 1, wrong + bool(figures[2])
    print(f"emergency brakings {plain} -> {ours}; of {runs} runs {wrong} are wrong")
    return 1 if ours > 1.1 * plain or wrong > runs * WRONG else 0


if __name__ == "__main__":
    sys.exit(main())
