#!/usr/bin/python3
"""Recomputes from SUMO's own outputs whether a run was right; shares nothing with src/.

    check_run.py town.sumocfg RUN [--plain PLAIN] [--free FREE] [limits ...]

RUN is a folder with what SUMO wrote: fcd.xml[.gz], tripinfo.xml[.gz] (--tripinfo-output with
--tripinfo-output.write-unfinished), and, as far as there: vehroute.xml[.gz], statistics.xml or
log.txt. A trajectories.csv in it (time,id,...) only tells who was controlled when, and only adds to
what FCD shows by itself; positions are always SUMO's. PLAIN holds the same outputs of plain SUMO for
comparison, FREE the tripinfo of a run without persons.

Exit code 0: all limits kept; 1: one broken; 2: the check could not be made.
"""
import argparse
import json
import os
import sys

import comparison
import measures
import outputs
import report
from fcd import read_fcd
from scenario import CheckError, open_bytes, read_scenario
from zone_area import ZoneArea, ZoneRule, read_network, read_zone_rule

import numpy


def read_controlled(path, fcd):
    """Rows of persons that a trajectories CSV says were controlled, to half a step."""
    numbers = {name.encode(): number for number, name in enumerate(fcd.persons.names)}
    step = numpy.diff(fcd.times).min() if len(fcd.times) > 1 else 1.0
    times, who = [], []
    with open_bytes(path) as stream:
        if not stream.readline().startswith(b"time,id,"):
            raise CheckError(f"{path}: does not begin with 'time,id,'")
        for number, line in enumerate(stream, 2):
            fields = line.split(b",", 2)
            if len(fields) < 3:
                raise CheckError(f"{path}:{number}: has no time and id")
            times.append(fields[0])
            who.append(numbers.get(fields[1], len(numbers)))
    try:
        moments = numpy.rint(numpy.array(times, "S16").astype(float) / step)
    except ValueError as error:
        raise CheckError(f"{path}: a time is no number: {error}") from None
    count = len(numbers) + 1  # with one for persons that FCD does not have
    listed = moments.astype(numpy.int64) * count + numpy.array(who, numpy.int64)
    steps = numpy.rint(fcd.times / step).astype(numpy.int64)[fcd.persons.step]
    return numpy.isin(steps * count + fcd.persons.who, listed)


class Check:
    """One run, measured."""

    def __init__(self, options):
        self.options = options
        self.scenario = read_scenario(options.config)
        self.run = outputs.read_run(options.run)
        self.plain = outputs.read_run(options.plain, False) if options.plain else None
        self.free = outputs.read_run(options.free, False) if options.free else None
        self.fcd = read_fcd(self.run.fcd_file)
        if not len(self.fcd.persons.x):
            raise CheckError(f"{self.run.fcd_file}: no persons, so there is nothing to check")
        self.riding = measures.riding_rows(self.fcd, self.run.persons)
        self.controlled = measures.find_detached(self.fcd)
        trajectories = options.trajectories or outputs.find_output(
            options.run, "trajectories", (".csv", ".csv.gz"))
        if trajectories:
            self.controlled |= read_controlled(trajectories, self.fcd)
        rule = read_zone_rule(options.zone) if options.zone else ZoneRule()
        self.network = read_network(self.scenario.net_file)
        self.area = ZoneArea(self.network, self.scenario.polygons, rule)

    def measure(self):
        """All figures as a dictionary fit for JSON."""
        result = {"persons": self._persons(), "contacts": self._contacts(),
                  "jumps": self._jumps(), "outside": self._outside(),
                  "teleports": self.run.teleports, "jams": self.run.person_jams,
                  "nan": int((~numpy.isfinite(self.fcd.persons.x)
                              | ~numpy.isfinite(self.fcd.persons.y)).sum())}
        result["vehicles"] = comparison.vehicle_durations(self.run, self.plain, self.free)
        if self.plain:
            # Whom SUMO alone walked has the same routeLength with all versions.
            shorter = set()
            if self.run.own_junctions_only:
                who = numpy.unique(self.fcd.persons.who[self.controlled])
                shorter = {self.fcd.persons.names[i] for i in who}
            result["plain"] = comparison.compare_persons(self.run, self.plain, shorter,
                                                         self.network)
        return result

    def _persons(self):
        losses = measures.find_losses(self.fcd, self.run.persons, self.run.vehicles)
        on_foot = self.fcd.persons.who[self.controlled]
        return {"departed": losses.departed, "arrived": losses.arrived,
                "walking": losses.walking, "lost": len(losses.lost),
                "lost_ids": losses.lost[:measures.EXAMPLES],
                "controlled": len(numpy.unique(on_foot)),
                "controlled_person_steps": int(self.controlled.sum()),
                "mean_duration_s": comparison.mean_duration(self.run.persons)}

    def _radius(self, name):
        if self.options.radius is not None:
            return self.options.radius
        trip = self.run.persons.get(name)
        return self.scenario.size(trip.type if trip else "DEFAULT_PEDTYPE")[1] / 2

    def _own_rides(self):
        persons = {name: i for i, name in enumerate(self.fcd.persons.names)}
        vehicles = {name: i for i, name in enumerate(self.fcd.vehicles.names)}
        return [(persons[name], vehicles[stage.vehicle])
                for name, trip in self.run.persons.items() for stage in trip.stages
                if name in persons and stage.vehicle in vehicles]

    def _contacts(self):
        fcd, fleet = self.fcd, self.fcd.vehicles
        radius = numpy.array([self._radius(name) for name in fcd.persons.names])
        clearances = measures.Clearances(
            fcd, radius, [self.scenario.size(name) for name in fleet.type_names])
        found = measures.find_contacts(fcd, clearances, self.riding, self.controlled,
                                       self._own_rides())
        # A vehicle that SUMO inserts on top of somebody whom it does not walk (and so does not see)
        # touches that person until it has stepped aside: nothing can delay the insertion. Counted
        # apart, by pair, and no longer than until it should have.
        inserted = measures.at_insertion(fcd, found)
        # Who squeezes past has turned its shoulders, which positions do not show. Of SUMO's people nobody does.
        turned = self.controlled[found.rows] & measures.touches_turned(fcd, found, radius) & ~inserted
        counts = ~inserted & ~turned
        controlled = self.controlled[found.rows] & counts
        zone_edges = numpy.array([name in self.area.edges for name in fcd.persons.edge_names])
        in_zone = (controlled | zone_edges[fcd.persons.edge[found.rows]]) & counts

        def figures(chosen):
            pairs = numpy.column_stack([fcd.persons.who[found.rows[chosen]],
                                        fleet.who[found.vehicles[chosen]]])
            by_type = {}
            for _, vehicle in numpy.unique(pairs, axis=0):
                row = numpy.flatnonzero(fleet.who == vehicle)[0]
                name = fleet.type_names[fleet.type[row]]
                by_type[name] = by_type.get(name, 0) + 1
            index = numpy.flatnonzero(chosen)
            finding = measures.describe(fcd, found.rows[chosen], lambda i: {
                "vehicle": fleet.names[fleet.who[found.vehicles[index[i]]]],
                "depth": round(float(found.depth[index[i]]), 3)})
            return {"pairs": len(numpy.unique(pairs, axis=0)), "frames": len(index),
                    "pairs_by_vehicle_type": by_type,
                    "deepest_m": float(found.depth[chosen].max(initial=0.0)),
                    "examples": finding.examples}

        return {"all": figures(numpy.ones(len(in_zone), bool)), "controlled": figures(controlled),
                "zone": figures(in_zone), "elsewhere": figures(~in_zone & counts),
                "at_insertion": figures(inserted), "turned": figures(turned),
                "min_clearance_m": found.min_clearance,
                "min_clearance_controlled_m": found.min_clearance_controlled}

    def _jumps(self):
        jumps = measures.without_steps_aside(
            self.fcd, measures.find_jumps(self.fcd, self.riding), self.run.persons, self.network)
        if self.plain and self.plain.fcd_file and len(jumps.rows):
            plain_fcd = read_fcd(self.plain.fcd_file)
            riding = measures.riding_rows(plain_fcd, self.plain.persons)
            jumps = measures.without_plain_jumps(self.fcd, jumps, self.controlled, plain_fcd,
                                                 measures.find_jumps(plain_fcd, riding))
        result = vars(measures.describe(
            self.fcd, jumps.rows, lambda i: {"distance": round(float(jumps.distance[i]), 2)}))
        controlled = self.controlled[jumps.rows] | self.controlled[jumps.before]
        result["controlled"] = int(controlled.sum())
        persons = self.fcd.persons
        result["controlled_jumps"] = [
            {"person": persons.names[persons.who[row]],
             "time": float(self.fcd.times[persons.step[row]]), "distance": float(distance)}
            for row, distance in zip(jumps.rows[controlled], jumps.distance[controlled])]
        return result

    def _outside(self):
        found = measures.find_outside(self.fcd, numpy.flatnonzero(self.controlled), self.area)
        tests = {"in_building": self.area.buildings, "on_road": self.area.roads,
                 "out_of_reach": self.area.reach}
        result = {}
        for name, rows in found.items():
            x, y = self.fcd.persons.x[rows], self.fcd.persons.y[rows]
            result[name] = vars(measures.describe(self.fcd, rows, lambda i: {
                "depth": round(tests[name].depth(x[i], y[i]), 2)}))
        every = numpy.unique(numpy.concatenate(list(found.values())))
        result["events"] = len(every)
        result["persons"] = len(numpy.unique(self.fcd.persons.who[every]))
        return result


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("config", help="the scenario's sumocfg")
    parser.add_argument("run", help="folder with the run's outputs")
    parser.add_argument("--plain", help="folder with plain SUMO's outputs")
    parser.add_argument("--free", help="folder with the tripinfo of a run without persons")
    parser.add_argument("--zone", help="zone file, where the run had one")
    parser.add_argument("--trajectories", help="CSV of who was controlled when "
                        "(default: RUN/trajectories.csv)")
    parser.add_argument("--radius", type=float, help="[m] of all persons, instead of half their "
                        "type's width")
    parser.add_argument("--json", help="write all figures to this file, or - for standard output")
    report.add_limits(parser)
    return parser.parse_args(arguments)


def main(arguments=None):
    options = parse_arguments(arguments)
    try:
        result = Check(options).measure()
        broken = report.broken_limits(options, result)
    except CheckError as error:
        print(f"check_run: {error}", file=sys.stderr)
        return 2
    result["broken_limits"] = broken
    if options.json == "-":
        json.dump(result, sys.stdout, indent=2)
        print()
    else:
        if options.json:
            partial = options.json + ".partial"
            with open(partial, "w", encoding="utf-8") as stream:
                json.dump(result, stream, indent=2)
            os.replace(partial, options.json)
        print(report.table(result))
    for line in broken:
        print(f"limit broken: {line}", file=sys.stderr)
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
