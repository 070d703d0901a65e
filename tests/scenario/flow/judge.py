"""Measures one run beside striping's, and says which limits it breaks."""
import json
import statistics
import sys
from dataclasses import dataclass, field
from pathlib import Path

import numpy

from runs import SUMMARY

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "check"))
import check_run  # noqa: E402  (found only now)
import outputs  # noqa: E402
from overlap import overlapping_pairs  # noqa: E402

AT_STOP = 16.0  # [m] SUMO puts who comes to a stop into its place there, anywhere along 20 m of it


@dataclass
class Side:
    """What became of everybody in one of the two runs."""
    arrived: int  # persons with all stages done
    vehicles: int  # arrived
    boarded: int  # rides begun
    mean: float  # [s] from departure to arrival, of those who arrived in both
    mean_walk: float  # [s] the same, of those who only walk
    last: float  # [s] when the last person arrived


@dataclass
class Verdict:
    """One case with one seed."""
    case: str
    seed: int
    demand: int = 0  # persons
    striping: Side = None
    pedzone: Side = None
    walked: int = 0  # persons that pedzone walked at some time
    overlaps: int = 0  # pairs of people whose bodies overlapped, neither squeezing
    jams: int = 0  # times that pedzone says it let somebody squeeze through
    nearest: float = None  # [m/m] least distance of two centres over the sum of the radii
    lost: int = 0
    outside: int = 0  # persons
    jumps: int = 0  # of people whom pedzone walks
    broken: list = field(default_factory=list)  # limits, in words
    processor: tuple = (0.0, 0.0)  # [s] striping, pedzone


def _durations(run, names):
    return [run.persons[name].duration for name in names]


def _mean(values):
    return statistics.fmean(values) if values else None


def _side(run, both):
    """both: ids of those who arrived with striping and with pedzone."""
    arrived = [trip for trip in run.persons.values() if trip.arrived]
    walkers = [name for name in both
               if all(stage.kind == "walk" for stage in run.persons[name].stages)]
    return Side(len(arrived), sum(trip.arrived for trip in run.vehicles.values()),
                sum(stage.kind == "ride" and stage.depart is not None and bool(stage.vehicle)
                    for trip in run.persons.values() for stage in trip.stages),
                _mean(_durations(run, both)), _mean(_durations(run, walkers)),
                max((trip.stages[-1].arrival for trip in arrived), default=None))


def compare(verdict, plain, run):
    """Fills in both sides from what SUMO wrote about trips."""
    both = [name for name, trip in plain.persons.items()
            if trip.arrived and name in run.persons and run.persons[name].arrived]
    verdict.demand = len(plain.persons)
    verdict.striping, verdict.pedzone = _side(plain, both), _side(run, both)


def _put_into_place(check, jump):
    """Whether SUMO itself moved the person: to its place at a stop, when its walk there ended."""
    trip = check.run.persons[jump["person"]]
    moments = [walk.arrival for walk, ride in zip(trip.stages, trip.stages[1:])
               if walk.kind == "walk" and ride.kind == "ride"]
    period = numpy.diff(check.fcd.times).min()
    return jump["distance"] <= AT_STOP and any(
        moment is not None and abs(moment - jump["time"]) <= 1.5 * period for moment in moments)


def inspect(verdict, config, zone, folder):
    """Fills in what positions tell: people lost, outside, thrown about, overlapping."""
    check = check_run.Check(check_run.parse_arguments(
        [str(config), str(folder), "--zone", str(zone)]))
    figures = check.measure()
    verdict.lost = figures["persons"]["lost"]
    verdict.outside = figures["outside"]["persons"]
    verdict.walked = figures["persons"]["controlled"]
    verdict.jumps = sum(not _put_into_place(check, jump)
                        for jump in figures["jumps"]["controlled_jumps"])
    jams = json.loads((folder / SUMMARY).read_text())["jams"]
    verdict.jams = len(jams)
    pairs, verdict.nearest = overlapping_pairs(check, jams)
    verdict.overlaps = len(pairs)


def broken_limits(limits, verdict):
    """One line in words for each limit of the case that is broken."""
    plain, own = verdict.striping, verdict.pedzone
    wanted = verdict.demand if limits.everybody else limits.arrivals * plain.arrived
    if own.arrived < wanted:
        yield f"{own.arrived} of {verdict.demand} people arrived, striping {plain.arrived}"
    if limits.everybody and own.vehicles < plain.vehicles:
        yield f"{own.vehicles} vehicles arrived, with striping {plain.vehicles}"
    for what, mean, other in (("people", own.mean, plain.mean),
                              ("people on foot", own.mean_walk, plain.mean_walk)):
        if mean is not None and mean > limits.time_ratio * other:
            yield (f"{what} take {mean:.0f} s, {mean / other:.2f} times striping's, at most "
                   f"{limits.time_ratio:g}")
    if own.boarded < limits.arrivals * plain.boarded:
        yield f"{own.boarded} got on a bus, with striping {plain.boarded}"
    if limits.last_ratio and own.last and own.last > limits.last_ratio * plain.last:
        yield f"the last arrives at {own.last:.0f} s, with striping at {plain.last:.0f} s"
    if not verdict.walked:
        yield "nobody was walked by pedzone"
    for count, what in ((verdict.overlaps, "pairs of bodies overlap"),
                        (verdict.lost, "people lost"), (verdict.jumps, "people thrown about"),
                        (verdict.outside, "people outside the footway")):
        if count:
            yield f"{count} {what}"


def judge(verdict, limits, config, zone, plain_folder, folder):
    """Measures everything; the verdict's `broken` says what is wrong."""
    compare(verdict, outputs.read_run(str(plain_folder), False),
            outputs.read_run(str(folder), False))
    inspect(verdict, config, zone, folder)
    verdict.broken += broken_limits(limits, verdict)
