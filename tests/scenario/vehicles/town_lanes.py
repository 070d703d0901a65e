#!/usr/bin/python3
"""Towns whose streets have lanes of other kinds than one for each direction, and no sidewalks.

usage: town_lanes.py PEDZONE [--towns NAME,NAME] [--seeds N,N] [--steps S,S] [--keep FOLDER]

By netgenerate, people and cars by randomTrips.py:
- turn: a lane more before each junction. The network does not tell which of the two a car will take.
  Where it is taken to drive onto the first one it minds nobody on its way to the other, and four
  people and more are touched in each run.
- opposites: cars overtake on the lane for the other direction. SUMO puts them there within a step.
- bikes: a lane for bicycles beside that for cars, which is not where cars depart.
Everything is read from SUMO's own messages and outputs, beside plain SUMO:
- of people and vehicles, at most one pair a run touches (but where SUMO inserts a vehicle, and who
  squeezes past one that stands), and at most three where SUMO inserts one
- all cars and people arrive, and cars take at most 1.5 times as long as in plain SUMO
- no more vehicles are teleported or collide with another than in plain SUMO
"""
import argparse
import itertools
import sys
import tempfile
from pathlib import Path

from junction import SUMO_HOME, call, contacts_but_turned, run_both
from lane_changes import mean

SECONDS, END = 400, 1500  # [s] in which all depart, of the run
CARS, PEOPLE = 200, 267
SLOWER, INSERTED = 1.5, 3
TOWNS = {"turn": ("--turn-lanes", 1, "--turn-lanes.length", 30), "opposites": ("--opposites.guess",),
         "bikes": ("--bikelanes.guess", "--default.lanenumber", 2)}


def make_scene(folder, town, seed, step):
    folder.mkdir(parents=True, exist_ok=True)
    call("netgenerate", "--grid", "--grid.number", 5, "--grid.length", 100, *TOWNS[town],
         "--seed", seed, "-o", "net.net.xml", folder=folder)
    for name, number, options in (
            ("c", CARS, ("--validate", "--min-distance", 100, "--fringe-factor", 5)),
            ("p", PEOPLE, ("--pedestrians", "--max-distance", 500))):
        call(sys.executable, f"{SUMO_HOME}/tools/randomTrips.py", "-n", "net.net.xml", "-e", SECONDS,
             "-p", SECONDS / number, "--seed", seed, "--prefix", name, *options,
             "-o", f"{name}.trips.xml", "-r", f"{name}.rou.xml", folder=folder)
    net = (folder / "net.net.xml").read_text()
    edges = " ".join(sorted(part.split('"')[0] for part in net.split('<edge id="')[1:]
                            if part[0] != ":"))
    (folder / "all.zone.xml").write_text(f'<zones><zone id="all" edges="{edges}"/></zones>')
    (folder / "s.sumocfg").write_text(
        f'<configuration><net-file value="net.net.xml"/><route-files value="c.rou.xml,p.rou.xml"/>'
        f'<end value="{END}"/><step-length value="{step}"/><seed value="{seed}"/></configuration>')


def check(pedzone, folder, town, seed, step):
    """What is wrong."""
    make_scene(folder, town, seed, step)
    plain, ours = run_both(pedzone, folder)
    inserted, touched = contacts_but_turned(folder)
    drives = [mean(run.driven) for run in (plain, ours)]
    walks = [mean(run.walks.values()) for run in (plain, ours)]
    print(f"{town}, seed {seed}, step {step} s: contacts {touched} and {inserted} at insertions, emergency "
          f"brakings {plain.brakings} -> {ours.brakings}, collisions {len(plain.collisions)} -> "
          f"{len(ours.collisions)}, drives {drives[0]:.0f} -> {drives[1]:.0f} s, walks {walks[0]:.0f} -> "
          f"{walks[1]:.0f} s", flush=True)
    wrong = {
        "touch": touched > 1,
        "are inserted onto somebody": inserted > INSERTED,
        "are not there": (len(ours.driven), len(ours.walks)) != (len(plain.driven), len(plain.walks)),
        "do not arrive": walks[1] == float("inf"),
        "drive too slowly": drives[1] > SLOWER * drives[0],
        "are teleported": len(ours.teleports) > len(plain.teleports),
        "collide": len(ours.collisions) > len(plain.collisions)}
    return [f"{town}, seed {seed}, step {step} s: some {what}" for what, found in wrong.items() if found]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone", type=Path)
    parser.add_argument("--towns", default=",".join(TOWNS))
    parser.add_argument("--seeds", default="2")
    parser.add_argument("--steps", default="1")
    parser.add_argument("--keep", type=Path, help="folder for networks and outputs")
    options = parser.parse_args()
    wrong = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = (options.keep or Path(temporary)).resolve()
        for town, step, seed in itertools.product(
                *(words.split(",") for words in (options.towns, options.steps, options.seeds))):
            wrong += check(options.pedzone.resolve(), folder / f"{town}-{step}-{seed}", town,
                           int(seed), float(step))
    print("\n".join(wrong or ["all as it should be"]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
