"""Reads SUMO's floating-car data (fcd-output) into arrays, fast enough for millions of rows.

Rows keep the file's order: by time, within a time step as SUMO wrote them. Positions are SUMO's: a
person's centre, a vehicle's middle of the front bumper; angles are degrees clockwise from north.
"""
import re
from dataclasses import dataclass

import numpy

from scenario import CheckError, open_bytes

_CHUNK = 1 << 24  # [bytes] read at a time
_STEP = b'<timestep time="'
# The attributes in the order in which SUMO 1.15 writes them.
_PERSON = re.compile(
    rb'<person id="([^"]*)" x="([^"]*)" y="([^"]*)"(?: z="[^"]*")? angle="[^"]*"[^>]*?'
    rb' speed="([^"]*)" pos="([^"]*)" edge="([^"]*)"')
_VEHICLE = re.compile(
    rb'<vehicle id="([^"]*)" x="([^"]*)" y="([^"]*)"(?: z="[^"]*")? angle="([^"]*)" type="([^"]*)"')


class _Names:
    """Numbers names in the order of their first appearance."""

    def __init__(self):
        self.numbers = {}

    def number_all(self, names):
        numbers = self.numbers
        return [numbers.setdefault(name, len(numbers)) for name in names]

    def decoded(self):
        return [name.decode("utf-8") for name in self.numbers]


@dataclass
class Rows:
    """One kind of road user, one row for each of them and time step."""
    names: list  # number -> id
    step: numpy.ndarray  # index into Fcd.times
    who: numpy.ndarray  # index into names
    x: numpy.ndarray  # [m]
    y: numpy.ndarray  # [m]


@dataclass
class PersonRows(Rows):
    speed: numpy.ndarray  # [m/s]
    position: numpy.ndarray  # [m] along the edge on which SUMO has the person
    edge: numpy.ndarray  # index into edge_names
    edge_names: list


@dataclass
class VehicleRows(Rows):
    angle: numpy.ndarray  # [deg] clockwise from north
    type: numpy.ndarray  # index into type_names
    type_names: list


@dataclass
class Fcd:
    times: numpy.ndarray  # [s] of each step
    persons: PersonRows
    vehicles: VehicleRows


class _Collector:
    """Columns of one kind of row, gathered piece by piece."""

    def __init__(self, tag, pattern, numeric, named):
        self.tag, self.pattern, self.numeric, self.named = tag, pattern, numeric, named
        self.steps = []
        self.columns = {group: [] for group in (*numeric, *named)}
        self.names = {group: _Names() for group in named}

    def add(self, pieces, first_step, path):
        """Adds the rows of consecutive steps, one piece of text a step."""
        counts, rows = [], []
        for piece in pieces:
            found = self.pattern.findall(piece)
            if len(found) != piece.count(self.tag):
                raise CheckError(f"{path}: a {self.tag.decode()}...> that is not as SUMO 1.15 "
                                 f"writes it, near time step {first_step + len(counts)}")
            counts.append(len(found))
            rows += found
        self.steps.append(numpy.repeat(
            numpy.arange(first_step, first_step + len(counts), dtype=numpy.int32), counts))
        if not rows:
            return
        groups = list(zip(*rows))
        for group in self.numeric:
            self.columns[group].append(numpy.array(groups[group]).astype(float))
        for group in self.named:
            self.columns[group].append(
                numpy.array(self.names[group].number_all(groups[group]), dtype=numpy.int32))

    def column(self, group):
        kind = float if group in self.numeric else numpy.int32
        return numpy.concatenate([numpy.empty(0, kind), *self.columns[group]])


def _pieces(path):
    """Lists of texts that each begin behind `<timestep time="`, whole steps only."""
    rest = b""
    with open_bytes(path) as stream:
        while True:
            try:
                chunk = stream.read(_CHUNK)
            except (OSError, EOFError) as error:
                raise CheckError(f"{path}: {error}") from error
            if not chunk:
                break
            pieces = (rest + chunk).split(_STEP)
            rest = _STEP + pieces.pop() if len(pieces) > 1 else pieces.pop()
            # What stands before the first step is the file's head.
            yield pieces if pieces and not pieces[0] else pieces[1:]
    if b"</fcd-export>" not in rest:
        raise CheckError(f"{path}: ends in the middle, or is no fcd-output")
    yield rest.split(_STEP)[1:]


def read_fcd(path):
    """Reads a plain or gzipped fcd-output."""
    persons = _Collector(b"<person ", _PERSON, (1, 2, 3, 4), (0, 5))
    vehicles = _Collector(b"<vehicle ", _VEHICLE, (1, 2, 3), (0, 4))
    times = []
    for pieces in _pieces(path):
        pieces = [piece for piece in pieces if piece]
        first = len(times)
        times += [float(piece[:piece.index(b'"')]) for piece in pieces]
        persons.add(pieces, first, path)
        vehicles.add(pieces, first, path)
    return Fcd(
        numpy.array(times),
        PersonRows(persons.names[0].decoded(), numpy.concatenate(persons.steps),
                   persons.column(0), persons.column(1), persons.column(2), persons.column(3),
                   persons.column(4), persons.column(5), persons.names[5].decoded()),
        VehicleRows(vehicles.names[0].decoded(), numpy.concatenate(vehicles.steps),
                    vehicles.column(0), vehicles.column(1), vehicles.column(2),
                    vehicles.column(3), vehicles.column(4), vehicles.names[4].decoded()))
