#!/usr/bin/python3
"""A town made up, to measure what pedzone costs where people are few: 2 km² of streets with sidewalks.

usage: networks/city/build.py FOLDER [--blocks N] [--seconds S] [--persons-per-hour N]

Writes into FOLDER, the same bytes each time (SUMO 1.15): `city.net.xml` by netgenerate, people and
cars by randomTrips.py, `city.sumocfg`, and two zone files: `sidewalks.zone.xml` has every sidewalk
with the crossings between them, `circle.zone.xml` those within 200 m of the middle.
"""

import argparse
import math
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

BLOCK = 128.0  # [m] from street to street: 11 × 11 blocks are 2 km²
RADIUS = 200.0  # [m] of the circle
CARS_PER_HOUR = 1800
SEED = "17"
SUMO_HOME = Path(os.environ.get("SUMO_HOME", "/usr/share/sumo"))
ENV = {**os.environ, "SUMO_HOME": str(SUMO_HOME), "PYTHONHASHSEED": "0"}


def call(*words, folder):
    subprocess.run([str(word) for word in words], check=True, cwd=folder, env=ENV,
                   stdout=subprocess.DEVNULL)


def make_network(folder, blocks):
    call("netgenerate", "--grid", "--grid.number", blocks + 1, "--grid.length", BLOCK,
         "--perturb-x", "norm(0,6)", "--perturb-y", "norm(0,6)", "--seed", SEED,
         "--sidewalks.guess", "--default.sidewalk-width", "2.5", "--crossings.guess",
         "--no-turnarounds", "--output-file", "city.net.xml", folder=folder)
    network = folder / "city.net.xml"
    # netgenerate's comment holds the date and the folder.
    text = re.sub(r"<!-- generated on.*?-->\n", "", network.read_text(encoding="utf-8"),
                  flags=re.DOTALL)
    network.write_text(text, encoding="utf-8")


def make_trips(folder, name, seconds, per_hour, *options):
    """Each goes from a random edge to another, at least 300 m away, by a way that duarouter finds."""
    call(sys.executable, SUMO_HOME / "tools" / "randomTrips.py", "-n", "city.net.xml",
         "-e", seconds, "-p", 3600.0 / per_hour, "--seed", SEED, "--min-distance", 300,
         "--validate", "-o", f"{name}.trips.xml", "-r", f"{name}.rou.xml", *options, folder=folder)
    routes = folder / f"{name}.rou.xml"
    text = re.sub(r"<!-- generated on.*?-->\n", "", routes.read_text(encoding="utf-8"),
                  flags=re.DOTALL)
    routes.write_text(text, encoding="utf-8")
    for left in folder.glob(f"{name}.*"):
        if left != routes:
            left.unlink()


def middle_of(edge):
    points = [tuple(map(float, point.split(","))) for point in edge[0].get("shape").split()]
    (x0, y0), (x1, y1) = points[0], points[-1]
    return (x0 + x1) / 2, (y0 + y1) / 2


def make_zones(folder):
    edges = [edge for edge in ET.parse(folder / "city.net.xml").getroot().iter("edge")
             if edge.get("function") is None]
    places = {edge.get("id"): middle_of(edge) for edge in edges}
    centre = [sum(place[axis] for place in places.values()) / len(places) for axis in (0, 1)]
    within = [name for name, place in places.items() if math.dist(place, centre) <= RADIUS]
    for zone, names in (("sidewalks", list(places)), ("circle", within)):
        (folder / f"{zone}.zone.xml").write_text(
            f'<zones><zone id="{zone}" edges="{" ".join(names)}"/></zones>\n', encoding="utf-8")


def make_scenario(folder, seconds):
    (folder / "city.sumocfg").write_text(f"""<configuration>
    <input>
        <net-file value="city.net.xml"/>
        <route-files value="cars.rou.xml,people.rou.xml"/>
    </input>
    <time>
        <end value="{seconds:g}"/>
        <step-length value="1"/>
    </time>
</configuration>
""", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--blocks", type=int, default=11, help="along each side")
    parser.add_argument("--seconds", type=int, default=3600)
    parser.add_argument("--persons-per-hour", type=float, default=3000)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    make_network(options.folder, options.blocks)
    make_trips(options.folder, "people", options.seconds, options.persons_per_hour, "--pedestrians",
               "--max-distance", 1000, "--prefix", "p")
    make_trips(options.folder, "cars", options.seconds, CARS_PER_HOUR, "--prefix", "c")
    make_zones(options.folder)
    make_scenario(options.folder, options.seconds)


if __name__ == "__main__":
    main()
