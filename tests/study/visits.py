"""People's visits of a zone, and shortest ways in its area, from floating-car data."""
import numpy
from shapely.geometry import Point
from shapely.geometry.polygon import orient as oriented
from shapely.ops import nearest_points
from shapely.prepared import prep

STANDING = 0.1  # [m/s]
CLEARANCE = 0.3  # [m] that shortest ways keep to walls
SIMPLER = 0.02  # [m] between the area's arcs and the corners taken of them


def _rings(area):
    """All borders, the area to their left."""
    for part in getattr(area, "geoms", [area]):
        part = oriented(part)
        for ring in (part.exterior, *part.interiors):
            yield ring


def _reflex(ring):
    """Corners round which a shortest way may bend: those where the area takes up more than half a turn."""
    corners = numpy.array(ring.coords[:-1])
    before, after = corners - numpy.roll(corners, 1, axis=0), numpy.roll(corners, -1, axis=0) - corners
    return corners[before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0] < 0]


class Ways:
    """Shortest ways by a visibility graph of the shrunk area's corners, all pairs of them at once."""

    _RINGS = (0.0, 15.0, 60.0, numpy.inf)  # [m] near walls are asked first: they hide most

    def __init__(self, area):
        self._room = area.buffer(-CLEARANCE, join_style=2)
        free = self._room.buffer(2 * SIMPLER, join_style=2)
        self._free = prep(free)
        self._largest = max(getattr(self._room, "geoms", [self._room]), key=lambda part: part.area)
        walls = [numpy.array(ring.simplify(SIMPLER / 2).coords) for ring in _rings(free)]
        self._from = numpy.concatenate([wall[:-1] for wall in walls])
        self._along = numpy.concatenate([numpy.diff(wall, axis=0) for wall in walls])
        self._corners = numpy.concatenate([_reflex(ring.simplify(SIMPLER))
                                           for ring in _rings(self._room)])
        count = len(self._corners)
        self._between = numpy.full((count, count), numpy.inf)
        for i, corner in enumerate(self._corners):
            seen, lengths = self._seen_from(corner)
            self._between[i, seen] = lengths
        numpy.minimum(self._between, self._between.T, out=self._between)
        numpy.fill_diagonal(self._between, 0.0)
        for k in range(count):  # Floyd and Warshall
            reached = numpy.flatnonzero(numpy.isfinite(self._between[k]))
            rows = self._between[reached]
            numpy.minimum(rows, rows[:, k, None] + self._between[k], out=rows)
            self._between[reached] = rows

    def _unhidden(self, place, targets):
        """Indices of the targets that no wall hides from a place."""
        start = self._from - place
        share = numpy.clip(-(start * self._along).sum(1) / (self._along ** 2).sum(1), 0.0, 1.0)
        distance = numpy.hypot(*(start + share[:, None] * self._along).T)
        side = start[:, 0] * self._along[:, 1] - start[:, 1] * self._along[:, 0]
        left = numpy.arange(len(targets))
        for low, high in zip(self._RINGS, self._RINGS[1:]):
            walls = numpy.flatnonzero((distance >= low) & (distance < high))
            way = (targets[left] - place)[:, None]
            a, along = start[walls], self._along[walls]
            first = way[..., 0] * a[:, 1] - way[..., 1] * a[:, 0]
            turn = way[..., 0] * along[:, 1] - way[..., 1] * along[:, 0]
            parts = (first * (first + turn) < 0) & (side[walls] * (side[walls] - turn) < 0)
            left = left[~parts.any(1)]
        return left

    def _seen_from(self, place):
        """Indices of the corners in sight of a place, and how far away they are [m]."""
        seen = self._unhidden(place, self._corners)
        return seen, numpy.hypot(*(self._corners[seen] - place).T)

    def _room_at(self, place, room):
        point = Point(place)
        if room is self._room and self._free.covers(point):
            return numpy.array(place)
        return numpy.array(nearest_points(room, point)[0].coords[0])

    def length(self, start, goal):
        """[m]; infinite where there is none."""
        length = self._length(start, goal, self._room)
        # Somebody may be nearest to a nook that shrinking has cut off.
        return length if numpy.isfinite(length) else self._length(start, goal, self._largest)

    def _length(self, start, goal, room):
        a, b = self._room_at(start, room), self._room_at(goal, room)
        extra = numpy.hypot(*(a - start)) + numpy.hypot(*(b - goal))
        if len(self._unhidden(a, b[None])):
            return extra + numpy.hypot(*(a - b))
        first, to_first = self._seen_from(a)
        last, from_last = self._seen_from(b)
        ways = to_first[:, None] + self._between[numpy.ix_(first, last)] + from_last
        return extra + ways.min(initial=numpy.inf)


def visits(inside):
    """Of one walk: [(first row, last row)] of its visits."""
    ends = numpy.diff(numpy.concatenate(([False], inside, [False])).astype(int))
    return list(zip(numpy.flatnonzero(ends > 0), numpy.flatnonzero(ends < 0) - 1))


def walk_measures(fcd, persons, inside, ways, free_share):
    """person.* of those who walk in the zone; `inside`: of each row; without `ways` no delay."""
    rows = fcd.persons
    total = dict.fromkeys(("time", "waiting", "walked", "covered", "jumped", "shortest", "delay"), 0.0)
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
                further = numpy.hypot(numpy.diff(x[part]), numpy.diff(y[part])) - dt * speed[part][1:]
                total["jumped"] += further[further > 1.0].sum()
                if ways is None:
                    continue
                shortest = ways.length((x[first], y[first]), (x[last], y[last]))
                total["shortest"] += shortest
                total["delay"] += time - shortest / (top * free_share)
        visitors += came
    values = {"person.visitors": visitors, "person.waiting": total["waiting"] / visitors,
              "person.walked": total["walked"] / visitors,
              "person.jumped": total["jumped"] / visitors,
              "person.speed": total["covered"] / total["time"]}
    if ways is not None:
        values["person.delay"] = total["delay"] / visitors
        values["person.detour"] = total["walked"] / total["shortest"]
    return values
