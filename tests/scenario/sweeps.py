#!/usr/bin/python3
"""What the paper says of waypoints, of steering and of its two equations, as sweeps with charts.

usage: sweeps.py PEDZONE [SWEEP ...] [--seeds N] [--jobs N] [--model M] [--out FOLDER] [--check]

SWEEP: steering, spacing, radius, occupied, wall, vehicle; all where none is named. Each is run for
every seed; a table of means with 95 % intervals is printed, --out gets an SVG for each measure. With
--check the directions that the paper's text claims have to hold: of the paired difference from one
value to another the interval lies on that side of 0. Measures come from SUMO's own floating-car
data.
"""

import argparse
import concurrent.futures
import math
import os
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import experiment_measures as m
from experiment_checks import SEEDS, interval
from experiment_tracks import SCENARIOS, outside, run
from experiments import OBSTACLE
from line_chart import Line, chart

sys.path.insert(0, str(SCENARIOS))
from paths import steered  # noqa: E402

BUS = 2.5        # [m] width of what stands in the way
END = 120.0      # [s] of 5.2's scenarios


def poi(name, x, y, radius=None):
    inner = f'<param key="pedzone.radius" value="{radius}"/>' if radius else ""
    return f'<poi id="{name}" type="pedzone.waypoint" x="{x}" y="{y}">{inner}</poi>'


def write(folder, name, text):
    (folder / name).write_text(text, encoding="utf-8")
    return folder / name


def zones(folder, paths, edge, vehicle_path="", parameters=None, model="heuristic"):
    routes = "".join(f'<path id="{name}" waypoints="{words}"/>' for name, words in paths.items())
    values = "".join(f'<param key="{key}" value="{value}"/>'
                     for key, value in (parameters or {}).items())
    script = ""
    if vehicle_path:
        write(folder, "av.csv", vehicle_path)
        script = '<vehiclePath vehicle="av" file="av.csv"/>'
    return write(folder, "sweep.zone.xml", f'<zones>{routes}<zone id="z" edges="{edge}" '
                 f'openSpace="0" model="{model}">{values}</zone>{script}</zones>')


def encounter(pedzone, folder, seed, words, steering=1.0, spacing=70.0, parameters=None,
              model="heuristic"):
    """5.1, with waypoints every `spacing` [m]."""
    lines, pois, paths = {"a": -1.0, "b": -2.0}, "", {}
    count = max(1, round(70.0 / spacing))
    for person, line in lines.items():
        names = [f"{person}.{k}" for k in range(count + 1)]
        pois += "".join(poi(name, 5 + 70 * k / count, line) for k, name in enumerate(names))
        paths[person] = " ".join(names)
    zone = zones(folder, paths, "street", steered(steering), parameters, model)
    more = write(folder, "sweep.add.xml", f"<additional>{pois}</additional>")
    one = run(pedzone, "5.1", zone, seed, words, ("--additional-files", str(more)))
    aside = [one.persons[p].y - line for p, line in lines.items()]
    far = [d[(one.persons[p].x > 6) & (one.persons[p].x < 20)] for d, p in zip(aside, lines)]
    return {"deviation": sum(abs(m.most(d)) for d in aside) / 2,
            "clearance": m.clearance(one, "av"),
            "off the path": sum(float(abs(d).mean()) for d in far) / 2,
            "outside": outside(one, "street")}


ONE_WALKER = """<routes>
<vType id="walker" vClass="pedestrian" maxSpeed="1.34" speedFactor="1"/>
<vType id="bus" vClass="delivery" length="{length}" width="{width}"/>
<person id="a" type="walker" depart="0" departPos="5"><param key="pedzone.path" value="a"/>
<walk edges="square" departPosLat="0" arrivalPos="77"/></person>
{more}</routes>"""


def corners(pedzone, folder, seed, words, radius):
    """One person on a zigzag of waypoints on the square, one of them behind a house's corner."""
    points = [(20, 48), (40, 47), (52, 34), (66, 48)]
    names = [f"p.{k}" for k in range(len(points))]
    house = 'type="pedzone.obstacle" shape="{0},{1} {2},{1} {2},{3} {0},{3} {0},{1}"'
    more = write(folder, "sweep.add.xml", "<additional>" + "".join(
        poi(name, x, y, radius) for name, (x, y) in zip(names, points))
        + f'<poly id="house" {house.format(*OBSTACLE)}/></additional>')
    routes = write(folder, "sweep.rou.xml", ONE_WALKER.format(length=5, width=2, more=""))
    zone = zones(folder, {"a": " ".join(names)}, "square")
    one = run(pedzone, "5.2a", zone, seed, words,
              ("--additional-files", str(more), "--route-files", str(routes)), routes)
    track = one.persons["a"]
    missed = [float(min(math.dist(at, point) for at in zip(track.x, track.y)))
              for point in (points[0], points[2], points[3])]
    return {"missed": sum(missed) / len(missed), "time": float(track.t[-1] - track.t[0]),
            "inside the house": -m.box_distance(track, OBSTACLE), "outside": outside(one, "square")}


def across(pedzone, folder, seed, words, length=6.0, equation=2, radius=None):
    """A bus of that length stands across the way of one person; on a waypoint of that radius,
    where one is given."""
    front = 40 + length / 2
    path = f"t,x,y\n1,40,{front - 1}\n2,40,{front}\n{2 * END},40,{front}\n"
    stops = {"start": poi("start", 5, 40), "goal": poi("goal", 75, 40)}
    if radius:
        stops = {"start": stops["start"], "under_the_bus": poi("under_the_bus", 40, 40, radius),
                 "goal": stops["goal"]}
    more = write(folder, "sweep.add.xml", f"<additional>{''.join(stops.values())}</additional>")
    bus = '<vehicle id="av" type="bus" depart="0"><route edges="street"/></vehicle>'
    routes = write(folder, "sweep.rou.xml",
                   ONE_WALKER.format(length=length, width=BUS, more=bus))
    zone = zones(folder, {"a": " ".join(stops)}, "square", path, {"equation": equation})
    one = run(pedzone, "5.2a", zone, seed, words,
              ("--additional-files", str(more), "--route-files", str(routes)), routes)
    track = one.persons["a"]
    passed = track.t[track.x > 40 + BUS]
    return {"time": float(passed[0]) if len(passed) else END}


@dataclass
class Claim:
    """That a measure is greater (or smaller) at one value than at another, of one line."""
    text: str
    measure: str
    low: float
    high: float
    sign: int = 1
    line: str = ""


@dataclass
class Sweep:
    title: str
    unit: str        # of the abscissa
    values: tuple
    scene: object    # (pedzone, folder, seed, words, **arguments) -> {measure: number}
    argument: str
    shown: dict      # measure -> its label
    lines: dict      # name -> further arguments
    claims: tuple = ()
    bounds: tuple = ()  # measures that may never be above 0


EQUATIONS = {"Eq. 1": {"equation": 1}, "Eq. 2": {"equation": 2}}
SWEEPS = {
    "steering": Sweep(
        "5.1: how far the vehicle is steered at them", "steering",
        (0.0, 0.2, 0.4, 0.6, 0.8, 1.0), encounter, "steering",
        {"deviation": "deviation [m]", "clearance": "least clearance [m]"}, {"heuristic": {}},
        (Claim("the more it is steered at them, the farther they go", "deviation", 0.0, 0.4),
         Claim("... and farther", "deviation", 0.4, 0.6),
         Claim("... and farther", "deviation", 0.6, 1.0)), ("outside",)),
    "spacing": Sweep(
        "5.1: how far apart waypoints are", "distance between waypoints [m]",
        (2.5, 5.0, 10.0, 20.0, 35.0, 70.0), encounter, "spacing",
        {"deviation": "deviation [m]", "off the path": "off the path before the encounter [m]"},
        {"heuristic": {}},
        (Claim("the farther apart, the more they give way", "deviation", 2.5, 20.0),
         Claim("... and more", "deviation", 10.0, 70.0),
         Claim("the nearer, the more exactly they follow the path", "off the path", 2.5, 20.0)),
        ("outside",)),
    "radius": Sweep(
        "Waypoints' radius at corners", "radius [m]", (0.3, 0.6, 1.0, 2.0, 4.0, 8.0), corners,
        "radius", {"missed": "distance to the corners [m]", "time": "time of the walk [s]"},
        {"heuristic": {}},
        (Claim("a large radius cuts corners", "missed", 0.3, 1.0),
         Claim("... the more the larger", "missed", 1.0, 4.0),
         Claim("and is quicker", "time", 0.3, 4.0, -1)), ("outside", "inside the house")),
    "occupied": Sweep(
        "A bus stands on a waypoint", "the waypoint's radius [m]", (0.3, 0.6, 1.0, 2.0, 3.0, 4.0),
        across, "radius", {"time": "time until it is passed [s]"}, {"heuristic": {}},
        (Claim("a small one costs the patience", "time", 0.3, 4.0, -1),)),
    "wall": Sweep(
        "A bus across the way", "its length [m]", (1.0, 2.0, 4.0, 8.0, 12.0, 16.0), across,
        "length", {"time": "time until it is passed [s]"}, EQUATIONS,
        (Claim("by Eq. 1 what is long holds people up", "time", 2.0, 12.0, 1, "Eq. 1"),)),
    "vehicle": Sweep(
        "5.1 by both equations, vehicles as in the paper", "steering", (0.0, 0.25, 0.5, 0.75, 1.0),
        encounter, "steering",
        {"deviation": "deviation [m]", "clearance": "least clearance [m]"},
        {name: {"model": "plain", "parameters": words} for name, words in EQUATIONS.items()}),
}


def measure(options, sweep, arguments, value, seed):
    words = ("--model", options.model) if options.model else ()
    with tempfile.TemporaryDirectory() as folder:
        return sweep.scene(options.pedzone, Path(folder), seed, words,
                           **{sweep.argument: value, **arguments})


def results(options, sweep):
    """(line, value) -> rows, one for each seed."""
    keys = [(line, value) for line in sweep.lines for value in sweep.values]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        jobs = {key: [pool.submit(measure, options, sweep, sweep.lines[key[0]], key[1], seed)
                      for seed in range(1, options.seeds + 1)] for key in keys}
        return {key: [job.result() for job in several] for key, several in jobs.items()}


def show(options, name, sweep, rows):
    for key, label in sweep.shown.items():
        lines = [Line(line, [(value, *interval([row[key] for row in rows[line, value]]))
                             for value in sweep.values]) for line in sweep.lines]
        print(f"{sweep.title}: {label}")
        for line in lines:
            cells = "  ".join(f"{x:g}: {mean:.2f} [{low:.2f}, {high:.2f}]"
                              for x, mean, low, high in line.points)
            print(f"  {line.name}: {cells}", flush=True)
        if options.out:
            file = Path(options.out) / f"{name}-{key.replace(' ', '-')}.svg"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(chart(sweep.title, sweep.unit, label, lines), encoding="utf-8")


def holds(sweep, rows):
    """Whether all that is claimed does."""
    good = True
    for claim in sweep.claims:
        line = claim.line or next(iter(sweep.lines))
        pairs = zip(rows[line, claim.low], rows[line, claim.high])
        mean, low, high = interval([b[claim.measure] - a[claim.measure] for a, b in pairs])
        right = (low if claim.sign > 0 else -high) > 0.0
        good = good and right
        print(f"  {claim.text}: {claim.measure} from {claim.low:g} to {claim.high:g}: {mean:+.2f} "
              f"[{low:+.2f}, {high:+.2f}]{'' if right else '  DOES NOT HOLD'}")
    for bound in sweep.bounds:
        worst = max(row[bound] for several in rows.values() for row in several)
        good = good and worst <= 0.0
        print(f"  {bound}: never{'' if worst <= 0.0 else f', but {worst:.2f} m  DOES NOT HOLD'}")
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pedzone")
    parser.add_argument("sweeps", nargs="*", metavar="SWEEP")
    parser.add_argument("--seeds", type=int, default=10, choices=SEEDS)
    parser.add_argument("--jobs", type=int, default=min(2, os.cpu_count() or 1))
    parser.add_argument("--model")
    parser.add_argument("--out")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    good = True
    for name in options.sweeps or SWEEPS:
        sweep = SWEEPS[name]
        rows = results(options, sweep)
        show(options, name, sweep, rows)
        good = holds(sweep, rows) and good
    return 0 if good or not options.check else 1


if __name__ == "__main__":
    sys.exit(main())
