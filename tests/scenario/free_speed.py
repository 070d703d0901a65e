#!/usr/bin/python3
"""With nobody to interact with, pedzone walks a person as fast as striping does.

Takes a scenario's own persons, a few of them, one after the other so that they never meet and
without vehicles, and runs them in plain SUMO and in pedzone. Speed is distance over time from
SUMO's own floating-car data, while the person moves; for pedzone only while it was in control, for
striping only on edges between junctions: over a walking area SUMO draws a curve that is up to a
tenth longer than the lane on which it moves the person, so that positions there seem too fast.

usage: free_speed.py PEDZONE SCENARIO.sumocfg [--persons N] [--tolerance SHARE]
"""

import argparse
import csv
import math
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

SPACING = 1000      # [s] between two departures: longer than any walk of the scenarios
MOVING = 0.3        # [m/s] slower samples are stops and waits
STEP = 0.1          # [s]
ENV = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}


def option(config, name):
    node = config.find(f".//{name}")
    return [] if node is None else [part.strip() for part in node.get("value").split(",")]


def lonely_demand(route_files, wanted):
    """Types of the scenario and `wanted` of its persons, far apart in time."""
    kept, persons = [], []
    for file in route_files:
        for element in ET.parse(file).getroot():
            if element.tag in ("vType", "vTypeDistribution"):
                kept.append(element)
            elif element.tag in ("person", "personFlow") and all(
                    child.tag == "walk" for child in element if child.tag != "param"):
                persons.append(element)
    chosen = persons[::max(1, len(persons) // wanted)][:wanted]
    routes = ET.Element("routes")
    routes.extend(kept)
    for number, element in enumerate(chosen):
        person = ET.SubElement(routes, "person", id=f"lonely{number}",
                               depart=str(number * SPACING))
        if element.get("type"):
            person.set("type", element.get("type"))
        person.extend(element)
    return routes, len(chosen)


def speeds(fcd, when=None):
    """{person: distance / time} over moving samples: at the times that `when` names, if given,
    else on edges between junctions."""
    walked, last = {}, {}
    time = None
    pattern = re.compile(r'<person id="([^"]*)" x="([^"]*)" y="([^"]*)".* edge="([^"]*)"')
    for line in open(fcd, encoding="utf-8"):
        if "<timestep" in line:
            time = round(float(re.search(r'time="([^"]*)"', line).group(1)), 2)
            continue
        match = pattern.search(line)
        if not match:
            continue
        person, here = match.group(1), (float(match.group(2)), float(match.group(3)))
        edge = match.group(4)
        before = last.get(person)
        last[person] = (time, here, edge)
        if before is None or abs(time - before[0] - STEP) > 1e-6:
            continue
        if when is None and (edge.startswith(":") or edge != before[2]):
            continue
        if when is not None and not {(person, time), (person, before[0])} <= when:
            continue
        distance = math.dist(here, before[1])
        if distance < MOVING * STEP:
            continue
        total = walked.setdefault(person, [0.0, 0.0])
        total[0] += distance
        total[1] += STEP
    return {person: total[0] / total[1] for person, total in walked.items() if total[1] > 10.0}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("pedzone")
    parser.add_argument("scenario")
    parser.add_argument("--persons", type=int, default=12)
    parser.add_argument("--tolerance", type=float, default=0.02)
    arguments = parser.parse_args()
    scenario = Path(arguments.scenario).resolve()
    config = ET.parse(scenario).getroot()
    route_files = [scenario.parent / name for name in option(config, "route-files")]
    demand, count = lonely_demand(route_files, arguments.persons)
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        ET.ElementTree(demand).write(folder / "lonely.rou.xml")
        common = ["--route-files", str(folder / "lonely.rou.xml"), "--end",
                  str(count * SPACING), "--step-length", str(STEP)]
        subprocess.run(["sumo", "-c", str(scenario), *common, "--fcd-output",
                        str(folder / "plain.xml"), "--no-step-log"], check=True, env=ENV,
                       capture_output=True)
        done = subprocess.run(
            [arguments.pedzone, "run", str(scenario), "--trajectories", str(folder / "t.csv"), "--",
             *common, "--fcd-output", str(folder / "pedzone.xml")], env=ENV)
        if done.returncode != 0:
            return 1
        with open(folder / "t.csv", newline="", encoding="utf-8") as file:
            controlled = {(row["id"], round(float(row["time"]), 2)) for row in csv.DictReader(file)}
        plain = speeds(folder / "plain.xml")
        ours = speeds(folder / "pedzone.xml", controlled)
    both = sorted(plain.keys() & ours.keys())
    print(f"{'person':<12}{'striping':>10}{'pedzone':>10}{'ratio':>8}   (m/s)")
    for person in both:
        print(f"{person:<12}{plain[person]:>10.3f}{ours[person]:>10.3f}"
              f"{ours[person] / plain[person]:>8.3f}")
    if not both:
        print("FAILED: nobody was controlled for longer than 10 s")
        return 1
    ratio = sum(ours[p] for p in both) / sum(plain[p] for p in both)
    print(f"mean ratio {ratio:.4f} over {len(both)} persons, allowed 1 ± {arguments.tolerance}")
    return 0 if abs(ratio - 1.0) <= arguments.tolerance else 1


if __name__ == "__main__":
    sys.exit(main())
