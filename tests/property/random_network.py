"""Random networks with random shared space, from SUMO's own generator."""

import math
import os
import random
import subprocess
import xml.etree.ElementTree as ET
from dataclasses import dataclass, field
from pathlib import Path

LIVING_STREET = {"type": "highway.living_street", "speed": "2.78",
                 "disallow": "tram rail_urban rail rail_electric rail_fast ship"}
PEDESTRIAN_STREET = {"type": "highway.pedestrian", "speed": "2.78",
                     "allow": "pedestrian delivery bicycle"}
FOOT_STREET = {"type": "highway.pedestrian", "speed": "2.78", "allow": "pedestrian"}
SLOW_LANE = {"type": "highway.service", "speed": "5.55",
             "allow": "pedestrian passenger delivery bicycle"}
# SUMO's own tools need it to find their schemas; pedzone finds them itself.
SUMO_ENVIRONMENT = {"SUMO_HOME": "/usr/share/sumo", **os.environ}
SHARED_TYPES = (LIVING_STREET, LIVING_STREET, PEDESTRIAN_STREET, FOOT_STREET, SLOW_LANE)


@dataclass
class Lane:
    """A lane as the network file has it."""
    id: str
    length: float
    allow: str
    disallow: str
    shape: list

    def permits(self, vehicle_class: str) -> bool:
        if self.allow:
            return vehicle_class in self.allow.split() or self.allow == "all"
        return vehicle_class not in self.disallow.split() and self.disallow != "all"


@dataclass
class Edge:
    id: str
    type: str
    lanes: list = field(default_factory=list)

    def lane_for(self, vehicle_class: str):
        """The rightmost lane that the class may use, or None."""
        return next((lane for lane in self.lanes if lane.permits(vehicle_class)), None)

    @property
    def length(self) -> float:
        return self.lanes[0].length

    @property
    def shared(self) -> bool:
        return self.type in {kind["type"] for kind in SHARED_TYPES}


def read_edges(net_file: Path) -> list:
    """The ordinary edges of a network."""
    edges = []
    for node in ET.parse(net_file).getroot().iter("edge"):
        if node.get("function", "normal") != "normal":
            continue
        edge = Edge(node.get("id"), node.get("type", ""))
        for lane in node.iter("lane"):
            shape = [tuple(map(float, p.split(",")[:2])) for p in lane.get("shape").split()]
            edge.lanes.append(Lane(lane.get("id"), float(lane.get("length")),
                                   lane.get("allow", ""), lane.get("disallow", ""), shape))
        edges.append(edge)
    return edges


def generator_options(rng: random.Random) -> list:
    """Shape of the street network: a grid, a spider's web, or a random one."""
    kind = rng.choice(("grid", "spider", "rand"))
    if kind == "grid":
        options = ["--grid", f"--grid.x-number={rng.randint(2, 4)}",
                   f"--grid.y-number={rng.randint(2, 4)}",
                   f"--grid.x-length={rng.uniform(25, 80):.1f}",
                   f"--grid.y-length={rng.uniform(25, 80):.1f}"]
        if rng.random() < 0.5:
            options.append(f"--grid.attach-length={rng.uniform(20, 60):.1f}")
    elif kind == "spider":
        options = ["--spider", f"--spider.arm-number={rng.randint(3, 7)}",
                   f"--spider.circle-number={rng.randint(1, 3)}",
                   f"--spider.space-radius={rng.uniform(25, 60):.1f}"]
        if rng.random() < 0.3:
            options.append("--spider.omit-center")
    else:
        options = ["--rand", f"--rand.iterations={rng.randint(8, 30)}",
                   "--rand.min-distance=25", "--rand.max-distance=90",
                   f"--rand.min-angle={rng.choice((30, 45))}",
                   f"--bidi-probability={rng.choice((0.6, 1))}"]
    return options + [f"--seed={rng.randrange(1 << 30)}",
                      f"--default.lanenumber={rng.choice((1, 1, 2))}"]


def converter_options(rng: random.Random) -> list:
    """What there is for pedestrians at junctions and beside the ordinary streets."""
    options = ["--no-turnarounds.tls" if rng.random() < 0.3 else "--no-turnarounds=false"]
    if rng.random() < 0.67:
        options.append("--sidewalks.guess")
        if rng.random() < 0.67:
            options += ["--crossings.guess", "--crossings.guess.speed-threshold=20"]
    if rng.random() < 0.5:
        options.append("--walkingareas")
    options.append(f"--junctions.corner-detail={rng.choice((0, 5))}")
    return options


def choose_streets(rng: random.Random, nodes: dict, streets: list) -> set:
    """Which streets (pairs of nodes) become shared space."""
    pattern = rng.choice(("patch", "patch", "scattered", "all", "single"))
    if pattern == "all":
        return set(streets)
    if pattern == "single":
        return {rng.choice(streets)}
    if pattern == "scattered":
        return {street for street in streets if rng.random() < 0.35} or {rng.choice(streets)}
    centre = nodes[rng.choice(sorted(nodes))]
    radius = rng.uniform(0.25, 0.6) * max(math.dist(centre, place) for place in nodes.values())
    near = {street for street in streets
            if all(math.dist(nodes[end], centre) <= radius for end in street)}
    return near or {rng.choice(streets)}


def share_streets(rng: random.Random, folder: Path) -> None:
    """Turns random streets of plain.*.xml into shared space, adds traffic lights and short edges."""
    node_tree = ET.parse(folder / "plain.nod.xml")
    nodes = {}
    for node in node_tree.getroot().iter("node"):
        nodes[node.get("id")] = (float(node.get("x")), float(node.get("y")))
        if rng.random() < 0.2 and node.get("type") in (None, "priority", "traffic_light"):
            node.set("type", "traffic_light")
    node_tree.write(folder / "plain.nod.xml")

    edge_tree = ET.parse(folder / "plain.edg.xml")
    edges = list(edge_tree.getroot().iter("edge"))
    street_of = {edge: tuple(sorted((edge.get("from"), edge.get("to")))) for edge in edges}
    chosen = choose_streets(rng, nodes, sorted(set(street_of.values())))
    kind_of = {street: rng.choice(SHARED_TYPES) for street in sorted(chosen)}
    if rng.random() < 0.5:
        one_kind = rng.choice(SHARED_TYPES)
        kind_of = dict.fromkeys(kind_of, one_kind)
    width_of = {street: rng.choice((2.0, 3.2, 4.5, 6.0)) for street in sorted(chosen)}
    for edge in edges:
        street = street_of[edge]
        if street in chosen:
            for attribute in ("allow", "disallow"):
                edge.attrib.pop(attribute, None)
            edge.attrib.update(kind_of[street])
            edge.set("width", f"{width_of[street]:g}")
            if rng.random() < 0.7:
                edge.set("numLanes", "1")
        if rng.random() < 0.04:  # a short edge, as maps have them
            ET.SubElement(edge, "split", {"pos": f"{rng.choice((-1, 1)) * rng.uniform(9, 18):.2f}"})
    edge_tree.write(folder / "plain.edg.xml")


def rectangle(rng: random.Random, centre: tuple, least: float, most: float) -> list:
    """A turned rectangle of random size round a point."""
    angle = rng.uniform(0, math.pi)
    half_x, half_y = (0.5 * rng.uniform(least, most) for _ in range(2))
    return [(centre[0] + x * math.cos(angle) - y * math.sin(angle),
             centre[1] + x * math.sin(angle) + y * math.cos(angle))
            for x, y in ((-half_x, -half_y), (half_x, -half_y), (half_x, half_y),
                         (-half_x, half_y))]


def write_polygons(rng: random.Random, edges: list, file: Path) -> None:
    """Buildings and squares near the shared streets, some of them dirty: over lanes, crossing
    themselves, with repeated points."""
    root = ET.Element("additional")
    shared = [edge for edge in edges if edge.shared] or edges
    for i in range(rng.choice((0, 3, 12))):
        place = rng.choice(rng.choice(shared).lanes[0].shape)
        distance, angle = rng.uniform(2, 25), rng.uniform(0, 2 * math.pi)
        centre = (place[0] + distance * math.cos(angle), place[1] + distance * math.sin(angle))
        ring = rectangle(rng, centre, 1.0, 14.0)
        if rng.random() < 0.15:
            ring[1], ring[2] = ring[2], ring[1]  # a bow tie
        if rng.random() < 0.3:
            ring.append(ring[0])
        kind = rng.choice(("building", "building", "jupedsim.obstacle", "pedzone.obstacle",
                           "jupedsim.walkable_area", "pedzone.walkable"))
        ET.SubElement(root, "poly", {
            "id": f"poly{i}", "type": kind, "color": "grey", "layer": "0",
            "shape": " ".join(f"{x:.2f},{y:.2f}" for x, y in ring)})
    ET.ElementTree(root).write(file)


def run_tool(command: list, folder: Path) -> None:
    """Runs one of SUMO's tools; raises subprocess.CalledProcessError with its words."""
    subprocess.run(command, cwd=folder, env=SUMO_ENVIRONMENT, check=True, timeout=120,
                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                   text=True)


def write_types(file: Path) -> None:
    """The types by name, which netconvert wants to know."""
    root = ET.Element("types")
    for name in sorted({kind["type"] for kind in SHARED_TYPES}):
        ET.SubElement(root, "type", {"id": name})
    ET.ElementTree(root).write(file)


def make_network(rng: random.Random, folder: Path) -> list:
    """Writes net.net.xml and polygons.add.xml into the folder and returns the edges."""
    run_tool(["netgenerate", "--plain-output-prefix", "plain", *generator_options(rng)], folder)
    share_streets(rng, folder)
    write_types(folder / "types.typ.xml")
    run_tool(["netconvert", "-t", "types.typ.xml", "-n", "plain.nod.xml", "-e",
              "plain.edg.xml", "-o", "net.net.xml", *converter_options(rng)], folder)
    edges = read_edges(folder / "net.net.xml")
    write_polygons(rng, edges, folder / "polygons.add.xml")
    return edges
