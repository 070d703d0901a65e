#!/usr/bin/python3
"""Who is on a path comes by each of its waypoints in turn; who is on none comes by as few as before.

usage: waypoints.py PEDZONE SCENARIO.sumocfg ZONE_FILE [--seeds N]

Runs the scenario and takes everything from the scenario's files and from what SUMO wrote
(fcd-output, tripinfo). Shares nothing with src/.
"""

import argparse
import math
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

ENV = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
ROUNDING = 0.015  # [m] fcd-output has two decimals


def parameters(node):
    return {child.get("key"): child.get("value") for child in node.findall("param")}


def on_lane(net, poi):
    """SUMO's place for lane, pos, posLat; straight lanes of two points only."""
    lane = next(node for node in net.iter("lane") if node.get("id") == poi.get("lane"))
    (ax, ay), (bx, by) = (map(float, point.split(",")) for point in lane.get("shape").split())
    length, pos = float(lane.get("length")), float(poi.get("pos"))
    share = (pos + length if pos < 0 else pos) / length
    dx, dy = (bx - ax), (by - ay)
    left = float(poi.get("posLat", 0)) / math.hypot(dx, dy)
    return ax + share * dx - left * dy, ay + share * dy + left * dx


class Plan:
    """Which person has to come by which circles (x, y, radius)."""

    def __init__(self, scenario, zone_file):
        folder = Path(scenario).parent
        config = ET.parse(scenario)

        def roots(option):
            value = config.find(f".//{option}").get("value")
            return [ET.parse(folder / name.strip()).getroot() for name in value.split(",")]

        zones = ET.parse(zone_file).getroot()
        default = 1.0
        for param in zones.iter("param"):
            if param.get("key") == "waypointRadius":
                default = float(param.get("value"))
        net = roots("net-file")[0]
        circles = {}
        for root in roots("additional-files"):
            for poi in root.iter("poi"):
                place = (on_lane(net, poi) if poi.get("lane")
                         else (float(poi.get("x")), float(poi.get("y"))))
                circles[poi.get("id")] = (
                    *place, float(parameters(poi).get("pedzone.radius", default)))
        self.paths = {path.get("id"): [circles[name] for name in path.get("waypoints").split()]
                      for path in zones.iter("path")}
        self.type_path, self.own_path, self.type_of = {}, {}, {}
        for root in roots("route-files"):
            for node in root.iter("vType"):
                self.type_path[node.get("id")] = parameters(node).get("pedzone.path")
            for node in [*root.iter("person"), *root.iter("personFlow")]:
                self.type_of[node.get("id")] = node.get("type")
                self.own_path[node.get("id")] = parameters(node).get("pedzone.path")

    def path_of(self, person):
        name = person if person in self.type_of else person.rsplit(".", 1)[0]
        return self.own_path[name] or self.type_path[self.type_of[name]]


def tracks(fcd):
    """{person: [(x, y), ...]}"""
    found = {}
    for _, node in ET.iterparse(fcd):
        if node.tag == "timestep":
            for person in node.iter("person"):
                found.setdefault(person.get("id"), []).append(
                    (float(person.get("x")), float(person.get("y"))))
            node.clear()
    return found


def distance(point, a, b):
    """Of a point to the way a-b of one step."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    squared = dx * dx + dy * dy
    share = 0.0
    if squared > 0.0:
        share = max(0.0, min(1.0, ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / squared))
    return math.hypot(a[0] + share * dx - point[0], a[1] + share * dy - point[1])


def entered_in_turn(track, circles):
    count = 0
    for a, b in zip(track, track[1:]):
        if count < len(circles):
            x, y, radius = circles[count]
            count += distance((x, y), a, b) <= radius + ROUNDING
    return count


def run(arguments, seed, folder):
    fcd, trips = folder / "fcd.xml", folder / "tripinfo.xml"
    subprocess.run([arguments.pedzone, "run", arguments.scenario, "--zone", arguments.zone,
                    "--seed", str(seed), "--", "--fcd-output", str(fcd), "--tripinfo-output",
                    str(trips)], check=True, env=ENV, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    arrived = {node.get("id") for node in ET.parse(trips).getroot().iter("personinfo")
               if all(float(walk.get("arrival")) >= 0 for walk in node.iter("walk"))}
    return tracks(fcd), arrived


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pedzone")
    parser.add_argument("scenario")
    parser.add_argument("zone")
    parser.add_argument("--seeds", type=int, default=5)
    arguments = parser.parse_args()
    plan = Plan(arguments.scenario, arguments.zone)
    people = on_path = complete = lost = strangers = 0
    for seed in range(1, arguments.seeds + 1):
        with tempfile.TemporaryDirectory() as folder:
            walked, arrived = run(arguments, seed, Path(folder))
        for person, track in walked.items():
            people += 1
            if person not in arrived:
                lost += 1
                print(f"seed {seed}: {person} has not arrived")
            path = plan.path_of(person)
            if path is None:
                strangers += any(entered_in_turn(track, circles) == len(circles)
                                 for circles in plan.paths.values())
                continue
            on_path += 1
            entered = entered_in_turn(track, plan.paths[path])
            complete += entered == len(plan.paths[path])
            if entered < len(plan.paths[path]):
                print(f"seed {seed}: {person} came by {entered} of the {len(plan.paths[path])} "
                      f"waypoints of '{path}'")
    print(f"{people} people over {arguments.seeds} seeds, {lost} of them not arrived")
    print(f"{complete} of {on_path} on a path came by all of its waypoints in turn")
    print(f"{strangers} of {people - on_path} without a path did so")
    return 0 if on_path > 0 and complete == on_path and lost == 0 and strangers == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
