"""Whether bodies of people overlap, from positions alone; shares nothing with src/.

A body is a disc as wide as its person, and no narrower than a share of that while its owner has
turned its shoulders. Two centres must therefore never be nearer than that share of the sum of both
radii. Whom SUMO inserts or sets down it puts upon those who stand there, and nobody can help it:
pairs count once both are farther than ENTRY from where they began.
"""
from dataclasses import dataclass

import numpy

TURNED = 0.5  # share of a body's width that is left when its owner turns sideways
TOLERANCE = 0.015  # [m] SUMO rounds four coordinates to 0.01 m: a distance by up to 0.014 m
ENTRY = 5.0  # [m] round the place where somebody begins to be walked
_NEIGHBOURS = ((0, 0), (1, 0), (-1, 1), (0, 1), (1, 1))  # of a cell: every pair of cells once


@dataclass
class Overlaps:
    """Pairs of people nearer than their bodies allow, one entry a pair and time step."""
    first: numpy.ndarray  # rows of FCD
    second: numpy.ndarray
    depth: numpy.ndarray  # [m] by how much the centres are too near
    nearest: float  # [m] least distance of two centres over the sum of the radii; inf: no pair


def _pairs_of_cells(step, column, row, offset):
    """Index pairs (i, j), i's cell being j's shifted by the offset, within one time step."""
    height, width = row.max() + 3, column.max() + 3
    key = (step.astype(numpy.int64) * width + column + 1) * height + row + 1
    order = numpy.argsort(key, kind="stable")
    wanted = key + offset[0] * height + offset[1]
    begin = numpy.searchsorted(key[order], wanted, "left")
    count = numpy.searchsorted(key[order], wanted, "right") - begin
    first = numpy.repeat(numpy.arange(len(key)), count)
    within = numpy.arange(len(first)) - numpy.repeat(numpy.cumsum(count) - count, count)
    second = order[numpy.repeat(begin, count) + within]
    if offset == (0, 0):
        once = first < second
        return first[once], second[once]
    return first, second


def _near_pairs(persons, rows, reach):
    """Index pairs into `rows` of people of one time step within `reach` [m], and some beyond."""
    x, y = persons.x[rows], persons.y[rows]
    column, row = (numpy.floor((value - value.min()) / reach).astype(numpy.int64)
                   for value in (x, y))
    pairs = [_pairs_of_cells(persons.step[rows], column, row, offset) for offset in _NEIGHBOURS]
    return tuple(numpy.concatenate(part) for part in zip(*pairs))


def _newcomers(fcd, rows):
    """Whether, by row of FCD, its person is still at the place where it began to be walked."""
    persons = fcd.persons
    order = rows[numpy.lexsort((persons.step[rows], persons.who[rows]))]
    step, who = persons.step[order], persons.who[order]
    begins = numpy.ones(len(order), bool)
    begins[1:] = (who[1:] != who[:-1]) | (step[1:] > step[:-1] + 1)  # again, after a ride
    first = order[begins][numpy.cumsum(begins) - 1]
    new = numpy.zeros(len(persons.x), bool)
    new[order] = numpy.hypot(persons.x[order] - persons.x[first],
                             persons.y[order] - persons.y[first]) <= ENTRY
    return new


def find_overlaps(fcd, walked, radius, turned=TURNED, tolerance=TOLERANCE):
    """Overlaps among the rows that are `walked`; radius: [m] by person number."""
    persons = fcd.persons
    rows = numpy.flatnonzero(walked & numpy.isfinite(persons.x) & numpy.isfinite(persons.y))
    none = numpy.empty(0, int)
    if len(rows) < 2:
        return Overlaps(none, none, numpy.empty(0), numpy.inf)
    first, second = (rows[part] for part in _near_pairs(persons, rows, 2 * radius.max()))
    new = _newcomers(fcd, rows)
    settled = ~(new[first] | new[second])
    first, second = first[settled], second[settled]
    apart = numpy.hypot(persons.x[first] - persons.x[second], persons.y[first] - persons.y[second])
    both = radius[persons.who[first]] + radius[persons.who[second]]
    near = numpy.flatnonzero(apart < turned * both - tolerance)
    nearest = (apart / both).min(initial=numpy.inf)
    return Overlaps(first[near], second[near], (turned * both - apart)[near], float(nearest))


def _squeezed(fcd, jams):
    """Which rows are of somebody who has squeezed by then: narrower than with turned shoulders.
    Only pedzone knows who does: `jams` of its summary."""
    began = numpy.full(len(fcd.persons.names), numpy.inf)
    number = {name: k for k, name in enumerate(fcd.persons.names)}
    for jam in jams:
        who = number.get(jam["person"])
        if who is not None:
            began[who] = min(began[who], jam["time"])
    return fcd.times[fcd.persons.step] >= began[fcd.persons.who] - 1.0


def overlapping_pairs(check, jams):
    """Pairs of walked people whose bodies overlapped at any time, neither having squeezed, as an
    array of two person numbers a row; and the least distance of two centres over the sum of their
    radii. check: check_run.Check after measure()."""
    persons = check.fcd.persons
    radius = numpy.array([check.scenario.size(check.run.persons[name].type)[1] / 2
                          for name in persons.names])
    found = find_overlaps(check.fcd, check.controlled & ~_squeezed(check.fcd, jams), radius)
    pairs = numpy.column_stack([persons.who[found.first], persons.who[found.second]])
    return numpy.unique(numpy.sort(pairs, axis=1), axis=0), found.nearest
