#!/usr/bin/python3
"""People and cars on random networks without sidewalks: nobody stands for ever.

    random_streets.py --pedzone build/src/app/pedzone [--crossing] [--networks 10] [--seed 1]

A seed makes a network (netgenerate --rand, defaults), people and cars (randomTrips.py), and a zone over
all of its streets or over some. pedzone runs it, and plain SUMO. With --crossing the streets have
sidewalks and crossings, and people cross them anywhere (crossing="anywhere"). What SUMO wrote tells who stood for
longer than 120 s because of the other kind (tests/check/standing.py), whom a vehicle touched at more
than 0.5 m/s, and who was teleported.

Exit code 0: nobody stood, was touched or was teleported of those whom plain SUMO lets through.
"""

import argparse
import concurrent.futures
import functools
import random
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from dataclasses import dataclass, field
from pathlib import Path

import numpy

from random_network import SUMO_ENVIRONMENT

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "check"))
import measures  # noqa: E402  (found only now)
import outputs  # noqa: E402
import standing  # noqa: E402
from fcd import read_fcd  # noqa: E402

TOOLS = "/usr/share/sumo/tools"
END = 1500  # [s] everybody departs in the first two minutes
DEPARTURES = 120  # [s]
TIMEOUT = 300  # [s] of wall time for one run
CONTACT_SPEED = 0.5  # [m/s]
PERSON_RADIUS, CAR_SIZE = 0.239, (5.0, 1.8)  # [m] SUMO's defaults


@dataclass
class Findings:
    """What one run of a network shows."""
    stands: list = field(default_factory=list)    # because of the other kind
    contacts: list = field(default_factory=list)  # (time, person, vehicle, speed)
    teleports: int = 0
    collisions: int = 0
    brakings: int = 0
    late: list = field(default_factory=list)      # persons that have not arrived
    walks: dict = field(default_factory=dict)
    stages: dict = field(default_factory=dict)


def make(seed: int, folder: Path, crossing: bool) -> None:
    """Network, demand, zone and sumocfg of a seed."""
    rng = random.Random(seed)
    folder.mkdir(parents=True, exist_ok=True)

    def tool(*command: str) -> None:
        subprocess.run(command, cwd=folder, env=SUMO_ENVIRONMENT, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    sidewalks = ["--sidewalks.guess", "--crossings.guess"] if crossing else []
    tool("netgenerate", "--rand", "--rand.iterations", str(rng.randint(4, 25)), "--seed",
         str(seed), *sidewalks, "-o", "net.net.xml")
    people, cars = rng.uniform(2, 8), rng.uniform(3, 12)  # [s] between two departures
    script = [sys.executable, f"{TOOLS}/randomTrips.py", "-n", "net.net.xml", "--seed", str(seed),
              "-e", str(DEPARTURES)]
    tool(*script, "--pedestrians", "--prefix", "p", "-p", f"{people:.2f}", "-o", "people.xml",
         "--validate", "-r", "people.rou.xml")
    tool(*script, "--prefix", "c", "-p", f"{cars:.2f}", "-o", "cars.xml", "--validate", "-r",
         "cars.rou.xml")
    edges = [edge.get("id") for edge in ET.parse(folder / "net.net.xml").getroot().iter("edge")
             if edge.get("function", "normal") == "normal"]
    if rng.random() < 0.5:
        edges = sorted(rng.sample(edges, max(1, int(len(edges) * rng.uniform(0.2, 0.8)))))
    zones = ET.Element("zones")
    zone = ET.SubElement(zones, "zone", {"id": "streets", "edges": " ".join(edges)})
    if crossing:
        zone.set("crossing", "anywhere")
    ET.ElementTree(zones).write(folder / "streets.zone.xml")
    root = ET.Element("configuration")
    for name, value in (("net-file", "net.net.xml"), ("route-files", "people.rou.xml,cars.rou.xml"),
                        ("step-length", rng.choice(("0.5", "1"))), ("end", str(END)),
                        ("seed", str(seed)), ("collision.action", "warn"),
                        ("collision.check-junctions", "true")):
        ET.SubElement(root, name, {"value": value})
    ET.ElementTree(root).write(folder / "streets.sumocfg")


def run(command: list, folder: Path, kind: str) -> str:
    """What it says; its outputs lie in folder/kind."""
    out = folder / kind
    out.mkdir(exist_ok=True)
    command += ["--fcd-output", str(out / "fcd.xml"), "--tripinfo-output", str(out / "tripinfo.xml"),
                "--tripinfo-output.write-unfinished", "true",
                "--statistic-output", str(out / "statistics.xml")]
    done = subprocess.run(command, cwd=folder, env=SUMO_ENVIRONMENT, timeout=TIMEOUT,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    (out / "log.txt").write_text(done.stdout)
    if done.returncode != 0:
        raise RuntimeError(f"{kind}: exit code {done.returncode}: {done.stdout[-300:]}")
    return done.stdout


def speeds_of(rows, times) -> numpy.ndarray:
    """[m/s] of each row, from its place and the one before."""
    order, same = measures.by_name(rows)
    speed = numpy.zeros(len(rows.x))
    x, y, time = rows.x[order], rows.y[order], times[rows.step[order]]
    way = numpy.hypot(numpy.diff(x), numpy.diff(y)) / numpy.maximum(numpy.diff(time), 1e-9)
    speed[order[1:]] = numpy.where(same[1:], way, 0.0)
    return speed


def find(folder: Path, kind: str, text: str) -> Findings:
    out = folder / kind
    fcd = read_fcd(str(out / "fcd.xml"))
    persons, _ = outputs.read_tripinfo(str(out / "tripinfo.xml"))
    clearances = measures.Clearances(fcd, numpy.full(len(fcd.persons.names), PERSON_RADIUS),
                                     [CAR_SIZE] * len(fcd.vehicles.type_names))
    found = Findings()
    found.stands = standing.because_of_others(standing.find_stands(fcd, clearances))
    found.contacts = touched(fcd, clearances)
    found.teleports = len(re.findall(r"^Warning: Teleporting vehicle", text, re.M))
    found.collisions = len(re.findall(r"collision with vehicle", text))
    found.brakings = len(re.findall(r"performs emergency braking", text))
    found.late = sorted(name for name, trip in persons.items() if not trip.arrived)
    found.stages = {name: [stage.kind for stage in trip.stages] for name, trip in persons.items()}
    found.walks = {name: trip.duration for name, trip in persons.items()}
    return found


def touched(fcd, clearances) -> list:
    """Whom a vehicle touches that drives, of those whom SUMO does not walk."""
    controlled = measures.find_detached(fcd)
    nobody = numpy.zeros(len(fcd.persons.x), bool)
    contacts = measures.find_contacts(fcd, clearances, nobody, controlled, [])
    made = measures.at_insertion(fcd, contacts)
    speed = speeds_of(fcd.vehicles, fcd.times)
    found = {}
    for row, vehicle, inserted in zip(contacts.rows, contacts.vehicles, made):
        if not controlled[row] or inserted or speed[vehicle] <= CONTACT_SPEED:
            continue
        pair = (fcd.persons.names[fcd.persons.who[row]],
                fcd.vehicles.names[fcd.vehicles.who[vehicle]])
        found.setdefault(pair, (float(fcd.times[fcd.persons.step[row]]), *pair,
                                round(float(speed[vehicle]), 2)))
    return list(found.values())


def judge(pedzone: str, work: Path, keep: bool, crossing: bool, seed: int) -> dict:
    folder = work / f"seed{seed}"
    try:
        make(seed, folder, crossing)
        text = run(["sumo", "-c", "streets.sumocfg", "--no-step-log"], folder, "plain")
    except (subprocess.CalledProcessError, RuntimeError) as error:
        return report(seed, folder, None, None, f"skipped: {error}")
    plain = find(folder, "plain", text)
    try:
        text = run([pedzone, "run", "streets.sumocfg", "--zone", "streets.zone.xml", "--threads",
                    "1", "--"], folder, "run")
    except (RuntimeError, subprocess.TimeoutExpired) as error:
        return report(seed, folder, None, plain, str(error))
    result = report(seed, folder, find(folder, "run", text), plain, "")
    if not keep and not result["failed"]:
        shutil.rmtree(folder)
    return result


def report(seed: int, folder: Path, ours, plain, problem: str) -> dict:
    """Prints a line, and says what is wrong beyond what plain SUMO does."""
    wrong = []
    if problem and not problem.startswith("skipped"):
        wrong.append(problem)
    if ours:
        wrong += [stand.line() for stand in ours.stands]
        wrong += [f"{person} is touched by {vehicle} at {time:g} s, {speed} m/s"
                  for time, person, vehicle, speed in ours.contacts]
        if ours.teleports > plain.teleports:
            wrong.append(f"{ours.teleports} teleports (plain {plain.teleports})")
        wrong += [f"{name} has other stages than in plain SUMO" for name in ours.stages
                  if ours.stages[name] != plain.stages.get(name)]
        wrong += [f"{name} never arrives" for name in ours.late if name not in plain.late]
    figures = "" if not ours else (
        f"{len(ours.walks)} people, stands {len(ours.stands)} (plain {len(plain.stands)}), teleports "
        f"{ours.teleports} ({plain.teleports}), collisions {ours.collisions} ({plain.collisions}), "
        f"emergency brakings {ours.brakings} ({plain.brakings})")
    print(f"seed {seed}: {problem}{figures}: " + ("\n    ".join(["", *wrong]) if wrong else "fine"),
          flush=True)
    return {"seed": seed, "failed": bool(wrong), "ours": ours, "plain": plain}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pedzone", required=True)
    parser.add_argument("--seed", type=int, default=1, help="the first seed")
    parser.add_argument("--networks", type=int, default=10)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--crossing", action="store_true",
                        help="streets with sidewalks, to be crossed anywhere")
    parser.add_argument("--keep", help="folder for inputs and outputs")
    options = parser.parse_args()
    work = Path(options.keep or tempfile.mkdtemp(prefix="pedzone-streets-")).resolve()
    one = functools.partial(judge, str(Path(options.pedzone).resolve()), work, bool(options.keep),
                            options.crossing)
    seeds = range(options.seed, options.seed + options.networks)
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        results = list(pool.map(one, seeds))
    run_at_all = [one for one in results if one["ours"]]
    for name in ("ours", "plain"):
        found = [one[name] for one in run_at_all]
        print(f"{name}: {len(found)} networks, {sum(len(f.walks) for f in found)} people: "
              f"{sum(len(f.stands) for f in found)} stands, {sum(len(f.contacts) for f in found)} "
              f"contacts, {sum(f.teleports for f in found)} teleports, "
              f"{sum(f.collisions for f in found)} collisions, {sum(f.brakings for f in found)} "
              f"emergency brakings, {sum(len(f.late) for f in found)} people late")
    failed = [one["seed"] for one in results if one["failed"]]
    if failed:
        print(f"failed: seeds {failed}; kept in {work}")
    elif not options.keep:
        shutil.rmtree(work)
    return 1 if failed or len(run_at_all) < 0.8 * len(results) else 0


if __name__ == "__main__":
    sys.exit(main())
