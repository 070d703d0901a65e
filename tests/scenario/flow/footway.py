"""Footways as a user would make them: plain XML, netconvert, its defaults."""
import os
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

ENVIRONMENT = {**os.environ, "SUMO_HOME": os.environ.get("SUMO_HOME", "/usr/share/sumo")}
SHAPES = ("straight", "bent", "walking-area")
ROAD_SPEED = 13.89  # [m/s] 50 km/h
ARM = 30.0  # [m] side arms that make a junction's walking area as wide as it is long


def write_xml(path, root):
    ET.ElementTree(root).write(path, encoding="utf-8", xml_declaration=True)


def _netconvert(folder, nodes, edges, *options):
    """Writes FOLDER/town.net.xml; nodes: {id: (x, y)}, edges: [{attribute: value}]."""
    root = ET.Element("nodes")
    for name, (x, y) in nodes.items():
        ET.SubElement(root, "node", {"id": name, "x": f"{x:g}", "y": f"{y:g}"})
    write_xml(folder / "town.nod.xml", root)
    root = ET.Element("edges")
    for edge in edges:
        ET.SubElement(root, "edge", edge)
    write_xml(folder / "town.edg.xml", root)
    subprocess.run(["netconvert", "-n", "town.nod.xml", "-e", "town.edg.xml", "-o", "town.net.xml",
                    "--no-warnings", *options], cwd=folder, check=True, env=ENVIRONMENT,
                   stdout=subprocess.DEVNULL)


def _footway(name, start, end, width):
    return {"id": name, "from": start, "to": end, "numLanes": "1", "allow": "pedestrian",
            "width": f"{width:g}", "speed": "2.78"}


def make_footway(folder, shape, width, length=100.0):
    """A footway for people only from a over b to c, `length` m in all; returns its edges in turn.

    straight:  a---------------c      walking-area:       n
    bent:      a-------b                            a-----+-----c   (+: b's walking area)
                       |                                  s
                       c
    """
    half = length / 2
    if shape == "straight":
        _netconvert(folder, {"a": (0, 0), "c": (length, 0)}, [_footway("ac", "a", "c", width)])
        return ["ac"]
    edges = [_footway("ab", "a", "b", width), _footway("bc", "b", "c", width)]
    if shape == "bent":
        _netconvert(folder, {"a": (0, 0), "b": (half, 0), "c": (half, -half)}, edges)
        return ["ab", "bc"]
    if shape != "walking-area":
        raise ValueError(f"shape '{shape}' is none of {', '.join(SHAPES)}")
    edges += [_footway("nb", "n", "b", width), _footway("bs", "b", "s", width)]
    nodes = {"a": (0, 0), "b": (half, 0), "c": (length, 0), "n": (half, ARM), "s": (half, -ARM)}
    _netconvert(folder, nodes, edges, "--walkingareas")
    return ["ab", "bc"]


def make_street(folder, width, length=100.0):
    """Edges ab and bc, each `length` m: a lane for vehicles (lane 1) and on its right a sidewalk of
    netconvert's (lane 0), along which people walk both ways. Returns the edges in turn."""
    edges = [{"id": name, "from": name[0], "to": name[1], "numLanes": "1",
              "speed": f"{ROAD_SPEED}", "sidewalkWidth": f"{width:g}"} for name in ("ab", "bc")]
    _netconvert(folder, {"a": (0, 0), "b": (length, 0), "c": (2 * length, 0)}, edges)
    return ["ab", "bc"]


def write_scenario(folder, edges, routes, additional, step_length, end, zone_lanes=None):
    """Writes routes, stops, zone file and FOLDER/town.sumocfg, whose path it returns.

    routes and additional are XML elements; the zone is these edges, or these lanes of theirs.
    """
    write_xml(folder / "town.rou.xml", routes)
    files = {"net-file": "town.net.xml", "route-files": "town.rou.xml"}
    if additional is not None:
        write_xml(folder / "town.add.xml", additional)
        files["additional-files"] = "town.add.xml"
    root = ET.Element("configuration")
    for name, value in {**files, "step-length": f"{step_length:g}", "end": f"{end:g}"}.items():
        ET.SubElement(root, name, {"value": value})
    write_xml(folder / "town.sumocfg", root)
    zones = ET.Element("zones")
    where = {"lanes": " ".join(zone_lanes)} if zone_lanes else {"edges": " ".join(edges)}
    ET.SubElement(zones, "zone", {"id": "footway", **where})
    write_xml(folder / "town.zone.xml", zones)
    return Path(folder) / "town.sumocfg"
