"""Narrow streets in which people and vehicles meet: each a scene with a network, demand and a zone.

The streets have one lane of 3.2 m and no sidewalk, so people walk on the lane itself. SUMO's striping
has them keep to its edge, and its vehicles slow down for whom they would touch.
"""

import os
import random
import subprocess
import xml.etree.ElementTree as ET
from dataclasses import dataclass, field
from math import cos, radians, sin
from pathlib import Path

ENVIRONMENT = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
STREET = {"numLanes": "1", "speed": "8.33", "width": "3.2"}
TYPES = {"person": {"vClass": "pedestrian"},
         "car": {"vClass": "passenger"},
         "van": {"vClass": "delivery", "length": "6.5", "width": "2.16"},
         "bus": {"vClass": "bus", "length": "9", "width": "2.5"}}


@dataclass
class Scene:
    """What netconvert and SUMO are given; zone: ids of edges, separated by spaces."""
    nodes: dict                    # id -> (x, y) or (x, y, type)
    edges: dict                    # id -> (from, to, further attributes)
    zone: str
    demand: list = field(default_factory=list)  # (depart [s], element)
    sidewalks: bool = False
    sumo_walks: bool = False  # people where they meet vehicles: it walks them through these

    def person(self, name: str, depart: float, edges: str, **walk) -> "Scene":
        node = ET.Element("person", {"id": name, "type": "person", "depart": f"{depart:g}"})
        if "departPos" in walk:
            node.set("departPos", walk.pop("departPos"))
        ET.SubElement(node, "walk", {"edges": edges, **walk})
        self.demand.append((depart, node))
        return self

    def vehicle(self, name: str, depart: float, edges: str, kind: str = "car", stop=None,
                **more) -> "Scene":
        node = ET.Element("vehicle", {"id": name, "type": kind, "depart": f"{depart:g}", **more})
        ET.SubElement(node, "route", {"edges": edges})
        if stop:
            ET.SubElement(node, "stop", stop)
        self.demand.append((depart, node))
        return self

    def write(self, folder: Path) -> tuple:
        """(sumocfg, zone file) in the folder."""
        folder.mkdir(parents=True, exist_ok=True)
        self.write_network(folder)
        routes = ET.Element("routes")
        for name, attributes in TYPES.items():
            ET.SubElement(routes, "vType", {"id": name, **attributes})
        routes.extend(node for _, node in sorted(self.demand, key=lambda pair: pair[0]))
        ET.ElementTree(routes).write(folder / "scene.rou.xml")
        config = ET.Element("configuration")
        for key, value in (("net-file", "scene.net.xml"), ("route-files", "scene.rou.xml"),
                           ("step-length", "0.5"), ("end", "1200"),
                           ("collision.check-junctions", "true"), ("collision.action", "warn")):
            ET.SubElement(config, key, {"value": value})
        ET.ElementTree(config).write(folder / "scene.sumocfg")
        zones = ET.Element("zones")
        ET.SubElement(zones, "zone", {"id": "shared", "edges": self.zone})
        ET.ElementTree(zones).write(folder / "scene.zone.xml")
        return folder / "scene.sumocfg", folder / "scene.zone.xml"

    def write_network(self, folder: Path) -> None:
        nodes, edges = ET.Element("nodes"), ET.Element("edges")
        for name, (x, y, *kind) in self.nodes.items():
            ET.SubElement(nodes, "node", {"id": name, "x": f"{x}", "y": f"{y}", **dict(zip(["type"], kind))})
        for name, (start, end, more) in self.edges.items():
            ET.SubElement(edges, "edge", {"id": name, "from": start, "to": end, **STREET, **more})
        ET.ElementTree(nodes).write(folder / "scene.nod.xml")
        ET.ElementTree(edges).write(folder / "scene.edg.xml")
        options = ["--crossings.guess", "--crossings.guess.speed-threshold=20"] if self.sidewalks else []
        subprocess.run(["netconvert", "-n", "scene.nod.xml", "-e", "scene.edg.xml", "-o",
                        "scene.net.xml", "--no-turnarounds", *options], cwd=folder, check=True,
                       env=ENVIRONMENT, stdout=subprocess.DEVNULL)


def street(zone: str = "before lane after") -> Scene:
    """Three edges in a row, 60, 100 and 60 m."""
    return Scene({"a": (0, 0), "b": (60, 0), "c": (160, 0), "d": (220, 0)},
                 {"before": ("a", "b", {}), "lane": ("b", "c", {}), "after": ("c", "d", {})}, zone)


WHOLE = "before lane after"


def cars(scene: Scene, count: int, first: float, apart: float = 3.0, kind: str = "car") -> Scene:
    for k in range(count):
        scene.vehicle(f"{kind}{k}", first + apart * k, WHOLE, kind)
    return scene


def head_on(count: int, zone: str = WHOLE, kind: str = "car") -> Scene:
    """One walks against the traffic."""
    scene = street(zone)
    scene.person("walker", 0, "after lane before", departPos="50", arrivalPos="5")
    return cars(scene, count, 10, kind=kind)


def from_behind(count: int, zone: str = WHOLE, kind: str = "car") -> Scene:
    """One walks ahead of the traffic."""
    scene = street(zone)
    scene.person("walker", 0, WHOLE, departPos="30", arrivalPos="55")
    return cars(scene, count, 10, kind=kind)


def within_lane(forward: bool, count: int, departs: float, kind: str = "car") -> Scene:
    """The walk begins and ends on the one edge of the zone, where cars come through."""
    scene = street("lane")
    ends = {"departPos": "12", "arrivalPos": "90"}
    if not forward:
        ends = {"departPos": "90", "arrivalPos": "12"}
    scene.person("walker", 0, "lane", **ends)
    return cars(scene, count, departs, kind=kind)


def one_edge(forward: bool, count: int, kind: str = "car") -> Scene:
    """Network of one edge: nothing but the lane."""
    scene = Scene({"a": (0, 0), "b": (100, 0)}, {"lane": ("a", "b", {})}, "lane")
    ends = {"departPos": "20", "arrivalPos": "96"}
    if not forward:
        ends = {"departPos": "96", "arrivalPos": "20"}
    scene.person("walker", 0, "lane", **ends)
    for k in range(count):
        scene.vehicle(f"{kind}{k}", 5 + 3 * k, "lane", kind)
    return scene


def stopped(forward: bool, kind: str = "car") -> Scene:
    """A vehicle stands in the lane for two minutes; people of both directions come by."""
    scene = street()
    scene.vehicle("standing", 0, WHOLE, kind,
                  stop={"lane": "lane_0", "endPos": "50", "duration": "120"})
    for k in range(3):
        if forward:
            scene.person(f"walker{k}", 10 + 5 * k, WHOLE, departPos="30", arrivalPos="55")
        else:
            scene.person(f"walker{k}", 10 + 5 * k, "after lane before", departPos="50",
                         arrivalPos="5")
    return scene


def crowd_before(kind: str = "van", people: int = 60) -> Scene:
    """A vehicle stands for five minutes in a lane that leaves 0.9 m beside it: for one person at a time. Every two
    seconds somebody comes, head-on."""
    wide = {"width": "4"}
    scene = Scene({"a": (0, 0), "b": (60, 0), "c": (220, 0)}, {"before": ("a", "b", wide), "lane": ("b", "c", wide)},
                  "before lane")
    scene.vehicle("standing", 0, "before lane", kind, stop={"lane": "lane_0", "endPos": "60", "duration": "300"})
    for k in range(people):
        scene.person(f"walker{k}", 25 + 2 * k, "lane", departPos="100", arrivalPos="20")
    return scene


def both_ways(count: int, kind: str = "car", people: int = 5) -> Scene:
    """People of both directions meet beside vehicles that follow each other."""
    scene = street()
    for k in range(people):
        scene.person(f"there{k}", 2 * k, WHOLE, departPos="30", arrivalPos="55")
        scene.person(f"back{k}", 2 * k, "after lane before", departPos="50", arrivalPos="5")
    return cars(scene, count, 30, kind=kind)


def corner(angle: int, people: int, seed: int, vans: int = 8) -> Scene:
    """A street with a corner of `angle` [deg], walls on both sides, with many people of both directions. A vehicle
    that is longer than the street is wide covers nearly all of it at the corner, and SUMO swings its rear."""
    rng = random.Random(seed)

    def past(way: float) -> tuple:  # a place so far [m] past the corner
        return 60 + way * cos(radians(angle)), way * sin(radians(angle))

    shape = " ".join(f"{x:.2f},{y:.2f}" for x, y in ((0, 0), (60, 0), past(60)))
    scene = Scene({"w": (-40, 0), "a": (0, 0), "d": past(60), "e": past(100)},
                  {"before": ("w", "a", {}), "lane": ("a", "d", {"shape": shape}), "after": ("d", "e", {})}, WHOLE)
    for k in range(people):
        name, edges = (f"there{k}", WHOLE) if k % 2 else (f"back{k}", "after lane before")
        scene.person(name, round(rng.uniform(0, 3 * people), 1), edges,
                     departPos=f"{rng.uniform(2, 38):.1f}", arrivalPos=f"{rng.uniform(2, 38):.1f}")
    for k in range(vans):
        scene.vehicle(f"van{k}", 30 + 50 * k, WHOLE, "van")
    return scene


def two_lanes(count: int, kind: str = "car", people: int = 12, width: str = "3.2") -> Scene:
    """A street of two lanes: vehicles meet side by side before people of both directions."""
    lane = {"width": width}
    scene = Scene({"a": (0, 0), "b": (150, 0)},
                  {"there": ("a", "b", lane), "back": ("b", "a", lane)}, "there back")
    for k in range(people):
        scene.person(f"there{k}", k, "there", departPos="40", arrivalPos="140")
        scene.person(f"back{k}", k, "back", departPos="40", arrivalPos="140")
    for k in range(count):
        scene.vehicle(f"east{k}", 15 + 4 * k, "there", kind)
        scene.vehicle(f"west{k}", 15 + 4 * k, "back", kind)
    return scene


def shared_end(seed: int, width: str = "3.5", people: int = 30, vehicles: int = 12) -> Scene:
    """A shared street ends at one with sidewalks: people and cars leave it there together. By SUMO's stripes a car of
    1.8 m fills such a lane at the right, where people walk."""
    lane, walk = {"width": width, "speed": "5.5", "allow": "pedestrian passenger"}, {"sidewalkWidth": "2.5"}
    scene = Scene({"w": (-100, 0), "a": (0, 0), "b": (200, 0), "e": (300, 0)},
                  {"aw": ("a", "w", walk), "wa": ("w", "a", walk), "ab": ("a", "b", lane), "ba": ("b", "a", lane),
                   "be": ("b", "e", walk), "eb": ("e", "b", walk)}, "ab ba", sidewalks=True)
    rng = random.Random(seed)
    for k in range(people):
        scene.person(f"walker{k}", 2 * k + rng.random(), "ba aw", departPos="60", arrivalPos="40")
    for k in range(vehicles):
        scene.vehicle(f"car{k}", 10 + 4 * k + rng.random(), "eb ba aw")
    return scene


def zone_end(seed: int, people: int = 20, vans: int = 10) -> Scene:
    """A zone of one street ends at a junction that it shares with two ordinary ones: vans come
    through the junction, people leave the zone over it."""
    rng = random.Random(seed)
    nodes = {"w": (-80, 0), "m": (0, 0), "e": (80, 0), "n": (0, 80), "s": (0, -80)}
    edges = {}
    for other in "wens":
        walk = {} if other == "s" else {"sidewalkWidth": "2"}
        edges[f"{other}m"] = (other, "m", walk)
        edges[f"m{other}"] = ("m", other, walk)
    scene = Scene(nodes, edges, "sm ms", sidewalks=True)
    for k in range(people):
        goal = rng.choice("wen")
        depart = round(rng.uniform(0, 120), 1)
        if rng.random() < 0.5:
            scene.person(f"out{k}", depart, f"sm m{goal}", departPos="10", arrivalPos="50")
        else:
            scene.person(f"in{k}", depart, f"{goal}m ms", departPos="40", arrivalPos="60")
    for k in range(vans):
        start, end = rng.sample("wens", 2)
        scene.vehicle(f"van{k}", round(rng.uniform(0, 150), 1), f"{start}m m{end}", "van")
    return scene


def footpath(kind: str = "car", people: int = 15) -> Scene:
    """A footpath that is drawn over a road, as maps have them: it begins at a junction with lights, under the
    vehicles that wait there, and leaves the road by and by."""
    walk = {"sidewalkWidth": "2"}
    scene = Scene({"b": (-80, -30), "j": (0, 0, "traffic_light"), "a": (100, 34), "q": (90, 45), "s": (20, -80)},
                  {"in": ("a", "j", walk), "out": ("j", "b", walk), "side": ("s", "j", walk),
                   "path": ("j", "q", {"allow": "pedestrian", "width": "2", "shape": "0,0 40,17 90,45"})},
                  "path out", sidewalks=True, sumo_walks=True)
    for k in range(people):
        scene.person(f"walker{k}", 40 * k, "out path", departPos="10", arrivalPos="40")
    for k in range(2 * people):
        scene.vehicle(f"{kind}{k}", 20 * k, "in out", kind)
        scene.vehicle(f"side{k}", 20 * k, "side out", kind)
    return scene


SCENES = {}
for _count in (1, 3):
    for _kind in ("car", "van", "bus"):
        SCENES[f"head-on-{_count}-{_kind}"] = head_on(_count, kind=_kind)
        SCENES[f"from-behind-{_count}-{_kind}"] = from_behind(_count, kind=_kind)
        SCENES[f"within-forward-{_count}-{_kind}"] = within_lane(True, _count, 4, kind=_kind)
        SCENES[f"within-back-{_count}-{_kind}"] = within_lane(False, _count, 4, kind=_kind)
        SCENES[f"one-edge-forward-{_count}-{_kind}"] = one_edge(True, _count, kind=_kind)
        SCENES[f"one-edge-back-{_count}-{_kind}"] = one_edge(False, _count, kind=_kind)
for _kind in ("car", "van", "bus"):
    SCENES[f"stopped-forward-{_kind}"] = stopped(True, _kind)
    SCENES[f"stopped-back-{_kind}"] = stopped(False, _kind)
    SCENES[f"crowd-before-{_kind}"] = crowd_before(_kind)
    SCENES[f"both-ways-{_kind}"] = both_ways(3, _kind)
    SCENES[f"two-lanes-{_kind}"] = two_lanes(3, _kind)
    SCENES[f"footpath-{_kind}"] = footpath(_kind)
for _seed in range(1, 6):
    SCENES[f"shared-end-{_seed}"] = shared_end(_seed)
for _width in ("2.6", "2.8"):
    SCENES[f"two-lanes-{_width}m"] = two_lanes(3, "van", width=_width)
