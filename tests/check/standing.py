"""Who stands for long because of the other kind: people before vehicles, vehicles before people."""
from dataclasses import dataclass

import numpy

STAYS = 1.0  # [m] who gets no farther than that from where it was stands
LONGEST = 120.0  # [s] nobody should stand for longer
BEFORE_PERSON = 5.0  # [m] a vehicle stands because of people where somebody is so near ...
BESIDE_VEHICLE = 3.0  # [m] ... a person because of vehicles where one is ...
MOSTLY = 0.8  # ... in so much of the time
SAMPLE = 1.0  # [s]


@dataclass
class Stand:
    """Somebody or something that stood for too long."""
    kind: str  # person, vehicle
    name: str
    begin: float  # [s]
    end: float  # [s]
    x: float  # [m]
    y: float  # [m]
    share: float  # of that time with the other kind near

    def line(self):
        return (f"{self.kind} {self.name} stands from {self.begin:g} to {self.end:g} s at "
                f"({self.x:.1f}, {self.y:.1f}), the other kind near in {100 * self.share:.0f} %")


def stands(times, x, y, longest=LONGEST):
    """(first, last) indices of the stretches in which a track stays within STAYS of its beginning
    for more than `longest` s. times: ascending [s]."""
    found, begin = [], 0
    while begin < len(times):
        away = numpy.hypot(x[begin:] - x[begin], y[begin:] - y[begin]) > STAYS
        leaves = begin + int(away.argmax()) if away.any() else len(times)
        # A gap in the track (somebody who rides, a teleport) ends a stretch, too.
        gaps = numpy.flatnonzero(numpy.diff(times[begin:leaves]) > 5 * SAMPLE)
        end = begin + int(gaps[0]) + 1 if len(gaps) else leaves
        if times[end - 1] - times[begin] > longest:
            found.append((begin, end - 1))
            begin = end
        else:
            begin = max(begin + 1, end) if end == leaves and not away.any() else begin + 1
    return found


def tracks(fcd, rows, stride):
    """{number: indices of rows} of each road user, every `stride`-th step."""
    chosen = numpy.flatnonzero(rows.step % stride == 0)
    order = chosen[numpy.lexsort((rows.step[chosen], rows.who[chosen]))]
    who = rows.who[order]
    cuts = numpy.flatnonzero(numpy.diff(who)) + 1
    return {rows.who[part[0]]: part for part in numpy.split(order, cuts) if len(part)}


def find_stands(fcd, clearances, waiting=lambda kind, name, time: False):
    """Every Stand. waiting(kind, name, time [s]): whether it is to stand there then, for a stop or a
    ride of its own."""
    step = numpy.diff(fcd.times).min() if len(fcd.times) > 1 else SAMPLE
    stride = max(1, round(SAMPLE / step))
    found = []
    for kind, rows, reach in (("person", fcd.persons, BESIDE_VEHICLE),
                              ("vehicle", fcd.vehicles, BEFORE_PERSON)):
        for number, part in tracks(fcd, rows, stride).items():
            times = fcd.times[rows.step[part]]
            for first, last in stands(times, rows.x[part], rows.y[part]):
                if waiting(kind, rows.names[number], times[first]):
                    continue
                share = share_near(clearances, kind, rows, part[first:last + 1], reach)
                found.append(Stand(kind, rows.names[number], float(times[first]),
                                   float(times[last]), float(rows.x[part[first]]),
                                   float(rows.y[part[first]]), share))
    return found


def share_near(clearances, kind, rows, stretch, reach):
    """The share of these rows in which the other kind is within `reach` [m]."""
    near = 0
    for row in stretch:
        both = clearances.of_step(rows.step[row])
        if both is None:
            continue
        people, fleet, distance = both
        own = distance[people == row] if kind == "person" else distance[:, fleet == row]
        near += bool(own.size and own.min() < reach)
    return near / len(stretch)


def because_of_others(found):
    """Those of the stands for which the other kind is to blame."""
    return [stand for stand in found if stand.share >= MOSTLY]
