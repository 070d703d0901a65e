"""Where people in shared space may be, computed from the network and the polygons alone.

This is deliberately not the exact walkable area but three statements that hold for any sensible one,
each with a margin, since two implementations of a rule about dirty map data differ at the edges:
nobody is inside a building, nobody is on a road that stays SUMO's, and nobody is farther from the
zone's lanes, junctions and polygons than the rule lets the area reach.
"""
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

import numpy
import shapely
from shapely.geometry import LineString, MultiPoint, Point, box
from shapely.geometry import Polygon as Ring
from shapely.ops import unary_union
from shapely.prepared import prep
from shapely.validation import make_valid

from scenario import CheckError, open_bytes, parse_points, parse_xml

SHARED_TYPES = ("highway.pedestrian", "highway.living_street")
WALKABLE_POLYGONS = ("jupedsim.walkable_area", "pedzone.walkable")
OBSTACLE_POLYGONS = ("building", "jupedsim.obstacle", "pedzone.obstacle")
STUB = 2.0  # [m] shorter paths between junctions of the zone come with it
SHARED_SPEED = 5.6  # [m/s] at most on lanes that persons and vehicles share
OPEN_SPACE = 12.0  # [m] round highway.pedestrian lanes
LANE_WIDTH = 3.2  # [m] SUMO's, where a lane has none
CORRIDOR = 1.0  # [m] at least, on each side of a centre line that an obstacle cuts
ROAD_MARGIN = 1.5  # [m] round zone lanes, where a road's shape may lap into the zone
TOLERANCE = 0.05  # [m] a centre may be beyond a border
SLIT = 0.4  # [m] apart lie the crossings and walking areas that SUMO's persons step between


@dataclass
class Lane:
    id: str
    edge: str
    persons: bool
    vehicles: bool
    speed: float  # [m/s]
    width: float  # [m]
    line: LineString
    length: float = 0.0  # [m] as SUMO counts it, which need not be its line's

    def area(self, margin=0.0, cap_style=2):
        return self.line.buffer(self.width / 2 + margin, cap_style=cap_style)


@dataclass
class Edge:
    id: str
    type: str
    function: str
    ends: tuple  # junction ids (from, to)
    lanes: list
    crossed: tuple = ()  # edges that a crossing crosses


@dataclass
class Network:
    edges: dict = field(default_factory=dict)
    junctions: dict = field(default_factory=dict)  # id -> shape
    links: list = field(default_factory=list)  # (from lane, to lane, via lane or None)
    next_inner: dict = field(default_factory=dict)  # lane of a junction -> the one after it
    signalled: set = field(default_factory=set)  # ids of crossings under a traffic light

    def distance_along(self, edge_id, start, end):
        """[m] between two points in the direction of an edge; None where there is none such."""
        edge = self.edges.get(edge_id)
        if edge is None or not edge.lanes:
            return None
        line = edge.lanes[0].line
        return abs(line.project(Point(end)) - line.project(Point(start)))


def _line(shape):
    points = parse_points(shape)
    return LineString(points if len(points) > 1 else points * 2)


def _ring(points):
    """A valid area, possibly empty, of a ring that may cross itself."""
    if len(points) < 3:
        return Ring()
    ring = Ring(points)
    if not ring.is_valid:
        parts = make_valid(ring)
        ring = unary_union([part for part in getattr(parts, "geoms", [parts]) if part.area > 0])
    return ring


def _read_lane(element, edge_id):
    allow, disallow = element.get("allow"), element.get("disallow")
    if allow is not None and allow != "all":
        classes = set(allow.split())
        persons, vehicles = "pedestrian" in classes, bool(classes - {"pedestrian"})
    else:
        refused = set((disallow or "").split())
        persons = not refused & {"pedestrian", "all"}
        vehicles = "all" not in refused
    return Lane(element.get("id"), edge_id, persons, vehicles, float(element.get("speed")),
                float(element.get("width", LANE_WIDTH)), _line(element.get("shape")),
                float(element.get("length")))


def read_network(path):
    """Reads a net.xml or net.xml.gz."""
    network = Network()
    with open_bytes(path) as stream:
        try:
            for _, element in ElementTree.iterparse(stream):
                if element.tag == "edge":
                    name = element.get("id")
                    lanes = [_read_lane(lane, name) for lane in element.findall("lane")]
                    network.edges[name] = Edge(
                        name, element.get("type", ""), element.get("function", "normal"),
                        (element.get("from"), element.get("to")), lanes,
                        tuple(element.get("crossingEdges", "").split()))
                elif element.tag == "junction" and element.get("type") != "internal":
                    network.junctions[element.get("id")] = _ring(
                        parse_points(element.get("shape", "")))
                elif element.tag == "connection":
                    if element.get("tl"):
                        network.signalled.update((element.get("from"), element.get("to")))
                    start = f"{element.get('from')}_{element.get('fromLane')}"
                    via = element.get("via")
                    network.links.append(
                        (start, f"{element.get('to')}_{element.get('toLane')}", via))
                    if via and start.startswith(":"):
                        network.next_inner[start] = via
                if element.tag in ("edge", "junction", "connection"):
                    element.clear()
        except (ElementTree.ParseError, OSError, EOFError) as error:
            raise CheckError(f"{path}: {error}") from error
    if not network.edges:
        raise CheckError(f"{path}: has no edges")
    return network


@dataclass
class ZoneRule:
    """What a zone file asks for; empty: the rule for networks without one."""
    edges: set = field(default_factory=set)
    edge_types: set = field(default_factory=set)
    lanes: set = field(default_factory=set)
    polygons: set = field(default_factory=set)
    open_space: float = None  # [m] None: 12 round highway.pedestrian edges

    def takes(self, edge, lane):
        """Whether the lane is shared space."""
        if edge.function != "normal" or not lane.persons:
            return False
        if self.edges or self.edge_types or self.lanes:
            return (edge.id in self.edges or edge.type in self.edge_types
                    or lane.id in self.lanes)
        return edge.type in SHARED_TYPES or (lane.vehicles and lane.speed <= SHARED_SPEED)

    def lanes_of(self, network):
        """The lanes that are shared space, by id; without a zone file also stubs of paths."""
        edges = [edge for edge in network.edges.values() if edge.function == "normal"]
        taken = {lane.id: lane for edge in edges for lane in edge.lanes if self.takes(edge, lane)}
        if self.edges or self.edge_types or self.lanes:
            return taken
        junctions = {end for lane in taken.values() for end in network.edges[lane.edge].ends}
        for edge in edges:
            if set(edge.ends) <= junctions and not any(lane.vehicles for lane in edge.lanes):
                taken.update((lane.id, lane) for lane in edge.lanes
                             if lane.persons and lane.length < STUB)
        return taken

    def reach(self, edge):
        """[m] beyond the lane's own width."""
        if self.open_space is not None:
            return self.open_space
        return OPEN_SPACE if edge.type == "highway.pedestrian" else 0.0


def read_zone_rule(path):
    """All zones of a zone file in one rule."""
    rule = ZoneRule()
    for zone in parse_xml(path).iter("zone"):
        rule.edges |= set(zone.get("edges", "").split())
        rule.edge_types |= set(zone.get("edgeTypes", "").split())
        rule.lanes |= set(zone.get("lanes", "").split())
        rule.polygons |= set(zone.get("polygons", "").split())
        if zone.get("openSpace") is not None:
            rule.open_space = max(rule.open_space or 0.0, float(zone.get("openSpace")))
    return rule


class PointTest:
    """Which of many points lie in an area; cells of a grid that it fills or misses decide most."""

    _CELL = 1.0  # [m]

    def __init__(self, area):
        self.area = area
        self.prepared = prep(area)

    def contains(self, x, y):
        """Boolean array for coordinate arrays [m]."""
        result = numpy.zeros(len(x), bool)
        if self.area.is_empty or not len(x):
            return result
        columns, rows = (numpy.floor(value / self._CELL).astype(numpy.int64) for value in (x, y))
        low, height = rows.min(), rows.max() - rows.min() + 1
        unique, inverse = numpy.unique(columns * height + (rows - low), return_inverse=True)
        state = numpy.zeros(len(unique), numpy.int8)
        for index, key in enumerate(unique):
            column, row = key // height * self._CELL, (key % height + low) * self._CELL
            cell = box(column, row, column + self._CELL, row + self._CELL)
            if self.prepared.intersects(cell):
                state[index] = 1 if self.prepared.contains(cell) else 2
        state = state[inverse]
        result[state == 1] = True
        doubtful = numpy.flatnonzero(state == 2)
        result[doubtful] = self._contains_each(x[doubtful], y[doubtful])
        return result

    def _contains_each(self, x, y):
        if hasattr(shapely, "contains_xy"):  # shapely 2
            shapely.prepare(self.area)
            return shapely.contains_xy(self.area, x, y)
        from shapely import vectorized
        return vectorized.contains(self.area, x, y)

    def depth(self, x, y):
        """[m] distance of one point to the area's border."""
        return Point(x, y).distance(self.area.boundary)


class ZoneArea:
    """The three statements about where a person in shared space may be."""

    def __init__(self, network, polygons, rule):
        self._network = network
        zone = rule.lanes_of(network)
        if not zone:
            raise CheckError("the network has no shared space")
        self.lane_count = len(zone)
        self.length = sum(lane.line.length for lane in zone.values())  # [m]
        walkable = [_ring(polygon.points) for polygon in polygons
                    if polygon.type in WALKABLE_POLYGONS or polygon.id in rule.polygons]
        obstacles = [_ring(polygon.points) for polygon in polygons
                     if polygon.type in OBSTACLE_POLYGONS and polygon.id not in rule.polygons]
        self.edges = self._edges_for_people(zone)
        inner = self._junction_parts(zone)
        lanes = [lane.area() for lane in zone.values()]
        own = unary_union(lanes + inner)
        open_space = [network.edges[lane.edge] for lane in zone.values()]
        reach = [lane.area(rule.reach(edge), cap_style=1)
                 for lane, edge in zip(zone.values(), open_space)]
        corridors = unary_union([line.buffer(max(CORRIDOR, half) + TOLERANCE)
                                 for line, half in self._centre_lines(zone)])
        buildings = unary_union(obstacles).buffer(-TOLERANCE).difference(corridors)
        passages = list(self._passages(zone))
        roads = unary_union(self._road_parts(zone)).buffer(-TOLERANCE)
        roads = roads.difference(unary_union([own.buffer(ROAD_MARGIN)] + walkable + passages))
        reach = unary_union(reach + inner + walkable + passages)
        self.reach = PointTest(reach.buffer(SLIT / 2).buffer(TOLERANCE - SLIT / 2))
        self.buildings = PointTest(buildings)
        self.roads = PointTest(roads)

    def _edges_for_people(self, zone):
        """Ids of the zone's edges and of walking areas and crossings that lead only to them."""
        edges = {lane.edge for lane in zone.values()}
        outer = {end for edge in self._network.edges.values() if edge.function == "normal"
                 for end in edge.ends
                 if any(lane.persons and lane.id not in zone for lane in edge.lanes)}
        for edge in self._network.edges.values():
            junction = edge.id[1:].rpartition("_")[0]
            if edge.function in ("walkingarea", "crossing") and junction not in outer:
                edges.add(edge.id)
        return edges

    def _junctions_of(self, zone):
        """Junctions at the zone's lanes: id -> whether all vehicle lanes there are the zone's."""
        touched = {end for lane in zone.values() for end in self._network.edges[lane.edge].ends}
        whole = dict.fromkeys(touched, True)
        for edge in self._network.edges.values():
            for end in edge.ends:
                if end in whole and any(lane.vehicles and lane.id not in zone
                                        for lane in edge.lanes):
                    whole[end] = False
        return whole

    def _junction_parts(self, zone):
        """Areas of junctions, walking areas and crossings that belong to the zone."""
        network, parts = self._network, []
        parts += [network.junctions[name] for name, whole in self._junctions_of(zone).items()
                  if whole and name in network.junctions]
        walking_areas = self._walking_areas(zone)
        for start, end, via in network.links:
            if start in zone and end in zone:
                parts += [lane.area() for lane in self._inner_lanes(via)]
        for edge in network.edges.values():
            if edge.function == "walkingarea" and edge.id in walking_areas:
                parts.append(_ring(list(edge.lanes[0].line.coords)))
        return parts + [lane.area() for lane in self._crossings(zone)]

    def _walking_areas(self, zone):
        """Ids of what touches the zone's lanes, walking areas among it."""
        return {other.rpartition("_")[0] for start, end, _ in self._network.links
                for lane, other in ((start, end), (end, start)) if lane in zone}

    def _crossings(self, zone):
        """Lanes of the crossings that are the zone's."""
        walking_areas = self._walking_areas(zone)
        return [lane for edge in self._network.edges.values()
                if edge.function == "crossing" and self._is_inside(edge, walking_areas, zone)
                for lane in edge.lanes]

    def _is_inside(self, crossing, walking_areas, zone):
        """Whether a crossing is the zone's: over its own lanes only, or without a traffic light
        between walking areas at its lanes."""
        network = self._network
        over_own = crossing.crossed and all(
            lane.id in zone for name in crossing.crossed
            for lane in network.edges[name].lanes if lane.vehicles)
        ends = {edge for start, end, _ in network.links
                for edge, other in ((start, end), (end, start))
                if other.rpartition("_")[0] == crossing.id}
        between_own = len(ends) > 1 and all(end.rpartition("_")[0] in walking_areas
                                            for end in ends)
        return over_own or (between_own and crossing.id not in network.signalled)

    def _inner_lanes(self, via):
        """A link's lanes inside the junction in turn: two where it waits in the middle."""
        found = []
        while via:
            edge = self._network.edges.get(via.rpartition("_")[0])
            found += [lane for lane in edge.lanes if lane.id == via] if edge else []
            via = self._network.next_inner.get(via)
        return found

    def _centre_lines(self, zone):
        """(line, half width [m]): the zone's lanes and crossings, and the straight ways between the
        lanes' ends."""
        for lane in self._crossings(zone):
            yield lane.line, lane.width / 2
        ends = {}
        for lane in zone.values():
            yield lane.line, lane.width / 2
            start, stop = self._network.edges[lane.edge].ends
            ends.setdefault(start, []).append(lane.line.coords[0])
            ends.setdefault(stop, []).append(lane.line.coords[-1])
        for points in ends.values():
            for index, point in enumerate(points):
                for other in points[:index]:
                    if point != other:
                        yield LineString([point, other]), 0.0
            yield MultiPoint(points), 0.0

    def _passages(self, zone):
        """Junctions without walking areas: SUMO's persons pass from lane end to lane end there, and
        the way between is as wide as the narrower lane."""
        with_areas = {name[1:].rpartition("_")[0] for name, edge in self._network.edges.items()
                      if edge.function == "walkingarea"}
        ends = {}
        for lane in zone.values():
            edge = self._network.edges[lane.edge]
            for junction, point in zip(edge.ends, (lane.line.coords[0], lane.line.coords[-1])):
                if junction not in with_areas:
                    ends.setdefault(junction, []).append((point, max(CORRIDOR, lane.width / 2)))
        for places in ends.values():
            for index, (point, half) in enumerate(places):
                for other, other_half in places[:index]:
                    yield LineString([point, other]).buffer(min(half, other_half))

    def _road_parts(self, zone):
        """Lanes that vehicles use and the zone does not, with their ways through junctions."""
        parts = [lane.area() for edge in self._network.edges.values()
                 if edge.function == "normal" for lane in edge.lanes
                 if lane.vehicles and lane.id not in zone]
        for start, end, via in self._network.links:
            if not (start in zone and end in zone):
                parts += [lane.area() for lane in self._inner_lanes(via) if lane.vehicles]
        return parts
