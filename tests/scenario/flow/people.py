"""Demand for footways: people both ways at random times, people at bus stops, buses."""
import xml.etree.ElementTree as ET

PEDESTRIAN = "walker"
# SUMO would begin and end walks against an edge's direction in its middle.
ENDS = {"forward": ("0", "-0.1"), "backward": ("-0.1", "0")}  # [m] departPos, arrivalPos
SIZE_OF_BUS = {"length": "12", "width": "2.5", "personCapacity": "100"}


class Demand:
    """Persons and vehicles; SUMO wants them sorted by departure."""

    def __init__(self, rng, body):
        """body: [m] how wide people are."""
        self._rng = rng
        self._entries = []  # (depart [s], order, element)
        self._types = [ET.Element("vType", {"id": PEDESTRIAN, "vClass": "pedestrian",
                                            "width": f"{body:g}"}),
                       ET.Element("vType", {"id": "bus", "vClass": "bus", **SIZE_OF_BUS})]
        self.additional = ET.Element("additional")

    def _add(self, depart, element):
        self._entries.append((depart, len(self._entries), element))

    def _person(self, name, depart, place):
        person = ET.Element("person", {"id": name, "type": PEDESTRIAN, "depart": f"{depart:.2f}",
                                       "departPos": place})
        self._add(depart, person)
        return person

    def times(self, count, begin, end):
        """[s] so many random moments, in order."""
        return sorted(self._rng.uniform(begin, end) for _ in range(count))

    def passers(self, count, edges, direction, begin, end):
        """People who walk along the edges (named in the order in which they walk them). Across the
        way they begin anywhere, or SUMO would put all of them on the same spot."""
        first, last = ENDS[direction]
        for index, depart in enumerate(self.times(count, begin, end)):
            person = self._person(f"{direction}{index}", depart, first)
            ET.SubElement(person, "walk", {"edges": " ".join(edges), "arrivalPos": last,
                                           "departPosLat": "random"})

    def stop(self, name, lane, start, end, capacity):
        """A bus stop with room for so many people to wait."""
        ET.SubElement(self.additional, "busStop", {
            "id": name, "lane": lane, "startPos": f"{start:g}", "endPos": f"{end:g}",
            "personCapacity": str(capacity)})

    def waiting(self, name, count, edges, direction, stop, line, goal, begin, end):
        """People who walk along the edges to the stop and take the line to the stop `goal`."""
        for index, depart in enumerate(self.times(count, begin, end)):
            person = self._person(f"{name}{index}", depart, ENDS[direction][0])
            ET.SubElement(person, "walk", {"edges": " ".join(edges), "busStop": stop,
                                           "departPosLat": "random"})
            ET.SubElement(person, "ride", {"busStop": goal, "lines": line})

    def bus(self, name, line, depart, edges, stops, alighting=(), alight_at=None):
        """A bus that calls at the stops; alighting: (edges, direction) of each person aboard that
        walks on from the stop `alight_at`."""
        bus = ET.Element("vehicle", {"id": name, "type": "bus", "line": line,
                                     "depart": f"{depart:.2f}"})
        ET.SubElement(bus, "route", {"edges": " ".join(edges)})
        for stop in stops:
            ET.SubElement(bus, "stop", {"busStop": stop, "duration": "20"})
        self._add(depart, bus)
        for index, (way, direction) in enumerate(alighting):
            person = ET.Element("person", {"id": f"{name}-out{index}", "type": PEDESTRIAN,
                                           "depart": "triggered"})
            ET.SubElement(person, "ride", {"from": edges[0], "busStop": alight_at, "lines": name})
            ET.SubElement(person, "walk", {"edges": " ".join(way),
                                           "arrivalPos": ENDS[direction][1]})
            self._add(depart, person)

    def routes(self):
        """The route file's document element."""
        root = ET.Element("routes")
        root.extend(self._types)
        root.extend(element for _, _, element in sorted(self._entries, key=lambda entry: entry[:2]))
        return root
