#!/usr/bin/python3
"""Both sides at once: nobody freezes, crowds let vehicles through, vehicles do not push.

usage: negotiation.py PEDZONE SCENARIO.sumocfg [--most-standing S] [--most-waiting S] [--creep M/S]

Runs the scenario and takes everything from what SUMO wrote (fcd-output): how long a person whom
pedzone walks stands at one place, how long a vehicle stands, and how fast a vehicle drives with
somebody close before its bumper. Shares nothing with src/.
"""

import argparse
import math
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from check.scenario import read_scenario  # noqa: E402

PLACE = 0.3     # [m] who stays within this stands
BEFORE = 0.5    # [m] so close before the bumper is pushed
RADIUS = 0.2    # [m] of a body, on the careful side


class Watch:
    """Takes in one time step after the other."""

    def __init__(self, scenario, walked):
        self.scenario, self.walked = scenario, walked
        self.since, self.place = {}, {}
        self.standing = (0.0, "")   # longest [s], person
        self.waiting = (0.0, "")    # longest [s], vehicle
        self.pushing = (0.0, "")    # fastest [m/s], vehicle, person, time
        self.vehicle_since = {}

    def step(self, time, vehicles, persons):
        for vehicle in vehicles:
            self.wait(time, vehicle)
        for person in persons:
            if (time, person["id"]) not in self.walked:
                self.since.pop(person["id"], None)
                continue
            self.stand(time, person)
            for vehicle in vehicles:
                self.push(time, vehicle, person)

    def wait(self, time, vehicle):
        name = vehicle["id"]
        if float(vehicle["speed"]) > 0.1:
            self.vehicle_since.pop(name, None)
            return
        stood = time - self.vehicle_since.setdefault(name, time)
        self.waiting = max(self.waiting, (stood, name))

    def stand(self, time, person):
        name, here = person["id"], (float(person["x"]), float(person["y"]))
        if name not in self.since or math.dist(here, self.place[name]) > PLACE:
            self.since[name], self.place[name] = time, here
        self.standing = max(self.standing, (time - self.since[name], name))

    def push(self, time, vehicle, person):
        angle = math.radians(90.0 - float(vehicle["angle"]))
        dx = float(person["x"]) - float(vehicle["x"])
        dy = float(person["y"]) - float(vehicle["y"])
        ahead = dx * math.cos(angle) + dy * math.sin(angle)
        aside = abs(dy * math.cos(angle) - dx * math.sin(angle))
        width = self.scenario.size(vehicle["type"])[1]
        if 0.0 <= ahead - RADIUS < BEFORE and aside < width / 2:
            self.pushing = max(self.pushing, (float(vehicle["speed"]), vehicle["id"]))


def read_walked(path):
    """{(time, person)} of those whom pedzone walks."""
    with open(path, encoding="utf-8") as stream:
        next(stream)
        return {(float(row.split(",")[0]), row.split(",")[1]) for row in stream}


def watch(fcd, scenario, walked):
    seen = Watch(scenario, walked)
    for _, node in ET.iterparse(fcd):
        if node.tag == "timestep":
            seen.step(float(node.get("time")), [v.attrib for v in node.iter("vehicle")],
                      [p.attrib for p in node.iter("person")])
            node.clear()
    return seen


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pedzone")
    parser.add_argument("scenario")
    parser.add_argument("--most-standing", type=float, default=30.0, help="[s] of a person")
    parser.add_argument("--most-waiting", type=float, default=60.0, help="[s] of a vehicle")
    parser.add_argument("--creep", type=float, default=1.2, help="[m/s] close before somebody")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        fcd, rows = Path(folder) / "fcd.xml", Path(folder) / "trajectories.csv"
        subprocess.run([options.pedzone, "run", options.scenario, "--trajectories", str(rows), "--",
                        "--fcd-output", str(fcd)], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        seen = watch(fcd, read_scenario(options.scenario), read_walked(rows))
    print(f"longest that a person stands      {seen.standing[0]:6.1f} s ({seen.standing[1]})")
    print(f"longest that a vehicle stands     {seen.waiting[0]:6.1f} s ({seen.waiting[1]})")
    print(f"fastest close before somebody     {seen.pushing[0]:6.2f} m/s ({seen.pushing[1]})")
    good = (seen.standing[0] <= options.most_standing and seen.waiting[0] <= options.most_waiting
            and seen.pushing[0] <= options.creep)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
