"""What is measured on a run: losses, contacts, jumps, people outside, durations."""
from dataclasses import dataclass, field

import numpy

from overlap import TURNED

CONTACT_DEPTH = 0.01  # [m] a disc may lap into a rectangle: SUMO writes positions to 0.01 m
JUMP_SPEED = 2.0  # [m/s]
JUMP_DISTANCE = 3.0  # [m] on top of what JUMP_SPEED allows in a step
SAME_PERSON_JUMP = 10.0  # [m] within which a jump is the one that plain SUMO makes with the person
SAME_PLACE_JUMP = 2.0  # [m] within which it is the one that plain SUMO makes with somebody
STEP_ASIDE_ALONG = 1.0  # [m] that a step aside may lead along the street
STILL = 0.025  # [m] walked in a step that need not show in a position written to 0.01 m
EXAMPLES = 20  # kept of each finding


@dataclass
class Finding:
    """Events of one kind: how many, on how many persons, and the first of them."""
    events: int = 0
    persons: int = 0
    examples: list = field(default_factory=list)


def by_name(rows):
    """Order of rows by person or vehicle, then time; and where a row follows one of the same."""
    order = numpy.lexsort((rows.step, rows.who))
    who = rows.who[order]
    same = numpy.zeros(len(who), bool)
    same[1:] = who[1:] == who[:-1]
    return order, same


def find_detached(fcd):
    """Rows of persons whom somebody else than SUMO walks.

    SUMO leaves a person that is moved from outside at the edge and position where its own model had
    it, and writes a speed that follows the coordinates. A person that SUMO walks and that has a speed
    also has another position; one that it only pushes aside has none.
    """
    rows = fcd.persons
    detached = numpy.zeros(len(rows.x), bool)
    if not len(rows.x):
        return detached
    order, same = by_name(rows)
    place, edge, times = rows.position[order], rows.edge[order], fcd.times[rows.step[order]]
    begins = ~same
    begins[1:] |= (place[1:] != place[:-1]) | (edge[1:] != edge[:-1])
    moved = numpy.zeros(len(order), bool)
    moved[1:] = rows.speed[order][1:] * numpy.diff(times) > STILL
    moved[begins] = False
    # From the first such row of a stretch on: where it stood before, SUMO may have put it.
    moves = numpy.cumsum(moved)
    before = (moves - moved)[numpy.flatnonzero(begins)][numpy.cumsum(begins) - 1]
    detached[order] = moves > before
    return detached


def riding_rows(fcd, trips):
    """Rows in which a person rides in a vehicle."""
    rows = fcd.persons
    riding = numpy.zeros(len(rows.x), bool)
    numbers = {name: number for number, name in enumerate(rows.names)}
    times = fcd.times[rows.step]
    step = numpy.diff(fcd.times).min() if len(fcd.times) > 1 else 0.0
    for name, trip in trips.items():
        for stage in trip.stages:
            if stage.kind == "ride" and stage.depart is not None and name in numbers:
                until = numpy.inf if stage.arrival is None else stage.arrival + step
                riding |= ((rows.who == numbers[name]) & (times >= stage.depart - step)
                           & (times <= until))
    return riding


@dataclass
class Losses:
    departed: int = 0
    arrived: int = 0
    walking: int = 0
    lost: list = field(default_factory=list)


def find_losses(fcd, trips, vehicles):
    """lost = departed - arrived - still in SUMO at the last time step. Still there is, too, who
    sits in a vehicle that has not arrived: FCD shows neither while SUMO teleports it or has no room
    to insert it."""
    rows = fcd.persons
    seen = {rows.names[number] for number in numpy.unique(rows.who)}
    last = {rows.names[number] for number in rows.who[rows.step == len(fcd.times) - 1]}
    for name, trip in trips.items():
        now = next((stage for stage in trip.stages if stage.arrival is None), None)
        if now is not None and now.kind == "ride" and now.vehicle:
            if now.vehicle not in vehicles or not vehicles[now.vehicle].arrived:
                last.add(name)
    departed = seen | {name for name, trip in trips.items()
                       if any(stage.depart is not None for stage in trip.stages)}
    arrived = {name for name in departed if name in trips and trips[name].arrived}
    return Losses(len(departed), len(arrived), len(last - arrived),
                  sorted(departed - arrived - last))


class Clearances:
    """Signed distances [m] between person discs and vehicle rectangles, negative in contact."""

    def __init__(self, fcd, radius, vehicle_sizes):
        """radius: [m] by person number; vehicle_sizes: [m] (length, width) by type number."""
        self._persons, self._vehicles, self._radius = fcd.persons, fcd.vehicles, radius
        angle = numpy.radians(fcd.vehicles.angle)
        self._forward = numpy.sin(angle), numpy.cos(angle)
        sizes = numpy.array(vehicle_sizes, float).reshape(-1, 2)[fcd.vehicles.type]
        self._length, self._half_width = sizes[:, 0], sizes[:, 1] / 2
        steps = numpy.arange(len(fcd.times) + 1)
        self._person_rows = numpy.searchsorted(fcd.persons.step, steps)
        self._vehicle_rows = numpy.searchsorted(fcd.vehicles.step, steps)

    def of_step(self, step):
        """(rows of persons, rows of vehicles, matrix) of one time step; None where one lacks."""
        people = numpy.arange(*self._person_rows[step:step + 2])
        fleet = numpy.arange(*self._vehicle_rows[step:step + 2])
        if not len(people) or not len(fleet):
            return None
        dx = self._persons.x[people][:, None] - self._vehicles.x[fleet]
        dy = self._persons.y[people][:, None] - self._vehicles.y[fleet]
        forward_x, forward_y = self._forward[0][fleet], self._forward[1][fleet]
        ahead = dx * forward_x + dy * forward_y  # of the front bumper
        aside = numpy.abs(dx * forward_y - dy * forward_x)
        beyond = numpy.maximum(ahead, -self._length[fleet] - ahead)
        beside = aside - self._half_width[fleet]
        outside = numpy.hypot(numpy.maximum(beyond, 0.0), numpy.maximum(beside, 0.0))
        inside = numpy.minimum(numpy.maximum(beyond, beside), 0.0)
        return people, fleet, outside + inside - self._radius[self._persons.who[people]][:, None]


@dataclass
class Contacts:
    """Rows in contact, with what they touch."""
    rows: numpy.ndarray  # of persons
    vehicles: numpy.ndarray  # rows
    depth: numpy.ndarray  # [m] > 0
    min_clearance: float = None  # [m] of anybody but those who ride
    min_clearance_controlled: float = None  # [m] of people whom SUMO does not walk


def find_contacts(fcd, clearances, riding, controlled, own_rides):
    """Every person and vehicle that touch in a time step; own_rides: pairs of numbers to leave out."""
    rows, vehicles, depths = [], [], []
    least = least_controlled = numpy.inf
    busy = numpy.intersect1d(numpy.unique(fcd.persons.step), numpy.unique(fcd.vehicles.step))
    for step in busy:
        people, fleet, clearance = clearances.of_step(step)
        clearance[riding[people] | ~numpy.isfinite(fcd.persons.x[people] + fcd.persons.y[people])] \
            = numpy.inf
        for person, vehicle in own_rides:
            clearance[numpy.ix_(fcd.persons.who[people] == person,
                                fcd.vehicles.who[fleet] == vehicle)] = numpy.inf
        least = min(least, clearance.min())
        if controlled[people].any():
            least_controlled = min(least_controlled, clearance[controlled[people]].min())
        touching = numpy.nonzero(clearance < -CONTACT_DEPTH)
        rows.append(people[touching[0]])
        vehicles.append(fleet[touching[1]])
        depths.append(-clearance[touching])
    none = numpy.empty(0, int)
    return Contacts(numpy.concatenate([none, *rows]), numpy.concatenate([none, *vehicles]),
                    numpy.concatenate([numpy.empty(0), *depths]),
                    None if numpy.isinf(least) else float(least),
                    None if numpy.isinf(least_controlled) else float(least_controlled))


SLOW = 0.5  # [m/s] people turn their shoulders beside a vehicle that is no faster


def touches_turned(fcd, contacts, radius):
    """Whether a contact is one of the full body's disc only, beside a vehicle that stands or crawls: the person
    can have turned its shoulders there. radius: [m] by person number."""
    fleet = fcd.vehicles
    speed = numpy.full(len(fleet.step), numpy.inf)
    order, same = by_name(fleet)
    now, before = order[same], order[numpy.flatnonzero(same) - 1]
    known = fleet.step[now] == fleet.step[before] + 1
    now, before = now[known], before[known]
    times = numpy.asarray(fcd.times)
    speed[now] = (numpy.hypot(fleet.x[now] - fleet.x[before], fleet.y[now] - fleet.y[before])
                  / (times[fleet.step[now]] - times[fleet.step[before]]))
    spare = (1 - TURNED) * radius[fcd.persons.who[contacts.rows]]
    return (speed[contacts.vehicles] <= SLOW) & (contacts.depth <= spare + CONTACT_DEPTH)


INSERTION = 2.0  # [s] within which somebody gets out from under a vehicle inserted on top of it


def at_insertion(fcd, contacts):
    """Whether a contact is one that a vehicle's insertion made: the pair touches in the vehicle's
    first time step, and that was no longer ago than INSERTION."""
    fleet = fcd.vehicles
    first = {}
    for vehicle, step in zip(fleet.who, fleet.step):
        first[vehicle] = min(first.get(vehicle, step), step)
    begin = numpy.array([first[vehicle] for vehicle in fleet.who[contacts.vehicles]], int)
    step = fcd.persons.step[contacts.rows]
    pairs = list(zip(fcd.persons.who[contacts.rows], fleet.who[contacts.vehicles]))
    made = {pair for pair, now, then in zip(pairs, step, begin) if now == then}
    times = numpy.asarray(fcd.times)
    recent = times[step] - times[begin] <= INSERTION if len(step) else numpy.empty(0, bool)
    return numpy.array([pair in made for pair in pairs], bool) & recent


@dataclass
class Jumps:
    """Rows at which a person has jumped since its row before."""
    rows: numpy.ndarray
    before: numpy.ndarray  # the rows before
    distance: numpy.ndarray  # [m]

    def only(self, kept):
        kept = numpy.array(kept, bool)
        return Jumps(self.rows[kept], self.before[kept], self.distance[kept])


def find_jumps(fcd, riding):
    """Every jump of a person that does not ride."""
    rows = fcd.persons
    order, same = by_name(rows)
    x, y, times = rows.x[order], rows.y[order], fcd.times[rows.step[order]]
    on_foot = ~riding[order]
    jumped = numpy.zeros(len(order), bool)
    distance = numpy.zeros(len(order))
    distance[1:] = numpy.hypot(numpy.diff(x), numpy.diff(y))
    jumped[1:] = distance[1:] > JUMP_SPEED * numpy.diff(times) + JUMP_DISTANCE
    jumped[1:] &= same[1:] & on_foot[1:] & on_foot[:-1]
    found = numpy.flatnonzero(jumped)
    return Jumps(order[found], order[found - 1], distance[found])


def without_steps_aside(fcd, jumps, trips, network):
    """Leaves out SUMO's own step across the street, to the side at a stop and back after it."""
    persons, kept = fcd.persons, []
    for row, before in zip(jumps.rows, jumps.before):
        name, time = persons.names[persons.who[row]], fcd.times[persons.step[row]]
        elapsed = time - fcd.times[persons.step[before]]
        at_stop = name in trips and any(
            abs(time - moment) <= 1.5 * elapsed
            for index, stage in enumerate(trips[name].stages) if stage.kind == "stop"
            for moment in (trips[name].stages[index - 1].arrival if index else None,
                           stage.arrival) if moment is not None)
        along = network.distance_along(
            persons.edge_names[persons.edge[row]], (persons.x[before], persons.y[before]),
            (persons.x[row], persons.y[row])) if at_stop else None
        kept.append(along is None or along > JUMP_SPEED * elapsed + STEP_ASIDE_ALONG)
    return jumps.only(kept)


def without_plain_jumps(fcd, jumps, controlled, plain_fcd, plain_jumps):
    """Leaves out what plain SUMO does too.

    That is a jump of the same person at about the same place, or, of somebody whom SUMO walks, a jump
    of anybody at the same place: striping jumps on some walking areas.
    """
    plain, persons, kept = plain_fcd.persons, fcd.persons, []
    names = [plain.names[number] for number in plain.who[plain_jumps.rows]]
    x, y = plain.x[plain_jumps.rows], plain.y[plain_jumps.rows]
    for row, before in zip(jumps.rows, jumps.before):
        apart = numpy.hypot(x - persons.x[row], y - persons.y[row])
        own = [name == persons.names[persons.who[row]] for name in names]
        by_sumo = not controlled[row] and not controlled[before]
        kept.append(not (apart[own] <= SAME_PERSON_JUMP).any()
                    and not (by_sumo and (apart <= SAME_PLACE_JUMP).any()))
    return jumps.only(kept)


def find_outside(fcd, rows, area):
    """{statement: rows} of the given rows that break one of the area's three statements."""
    x, y = fcd.persons.x[rows], fcd.persons.y[rows]
    finite = numpy.isfinite(x) & numpy.isfinite(y)
    rows, x, y = rows[finite], x[finite], y[finite]
    return {"in_building": rows[area.buildings.contains(x, y)],
            "on_road": rows[area.roads.contains(x, y)],
            "out_of_reach": rows[~area.reach.contains(x, y)]}


def describe(fcd, rows, extra=None):
    """A Finding of rows of persons; extra(index) adds to an example's fields."""
    persons = fcd.persons
    finding = Finding(len(rows), len(numpy.unique(persons.who[rows])))
    # The first of each person says more than many of one.
    _, first = numpy.unique(persons.who[rows], return_index=True)
    for index in sorted(first, key=lambda i: persons.step[rows[i]])[:EXAMPLES]:
        row = rows[index]
        example = {"time": float(fcd.times[persons.step[row]]),
                   "person": persons.names[persons.who[row]],
                   "x": float(persons.x[row]), "y": float(persons.y[row])}
        if extra:
            example.update(extra(index))
        finding.examples.append(example)
    return finding
