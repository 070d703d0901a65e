#!/usr/bin/python3
"""The limits of the experiments' checks that are recorded, by the measures of the experiments.

usage: experiment_recordings.py FOLDER

FOLDER: with citr/ and dut/, the clips that tools/recordings.py makes. Prints what
scenarios/experiments/README.md names as recorded.
"""

import csv
import itertools
import sys
from pathlib import Path

import numpy

import experiment_measures as m
from experiment_tracks import RADIUS, STEP, Run, Track

LATERAL = 0.2     # [m] so far from its course somebody recorded has turned: people sway
HEAD_ON = -0.8    # cosine between two ways that lead against each other
PAIR = 1.0        # [m] who passes another so near meets it


def read(file):
    """A clip: positions of people, of vehicles the middle of their front bumper."""
    rows, sizes = {"ped": {}, "veh": {}}, {}
    with open(file, encoding="utf-8") as text:
        for row in csv.DictReader(text):
            t, x, y = (float(row[key]) for key in ("t", "x", "y"))
            heading = 0.0
            if row["kind"] == "veh":
                heading = float(row["heading"])
                front, rear, half = (float(row[key]) for key in ("front", "rear", "half_width"))
                x, y = x + front * numpy.cos(heading), y + front * numpy.sin(heading)
                sizes[row["id"]] = (front + rear, 2.0 * half)
            rows[row["kind"]].setdefault(row["id"], []).append(
                (t, x, y, 90.0 - numpy.degrees(heading)))
    return Run(*({name: Track(*numpy.array(track).T) for name, track in rows[kind].items()}
                 for kind in ("ped", "veh")), sizes)


def clips(folder, pattern):
    return [read(file) for file in sorted(Path(folder).glob(pattern))]


def turned(run, track, until):
    """The run turned so that `track` leads along x, its start at y = 0, to where it is at row
    `until`."""
    along = numpy.arctan2(track.y[until] - track.y[0], track.x[until] - track.x[0])
    cos, sin = numpy.cos(along), numpy.sin(along)

    def turn(one):
        x, y = one.x - track.x[0], one.y - track.y[0]
        return Track(one.t, x * cos + y * sin, y * cos - x * sin, one.angle + numpy.degrees(along))

    return Run(*({name: turn(one) for name, one in tracks.items()}
                 for tracks in (run.persons, run.vehicles)), run.sizes)


def straight(track):
    return Track(track.t, track.x, numpy.zeros(len(track.t)), track.angle)


def before_a_vehicle(runs):
    """Of each person: onset [m] and [s], sharpest change, clearance."""
    rows = []
    for run in runs:
        vehicle = next(iter(run.vehicles))
        for person, track in run.persons.items():
            one = turned(run, track, -1)
            control = Run({person: straight(one.persons[person])}, {})
            rows.append((*m.onset(one, control, person, vehicle), m.sharpest(one, person, vehicle),
                         float(one.gaps(person, vehicle)[1].min())))
    return numpy.array(rows).T


def way(track):
    vector = numpy.array([track.x[-1] - track.x[0], track.y[-1] - track.y[0]])
    return vector / numpy.hypot(*vector)


def head_on(runs):
    """Of each pair that meets: the least distance, least share of speed, and where the first turns
    from its course of the first second (nan where they would not have touched)."""
    rows, second = [], round(1.0 / STEP)
    for run in runs:
        for a, b in itertools.combinations(run.persons, 2):
            if way(run.persons[a]) @ way(run.persons[b]) > HEAD_ON:
                continue
            t, gap = m.distances(run, a, b)
            if gap.min() > PAIR or gap.argmin() in (0, len(gap) - 1):
                continue
            courses = {}
            first = []
            for p in (a, b):
                one = turned(run, run.persons[p], second).persons[p]
                courses[p] = one
                off = numpy.abs(numpy.interp(t, one.t, one.y))[:gap.argmin()] > LATERAL
                first.append(gap[:gap.argmin()][off][0] if off.any() else 0.0)
            rows.append((gap.min(), m.kept_speed(run, a, b),
                         max(first) if would_touch(run, a, b, second) else numpy.nan))
    return numpy.array(rows).T


def would_touch(run, a, b, second):
    """By their courses of the first second that both are there."""
    t, _ = m.distances(run, a, b)
    places = [numpy.stack(run.persons[p].at(t[[0, second]])) for p in (a, b)]
    away, course = (places[1] - places[0])[:, 0], numpy.diff(places[1] - places[0])[:, 0]
    return abs(away[0] * course[1] - away[1] * course[0]) / numpy.hypot(*course) < 2 * RADIUS


def courses(runs):
    """Of each clip: contacts foreseen per person and minute; and least distances after them."""
    rates, after = [], []
    for run in runs:
        count, minutes = 0, sum(len(track.t) for track in run.persons.values()) * STEP / 60.0
        for a, b in itertools.combinations(run.persons, 2):
            pair = Run({key: run.persons[key] for key in (a, b)}, {})
            times = m.common_times(pair)
            if len(times) < 15 or way(run.persons[a]) @ way(run.persons[b]) < -HEAD_ON:
                continue
            found = m.foreseen(pair, times)
            count += len(found)
            after += found
        rates.append(count / minutes)
    return rates, numpy.array(after)


def show(name, values, shares=(0, 5, 25, 50, 75, 95, 100)):
    values = numpy.array(values, float)
    values = values[~numpy.isnan(values)]
    print(f"  {name}, {len(values)}: " + ", ".join(
        f"{share} %: {numpy.percentile(values, share):.2f}" for share in shares))


def main():
    folder = sys.argv[1]
    print("A vehicle from ahead (citr/front)")
    for name, values in zip(("onset [m]", "onset [s]", "sharpest change [m/s^2]",
                             "clearance of the centre [m]"),
                            before_a_vehicle(clips(folder, "citr/front_*"))):
        show(name, values)
    print("Two who meet head-on (citr/bidirection_no_vehicle)")
    for name, values in zip(("distance of centres [m]", "least share of speed",
                             "the first turns at [m]"),
                            head_on(clips(folder, "citr/bidirection_no_vehicle*"))):
        show(name, values)
    for pattern in ("citr/*direction*", "dut/*"):
        rates, after = courses(clips(folder, pattern))
        print(f"Same way ({pattern})")
        show("contacts foreseen per person and minute, by clip", rates)
        print(f"  of {len(after)} foreseen come about: {(after < m.TOUCH).mean():.2f}")


if __name__ == "__main__":
    main()
