#!/usr/bin/python3
"""A study's measures are what one finds in SUMO's outputs oneself; shares nothing with src/.

Runs a scenario with striping and with pedzone, has the program measure the outputs, and recomputes
the measures from the same files: trips, demand, stops and conflicts exactly, what depends on the
zone's area or on what happens between two steps within a tolerance that says why.

usage: check_measures.py PEDZONE MEASURE_RUN SCENARIO.sumocfg [--end SECONDS]
"""
import argparse
import csv
import os
import re
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "check"))
from fcd import read_fcd  # noqa: E402
from measures import Clearances  # noqa: E402
from scenario import open_bytes, read_scenario  # noqa: E402
from trips import demand, read_trips, trip_measures  # noqa: E402
from visits import Ways, walk_measures  # noqa: E402
from zone_area import TOLERANCE, ZoneArea, ZoneRule, read_network  # noqa: E402
from zone_people import of_the_zone, read_table, rows_in_zone  # noqa: E402

ENV = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
FREE_SHARE = 0.9  # of the maximum speed: SUMO's striping takes off up to 0.2 in every step
CIRCLE = 2.0  # [m]
SPACE = (3.25, 2.32, 1.39, 0.93, 0.46)  # [m²] Fruin 1971
TOUCH = 0.03  # [m] clearances differ by so much between two steps' ends and what lies between
SAME = 1e-6  # relative: the same numbers summed in another order
WAYS = 0.01  # relative: of shortest ways, since the area recomputed differs at its borders
WRITTEN = 1e-3  # of series.csv, which has four decimals


def run(command, **options):
    done = subprocess.run(command, env=ENV, capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nended with {done.returncode}\n{done.stderr}")
    return done.stdout


def simulate(arguments, model, folder):
    outputs = ["--fcd-output", str(folder / "fcd.xml.gz"), "--tripinfo-output",
               str(folder / "tripinfo.xml"), "--tripinfo-output.write-unfinished",
               "--tripinfo-output.write-undeparted", "--precision", "4"]
    folder.mkdir()
    if model == "striping":
        run(["sumo", "-c", arguments.scenario, "--seed", "1", "--end", arguments.end, *outputs])
    else:
        run([arguments.pedzone, "run", arguments.scenario, "--model", model, "--seed", "1",
             "--end", arguments.end, "--", *outputs])


def measure(arguments, folder):
    """{key: value} as the program measures them."""
    text = run([arguments.measure_run, folder, arguments.scenario])
    pairs = [line.rsplit(" ", 1) for line in text.splitlines()]
    return {key: value if key.startswith("demand.") else float(value) for key, value in pairs}


def stops(fcd_file):
    """Times that a vehicle came to a stand after it was under way."""
    pattern = re.compile(rb'<vehicle id="([^"]*)".*? speed="([^"]*)"')
    under_way, count = set(), 0
    with open_bytes(str(fcd_file)) as stream:
        for line in stream:
            found = pattern.search(line)
            if not found:
                continue
            name, speed = found.group(1), float(found.group(2))
            if speed < 0.1 and name in under_way:
                under_way.remove(name)
                count += 1
            elif speed > 1.0:
                under_way.add(name)
    return count


def walking_rows(fcd, persons):
    """Rows in which a person walks: not a planned stop, no ride."""
    rows = fcd.persons
    times, walking = fcd.times[rows.step], numpy.zeros(len(rows.x), bool)
    numbers = {name: number for number, name in enumerate(rows.names)}
    for trip in persons:
        own = rows.who == numbers.get(trip.id, -1)
        for depart, arrival, _ in trip.walks:
            walking |= own & (times >= depart - 1e-6) & (times <= arrival + 1e-6)
    return walking


def space_measures(fcd, walking, inside):
    """Density, levels of service and jams of people who walk in the zone."""
    rows, counted = fcd.persons, walking & inside
    bounds = numpy.searchsorted(rows.step, numpy.arange(len(fcd.times) + 1))
    stood = numpy.zeros(len(rows.names))  # [s] by person, without a break
    densities, jammed, windows = [], 0, {}
    for step in range(1, len(fcd.times)):  # the first ends no interval
        here = slice(bounds[step], bounds[step + 1])
        x, y, who = rows.x[here], rows.y[here], rows.who[here]
        near = numpy.hypot(x[:, None] - x, y[:, None] - y) <= CIRCLE
        densities.append(near.sum(axis=1)[counted[here]] / (numpy.pi * CIRCLE ** 2))
        windows.setdefault(int(fcd.times[step] / 10.0 + 1e-9), []).append(densities[-1])
        before = numpy.zeros(len(stood))
        before[rows.who[bounds[step - 1]:bounds[step]]] = 1.0
        still = numpy.zeros(len(stood))
        still[who] = walking[here] & (rows.speed[here] < 0.1) & (before[who] > 0)
        stood = (stood + fcd.times[step] - fcd.times[step - 1]) * still
        stuck = stood[who] > 5.0 - 1e-6
        jammed += ((near & stuck).sum(axis=1) >= 3)[counted[here] & stuck].sum()
    densities = numpy.concatenate(densities)
    means = [numpy.concatenate(window) for window in windows.values()]
    peak = max(window.mean() for window in means if window.size)
    level = sum((densities > 1.0 / space).astype(int) for space in SPACE)
    values = {f"space.level{letter}": numpy.mean(level == number)
              for number, letter in enumerate("ABCDEF")}
    return {**values, "space.density": densities.mean(), "space.peak": peak, "space.jammed": jammed / len(densities)}


def touching(fcd, scenario, persons):
    """{(person, vehicle): least clearance [m]} of those nearer than TOUCH."""
    types = {trip.id: trip.type for trip in persons}
    radius = [scenario.size(types[name])[1] / 2 for name in fcd.persons.names]
    clearances = Clearances(fcd, numpy.array(radius),
                            [scenario.size(name) for name in fcd.vehicles.type_names])
    least = {}
    for step in range(len(fcd.times)):
        found = clearances.of_step(step)
        if found is None:
            continue
        people, fleet, clearance = found
        for i, j in zip(*numpy.nonzero(clearance < TOUCH)):
            pair = (fcd.persons.names[fcd.persons.who[people[i]]],
                    fcd.vehicles.names[fcd.vehicles.who[fleet[j]]])
            least[pair] = min(least.get(pair, TOUCH), clearance[i, j])
    return least


class Comparison:
    """What the program says against what was found."""

    def __init__(self, title, measured):
        self.measured, self.failed = measured, 0
        print(f"{title}\n  {'measure':<22}{'measured':>14}{'recomputed':>14}  tolerance")

    def check(self, key, found, relative=SAME, absolute=0.0):
        value = self.measured[key]
        good = abs(value - found) <= relative * abs(found) + absolute + 1e-9
        self.failed += not good
        print(f"  {key:<22}{value:>14.6g}{found:>14.6g}  {relative:g}"
              + (f" + {absolute:g}" if absolute else "") + ("" if good else "  FAILED"))

    def require(self, what, good):
        self.failed += not good
        print(f"  {what}: {'yes' if good else 'no  FAILED'}")


def parted(rows):
    """Insertions, conflicts with vehicles that move at the moment each is told by, and others."""
    put, moving, standing = [], [], []
    for row in rows:
        moment = next(name for name in ("contact", "minTTC", "PET", "minClearance") if row[name])
        if row["contact"] and float(row["contact_time"]) <= float(row["begin"]):
            put.append(row)
        elif float(row[f"{moment}_vehicleSpeed"]) > 0.5:
            moving.append(row)
        else:
            standing.append(row)
    return put, moving, standing


def check_conflicts(comparison, arguments, folder, fcd, scenario, persons, inside):
    table = folder / "again.csv"
    run([arguments.pedzone, "conflicts", folder / "fcd.xml.gz", "--scenario", arguments.scenario,
         "--vtypes", folder / "tripinfo.xml", "--conflict-csv", table])
    comparison.require("conflicts.csv is that of `pedzone conflicts`",
                       table.read_bytes() == (folder / "conflicts.csv").read_bytes())
    everywhere = read_table(table)
    rows, unsure = of_the_zone(fcd, everywhere, inside)
    print(f"  conflicts in the zone: {len(rows)} of {len(everywhere)}, not sure: {unsure}")
    comparison.require("zone-conflicts.csv has them",
                       unsure > 0 or read_table(folder / "zone-conflicts.csv") == rows)

    def values(name):
        return [float(row[name]) for row in rows if row[name]]

    put, moving, standing = parted(rows)
    comparison.check("conflict.insertions", len(put), absolute=unsure)
    # Values of the table are rounded: one at a limit may count or not.
    for end, part in (("", moving), ("Standing", standing)):
        contacts = [row for row in part if row["contact"]]
        serious = [row for row in part if row["contact"] or float(row["minTTC"] or 9) < 1.5
                   or float(row["PET"] or 9) < 1.0]
        comparison.check("conflict.standing" if end else "conflict.count", len(part),
                         absolute=1 + unsure)
        comparison.check(f"conflict.contacts{end}", len(contacts), absolute=1 + unsure)
        comparison.check(f"conflict.serious{end}", len(serious), absolute=1 + unsure)
    rows = moving
    contacts = [row for row in rows if row["contact"]]
    kinds = {"headOn": ("headOn",), "fromBehind": ("fromBehind",), "following": ("following",),
             "crossing": ("crossingLeft", "crossingRight")}
    for key, names in kinds.items():
        comparison.check(f"conflict.{key}", sum(row["type"] in names for row in rows),
                         absolute=unsure)
    for key, name in (("ttc", "minTTC"), ("pet", "PET"), ("drac", "maxDRAC")):
        if values(name) and not unsure:
            comparison.check(f"conflict.{key}", statistics.median(values(name)), absolute=0.0051)
    if rows:
        clearance = 0.0 if contacts else max(0.0, min(values("minClearance")))
        comparison.check("conflict.clearance", clearance, absolute=0.0051)
    told = {(row["person"], row["vehicle"]) for row in everywhere if row["contact"]}
    # From the places alone: who overlaps in a step has touched, who touched was near in a step.
    near = touching(fcd, scenario, persons)
    overlapping = {pair for pair, least in near.items() if least < -TOUCH}
    print(f"  pairs that overlap by more than {TOUCH} m: {len(overlapping)}, nearer than that: "
          f"{len(near)}, told as contacts: {len(told)}")
    comparison.require("every overlap is told", overlapping <= told)
    comparison.require("every contact told is one", told <= set(near))


def elsewhere(folder, fcd, inside):
    """(cells of density.csv, [s] of all inside, [s] of them that it has not in their cell)."""
    step = numpy.diff(fcd.times).min()
    with open(folder / "density.csv", newline="", encoding="utf-8") as file:
        cells = {(float(row["x"]), float(row["y"])): float(row["personSeconds"])
                 for row in csv.DictReader(file)}
    found, rows = {}, inside & (fcd.persons.step > 0)
    for x, y in zip(fcd.persons.x[rows] // 2 * 2, fcd.persons.y[rows] // 2 * 2):
        found[x, y] = found.get((x, y), 0.0) + step
    error = sum(abs(cells.get(cell, 0.0) - found.get(cell, 0.0)) for cell in {*cells, *found})
    return len(cells), sum(found.values()), error


def check_series(comparison, folder, fcd, counted):
    """series.csv of those who count against the rows themselves."""
    with open(folder / "series.csv", newline="", encoding="utf-8") as file:
        series = list(csv.DictReader(file))
    step = numpy.diff(fcd.times).min()
    rows = counted & (fcd.persons.step > 0)
    windows = numpy.floor(fcd.times[fcd.persons.step] / 10.0 + 1e-9) * 10.0
    for window in series:
        begin = float(window["time"])
        here = rows & (windows == begin)
        length = (numpy.floor(fcd.times[1:] / 10.0 + 1e-9) * 10.0 == begin).sum() * step
        found = here.sum() * step / length
        speed = fcd.persons.speed[here].mean() if here.any() else 0.0
        if (abs(float(window["persons"]) - found) > WRITTEN
                or abs(float(window["personSpeed"] or 0.0) - speed) > WRITTEN):
            comparison.require(f"window {window} is {found:.2f} at {speed:.3f} m/s", False)
    comparison.require(f"series of {len(series)} windows", len(series) >= 10)


def check_run(arguments, model, folder):
    simulate(arguments, model, folder)
    measured = measure(arguments, folder)
    scenario = read_scenario(arguments.scenario)
    fcd = read_fcd(str(folder / "fcd.xml.gz"))
    end = fcd.times[-1] + numpy.diff(fcd.times)[-1]
    persons, vehicles = read_trips(folder / "tripinfo.xml", end)
    comparison = Comparison(model, measured)
    for key, value in trip_measures(persons, vehicles, end).items():
        comparison.check(key, value)
    comparison.check("vehicle.stops", stops(folder / "fcd.xml.gz") / len(vehicles))
    for who, trips in (("persons", persons), ("vehicles", vehicles)):
        comparison.require(f"demand of {who}", measured[f"demand.{who}"] == demand(trips))

    network = read_network(scenario.net_file)
    parts = ZoneArea(network, scenario.polygons, ZoneRule())
    area = parts.reach.area.difference(parts.buildings.area).difference(parts.roads.area)
    area = area.buffer(-TOLERANCE)  # all three are that much on the safe side
    walking, inside = walking_rows(fcd, persons), rows_in_zone(fcd, parts.edges)
    cells, total, error = elsewhere(folder, fcd, inside)
    print(f"  cells: {cells}, {total:.1f} person seconds, {error:.2f} of them elsewhere")
    comparison.require("grid of density", error < SAME * total + WRITTEN * cells)
    for key, value in walk_measures(fcd, persons, inside, Ways(area), FREE_SHARE).items():
        if key == "person.delay":  # a small difference of long times
            comparison.check(key, value, WAYS, 0.1)
        else:
            comparison.check(key, value, WAYS if key == "person.detour" else SAME)
    for key, value in space_measures(fcd, walking, inside).items():
        comparison.check(key, value)
    check_conflicts(comparison, arguments, folder, fcd, scenario, persons, inside)
    check_series(comparison, folder, fcd, walking & inside)
    return comparison, measured


def refuses_cut_off(arguments, folder, files):
    """Whether the program tells, with exit code 2, which file is cut off, and leaves no table."""
    for file in files:
        (folder / file).unlink()
    good = True
    for name in ("fcd.xml.gz", "tripinfo.xml"):
        whole = (folder / name).read_bytes()
        (folder / name).write_bytes(whole[:len(whole) // 2])
        done = subprocess.run([arguments.measure_run, folder, arguments.scenario],
                              capture_output=True, text=True)
        (folder / name).write_bytes(whole)
        good &= done.returncode == 2 and name in done.stderr
        good &= not any(entry.suffix in (".csv", ".partial") and entry.name != "again.csv"
                        for entry in folder.iterdir())
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("pedzone")
    parser.add_argument("measure_run")
    parser.add_argument("scenario")
    parser.add_argument("--end", default="200")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        striping, of_striping = check_run(arguments, "striping", folder / "striping")
        ours, of_ours = check_run(arguments, "heuristic", folder / "heuristic")
        ours.require("the demand is the same", all(
            of_striping[key] == of_ours[key] for key in of_ours if key.startswith("demand.")))
        # The same outputs, whoever wrote them, have the same measures; and the same again.
        (folder / "striping").rename(folder / "heuristic-by-another-name")
        files = ("conflicts.csv", "zone-conflicts.csv", "series.csv", "density.csv")
        moved = folder / "heuristic-by-another-name"
        before = [(moved / file).read_bytes() for file in files]
        ours.require("the same outputs under another name measure the same",
                     measure(arguments, moved) == of_striping
                     and before == [(moved / file).read_bytes() for file in files])
        ours.require("outputs that are cut off are refused, and nothing is written",
                     refuses_cut_off(arguments, moved, files))
        # They are no constants: the two models differ in most of them.
        differ = [key for key in of_ours if of_ours[key] != of_striping.get(key)]
        ours.require(f"the models differ in {len(differ)} measures", len(differ) > 15)
    return 1 if striping.failed or ours.failed else 0


if __name__ == "__main__":
    sys.exit(main())
