#!/usr/bin/python3
"""A fundamental diagram from exported trajectories is the one that pedzone tells of the same run.

Densities and speeds are computed from JuPedSim's database alone, by code that shares nothing with
src/: the density that a person is in (people on foot within 2 m, over the circle's area), the speed
from one frame to the next. Compared with series.csv, 10 s by 10 s.

usage: test_exported_diagram.py PEDZONE MEASURE_RUN SCENARIO.sumocfg SECONDS
"""
import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
from shapely.geometry import Point
from shapely.prepared import prep

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
from trajectory_files import Database  # noqa: E402

ENV = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
CIRCLE = 2.0  # [m]
WINDOW = 10.0  # [s]
# People who wait as planned count for pedzone's density, not for its means, and walls are on a grid
# of millimetres: so much may be between two means, relative.
SAME = 0.02


def run(*command):
    done = subprocess.run([*map(str, command)], env=ENV, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{command}\nended with {done.returncode}\n{done.stderr}")


def densities(places):
    """[1/m²] that each is in."""
    apart = numpy.hypot(*(places[:, None, :] - places[None, :, :]).transpose(2, 0, 1))
    return (apart <= CIRCLE).sum(axis=1) / (numpy.pi * CIRCLE ** 2)


def diagram(data, ground):
    """{window [s]: [(density, speed)] of each person and frame in the zones}."""
    found, before = {}, {}
    inside = prep(ground)
    begin = float(data.metadata["begin"])
    rows = data.rows[numpy.argsort(data.rows[:, 0], kind="stable")]
    for frame in numpy.split(rows, numpy.flatnonzero(numpy.diff(rows[:, 0])) + 1):
        places = frame[:, 2:4]
        here = dict(zip(frame[:, 1], places))
        window = (begin + frame[0, 0] / data.rate) // WINDOW * WINDOW
        for number, place, density in zip(frame[:, 1], places, densities(places)):
            if number in before and inside.covers(Point(place)):
                speed = numpy.hypot(*(place - before[number])) * data.rate
                found.setdefault(window, []).append((density, speed))
        before = here
    return found


def main(pedzone, measure_run, scenario, seconds):
    with tempfile.TemporaryDirectory(prefix="pedzone-diagram-") as folder:
        folder = Path(folder)
        outputs = ["--fcd-output", folder / "fcd.xml.gz", "--precision", 4, "--tripinfo-output",
                   folder / "tripinfo.xml", "--tripinfo-output.write-unfinished",
                   "--tripinfo-output.write-undeparted"]
        common = ["run", scenario, "--seed", 1, "--end", seconds, "--quiet", "--trajectories"]
        run(pedzone, *common, folder / "all.sqlite", "--trajectories-of", "all", "--", *outputs)
        run(pedzone, *common, folder / "zones.sqlite")
        run(measure_run, folder, scenario)
        ground = Database(folder / "zones.sqlite").ground()
        found = diagram(Database(folder / "all.sqlite"), ground)
        with open(folder / "series.csv", newline="", encoding="utf-8") as file:
            told = {float(row["time"]): row for row in csv.DictReader(file)}
    compared = 0
    for window, values in found.items():
        density, speed = numpy.mean(values, axis=0)
        if len(values) < 200:
            continue
        row = told[window]
        print(f"{window:6.0f} s: density {density:.4f} told {row['density']}, speed {speed:.4f} "
              f"told {row['personSpeed']}")
        for mine, theirs in ((density, row["density"]), (speed, row["personSpeed"])):
            if abs(mine - float(theirs)) > SAME * mine:
                sys.exit(f"window {window}: {mine} is not {theirs}")
        compared += 1
    alone = 1.0 / (numpy.pi * CIRCLE ** 2)
    others = [numpy.mean(values, axis=0)[0] - alone for values in found.values()]
    print(f"{compared} windows agree; by others {min(others):.3f} to {max(others):.3f} /m²")
    if compared < 10 or max(others) < 2.0 * min(others):
        sys.exit("too little to compare")


if __name__ == "__main__":
    main(*sys.argv[1:])
