"""Turns the persons of a random scenario into people: profiles, activities, groups, families and
weather, by the parameters that pedzone reads and plain SUMO ignores."""

import random
import xml.etree.ElementTree as ET
from collections import defaultdict
from pathlib import Path

PROFILES = ("child", "preteen", "teenager", "adult", "middle-aged", "senior", "wheelchair", "pram",
            "cyclist")
ACTIVITIES = ("texting", "phoning", "looking", "chatting", "sitting")
WEATHER = ("fair", "rain", "heat", "ice")


def set_parameter(node: ET.Element, key: str, value: str) -> None:
    known = node.find(f"param[@key='{key}']")
    if known is None:
        known = ET.SubElement(node, "param", {"key": key})
    known.set("value", value)


def make_people(seed: int, folder: Path, zone_file: Path | None) -> Path:
    """Changes routes.rou.xml; returns the zone file, a new one where there was none. Numbers of its
    own, so that a seed's network and demand are those it has without."""
    rng = random.Random(f"people {seed}")
    routes = ET.parse(folder / "routes.rou.xml")
    together = defaultdict(list)
    for person in routes.iter("person"):
        together[person.get("depart"), person.get("departPos")].append(person)
        set_parameter(person, "pedzone.profile", rng.choice(PROFILES))
        if rng.random() < 0.3:
            set_parameter(person, "pedzone.activities", rng.choice(ACTIVITIES))
        if rng.random() < 0.1:
            set_parameter(person, "pedzone.aware", "false")
    for number, persons in enumerate(together.values()):
        if len(persons) < 2 or rng.random() < 0.3:
            continue
        for person in persons:
            set_parameter(person, "pedzone.group", f"group{number}")
        if rng.random() < 0.5:  # a family
            set_parameter(persons[0], "pedzone.profile", "adult")
            set_parameter(persons[1], "pedzone.profile", "infant")
    for vehicle in routes.iter("vehicle"):
        if rng.random() < 0.2:
            set_parameter(vehicle, "pedzone.signal", "after-you")
        if rng.random() < 0.1:
            set_parameter(vehicle, "pedzone.horn", "true")
    routes.write(folder / "routes.rou.xml")
    zones = ET.parse(zone_file).getroot() if zone_file else ET.Element("zones")
    if not zone_file:
        ET.SubElement(zones, "zone", {"id": "all"})
    for zone in zones.iter("zone"):
        zone.set("weather", rng.choice(WEATHER))
    path = folder / "people.zone.xml"
    ET.ElementTree(zones).write(path)
    return path
