#!/usr/bin/python3
"""Which conflicts a study counts: those of people in the zone, by the edges of SUMO's outputs.

As a program it checks that on a scenario where people of the zone and of other streets meet the same
vehicles at junctions that both share. Shares nothing with src/.

usage: zone_conflicts.py MEASURE_RUN SCENARIO.sumocfg END_SECONDS
"""
import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "check"))
from fcd import read_fcd  # noqa: E402
from scenario import read_scenario  # noqa: E402
from zone_area import ZoneRule, read_network  # noqa: E402


def read_table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def edges_of(fcd, person):
    """[(time, edge)] at which somebody came to each edge."""
    rows = fcd.persons
    own = numpy.flatnonzero(rows.who == rows.names.index(person))
    new = own[numpy.diff(rows.edge[own], prepend=-1) != 0]
    return [(fcd.times[rows.step[row]], rows.edge_names[rows.edge[row]]) for row in new]


def in_zone(visits, time, edges):
    """Whether somebody is on an edge of the zone, or in a junction between two of them."""
    now = max((i for i, (begin, _) in enumerate(visits) if begin <= time + 1e-6), default=None)
    if now is None:
        return False

    def normal(places):
        return next((edge in edges for _, edge in places if not edge.startswith(":")), None)

    if not visits[now][1].startswith(":"):
        return visits[now][1] in edges
    before, after = normal(reversed(visits[:now])), normal(visits[now + 1:])
    return bool(before) and after in (True, None)


def of_the_zone(fcd, rows, edges):
    """Those of people in the zone at the moment that each is told by; how many it is not sure of,
    since times in the table are rounded."""
    inside, unsure = [], 0
    for row in rows:
        moment = next(name for name in ("contact", "minTTC", "PET", "minClearance") if row[name])
        time, visits = float(row[f"{moment}_time"]), edges_of(fcd, row["person"])
        answers = [in_zone(visits, time + shift, edges) for shift in (-0.005, 0.0, 0.005)]
        unsure += len(set(answers)) > 1
        if answers[1]:
            inside.append(row)
    return inside, unsure


def main():
    measure_run, scenario, end = sys.argv[1:]
    environment = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        subprocess.run(["sumo", "-c", scenario, "--seed", "1", "--end", end, "--precision", "4",
                        "--no-warnings", "--fcd-output", folder / "fcd.xml.gz",
                        "--tripinfo-output", folder / "tripinfo.xml",
                        "--tripinfo-output.write-unfinished", "--tripinfo-output.write-undeparted"],
                       env=environment, check=True, stdout=subprocess.DEVNULL)
        subprocess.run([measure_run, folder, scenario], env=environment, check=True,
                       stdout=subprocess.DEVNULL)
        rule, network = ZoneRule(), read_network(read_scenario(scenario).net_file)
        edges = {edge.id for edge in network.edges.values()
                 if any(rule.takes(edge, lane) for lane in edge.lanes)}
        everywhere = read_table(folder / "conflicts.csv")
        inside, unsure = of_the_zone(read_fcd(str(folder / "fcd.xml.gz")), everywhere, edges)
        counted = read_table(folder / "zone-conflicts.csv")
    print(f"conflicts: {len(everywhere)}, counted {len(counted)}, of the zone {len(inside)}, "
          f"not sure {unsure}")
    differ = sum(row not in counted for row in inside) + sum(row not in inside for row in counted)
    return 0 if differ <= unsure and 10 < len(inside) < len(everywhere) - 10 else 1


if __name__ == "__main__":
    sys.exit(main())
