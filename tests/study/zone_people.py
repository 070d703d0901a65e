#!/usr/bin/python3
"""Whom a study counts, and which conflicts: people in the zone, by the edges of SUMO's outputs.

As a program it checks that on a scenario where people of the zone and of other streets meet at
junctions that both share. Shares nothing with src/.

usage: zone_people.py MEASURE_RUN SCENARIO.sumocfg END_SECONDS
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
from trips import read_trips  # noqa: E402
from visits import STANDING, walk_measures  # noqa: E402
from zone_area import ZoneRule, read_network  # noqa: E402


def read_table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def rows_in_zone(fcd, edges):
    """Of each row of a person: whether it is on an edge of the zone, or in a junction between two
    of them, or to the end in one to which it came from the zone."""
    rows = fcd.persons
    kinds = numpy.array([0 if name.startswith(":") else 1 if name in edges else -1
                         for name in rows.edge_names])[rows.edge]
    inside = numpy.zeros(len(rows.x), bool)
    order = numpy.lexsort((rows.step, rows.who))
    for own in numpy.split(order, numpy.flatnonzero(numpy.diff(rows.who[order])) + 1):
        kind = kinds[own]
        known = numpy.flatnonzero(kind)
        if len(known) == 0:
            continue
        after = numpy.searchsorted(known, numpy.arange(len(own)))
        before = numpy.searchsorted(known, numpy.arange(len(own)), side="right") - 1
        came_from = numpy.where(before >= 0, kind[known[numpy.maximum(before, 0)]], -1)
        went_to = kind[known[numpy.minimum(after, len(known) - 1)]]  # to the end: where it was last
        inside[own] = (came_from > 0) & (went_to > 0)
    return inside


def of_the_zone(fcd, rows, inside):
    """Those of people in the zone at the moment that each is told by; how many it is not sure of,
    since times in the table are rounded. `inside`: rows_in_zone."""
    told, unsure = [], 0
    for row in rows:
        moment = next(name for name in ("contact", "minTTC", "PET", "minClearance") if row[name])
        own = numpy.flatnonzero(fcd.persons.who == fcd.persons.names.index(row["person"]))
        times = fcd.times[fcd.persons.step[own]]
        near = float(row[f"{moment}_time"]) + numpy.array([-0.005, 0.0, 0.005])
        latest = numpy.searchsorted(times, near + 1e-6, side="right") - 1
        answers = inside[own[numpy.maximum(latest, 0)]] & (latest >= 0)
        unsure += len(set(answers)) > 1
        if answers[1]:
            told.append(row)
    return told, unsure


def check_conflicts(folder, fcd, in_zone):
    everywhere = read_table(folder / "conflicts.csv")
    inside, unsure = of_the_zone(fcd, everywhere, in_zone)
    counted = read_table(folder / "zone-conflicts.csv")
    print(f"conflicts: {len(everywhere)}, counted {len(counted)}, of the zone {len(inside)}, "
          f"not sure {unsure}")
    differ = sum(row not in counted for row in inside) + sum(row not in inside for row in counted)
    return differ <= unsure and 10 < len(inside) < len(everywhere) - 10


def check_walks(measured, fcd, persons, inside):
    print(f"rows of people in the zone: {inside.sum()} of {len(inside)}")
    found_all = walk_measures(fcd, persons, inside, None, 1.0)
    # Who walks at exactly that speed stands or does not by the last bit of a number.
    doubtful = (inside & (abs(fcd.persons.speed - STANDING) < 1e-9)).sum()
    spare = {"person.waiting": doubtful * numpy.diff(fcd.times).max() / found_all["person.visitors"]}
    good = True
    for key, found in found_all.items():
        same = abs(measured[key] - found) <= 1e-6 * found + spare.get(key, 0.0)
        print(f"{key}: {measured[key]:.6g}, recomputed {found:.6g}" + ("" if same else "  FAILED"))
        good &= same
    return good


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
        text = subprocess.run([measure_run, folder, scenario], env=environment, check=True,
                              capture_output=True, text=True).stdout
        measured = {key: float(value) for key, value in
                    (line.rsplit(" ", 1) for line in text.splitlines() if line.startswith("person."))}
        rule, network = ZoneRule(), read_network(read_scenario(scenario).net_file)
        edges = {lane.edge for lane in rule.lanes_of(network).values()}
        fcd = read_fcd(str(folder / "fcd.xml.gz"))
        persons, _ = read_trips(folder / "tripinfo.xml", float(end))
        inside = rows_in_zone(fcd, edges)
        good = check_conflicts(folder, fcd, inside)
        return 0 if check_walks(measured, fcd, persons, inside) and good else 1


if __name__ == "__main__":
    sys.exit(main())
