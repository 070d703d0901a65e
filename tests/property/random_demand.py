"""Random persons and vehicles for a network: plans, places and times, as route files."""

import random
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

from random_network import Edge, run_tool

DEPART_WINDOW = 60.0  # [s] everybody departs within


def route_trips(folder: Path, trips: list, vehicle_class: str) -> dict:
    """Routes (id, from, to) trips by SUMO's router; those without a way are missing in the answer.
    Returns {id: [edge ids]}."""
    if not trips:
        return {}
    root = ET.Element("routes")
    if vehicle_class == "pedestrian":
        for trip, start, end in trips:
            person = ET.SubElement(root, "person", {"id": trip, "depart": "0"})
            ET.SubElement(person, "walk", {"from": start, "to": end})
    else:
        ET.SubElement(root, "vType", {"id": "type", "vClass": vehicle_class})
        for trip, start, end in trips:
            ET.SubElement(root, "trip", {"id": trip, "type": "type", "depart": "0",
                                         "from": start, "to": end})
    ET.ElementTree(root).write(folder / "trips.xml")
    if not trips:
        return {}
    try:
        run_tool(["duarouter", "-n", "net.net.xml", "-r", "trips.xml", "-o", "routed.xml",
                  "--ignore-errors", "--no-warnings"], folder)
    except subprocess.CalledProcessError:
        return {}
    routed = {}
    for node in ET.parse(folder / "routed.xml").getroot():
        part = node.find("walk" if node.tag == "person" else "route")
        if part is not None and part.get("edges"):
            routed[node.get("id")] = part.get("edges").split()
    return routed


class Demand:
    """What moves in one random scenario."""

    def __init__(self, rng: random.Random, folder: Path, edges: list):
        self.rng, self.folder = rng, folder
        self.edge_of = {edge.id: edge for edge in edges}
        self.walkable = [edge for edge in edges if edge.lane_for("pedestrian")]
        self.drivable = [edge for edge in edges if edge.lane_for("delivery")]
        self.parkable = [edge for edge in self.drivable
                         if edge.length > 10 and edge.lane_for("pedestrian")]
        self.bus_line = None   # (first edge, last edge)
        self.departures = []   # (depart, element): SUMO drops what is not sorted
        self.stops = ET.Element("additional")

    def some_edge(self, edges: list) -> Edge:
        """An edge, more often a shared one than by chance."""
        shared = [edge for edge in edges if edge.shared]
        return self.rng.choice(shared if shared and self.rng.random() < 0.6 else edges)

    def position(self, edge: Edge) -> str:
        """A place along an edge, its very ends included."""
        share = self.rng.choice((0.0, 1.0, *[self.rng.random() for _ in range(6)]))
        return f"{share * max(0.0, edge.length - 0.1):.2f}"

    # --- persons ---

    def add_person_types(self) -> None:
        for i in range(3):
            ET.SubElement(self.stops, "vType", {
                "id": f"walker{i}", "vClass": "pedestrian",
                "maxSpeed": f"{self.rng.uniform(0.7, 1.9):.2f}",
                "width": f"{self.rng.uniform(0.35, 0.8):.2f}",
                "length": f"{self.rng.uniform(0.2, 0.9):.2f}",
                "speedFactor": f"normc(1.0,{self.rng.choice((0, 0.1, 0.2))},0.5,1.5)"})

    def add_persons(self, count: int) -> None:
        """Persons with plans of walks, stops and rides; groups depart at one place and time."""
        ways = self.route_plans(count)
        number = 0
        for i in range(count):
            way = ways.get(f"there{i}")
            if not way:
                continue
            depart = self.rng.uniform(0, DEPART_WINDOW)
            start, kind = self.position(self.edge_of[way[0]]), f"walker{self.rng.randrange(3)}"
            plan = self.rng.choice(("walk", "walk", "stop", "twice", "ride", "bus"))
            for _ in range(self.rng.choice((1, 1, 1, 2, 5))):
                person = ET.Element("person", {
                    "id": f"p{number}", "type": kind, "depart": f"{depart:.2f}",
                    "departPos": start})
                number += 1
                self.fill_plan(person, plan, i, ways)
                self.departures.append((depart, person))

    def route_plans(self, count: int) -> dict:
        """The ways of every plan that person i might get: there, back from there to somewhere
        (over the same edges again, perhaps), a drive on from there and the walk home from its end,
        the walks to and from the bus."""
        walks, drives = [], []
        for i in range(count):
            start, there, other = (self.some_edge(self.walkable).id for _ in range(3))
            walks += [(f"there{i}", start, there), (f"back{i}", there, other)]
            if self.bus_line:
                first, last = self.bus_line
                walks += [(f"to_bus{i}", start, first.id), (f"from_bus{i}", last.id, there)]
            if self.edge_of[there] in self.parkable:
                goal = self.some_edge(self.parkable).id
                drives.append((f"drive{i}", there, goal))
                walks.append((f"home{i}", goal, start))
        return (route_trips(self.folder, walks, "pedestrian") |
                route_trips(self.folder, drives, "delivery"))

    def fill_plan(self, person: ET.Element, plan: str, i: int, ways: dict) -> None:
        """Adds the stages of the plan, or a mere walk where the plan has no way."""
        there, back = ways[f"there{i}"], ways.get(f"back{i}")
        drive, home = ways.get(f"drive{i}"), ways.get(f"home{i}")
        to_bus, from_bus = ways.get(f"to_bus{i}"), ways.get(f"from_bus{i}")
        if plan == "twice" and back:
            self.walk(person, there + back[1:])
        elif plan == "stop" and back:
            self.walk(person, there)
            ET.SubElement(person, "stop", {
                "edge": there[-1], "duration": f"{self.rng.choice((0, 1, 12.5))}",
                "actType": "looking"})
            self.walk(person, back)
        elif plan == "ride" and drive and home:
            self.walk(person, there)
            self.ride(person, drive)
            self.walk(person, home)
        elif plan == "bus" and to_bus and from_bus:
            ET.SubElement(person, "walk", {"edges": " ".join(to_bus), "busStop": "first"})
            ET.SubElement(person, "ride", {"busStop": "last", "lines": "L"})
            self.walk(person, from_bus)
        else:
            self.walk(person, there)

    def walk(self, person: ET.Element, way: list) -> None:
        walk = ET.SubElement(person, "walk", {
            "edges": " ".join(way), "arrivalPos": self.position(self.edge_of[way[-1]])})
        if self.rng.random() < 0.3:
            walk.set("departPosLat", self.rng.choice(("random", "center", "right", "left")))

    def ride(self, person: ET.Element, drive: list) -> None:
        """Drives in an own car that waits for its driver."""
        car = f"car-{person.get('id')}"
        ET.SubElement(person, "ride", {"from": drive[0], "to": drive[-1], "lines": car})
        vehicle = ET.Element("vehicle", {"id": car, "type": "delivery", "depart": "triggered",
                                         "departPos": "last", "arrivalPos": "max"})
        ET.SubElement(vehicle, "route", {"edges": " ".join(drive)})
        self.departures.append((float(person.get("depart")), vehicle))

    # --- buses ---

    def add_bus(self) -> None:
        """A bus line between two stops, either of them perhaps in shared space."""
        long_enough = [edge for edge in self.parkable if edge.length > 16]
        if len(long_enough) < 2:
            return
        first, last = (self.some_edge(long_enough) for _ in range(2))
        way = route_trips(self.folder, [("bus", first.id, last.id)], "delivery").get("bus")
        if not way or first is last:
            return
        for name, edge in (("first", first), ("last", last)):
            ET.SubElement(self.stops, "busStop", {
                "id": name, "lane": edge.lane_for("delivery").id, "startPos": "2",
                "endPos": f"{min(edge.length - 1, 14):.2f}", "friendlyPos": "true"})
        for i in range(10):
            depart = 30.0 + 60.0 * i
            bus = ET.Element("vehicle", {"id": f"bus{i}", "type": "minibus", "line": "L",
                                         "depart": f"{depart:.2f}", "departPos": "0"})
            ET.SubElement(bus, "route", {"edges": " ".join(way)})
            for name in ("first", "last"):
                ET.SubElement(bus, "stop", {"busStop": name, "duration": "8"})
            self.departures.append((depart, bus))
        self.bus_line = (first, last)

    # --- vehicles ---

    def add_vehicles(self, count: int) -> None:
        for name, attributes in (("delivery", {"length": "5", "width": "1.9"}),
                                 ("minibus", {"length": "7", "width": "2.1"})):
            ET.SubElement(self.stops, "vType", {"id": name, "vClass": "delivery", **attributes})
        ET.SubElement(self.stops, "vType", {"id": "bicycle", "vClass": "bicycle"})
        for kind in ("delivery", "bicycle"):
            usable = [edge for edge in self.edge_of.values() if edge.lane_for(kind)]
            if not usable:
                continue
            trips = [(f"{kind}{i}", self.some_edge(usable).id, self.some_edge(usable).id)
                     for i in range(count)]
            for name, way in route_trips(self.folder, trips, kind).items():
                depart = self.rng.uniform(0, 2 * DEPART_WINDOW)
                vehicle = ET.Element("vehicle", {"id": name, "type": kind,
                                                 "depart": f"{depart:.2f}"})
                ET.SubElement(vehicle, "route", {"edges": " ".join(way)})
                last = self.edge_of[way[-1]]
                if self.rng.random() < 0.2 and last.length > 20:
                    ET.SubElement(vehicle, "stop", {
                        "lane": last.lane_for(kind).id, "endPos": "15", "duration": "20",
                        "parking": self.rng.choice(("true", "false"))})
                self.departures.append((depart, vehicle))

    def write(self) -> None:
        """stops.add.xml (types and bus stops) and routes.rou.xml."""
        ET.ElementTree(self.stops).write(self.folder / "stops.add.xml")
        root = ET.Element("routes")
        root.extend(element for _, element in sorted(self.departures, key=lambda pair: pair[0]))
        ET.ElementTree(root).write(self.folder / "routes.rou.xml")


def make_demand(rng: random.Random, folder: Path, edges: list) -> None:
    """Writes stops.add.xml and routes.rou.xml into the folder."""
    demand = Demand(rng, folder, edges)
    demand.add_person_types()
    demand.add_bus()
    demand.add_persons(rng.randint(8, 24))
    demand.add_vehicles(rng.choice((0, 3, 8)))
    demand.write()
