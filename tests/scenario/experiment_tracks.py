"""Runs one of scenarios/experiments and reads who was where from SUMO's own floating-car data.

Shares nothing with src/. Positions are network metres; a vehicle's is that of the middle of its
front bumper, its angle in degrees clockwise from north.
"""

import os
import subprocess
import tempfile
import xml.etree.ElementTree as ET
from dataclasses import dataclass, field
from pathlib import Path

import numpy

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios" / "experiments"
NETWORK = SCENARIOS.parents[1] / "networks" / "experiments" / "experiments.net.xml"
ENV = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
RADIUS = 0.239  # [m] of a person: half the width of SUMO's pedestrian (0.478 m)
STEP = 0.1      # [s] of the scenarios


@dataclass
class Track:
    """One row for each time step."""
    t: numpy.ndarray  # [s]
    x: numpy.ndarray  # [m]
    y: numpy.ndarray  # [m]
    angle: numpy.ndarray  # [deg]

    @property
    def speed(self):
        """[m/s] over the last step; 0 in the first."""
        return numpy.hypot(numpy.diff(self.x, prepend=self.x[0]),
                           numpy.diff(self.y, prepend=self.y[0])) / STEP

    def at(self, times):
        """x, y [m] at times that it was there; nan elsewhere."""
        return (numpy.interp(times, self.t, self.x, numpy.nan, numpy.nan),
                numpy.interp(times, self.t, self.y, numpy.nan, numpy.nan))


@dataclass
class Run:
    """What one run's outputs say."""
    persons: dict  # id -> Track
    vehicles: dict  # id -> Track
    sizes: dict = field(default_factory=dict)  # vehicle id -> (length, width) [m]

    def seen_from(self, person, vehicle):
        """t, and how far [m] the person's centre is ahead of the vehicle's front bumper and to the
        left of its middle; while both are there."""
        one, other = self.persons[person], self.vehicles[vehicle]
        keep = (one.t >= other.t[0]) & (one.t <= other.t[-1])
        t, x, y = one.t[keep], one.x[keep], one.y[keep]
        vx, vy = other.at(t)
        north = numpy.interp(t, other.t, numpy.unwrap(other.angle, period=360))
        angle = numpy.radians(90.0 - north)
        return (t, (x - vx) * numpy.cos(angle) + (y - vy) * numpy.sin(angle),
                (y - vy) * numpy.cos(angle) - (x - vx) * numpy.sin(angle))

    def gaps(self, person, vehicle):
        """t, and how far [m] the person's centre is from the vehicle's rectangle."""
        length, width = self.sizes[vehicle]
        t, ahead, aside = self.seen_from(person, vehicle)
        return t, numpy.hypot(numpy.maximum(numpy.maximum(-length - ahead, ahead), 0.0),
                              numpy.maximum(numpy.abs(aside) - width / 2, 0.0))


def read_fcd(file):
    rows = {"person": {}, "vehicle": {}}
    for _, node in ET.iterparse(file):
        if node.tag != "timestep":
            continue
        time = float(node.get("time"))
        for child in node:
            rows[child.tag].setdefault(child.get("id"), []).append(
                (time, *(float(child.get(key)) for key in ("x", "y", "angle"))))
        node.clear()
    return [{name: Track(*numpy.array(track).T) for name, track in rows[kind].items()}
            for kind in ("person", "vehicle")]


def vehicle_sizes(route_file):
    root = ET.parse(route_file).getroot()
    types = {t.get("id"): (float(t.get("length")), float(t.get("width")))
             for t in root.iter("vType") if t.get("length")}
    return {v.get("id"): types[v.get("type")] for v in root.iter("vehicle")}


def stars(scenario):
    """id -> (x, y) [m] of the waypoints."""
    return {poi.get("id"): (float(poi.get("x")), float(poi.get("y")))
            for poi in ET.parse(SCENARIOS / f"{scenario}.add.xml").iter("poi")}


def zone_box(edge):
    """x0, y0, x1, y1 [m] of an edge of the network; each is straight and leads east or west."""
    lane = next(node for node in ET.parse(NETWORK).iter("lane") if node.get("id") == f"{edge}_0")
    points = [tuple(map(float, point.split(","))) for point in lane.get("shape").split()]
    half = float(lane.get("width")) / 2
    xs, ys = zip(*points)
    assert max(ys) - min(ys) < 0.01, edge
    return min(xs), min(ys) - half, max(xs), max(ys) + half


def outside(run, edge):
    """How far [m] somebody's centre is outside the edge's lane at most."""
    x0, y0, x1, y1 = zone_box(edge)
    return max(float(numpy.max([x0 - p.x, p.x - x1, y0 - p.y, p.y - y1]))
               for p in run.persons.values())


def start(pedzone, scenario, zone, seed, folder, words=(), sumo=()):
    """Runs it; the floating-car data's file."""
    fcd = Path(folder) / "fcd.xml"
    done = subprocess.run(
        [pedzone, "run", str(SCENARIOS / f"{scenario}.sumocfg"), "--zone", str(zone), "--seed",
         str(seed), "--threads", "1", *words, "--", "--fcd-output", str(fcd), "--no-warnings",
         "true", *sumo], capture_output=True, text=True, env=ENV)
    if done.returncode != 0:
        raise RuntimeError(f"{scenario}, seed {seed}: {done.stderr}")
    return fcd


def only(scenario, ending, folder):
    """The scenario's routes with those persons only whose id ends so."""
    tree = ET.parse(SCENARIOS / f"{scenario}.rou.xml")
    for person in tree.getroot().findall("person"):
        if not person.get("id").endswith(ending):
            tree.getroot().remove(person)
    tree.write(Path(folder) / "only.rou.xml")
    return Path(folder) / "only.rou.xml"


def run_only(pedzone, scenario, zone, seed, words, ending):
    with tempfile.TemporaryDirectory() as folder:
        routes = only(scenario, ending, folder)
        return run(pedzone, scenario, zone, seed, words, ("--route-files", str(routes)), routes)


def run(pedzone, scenario, zone, seed, words=(), sumo=(), routes=None):
    with tempfile.TemporaryDirectory() as folder:
        persons, vehicles = read_fcd(start(pedzone, scenario, zone, seed, folder, words, sumo))
    return Run(persons, vehicles, vehicle_sizes(routes or SCENARIOS / f"{scenario}.rou.xml"))
