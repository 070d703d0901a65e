#!/usr/bin/python3
"""A small town in which SUMO moves vehicles otherwise than by default: with pedzone and in plain SUMO.

usage: step_methods.py PEDZONE [--methods NAME,NAME] [--seeds N,N] [--keep FOLDER]

Network and demand are made by netgenerate and randomTrips.py with their defaults, all sidewalks are
one zone. Methods (options of SUMO):
- ballistic: within a step of 1 s a vehicle's speed changes evenly (step-method.ballistic)
- actions: steps of 0.1 s, of which drivers act in every tenth (default.action-step-length)
- sublanes: vehicles have a place within their lane (lateral-resolution)
Everything is read from SUMO's own messages and outputs, for each method summed over the seeds:
- everybody arrives, cars in at most 1.1 times plain SUMO's time with actions (1.07; in the mean of five
  seeds 1.03), 1.08 with sublanes (1.05; 1.03 while those that turn gave way to nobody on crossings
  without a zebra), 1.12 with ballistic steps (in the mean of six seeds 1.04 with SUMO 1.15, 1.07 with
  1.18, one seed at most 1.12: a car that people held up begins a round of turning cars that all wait
  for each other, by SUMO's rules)
- at most one person a run is touched, but at insertions, or with turned shoulders
- no more vehicles are teleported than in plain SUMO, and one; nor collide with another
"""
import argparse
import math
import statistics
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

from junction import SUMO_HOME, call, contacts_but_turned, run_both

METHODS = {  # [s] of a step, what the configuration says, cars' time over plain SUMO's at most
    "ballistic": (1.0, '<step-method.ballistic value="true"/>', 1.12),
    "actions": (0.1, '<default.action-step-length value="1"/>', 1.1),
    "sublanes": (1.0, '<lateral-resolution value="0.8"/>', 1.08),
}
CARS, PEOPLE = 400, 400
SECONDS, END = 600, 1500


def make_trips(folder, name, number, seed, *options):
    call(sys.executable, f"{SUMO_HOME}/tools/randomTrips.py", "-n", "net.net.xml", "-e", SECONDS,
         "-p", SECONDS / number, "--seed", seed, "--prefix", name, *options,
         "-o", f"{name}.trips.xml", "-r", f"{name}.rou.xml", folder=folder)


def make_scene(folder, method, seed):
    folder.mkdir(parents=True, exist_ok=True)
    step, option, _ = METHODS[method]
    call("netgenerate", "--grid", "--grid.number", 4, "--grid.length", 150, "--sidewalks.guess",
         "--crossings.guess", "-o", "net.net.xml", folder=folder)
    make_trips(folder, "c", CARS, 1000 + seed, "--validate")
    make_trips(folder, "p", PEOPLE, seed, "--pedestrians", "--max-distance", 600)
    edges = [edge.get("id") for edge in xml.parse(folder / "net.net.xml").getroot().iter("edge")
             if not edge.get("function")]
    (folder / "all.zone.xml").write_text(f'<zones><zone id="all" edges="{" ".join(edges)}"/></zones>')
    (folder / "s.sumocfg").write_text(
        f'<configuration><net-file value="net.net.xml"/><route-files value="c.rou.xml,p.rou.xml"/>'
        f'<end value="{END}"/><step-length value="{step}"/><seed value="{seed}"/>{option}'
        f'<collision.check-junctions value="true"/></configuration>')


def check(pedzone, folder, method, seeds):
    """What is wrong."""
    drives, touched, teleports, collisions, late = ([], []), 0, [0, 0], [0, 0], 0
    for seed in seeds:
        place = folder / f"{method}-{seed}"
        make_scene(place, method, seed)
        both = run_both(pedzone, place, "--quiet")
        for k, run in enumerate(both):
            drives[k].extend(run.driven)
            teleports[k] += len(run.teleports)
            collisions[k] += len(run.collisions)
        late += sum(math.isinf(walk) for walk in both[1].walks.values())
        touched += contacts_but_turned(place)[1]
    plain, ours = map(statistics.mean, drives)
    print(f"{method}: cars {plain:.1f} -> {ours:.1f} s, touched {touched}, teleports {teleports[0]} -> "
          f"{teleports[1]}, collisions {collisions[0]} -> {collisions[1]}, do not arrive {late}", flush=True)
    wrong = {"cars are late": ours > METHODS[method][2] * plain or len(drives[1]) < len(drives[0]),
             "people are late": late,
             "people are touched": touched > len(seeds),
             "vehicles are teleported": teleports[1] > teleports[0] + 1,
             "vehicles collide": collisions[1] > collisions[0] + 1}
    return [f"{method}: {what}" for what, found in wrong.items() if found]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone", type=Path)
    parser.add_argument("--methods", default=",".join(METHODS))
    parser.add_argument("--seeds", default="1,2")
    parser.add_argument("--keep", type=Path, help="folder for networks and outputs")
    options = parser.parse_args()
    wrong = []
    with tempfile.TemporaryDirectory() as temporary:
        for method in options.methods.split(","):
            wrong += check(options.pedzone.resolve(), (options.keep or Path(temporary)).resolve(), method,
                           [int(seed) for seed in options.seeds.split(",")])
    print("\n".join(wrong or ["all as it should be"]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
