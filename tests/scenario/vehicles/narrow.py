#!/usr/bin/python3
"""Runs scenes of narrow streets with pedzone and in plain SUMO, and compares.

usage: narrow.py PEDZONE [--model M] [--keep FOLDER] [--brakings] [--corners N] [--zone-ends N] SCENE...

For each scene: nobody walks longer than 3 times plain SUMO's time + 20 s, everybody arrives, nobody is ever
with the middle of the body inside a vehicle (but where SUMO walks them), no vehicle is teleported, no vehicle
meets another, and with --brakings SUMO tells of no more emergency brakings than in plain SUMO + 10 %. Everything
is read from SUMO's own outputs and messages.

A zone's end is judged over many seeds together: there people and vehicles of plain SUMO wait for each other
until a teleport, in 15 of 100 seeds and not in the same ones. Nobody is left, vehicles are teleported at most half
as often as in plain SUMO, at most half as many people walk long (3 times the median of plain SUMO's walks + 20 s),
and there are no more emergency brakings + 10 % (two are chance), nor vehicles that meet (one more is allowed: in
plain SUMO 3 in 100 seeds).
"""

import argparse
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from statistics import median

import numpy
from narrow_scenes import ENVIRONMENT, SCENES, corner, zone_end

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "check"))
import measures  # noqa: E402
import outputs  # noqa: E402
from fcd import read_fcd  # noqa: E402
from scenario import read_scenario  # noqa: E402

LONGER, MORE = 3.0, 20.0  # a walk may take so many times plain SUMO's time, and so many [s] more
MORE_BRAKINGS = 1.1
FEW_BRAKINGS = 2  # of few runs: plain SUMO has 25 in 200 zones' ends


@dataclass
class Told:
    """What one run tells of itself."""
    walks: dict            # person -> [s], None: has not arrived
    drives: dict           # vehicle -> [s], None: has not arrived
    teleports: int
    collisions: int        # of vehicles with vehicles
    brakings: int


def count_inside(folder: Path) -> int:
    """Pairs of a person and a vehicle of which the one's middle is inside the other, but where SUMO inserts it."""
    fcd = read_fcd(str(folder / "run/fcd.xml"))
    sizes = read_scenario(str(folder / "scene.sumocfg")).size
    points = measures.Clearances(fcd, numpy.zeros(len(fcd.persons.names)),
                                 [sizes(name) for name in fcd.vehicles.type_names])
    nobody = numpy.zeros(len(fcd.persons.step), bool)
    found = measures.find_contacts(fcd, points, nobody, nobody, [])
    late = ~measures.at_insertion(fcd, found)
    return len(set(zip(fcd.persons.who[found.rows[late]], fcd.vehicles.who[found.vehicles[late]])))


def run(command: list, folder: Path) -> Told:
    folder.mkdir(parents=True, exist_ok=True)
    options = ["--fcd-output", str(folder / "fcd.xml"),
               "--tripinfo-output", str(folder / "tripinfo.xml"),
               "--tripinfo-output.write-unfinished", "true",
               "--statistic-output", str(folder / "statistics.xml")]
    done = subprocess.run([*command, *options], env=ENVIRONMENT, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    (folder / "log.txt").write_text(done.stdout)
    if done.returncode != 0:
        raise SystemExit(f"{command[0]} ends with code {done.returncode}:\n{done.stdout[-2000:]}")
    persons, vehicles = outputs.read_tripinfo(str(folder / "tripinfo.xml"))
    text = done.stdout
    return Told({name: trip.duration for name, trip in persons.items()},
                {name: trip.duration if trip.arrived else None for name, trip in vehicles.items()},
                len(re.findall(r"^Warning: Teleporting vehicle", text, re.M)),
                len(re.findall(r"^Warning: Vehicle '[^']*'; (?:junction )?collision with vehicle",
                               text, re.M)),
                len(re.findall(r"^Warning: Vehicle '[^']*' performs emergency braking", text, re.M)))


def compare(ours: Told, plain: Told, brakings: bool) -> list:
    """What is wrong with our run."""
    wrong = []
    for name, usual in plain.walks.items():
        if usual is None:
            continue
        time = ours.walks.get(name)
        if time is None:
            wrong.append(f"{name} never arrives, plain SUMO's after {usual:.0f} s")
        elif time > LONGER * usual + MORE:
            wrong.append(f"{name} walks for {time:.0f} s, plain SUMO's for {usual:.0f} s")
    for name, usual in plain.drives.items():
        if usual is not None and ours.drives.get(name) is None:
            wrong.append(f"{name} never arrives")
    if ours.teleports > plain.teleports:
        wrong.append(f"{ours.teleports} teleports, plain SUMO's {plain.teleports}")
    if ours.collisions > plain.collisions:
        wrong.append(f"{ours.collisions} collisions, plain SUMO's {plain.collisions}")
    if brakings and ours.brakings > MORE_BRAKINGS * plain.brakings:
        wrong.append(f"{ours.brakings} emergency brakings, plain SUMO's {plain.brakings}")
    return wrong


def compare_together(runs: list, plain_runs: list) -> list:
    """What is wrong with our runs of zones' ends."""
    wrong = [f"{name} never arrives" for ours, plain in zip(runs, plain_runs)
             for kind in ("walks", "drives") for name, usual in getattr(plain, kind).items()
             if usual is not None and getattr(ours, kind).get(name) is None]

    def long_walks(told: list) -> int:
        limits = [LONGER * median(filter(None, plain.walks.values())) + MORE for plain in plain_runs]
        return sum(time > most for one, most in zip(told, limits) for time in filter(None, one.walks.values()))

    def total(told: list, name: str) -> int:
        return sum(getattr(one, name) for one in told)

    for what, ours, most in (
            ("long walks", long_walks(runs), long_walks(plain_runs) / 2),
            ("teleports", total(runs, "teleports"), total(plain_runs, "teleports") / 2),
            ("collisions", total(runs, "collisions"), total(plain_runs, "collisions") + 1),
            ("emergency brakings", total(runs, "brakings"),
             max(FEW_BRAKINGS, MORE_BRAKINGS * total(plain_runs, "brakings")))):
        print(f"zones' ends: {ours} {what} (at most {most:g})")
        if ours > most:
            wrong.append(f"{ours} {what}, allowed {most:g}")
    return wrong


def seconds(times: dict) -> str:
    return " ".join("-" if time is None else f"{time:.0f}" for time in list(times.values())[:6])


def run_both(name: str, scene, arguments: argparse.Namespace, base: Path) -> tuple:
    """Ours, and plain SUMO's."""
    folder = (base / name).resolve()
    config, zone = scene.write(folder)
    plain = run(["sumo", "-c", str(config), "--no-step-log"], folder / "plain")
    model = ["--model", arguments.model] if arguments.model else []
    return run([arguments.pedzone, "run", str(config), "--zone", str(zone), *model,
                "--threads", "1", "--"], folder / "run"), plain


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone")
    parser.add_argument("scene", nargs="*", help=f"all, or of {', '.join(SCENES)}")
    parser.add_argument("--corners", type=int, default=0, metavar="N",
                        help="so many seeds of each crowded street with a corner, with 120 and 200 people")
    parser.add_argument("--zone-ends", type=int, default=0, metavar="N", help="so many of them, judged together")
    parser.add_argument("--brakings", action="store_true", help="emergency brakings count, too")
    parser.add_argument("--model")
    parser.add_argument("--keep")
    arguments = parser.parse_args()
    scenes = {name: SCENES[name] for name in (SCENES if arguments.scene == ["all"] else arguments.scene)}
    scenes |= {f"corner-{angle}-{people}-{seed}": corner(angle, people, seed)
               for angle in (60, 90, 110) for people in (120, 200) for seed in range(1, arguments.corners + 1)}
    failed, together = 0, ([], [])
    with tempfile.TemporaryDirectory() as temporary:
        base = Path(arguments.keep or temporary)
        for name, scene in scenes.items():
            ours, plain = run_both(name, scene, arguments, base)
            wrong = compare(ours, plain, arguments.brakings)
            if inside := 0 if scene.sumo_walks else count_inside(base / name):
                wrong.append(f"{inside} people are inside a vehicle")
            failed += bool(wrong)
            print(f"{name}: walks {seconds(ours.walks)} (plain {seconds(plain.walks)}), drives "
                  f"{seconds(ours.drives)} (plain {seconds(plain.drives)}), "
                  f"{ours.brakings} emergency brakings (plain {plain.brakings}): "
                  + ("; ".join(wrong) or "fine"), flush=True)
        for seed in range(arguments.zone_ends):
            for runs, told in zip(together, run_both(f"zone-end-{seed}", zone_end(seed), arguments, base)):
                runs.append(told)
    if arguments.zone_ends:
        failed += bool(wrong := compare_together(*together))
        print("; ".join(wrong) or "fine")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
