"""People's visits of a zone, and shortest ways in its area, from floating-car data."""
import heapq

import numpy
from shapely.geometry import LineString, Point
from shapely.ops import nearest_points
from shapely.prepared import prep

STANDING = 0.1  # [m/s]
CLEARANCE = 0.3  # [m] that shortest ways keep to walls
SIMPLER = 0.02  # [m] between the area's arcs and the corners taken of them


class Ways:
    """Shortest ways by a visibility graph of the shrunk area's corners."""

    def __init__(self, area):
        self._room = area.buffer(-CLEARANCE, join_style=2)
        self._free = prep(self._room.buffer(2 * SIMPLER))
        parts = getattr(self._room, "geoms", [self._room])
        self._corners = [point for part in parts for ring in (part.exterior, *part.interiors)
                         for point in ring.simplify(SIMPLER).coords[:-1]]
        self._links = {i: {} for i in range(len(self._corners))}
        for i, a in enumerate(self._corners):
            for j in range(i):
                if self._sees(a, self._corners[j]):
                    self._links[i][j] = self._links[j][i] = numpy.hypot(
                        *numpy.subtract(a, self._corners[j]))

    def _sees(self, a, b):
        return self._free.covers(LineString([a, b]))

    def _room_at(self, place):
        point = Point(place)
        return place if self._free.covers(point) else nearest_points(self._room, point)[0].coords[0]

    def length(self, start, goal):
        """[m]; infinite where there is none."""
        a, b = self._room_at(start), self._room_at(goal)
        extra = numpy.hypot(*numpy.subtract(a, start)) + numpy.hypot(*numpy.subtract(b, goal))
        if self._sees(a, b):
            return extra + numpy.hypot(*numpy.subtract(a, b))
        last = {i: numpy.hypot(*numpy.subtract(c, b)) for i, c in enumerate(self._corners)
                if self._sees(c, b)}
        queue = [(numpy.hypot(*numpy.subtract(c, a)), i) for i, c in enumerate(self._corners)
                 if self._sees(a, c)]
        heapq.heapify(queue)
        best, done = numpy.inf, set()
        while queue and queue[0][0] < best:
            length, node = heapq.heappop(queue)
            if node in done:
                continue
            done.add(node)
            best = min(best, length + last.get(node, numpy.inf))
            for other, step in self._links[node].items():
                heapq.heappush(queue, (length + step, other))
        return extra + best


def visits(inside):
    """Of one walk: [(first row, last row)] of its visits."""
    ends = numpy.diff(numpy.concatenate(([False], inside, [False])).astype(int))
    return list(zip(numpy.flatnonzero(ends > 0), numpy.flatnonzero(ends < 0) - 1))


def walk_measures(fcd, persons, inside, ways, free_share):
    """person.* of those who walk in the zone; `inside`: of each row; without `ways` no delay."""
    rows = fcd.persons
    total = dict.fromkeys(("time", "waiting", "walked", "covered", "shortest", "delay"), 0.0)
    numbers = {name: number for number, name in enumerate(rows.names)}
    order = numpy.lexsort((rows.step, rows.who))
    bounds = numpy.searchsorted(rows.who[order], numpy.arange(len(rows.names) + 1))
    visitors = 0
    for trip in persons:
        if trip.id not in numbers:
            continue
        mine = order[bounds[numbers[trip.id]]:bounds[numbers[trip.id] + 1]]
        moments = fcd.times[rows.step[mine]]
        came = False
        for depart, arrival, top in trip.walks:
            own = mine[(moments >= depart - 1e-6) & (moments <= arrival + 1e-6)]
            times, x, y, speed = (fcd.times[rows.step[own]], rows.x[own], rows.y[own],
                                  rows.speed[own])
            for first, last in visits(inside[own]):
                came = True
                part = slice(first, last + 1)
                dt = numpy.diff(times[part])
                time = times[last] - times[first]
                total["time"] += time
                total["waiting"] += dt[speed[part][1:] < STANDING].sum()
                total["walked"] += numpy.hypot(numpy.diff(x[part]), numpy.diff(y[part])).sum()
                total["covered"] += (dt * speed[part][1:]).sum()
                if ways is None:
                    continue
                shortest = ways.length((x[first], y[first]), (x[last], y[last]))
                total["shortest"] += shortest
                total["delay"] += time - shortest / (top * free_share)
        visitors += came
    values = {"person.visitors": visitors, "person.waiting": total["waiting"] / visitors,
              "person.walked": total["walked"] / visitors,
              "person.speed": total["covered"] / total["time"]}
    if ways is not None:
        values["person.delay"] = total["delay"] / visitors
        values["person.detour"] = total["walked"] / total["shortest"]
    return values
