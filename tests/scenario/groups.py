#!/usr/bin/python3
"""Groups stay together, and would not without being groups; everybody arrives.

usage: groups.py PEDZONE SCENARIO.sumocfg [--seed N] [--most-apart M] [--apart-at-end M]
                 [--least-gain FACTOR] [--child-apart M]

Runs the scenario as it is, and with every pedzone.group taken out of its route files. Members are
told by their ids, GROUP.NUMBER. How far apart the two members of a group are that are farthest from
each other, and how far a child is from the nearest adult of its group while a vehicle that moves is
near, comes from SUMO's own fcd-output; who arrived from its tripinfo-output. Shares nothing with
src/.
"""

import argparse
import itertools
import math
import os
import re
import statistics
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from collections import defaultdict
from pathlib import Path

SETTLED = 20.0     # [s] after the first moment with all members: they have found each other
NEAR = 10.0        # [m] from a vehicle's front to a child
MOVING = 0.3       # [m/s]
CHILDREN = ("infant", "child")
ENV = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}


def route_files(scenario):
    value = ET.parse(scenario).find(".//route-files").get("value")
    return [(Path(scenario).parent / name.strip()).resolve() for name in value.split(",")]


def children_of(files):
    """Ids of the persons whose type names a child's profile."""
    persons, types = [], set()
    for file in files:
        root = ET.parse(file).getroot()
        for kind in root.iter("vType"):
            types |= {kind.get("id") for param in kind.iter("param")
                      if param.get("key") == "pedzone.profile" and param.get("value") in CHILDREN}
        persons += [(person.get("id"), person.get("type")) for person in root.iter("person")]
    return {person for person, kind in persons if kind in types}, [name for name, _ in persons]


def without_groups(files, folder):
    for file in files:
        text = re.sub(r'<param key="pedzone.group"[^>]*/>', "", file.read_text(encoding="utf-8"))
        (folder / file.name).write_text(text, encoding="utf-8")
    return ",".join(str(folder / file.name) for file in files)


class Run:
    """One run, and what its outputs say of each group."""

    def __init__(self, pedzone, scenario, folder, seed, children, sizes, options):
        self.children, self.sizes = children, sizes
        self.apart = defaultdict(list)        # group -> [(time, m)] while all members are there
        self.child_apart = defaultdict(list)  # child -> [m] while a vehicle is near
        fcd, trips = folder / "fcd.xml", folder / "tripinfo.xml"
        subprocess.run([pedzone, "run", scenario, "--seed", str(seed), "--", "--fcd-output",
                        str(fcd), "--tripinfo-output", str(trips), *options], check=True, env=ENV,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.arrived = {person.get("id") for person in ET.parse(trips).iter("personinfo")
                        if float(person[-1].get("arrival", -1)) >= 0.0}
        for _, node in ET.iterparse(fcd):
            if node.tag == "timestep":
                self.step(float(node.get("time")), node)
                node.clear()

    def step(self, time, node):
        places = defaultdict(dict)
        for person in node.iter("person"):
            group = person.get("id").rpartition(".")[0]
            places[group][person.get("id")] = (float(person.get("x")), float(person.get("y")))
        moving = [(float(v.get("x")), float(v.get("y"))) for v in node.iter("vehicle")
                  if float(v.get("speed")) > MOVING]
        for group, members in places.items():
            if len(members) == self.sizes[group]:
                widest = max(math.dist(a, b)
                             for a, b in itertools.combinations(members.values(), 2))
                self.apart[group].append((time, widest))
            adults = [at for name, at in members.items() if name not in self.children]
            for name, at in members.items():
                if name in self.children and adults and any(
                        math.dist(at, front) < NEAR for front in moving):
                    self.child_apart[name].append(min(math.dist(at, adult) for adult in adults))

    def settled(self, group):
        """[m], once they have had time to find each other."""
        times = self.apart[group]
        return [apart for time, apart in times if time >= times[0][0] + SETTLED]


def high(values):
    """95th percentile."""
    return sorted(values)[int(0.95 * (len(values) - 1))]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pedzone")
    parser.add_argument("scenario")
    parser.add_argument("--seed", type=int, default=23423)
    parser.add_argument("--most-apart", type=float, default=6.0, help="[m] median")
    parser.add_argument("--apart-at-end", type=float, default=8.0,
                        help="[m] when the first of the group arrives")
    parser.add_argument("--least-gain", type=float, default=2.0,
                        help="without groups so many times as far apart, over all groups")
    parser.add_argument("--child-apart", type=float, default=2.0, help="[m] 95th percentile")
    options = parser.parse_args()
    files = route_files(options.scenario)
    children, persons = children_of(files)
    sizes = defaultdict(int)
    for name in persons:
        sizes[name.rpartition(".")[0]] += 1
    good = True
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run = Run(options.pedzone, options.scenario, folder, options.seed, children, sizes, [])
        alone = Run(options.pedzone, options.scenario, folder, options.seed, children, sizes,
                    ["--route-files", without_groups(files, folder)])
    means, means_alone = [], []
    for group in sizes:
        apart, apart_alone = run.settled(group), alone.settled(group)
        means.append(statistics.mean(apart))
        means_alone.append(statistics.mean(apart_alone))
        end = run.apart[group][-1][1]
        middle = statistics.median(apart)
        good &= middle <= options.most_apart and end <= options.apart_at_end
        print(f"{group:12} farthest apart: median {middle:5.1f} m, 95 % {high(apart):5.1f} m, "
              f"when the first arrives {end:4.1f} m; "
              f"not as a group {statistics.median(apart_alone):5.1f} m, {high(apart_alone):5.1f} m")
    gain = statistics.mean(means_alone) / statistics.mean(means)
    good &= gain >= options.least_gain
    print(f"not as groups {gain:.1f} times as far apart")
    for child in sorted(children):
        apart = run.child_apart[child]
        if not apart:
            good = False
            print(f"{child:12} met no vehicle")
            continue
        good &= high(apart) <= options.child_apart
        print(f"{child:12} from the nearest adult while a vehicle is near ({len(apart)} steps): "
              f"95 % {high(apart):4.2f} m; not as a group {high(alone.child_apart[child] or [0]):4.2f} m")
    missing = set(persons) - run.arrived
    print(f"arrived {len(run.arrived)} of {len(persons)}")
    return 0 if good and not missing else 1


if __name__ == "__main__":
    sys.exit(main())
