#!/usr/bin/python3
"""A made-up town (networks/city/build.py) with pedzone and in plain SUMO: the same people arrive,
about as soon; and what both cost.

usage: city.py PEDZONE [--blocks N] [--seconds S] [--persons-per-hour N] [--zone sidewalks]
               [--times N] [-- OPTIONS OF pedzone run]

Everybody has half an hour more to arrive. With --times both are run so often and the medians of
their processor time are told: of whole runs, as a user has them, on however busy a machine.
"""

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent.parent
ENV = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
LEFT_TO_ARRIVE = 1800  # [s]
TOLERANCE = 0.1  # of the mean duration
MOST = 0.99  # of the persons are walked by pedzone where all sidewalks are a zone


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def durations(tripinfo):
    """{person: [s] its whole walk took} of those who arrived."""
    found = {}
    for person in ET.parse(tripinfo).getroot().iter("personinfo"):
        walks = list(person.iter("walk"))
        if walks and all(float(walk.get("arrival")) >= 0 for walk in walks):
            found[person.get("id")] = sum(float(walk.get("duration")) for walk in walks)
    return found


def run(command, tripinfo):
    """Durations by person and processor time [s]."""
    before = processor_time()
    subprocess.run([*map(str, command), "--tripinfo-output", str(tripinfo), "--no-warnings", "true"],
                   check=True, env=ENV, stdout=subprocess.DEVNULL)
    return durations(tripinfo), processor_time() - before


def departing(routes):
    return {person.get("id") for person in ET.parse(routes).getroot().iter("person")}


def compare(everybody, plain, pedzone):
    """What is not as it must be."""
    faults = []
    for name, arrived in (("plain SUMO", plain), ("pedzone", pedzone)):
        if set(arrived) != everybody:
            faults.append(f"{name}: {len(everybody - set(arrived))} of {len(everybody)} never "
                          "arrive")
    ratio = statistics.mean(pedzone.values()) / statistics.mean(plain.values())
    print(f"{len(everybody)} persons; mean duration {statistics.mean(plain.values()):.1f} s in plain "
          f"SUMO, {statistics.mean(pedzone.values()):.1f} s with pedzone: {ratio:.3f} times")
    if abs(ratio - 1.0) > TOLERANCE:
        faults.append(f"the mean duration is {ratio:.3f} times that of plain SUMO")
    return faults


def main():
    own = sys.argv[1:]
    further = own[own.index("--") + 1:] if "--" in own else []
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone")
    parser.add_argument("--blocks", default="11")
    parser.add_argument("--seconds", type=int, default=3600)
    parser.add_argument("--persons-per-hour", default="3000")
    parser.add_argument("--zone", default="sidewalks", choices=("sidewalks", "circle"))
    parser.add_argument("--times", type=int, default=1)
    options = parser.parse_args(own[:own.index("--")] if "--" in own else own)
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        subprocess.run([PROJECT / "networks" / "city" / "build.py", folder, "--blocks",
                        options.blocks, "--seconds", str(options.seconds), "--persons-per-hour",
                        options.persons_per_hour], check=True, env=ENV)
        scenario = folder / "city.sumocfg"
        end = ["--end", options.seconds + LEFT_TO_ARRIVE]
        plain_costs, costs = [], []
        for _ in range(options.times):
            plain, cost = run(["sumo", "-c", scenario, *end], folder / "plain.xml")
            plain_costs.append(cost)
            pedzone, cost = run([options.pedzone, "run", scenario, "--zone",
                                 folder / f"{options.zone}.zone.xml", *end, "--summary",
                                 folder / "summary.json", *further, "--"], folder / "pedzone.xml")
            costs.append(cost)
        everybody = departing(folder / "people.rou.xml")
        faults = compare(everybody, plain, pedzone)
        walked = json.loads((folder / "summary.json").read_text())["persons"]["controlled"]
        print(f"pedzone walked {walked} of them")
        if options.zone == "sidewalks" and walked < MOST * len(everybody):
            faults.append(f"pedzone walked only {walked} of {len(everybody)} persons")
        plain_cost, cost = statistics.median(plain_costs), statistics.median(costs)
        print(f"processor time: plain SUMO {plain_cost:.2f} s, pedzone {cost:.2f} s: "
              f"{cost / plain_cost:.2f} times")
    for fault in faults:
        print(f"Error: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
