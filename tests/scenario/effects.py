#!/usr/bin/python3
"""What profiles, awareness, activities and weather do to two encounters with a vehicle, over seeds.

usage: effects.py PEDZONE PEOPLE.sumocfg [--seeds N] [--jobs N] [--only NAME] [--markdown]

Each effect is one change to the scenario's types (or to the zone file) against the scenario as it
is. Both are run for every seed; the 95 % interval (Student) of the paired difference of one measure
has to lie on the expected side of 0. Measures come from SUMO's own floating-car data. Exit code: 0
when all do.
"""

import argparse
import concurrent.futures
import math
import os
import statistics
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from dataclasses import dataclass, field
from pathlib import Path

ASIDE = 0.5           # [m] so far from its line somebody steps aside
STANDS = 0.1          # [m/s] slower, a shuttle stands
LENGTH, WIDTH = 5.0, 2.0  # [m] of the scenario's shuttles
# Student's t, 97.5 %, for n - 1 degrees of freedom
STUDENT = {19: 2.093, 24: 2.064, 29: 2.045, 39: 2.023, 49: 2.010}


@dataclass
class Effect:
    name: str
    measure: str
    sign: int                     # of the expected difference to the base
    walker: dict = field(default_factory=dict)   # parameters of the persons' type
    vehicle: dict = field(default_factory=dict)  # parameters of the shuttles' type
    zone: str = ""                # attributes of <zone>
    base_walker: dict = field(default_factory=dict)  # of both
    base_vehicle: dict = field(default_factory=dict)
    extra: str = ""               # XML beside the types
    base_extra: str = ""
    profiles: str = ""            # XML before <zone>


def profile(name, measure, sign):
    return Effect(f"profile {name}", measure, sign, {"pedzone.profile": name})


def activity(name, measure, sign):
    return Effect(f"activity {name}", measure, sign, {"pedzone.activities": f"{name}=6"})


SHADE = (-45.0, 2.5, -8.0, 5.5)  # [m] as the scenario's polygon "trees"
TREES = ('<poly id="trees" type="pedzone.shade" color="green" '
         'shape="{0},{1} {2},{1} {2},{3} {0},{3}"/>'.format(*SHADE))

RASH = '<profile id="rash" base="adult" impulsiveness="60"/>'

EFFECTS = [
    profile("infant", "gap", -1), profile("child", "gap", -1), profile("preteen", "gap", -1),
    profile("teenager", "crossing_gap", -1), profile("middle-aged", "gap", -1),
    profile("senior", "gap", -1), profile("wheelchair", "gap", -1),
    profile("pram", "crossing_gap", 1), profile("cyclist", "crossing_gap", 1),
    Effect("impulsive", "crossing_gap", -1, {"pedzone.profile": "rash"}, profiles=RASH),
    Effect("unaware", "clearance", -1, {"pedzone.aware": "false"}),
    Effect("horn for the unaware", "clearance", 1, vehicle={"pedzone.horn": "true"},
           base_walker={"pedzone.aware": "false"}),
    Effect("electric", "gap", -1, vehicle={"pedzone.electric": "true"}),
    Effect("after you", "crossing_time", -1, vehicle={"pedzone.signal": "after-you"}),
    activity("texting", "gap", -1), activity("phoning", "gap", -1),
    activity("looking", "sway", 1), activity("chatting", "time", 1), activity("sitting", "time", 1),
    Effect("rain", "time", -1, zone='weather="rain"'),
    Effect("heat", "time", 1, zone='weather="heat"'),
    Effect("heat under trees", "shade", 1, zone='weather="heat"', base_extra=TREES),
    Effect("ice", "time", 1, zone='weather="ice"'),
    Effect("ice under a vehicle that yields", "braking", 1, zone='weather="ice"',
           base_vehicle={"pedzone.yield": "true"}),
]


def parameters(pairs):
    return "".join(f'<param key="{key}" value="{value}"/>' for key, value in pairs.items())


def types(walker, vehicle, extra):
    walker = {"pedzone.profile": "adult", "pedzone.aware": "true", **walker}
    vehicle = {"pedzone.yield": "false", **vehicle}
    return f"""<additional>
  <vType id="walker" vClass="pedestrian" maxSpeed="1.4" speedFactor="1">{parameters(walker)}</vType>
  <vType id="shuttle" length="{LENGTH}" width="{WIDTH}" maxSpeed="4.17" speedFactor="1" sigma="0">
    {parameters(vehicle)}</vType>{extra}</additional>"""


def clearance(vehicle, x, y):
    """[m] from a point to the rectangle whose front bumper's middle SUMO names."""
    angle = math.radians(90.0 - vehicle[2])
    dx, dy = x - vehicle[0], y - vehicle[1]
    ahead = dx * math.cos(angle) + dy * math.sin(angle)
    aside = dy * math.cos(angle) - dx * math.sin(angle)
    return math.hypot(max(-LENGTH - ahead, ahead, 0.0), max(abs(aside) - WIDTH / 2, 0.0))


@dataclass
class Track:
    """One person's: [(time, x, y, {vehicle: (front x, front y, angle, speed)})]."""
    rows: list = field(default_factory=list)


def read_tracks(fcd):
    tracks = {}
    for _, step in ET.iterparse(fcd):
        if step.tag != "timestep":
            continue
        vehicles = {v.get("id"): (float(v.get("x")), float(v.get("y")), float(v.get("angle")),
                                  float(v.get("speed"))) for v in step.iter("vehicle")}
        for p in step.iter("person"):
            tracks.setdefault(p.get("id"), Track()).rows.append(
                (float(step.get("time")), float(p.get("x")), float(p.get("y")), vehicles))
        step.clear()
    return tracks


def measures(fcd):
    tracks = read_tracks(fcd)
    ahead, crossing = tracks["ahead"].rows, tracks["crossing"].rows
    near = [(row, clearance(v["shuttle.1"], row[1], row[2]))
            for row in ahead if "shuttle.1" in (v := row[3])]
    # How far behind it still was when the person stepped aside; 0 when it did not until it was run
    # into. (These shuttles brake for nobody; one that runs into somebody stands for a while.)
    gap, line = 0.0, None
    for (_, x, y, vehicles), distance in near:
        if distance > 25.0 and vehicles["shuttle.1"][0] < x:
            line = y
        elif vehicles["shuttle.1"][0] < x and abs(y - line) > ASIDE:
            gap = distance
            break
        if vehicles["shuttle.1"][3] < STANDS:
            break
    before = [row[2] for row in ahead[20:] if row[0] < near[0][0][0]
              or row[3].get("shuttle.1", (math.inf,))[0] < row[1] - 30.0]
    crossed = next((row[0] for row in crossing if row[2] < -5.0), crossing[-1][0] + 60.0)
    # How far behind the person it was when it had lost a tenth of its speed.
    behind = [(row[1] - row[3]["shuttle.1"][0], row[3]["shuttle.1"][3]) for row in ahead
              if "shuttle.1" in row[3] and row[3]["shuttle.1"][0] > -60.0]
    slow = next((distance for distance, speed in behind if speed < 0.9 * behind[0][1]), 0.0)
    return {
        "gap": gap,
        "clearance": min(distance for _, distance in near),
        "time": ahead[-1][0] - ahead[0][0],
        "shade": statistics.fmean(SHADE[0] < row[1] < SHADE[2] and SHADE[1] < row[2] < SHADE[3]
                                  for row in ahead),
        # Of the way that it makes aside in a second.
        "sway": statistics.pstdev(b - a for a, b in zip(before, before[10:])),
        "crossing_gap": min(clearance(row[3]["shuttle.2"], row[1], row[2]) for row in crossing
                            if "shuttle.2" in row[3]),
        "crossing_time": crossed - crossing[0][0],
        "braking": slow,
    }


def run(pedzone, scenario, seed, walker, vehicle, extra, zone, profiles):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "types.add.xml").write_text(types(walker, vehicle, extra))
        (folder / "a.zone.xml").write_text(f'<zones>{profiles}<zone id="street" {zone}/></zones>')
        done = subprocess.run(
            [pedzone, "run", scenario, "--zone", str(folder / "a.zone.xml"), "--seed", str(seed),
             "--threads", "1", "--", "--additional-files", str(folder / "types.add.xml"),
             "--fcd-output", str(folder / "fcd.xml")], capture_output=True, text=True)
        if done.returncode != 0 or "emergencyDecel" in done.stderr:  # SUMO warns of how pedzone brakes it
            raise RuntimeError(done.stderr)
        return measures(folder / "fcd.xml")


def interval(differences):
    count = len(differences)
    mean = statistics.fmean(differences)
    half = STUDENT[count - 1] * statistics.stdev(differences) / math.sqrt(count)
    return mean, mean - half, mean + half


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pedzone")
    parser.add_argument("scenario")
    parser.add_argument("--seeds", type=int, default=20, choices=[n + 1 for n in STUDENT])
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", default="")
    parser.add_argument("--markdown", action="store_true", help="print a table for the README")
    options = parser.parse_args()
    effects = [e for e in EFFECTS if options.only in e.name]
    pool = concurrent.futures.ThreadPoolExecutor(options.jobs)
    cache = {}

    def start(seed, walker, vehicle, extra, zone, profiles):
        key = (seed, str(walker), str(vehicle), extra, zone, profiles)
        if key not in cache:
            cache[key] = pool.submit(run, options.pedzone, options.scenario, seed, walker, vehicle,
                                     extra, zone, profiles)
        return cache[key]

    runs = [[(start(seed, e.base_walker, e.base_vehicle, e.base_extra, "", ""),
              start(seed, {**e.base_walker, **e.walker}, {**e.base_vehicle, **e.vehicle},
                    e.extra + e.base_extra, e.zone, e.profiles))
             for seed in range(1, options.seeds + 1)]
            for e in effects]
    bar = "| " if options.markdown else ""
    good = True
    for effect, pairs in zip(effects, runs):
        base = [a.result()[effect.measure] for a, _ in pairs]
        changed = [b.result()[effect.measure] for _, b in pairs]
        mean, low, high = interval([b - a for a, b in zip(base, changed)])
        holds = (low if effect.sign > 0 else -high) > 0.0
        good = good and holds
        print(f"{bar}{effect.name:32} {bar}{effect.measure:14} {bar}{statistics.fmean(base):8.2f} "
              f"{bar}{statistics.fmean(changed):8.2f} {bar}{mean:+7.2f} "
              f"[{low:+.2f}, {high:+.2f}] {bar}{'' if holds else 'NOT AS EXPECTED'}", flush=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
