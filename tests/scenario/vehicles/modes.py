#!/usr/bin/python3
"""Buses, taxis, bicycles, cars that park, people who change between them: with pedzone and in plain SUMO.

usage: modes.py PEDZONE [--nets grid,spider] [--zones all,junctions] [--seeds N,N] [--keep FOLDER]

The network is netgenerate's with sidewalks and crossings guessed, steps of 1 s. A third of the people
walk to a bus, ride, and walk on; a third say modes="public" or modes="taxi" and SUMO finds their ways;
some walk somewhere, stay, and walk back. All edges for people are one zone (all), or the streets that
lead to a junction are one each (junctions). Read from SUMO's outputs:
- everybody arrives who does in plain SUMO, by the same kinds of stages; so do all vehicles
- people's mean duration is within 10 % of plain SUMO's
- no more vehicles are teleported or collide than in plain SUMO, but for two that meet by chance
"""
import argparse
import random
import statistics
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

from junction import SUMO_HOME, call

sys.path.insert(0, f"{SUMO_HOME}/tools")
import sumolib  # noqa: E402

NETS = {"grid": ("--grid", "--grid.number", "5", "--grid.length", "150"),
        "spider": ("--spider", "--spider.arm-number", "6", "--spider.circle-number", "3",
                   "--spider.space-radius", "120")}
BUS_LINES, TAXIS, BICYCLES, CARS, PEOPLE = 6, 8, 60, 150, 300
LEAST_RIDES = 50  # by bus and taxi in plain SUMO, or it is not what it is meant to be
SECONDS, END = 600, 4800  # [s] of departures; of the run: everybody has arrived long before
TOLERANCE, FEW = 0.1, 2  # of the mean duration; teleports and collisions


class Demand:
    def __init__(self, folder, seed):
        self.folder, self.random = folder, random.Random(seed)
        self.net = sumolib.net.readNet(str(folder / "n.net.xml"))
        self.edges = [edge for edge in self.net.getEdges() if edge.getLength() > 50.0
                      and edge.allows("passenger") and edge.allows("pedestrian")]
        self.additional, self.departures = ET.Element("additional"), []
        self.stops, self.lines = {}, []  # by edge; the edges with stops of each line

    def write(self):
        for kind, more in (("bus", {"length": "12", "personCapacity": "60"}), ("bicycle", {}),
                           ("taxi", {"personCapacity": "3"})):
            made = ET.SubElement(self.additional, "vType", id=kind, vClass=kind, **more)
            if kind == "taxi":
                ET.SubElement(made, "param", key="has.taxi.device", value="true")
        for number in range(BUS_LINES):
            self.bus_line(number)
        for number in range(TAXIS):
            self.taxi(number)
        for number in range(BICYCLES):
            self.trip(f"bicycle{number}", type="bicycle")
        for number in range(CARS):
            self.trip(f"car{number}", parks=number % 10 == 0)
        for number in range(PEOPLE):
            self.person(number)
        ET.ElementTree(self.additional).write(self.folder / "s.add.xml")
        routes = ET.Element("routes")
        routes.extend(element for _, element in sorted(self.departures, key=lambda one: one[0]))
        ET.ElementTree(routes).write(self.folder / "s.rou.xml")

    def depart(self, tag, id_, time, **attributes):
        element = ET.Element(tag, id=id_, **attributes)
        element.set("begin" if tag == "flow" else "depart", f"{time:.0f}")
        self.departures.append((time, element))
        return element

    @staticmethod
    def lane_of(edge, kind):
        return next(lane for lane in edge.getLanes() if lane.allows(kind))

    def bus_stop(self, edge):
        end = edge.getLength() - 15.0
        if edge.getID() not in self.stops:
            self.stops[edge.getID()] = f"stop_{edge.getID()}"
            ET.SubElement(self.additional, "busStop", id=self.stops[edge.getID()],
                          lane=self.lane_of(edge, "bus").getID(), startPos=f"{end - 15.0:.1f}",
                          endPos=f"{end:.1f}")
        return self.stops[edge.getID()]

    def bus_line(self, number):
        way, length = None, 0.0
        while not way or length < 500.0:
            way, length = self.net.getShortestPath(*self.random.sample(self.edges, 2), vClass="bus")
        flow = self.depart("flow", f"bus{number}", self.random.randint(0, 60), type="bus",
                           end=str(SECONDS + 1500), period="90", line=f"L{number}")
        ET.SubElement(flow, "route", edges=" ".join(edge.getID() for edge in way))
        self.lines.append([edge for edge in way if edge in self.edges])
        for edge in self.lines[-1]:
            ET.SubElement(flow, "stop", busStop=self.bus_stop(edge), duration="12")

    def taxi(self, number):
        edge = self.random.choice(self.edges)
        taxi = self.depart("trip", f"taxi{number}", 0, type="taxi", **{"from": edge.getID()})
        ET.SubElement(taxi, "stop", lane=self.lane_of(edge, "taxi").getID(), triggered="person",
                      endPos=f"{edge.getLength() - 8.0:.1f}", parking="true")

    def trip(self, id_, parks=False, **attributes):
        start, end = self.random.sample(self.edges, 2)
        trip = self.depart("trip", id_, self.random.uniform(0, SECONDS), **attributes,
                           **{"from": start.getID(), "to": end.getID()})
        if parks:
            ET.SubElement(trip, "stop", lane=self.lane_of(end, "passenger").getID(), duration="40",
                          endPos=f"{end.getLength() - 10.0:.1f}", parking="true")

    def person(self, number):
        start, end = self.random.sample(self.edges, 2)
        there = {"from": start.getID(), "to": end.getID()}
        person = self.depart("person", f"p{number}", self.random.uniform(0, SECONDS),
                             departPos=f"{self.random.uniform(1.0, start.getLength() - 1.0):.1f}")
        kind = number % 10
        if kind < 3:
            ET.SubElement(person, "personTrip", modes="taxi" if kind == 0 else "public", **there)
        elif kind < 6:
            self.ride(person, start, end)
        else:
            ET.SubElement(person, "walk", **there)
        if kind == 6:
            ET.SubElement(person, "stop", edge=end.getID(), duration="30")
            ET.SubElement(person, "walk", **{"from": end.getID(), "to": start.getID()})


    def ride(self, person, start, end):
        """On foot to a bus, and from it."""
        line = self.random.randrange(len(self.lines))
        get_in, get_out = sorted(self.random.sample(range(len(self.lines[line])), 2))
        on, off = self.lines[line][get_in], self.lines[line][get_out]
        ET.SubElement(person, "walk", busStop=self.bus_stop(on), **{"from": start.getID()})
        ET.SubElement(person, "ride", busStop=self.bus_stop(off), lines=f"L{line}")
        ET.SubElement(person, "walk", **{"from": off.getID(), "to": end.getID()})


def write_zones(folder, net):
    by_junction = {}
    for edge in net.getEdges():
        if edge.allows("pedestrian"):
            by_junction.setdefault(edge.getToNode().getID(), []).append(edge.getID())
    everything = sum(by_junction.values(), [])
    for name, zones in (("all", {"all": everything}), ("junctions", by_junction)):
        root = ET.Element("zones")
        for zone, edges in zones.items():
            ET.SubElement(root, "zone", id=zone, edges=" ".join(edges))
        ET.ElementTree(root).write(folder / f"{name}.zone.xml")


def make_scenario(folder, net, seed):
    folder.mkdir(parents=True, exist_ok=True)
    call("netgenerate", *NETS[net], "--seed", seed, "--sidewalks.guess", "--default.sidewalk-width", 2,
         "--crossings.guess", "--tls.guess", "--no-turnarounds", "-o", "n.net.xml", folder=folder)
    demand = Demand(folder, seed)
    demand.write()
    write_zones(folder, demand.net)
    config = folder / "s.sumocfg"
    config.write_text(
        '<configuration><net-file value="n.net.xml"/><additional-files value="s.add.xml"/>'
        f'<route-files value="s.rou.xml"/><end value="{END}"/><seed value="{seed}"/>'
        '<device.taxi.dispatch-algorithm value="greedy"/></configuration>')
    return config


def run(command, folder):
    """{id: ([kind of stage], [s] duration)} of those who arrived, and how often what went wrong."""
    folder.mkdir()
    said = call(*command, "--no-step-log", "true", "--tripinfo-output", folder / "trips.xml")
    arrived = {}
    for trip in ET.parse(folder / "trips.xml").getroot():
        stages = list(trip) if trip.tag == "personinfo" else [trip]
        if all(float(stage.get("arrival", "0")) >= 0.0 for stage in stages):
            arrived[trip.get("id")] = ([stage.tag for stage in stages],
                                       sum(float(stage.get("duration", "0")) for stage in stages))
    return arrived, {word: said.count(word) for word in ("Teleporting", "collision")}


def faults_of(plain, ours):
    (before, wrong_before), (after, wrong_after) = plain, ours
    missing = sorted(before.keys() - after.keys())
    others = sorted(one for one in before.keys() & after.keys() if before[one][0] != after[one][0])
    people = [one for one in before if one.startswith("p") and one in after]
    mean, mean_before = (statistics.mean(found[one][1] for one in people)
                         for found in (after, before))
    rides = sum(stages.count("ride") for stages, _ in before.values())
    print(f"{len(after)} of {len(before)} arrive, {rides} rides, people after {mean:.0f} s, in plain "
          f"SUMO {mean_before:.0f} s; {wrong_after}, in plain SUMO {wrong_before}", flush=True)
    faults = [f"only {rides} rides"] if rides < LEAST_RIDES else []
    if missing:
        faults.append(f"{len(missing)} do not arrive: {missing[:5]}")
    if others:
        faults.append(f"{len(others)} have other stages: {others[:5]}")
    if abs(mean / mean_before - 1.0) > TOLERANCE:
        faults.append(f"people take {mean / mean_before:.3f} times as long")
    faults += [f"{word}: {number}" for word, number in wrong_after.items()
               if number > wrong_before[word] + FEW]
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pedzone", type=Path)
    parser.add_argument("--nets", default="grid,spider")
    parser.add_argument("--zones", default="all,junctions")
    parser.add_argument("--seeds", default="3")
    parser.add_argument("--keep", type=Path)
    options = parser.parse_args()
    faults = []
    with tempfile.TemporaryDirectory() as temporary:
        for net in options.nets.split(","):
            for seed in options.seeds.split(","):
                folder = (options.keep or Path(temporary)) / f"{net}-{seed}"
                config = make_scenario(folder, net, int(seed))
                plain = run(["sumo", "-c", config], folder / "plain")
                for zones in options.zones.split(","):
                    ours = run([options.pedzone, "run", config, "--quiet", "--zone",
                                folder / f"{zones}.zone.xml", "--"], folder / zones)
                    print(f"{net}, seed {seed}, {zones}: ", end="")
                    faults += [f"{net}, seed {seed}, {zones}: {fault}"
                               for fault in faults_of(plain, ours)]
    for fault in faults:
        print(f"Error: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
