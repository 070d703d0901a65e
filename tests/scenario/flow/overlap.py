"""Whether bodies of people overlap, from positions alone; shares nothing with src/.

A body is a disc as wide as its person, and no narrower than a share of that while its owner has
turned its shoulders. Two centres must therefore never be nearer than that share of the sum of both
radii. Whom SUMO inserts (or sets down) upon somebody overlaps until they have stepped apart: such a
pair counts once it has been apart, or after SETTLE.
"""
from dataclasses import dataclass

import numpy

TURNED = 0.5  # share of a body's width that is left when its owner turns sideways
TOLERANCE = 0.01  # [m] SUMO writes positions to 0.01 m
SETTLE = 5.0  # [s] within which two who begin on one spot have stepped apart
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


def _walked_since(fcd, rows):
    """[s] by row of FCD: since when its person has been walked without a break."""
    persons = fcd.persons
    order = rows[numpy.lexsort((persons.step[rows], persons.who[rows]))]
    times, who = fcd.times[persons.step[order]], persons.who[order]
    begins = numpy.ones(len(order), bool)
    begins[1:] = (who[1:] != who[:-1]) | (persons.step[order][1:] > persons.step[order][:-1] + 1)
    since = numpy.full(len(persons.x), numpy.inf)
    since[order] = times[begins][numpy.cumsum(begins) - 1]
    return since


def _begun_together(fcd, since, first, second):
    """Whether each overlap, in order of time, goes on from the moment when the later of the two
    began to be walked, and that was no longer than SETTLE ago."""
    persons = fcd.persons
    excused = numpy.zeros(len(first), bool)
    last = {}  # pair -> time step of its last excused overlap
    for index, (one, other) in enumerate(zip(first, second)):
        pair = frozenset((persons.who[one], persons.who[other]))
        step, begun = persons.step[one], max(since[one], since[other])
        goes_on = last.get(pair) == step - 1 or fcd.times[step] == begun
        if goes_on and fcd.times[step] - begun <= SETTLE:
            excused[index] = True
            last[pair] = step
    return excused


def find_overlaps(fcd, walked, radius, turned=TURNED, tolerance=TOLERANCE):
    """Overlaps among the rows that are `walked`; radius: [m] by person number."""
    persons = fcd.persons
    rows = numpy.flatnonzero(walked & numpy.isfinite(persons.x) & numpy.isfinite(persons.y))
    none = numpy.empty(0, int)
    if len(rows) < 2:
        return Overlaps(none, none, numpy.empty(0), numpy.inf)
    first, second = (rows[part] for part in _near_pairs(persons, rows, 2 * radius.max()))
    in_time = numpy.argsort(persons.step[first], kind="stable")
    first, second = first[in_time], second[in_time]
    apart = numpy.hypot(persons.x[first] - persons.x[second], persons.y[first] - persons.y[second])
    both = radius[persons.who[first]] + radius[persons.who[second]]
    counts = numpy.ones(len(first), bool)
    near = numpy.flatnonzero(apart < turned * both - tolerance)
    counts[near] = ~_begun_together(fcd, _walked_since(fcd, rows), first[near], second[near])
    near = near[counts[near]]
    nearest = (apart / both)[counts].min(initial=numpy.inf)
    return Overlaps(first[near], second[near], (turned * both - apart)[near], float(nearest))
