#!/usr/bin/python3
"""A street of 7 m with 2,400 cars an hour between two zebra crossings: who walks there, and which gaps
the others take.

usage: busy_street.py PEDZONE [--seeds N] [--model M] [--keep FOLDER]

From SUMO's own floating-car data of all seeds together:
- more than half of the people who cross do so at a zebra crossing
- the median gap that is taken between them lies between 3 s, the least in a single stream (DiPietro and
  King 1970), and 9.4 s, the longest 85th percentile of 11 crossings (Brewer et al. 2006)
- who has waited for longer takes shorter gaps; seniors take longer ones than adults: each difference
  of means with its 95 % interval
- nobody is touched at more than 0.5 m/s
`--model constant-velocity` must fail: it does not look.
"""
import argparse
import bisect
import math
import statistics
import sys
import tempfile
from pathlib import Path

import street

CARS, PEOPLE = 2400, 300  # an hour
BEGIN, END = 1800, 2400  # [s]
KERB, MIDDLE = 3.5, 0.0  # [m] |y| of the street
WEST, EAST = 8.0, 207.0  # [m] x of its ends
WAITS = 0.3  # [m/s] who is slower waits
SHORT, LONG = 10.0, 40.0  # [s] waited less, and more
LEAST, MOST = 3.0, 9.4  # [s]
TYPES = {
    "adult": (0.6, '<vType id="adult" vClass="pedestrian"><param key="pedzone.profile" '
                   'value="adult"/></vType>'),
    "senior": (0.4, '<vType id="senior" vClass="pedestrian" maxSpeed="1.16"><param '
                    'key="pedzone.profile" value="senior"/></vType>')}


def anywhere(rng):
    return rng.uniform(2.0, 198.0), rng.uniform(2.0, 198.0)


class Passes:
    """When cars pass a place, by lane."""

    def __init__(self, cars):
        self.tracks = {1: [], -1: []}  # eastward, westward
        for track in cars.values():
            if len(track) > 1:
                way = 1 if track[-1][1] > track[0][1] else -1
                self.tracks[way].append(track)

    def next(self, way, x, after):
        """[s] when the next car of that way passes x; infinity."""
        best = math.inf
        for track in self.tracks[way]:
            if track[-1][0] < after or track[0][0] > best:
                continue
            k = bisect.bisect_left(track, x * way, key=lambda place: place[1] * way)
            if 0 < k < len(track) and track[k][0] >= after:
                best = min(best, track[k][0])
        return best


def crossing_of(walk, passes):
    """(between the junctions, waited [s], gap that was taken [s] or infinity) of a walk from one
    side to the other; None: it has not got there."""
    track = walk.track
    begin, end = track[0][2], track[-1][2]
    if begin * end > 0 or abs(end) < KERB:
        return None
    side = 1 if begin < 0 else -1  # 1: northward, over the eastward lane first
    on_road = [place for place in track if abs(place[2]) < KERB - 0.1]
    if not on_road or not WEST < on_road[0][1] < EAST:
        return False, 0.0, math.inf
    out, x = on_road[0][:2]
    middle = next((t for t, _, y in on_road if y * side > MIDDLE), on_road[-1][0])
    waited = sum(b[0] - a[0] for a, b in zip(track, track[1:])
                 if b[0] <= out and math.dist(a[1:], b[1:]) < WAITS * (b[0] - a[0]))
    gap = min(passes.next(side, x, out), passes.next(-side, x, middle)) - out
    return True, waited, gap


def difference(first, second):
    """Mean of the first less that of the second, and half its 95 % interval."""
    if min(len(first), len(second)) < 2:
        return 0.0, math.inf
    mean = statistics.mean(first) - statistics.mean(second)
    half = 1.96 * math.sqrt(statistics.variance(first) / len(first) +
                            statistics.variance(second) / len(second))
    return mean, half


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--model")
    parser.add_argument("--keep", type=Path)
    given = parser.parse_args()
    options = ["--model", given.model] if given.model else []
    scratch = tempfile.TemporaryDirectory()
    root = given.keep or Path(scratch.name)
    crossings, touched = [], 0
    for seed in range(1, given.seeds + 1):
        folder = root / str(seed)
        routes = street.demand(seed, CARS, PEOPLE, BEGIN, anywhere, TYPES)
        street.write_scenario(folder, routes, END)
        street.run_pedzone(folder, given.program.resolve(), seed, *options)
        seen = street.read_fcd(folder / "pedzone.fcd.xml")
        passes = Passes(seen.cars)
        touched += sum(speed > 0.5 for _, _, _, speed in seen.contacts)
        for name, walk in seen.walks.items():
            crossing = crossing_of(walk, passes)
            if crossing is not None:
                crossings.append((*crossing, seen.types[name]))
    between = [one for one in crossings if one[0]]
    share = len(between) / len(crossings)
    known = [one for one in between if math.isfinite(one[2])]
    median = statistics.median(gap for _, _, gap, _ in known)
    soon = [gap for _, waited, gap, _ in known if waited < SHORT]
    late = [gap for _, waited, gap, _ in known if waited > LONG]
    by_wait = difference(soon, late)
    seniors = [gap for _, _, gap, kind in known if kind == "senior"]
    adults = [gap for _, _, gap, kind in known if kind == "adult"]
    by_age = difference(seniors, adults)
    print(f"{len(crossings)} crossings, {len(between)} between the junctions ({100 * share:.0f} %); "
          f"median gap taken {median:.1f} s; {touched} people touched")
    print(f"waited under {SHORT:g} s ({len(soon)}) less over {LONG:g} s ({len(late)}): "
          f"{by_wait[0]:.2f} +- {by_wait[1]:.2f} s")
    print(f"seniors ({len(seniors)}) less adults ({len(adults)}): {by_age[0]:.2f} +- {by_age[1]:.2f} s")
    holds = {"over half walk to a crossing": share < 0.5,
             "median gap": LEAST <= median <= MOST,
             "shorter gaps after waiting": by_wait[0] - by_wait[1] > 0.0,
             "longer gaps of seniors": by_age[0] - by_age[1] > 0.0,
             "nobody touched": touched == 0}
    for name, held in holds.items():
        if not held:
            print(f"does not hold: {name}")
    sys.exit(0 if all(holds.values()) else 1)


if __name__ == "__main__":
    main()
