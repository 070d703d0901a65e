#!/usr/bin/python3
"""People walk along the streets that their routes name, and SUMO has them there.

usage: routes.py PEDZONE [--keep FOLDER]

A town by netgenerate, all its sidewalks one zone, people by randomTrips.py: their routes are as long
as other ways, and some lead round a block. Read from SUMO's floating-car data and tripinfo:
- people stay within 20 m of the edges of their routes, as in plain SUMO (junctions are as wide)
- they are within 20 m of the edge that SUMO has them on
- SUMO's speed of a person is that of its way, also in the step in which it gets another edge
- walks take as long as in plain SUMO, but for 10 %
"""
import argparse
import math
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

import waypoints

sys.path.insert(0, str(Path(__file__).resolve().parent / "vehicles"))
from junction import SUMO_HOME, call, run_both, zone_of_all  # noqa: E402

PEOPLE, WINDOW, END, STEP = 120, 300, 2000, 1.0  # number; [s]
NEAR, MOST = 20.0, 0.05  # [m]; share of the places, at most, that are farther
SPEED = 0.5              # [m/s]
LONGER, FEW = 0.10, 0.02  # share; of the walks


def make(folder):
    call("netgenerate", "--grid", "--grid.number", "7", "--grid.length", "110", "--seed", "5",
         "--perturb-x", "20", "--perturb-y", "20", "--sidewalks.guess", "--crossings.guess",
         "-o", "n.net.xml", folder=folder)
    zone_of_all(folder)
    call(sys.executable, f"{SUMO_HOME}/tools/randomTrips.py", "-n", "n.net.xml", "--pedestrians",
         "-e", WINDOW, "-p", WINDOW / PEOPLE, "--min-distance", "200", "--seed", "3",
         "-r", "p.rou.xml", "-o", "p.trips.xml", folder=folder)
    (folder / "s.sumocfg").write_text(
        '<configuration><net-file value="n.net.xml"/><route-files value="p.rou.xml"/>'
        f'<end value="{END}"/></configuration>')


def distance(point, line):
    """[m] from a point to a line."""
    return min(waypoints.distance(point, a, b) for a, b in zip(line, line[1:]))


def lanes(folder):
    """{edge: the line of its first lane}; inside junctions the outline or line of that."""
    return {edge.get("id"): [tuple(map(float, place.split(",")[:2]))
                             for place in edge.find("lane").get("shape").split()]
            for edge in xml.parse(folder / "n.net.xml").getroot().iter("edge")}


def shares(folder, who):
    """Of all places of people: (beside their routes, beside SUMO's edge), and the largest
    difference [m/s] between SUMO's speed and that of the way when an edge changes."""
    line = lanes(folder)
    routes = {person.get("id"): person.find("walk").get("edges").split()
              for person in xml.parse(folder / "p.rou.xml").getroot().iter("person")}
    places, astray, elsewhere, worst, last = 0, 0, 0, 0.0, {}
    for _, step in xml.iterparse(folder / who / "fcd.xml"):
        if step.tag != "timestep":
            continue
        for person in step.iter("person"):
            name, edge = person.get("id"), person.get("edge")
            at = float(person.get("x")), float(person.get("y"))
            places += 1
            astray += min(distance(at, line[one]) for one in routes[name]) > NEAR
            elsewhere += distance(at, line[edge]) > NEAR
            if name in last and edge != last[name][1]:
                speed = math.dist(at, last[name][0]) / STEP
                worst = max(worst, abs(speed - float(person.get("speed"))))
            last[name] = at, edge
        step.clear()
    return astray / places, elsewhere / places, worst


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone")
    parser.add_argument("--keep", help="folder for network and outputs")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as work:
        folder = Path(asked.keep or work).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        make(folder)
        plain, ours = (run.walks for run in run_both(Path(asked.pedzone).resolve(), folder))
        plain = {name: walk for name, walk in plain.items() if walk < math.inf}
        astray, elsewhere, worst = shares(folder, "ours")
        late = [name for name in plain
                if abs(ours.get(name, math.inf) - plain[name]) > LONGER * plain[name]]
    print(f"{len(plain)} walks, {len(late)} take more than {LONGER:.0%} longer or shorter;"
          f" {astray:.1%} of the places are not beside the route, {elsewhere:.1%} not beside the edge"
          f" that SUMO has; speeds differ by {worst:.2f} m/s at most where that changes")
    fine = len(plain) > 0.9 * PEOPLE and len(late) <= FEW * len(plain)
    return 0 if fine and max(astray, elsewhere) <= MOST and worst <= SPEED else 1


if __name__ == "__main__":
    sys.exit(main())
