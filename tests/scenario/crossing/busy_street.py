#!/usr/bin/python3
"""A street of 7 m between two zebra crossings: who walks to one of them, and which gaps the others
take.

usage: busy_street.py PEDZONE [--seeds N] [--model M] [--keep FOLDER]

From SUMO's own floating-car data of all seeds together, with 2,400 cars an hour and people who walk from
anywhere to anywhere:
- more than half of those who cross do so at a zebra crossing
- the median gap that is taken between them lies between 3 s, the least in a single stream (DiPietro and
  King 1970), and 9.4 s, the longest 85th percentile of 11 crossings (Brewer et al. 2006)
- nobody stands for over 300 s, nobody is touched at more than 0.5 m/s
With 1,800 cars and doors opposite each other, for which people wait longer:
- gaps taken are shorter after a longer wait: adults only, since who walks slowly waits longer and needs
  more, too
- seniors take longer gaps than adults
Both are differences of means with their 95 % intervals, of gaps up to 20 s: longer ones everybody takes.
`--model constant-velocity` must fail: it does not look.
"""
import bisect
import math
import statistics
import sys
from typing import NamedTuple

import street

BUSY, LESS_BUSY = 2400, 1800  # cars an hour
PEOPLE = 300  # an hour
BEGIN, END = 1800, 2400  # [s] until when cars and people come, and are watched
KERB, NEAR, FAR = 3.5, 2.9, -0.6  # [m] from the middle of the street: where a body has left the
                                  # kerb, and where it comes to the cars of the two lanes
WEST, EAST = 8.0, 207.0  # [m] x of its ends
WAITS = 0.3  # [m/s] who is slower waits
SHORT, LONG = 10.0, 40.0  # [s] waited less, and more
LEAST, MOST = 3.0, 9.4  # [s]
LONGEST_GAP, LONGEST_STAND = 20.0, 300.0  # [s]
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


class Crossing(NamedTuple):
    """One walk from one side to the other."""
    between: bool  # the junctions
    waited: float  # [s]
    gap: float  # [s] that was taken; infinity: no car came
    kind: str  # of person


def crossing_of(walk, passes, kind):
    """None of a walk that does not get to the other side, or not while cars come."""
    track = walk.track
    begin, end = track[0][2], track[-1][2]
    if begin * end > 0 or abs(end) < KERB:
        return None
    side = 1 if begin < 0 else -1  # 1: northward, over the eastward lane first
    on_road = [place for place in track if abs(place[2]) < KERB - 0.1]
    if not on_road or not WEST < on_road[0][1] < EAST:
        return Crossing(False, 0.0, math.inf, kind)
    out, x = on_road[0][:2]
    if out > BEGIN:
        return None  # no cars come any more
    near, far = (next((t for t, _, y in on_road if y * side > -line), on_road[-1][0])
                 for line in (NEAR, FAR))
    waited = sum(b[0] - a[0] for a, b in zip(track, track[1:])
                 if b[0] <= out and math.dist(a[1:], b[1:]) < WAITS * (b[0] - a[0]))
    gap = min(passes.next(side, x, near), passes.next(-side, x, far)) - out
    return Crossing(True, waited, gap, kind)


def observe(given, cars, places):
    """(all crossings, faults) of all seeds with so many cars an hour."""
    crossings, faults = [], []
    for seed in range(1, given.seeds + 1):
        folder = given.keep / f"{cars}-{seed}"
        routes = street.demand(seed, cars, PEOPLE, BEGIN, places, TYPES)
        street.write_scenario(folder, routes, END)
        street.run_pedzone(folder, given.program, seed, *given.model)
        seen = street.read_fcd(folder / "pedzone.fcd.xml")
        passes = Passes(seen.cars)
        types = street.read_types(folder / "pedzone.trips.xml")
        crossings += filter(None, (crossing_of(walk, passes, types[name])
                                   for name, walk in seen.walks.items()))
        faults += [f"seed {seed}: {person} is touched by {car} at {time:.1f} s, {speed:.1f} m/s"
                   for time, person, car, speed in seen.contacts if speed > 0.5]
        faults += [f"seed {seed}: {name} stands for {walk.longest_stand():.0f} s"
                   for name, walk in seen.walks.items() if walk.longest_stand() > LONGEST_STAND]
    between = [one for one in crossings if one.between]
    print(f"{cars} cars an hour: {len(crossings)} crossings, {len(between)} between the junctions "
          f"({100 * len(between) / len(crossings):.0f} %); {len(faults)} faults")
    for fault in faults[:5]:
        print(fault)
    return crossings, faults


def gaps(crossings, kind, least_wait=0.0, most_wait=math.inf):
    """[s] that those of a kind took between the junctions who had waited so long."""
    return [one.gap for one in crossings if one.kind == kind and one.gap < LONGEST_GAP and
            least_wait <= one.waited < most_wait]


def difference(first, second):
    """Mean of the first less that of the second, and half its 95 % interval."""
    if min(len(first), len(second)) < 2:
        return 0.0, math.inf
    mean = statistics.mean(first) - statistics.mean(second)
    half = 1.96 * math.sqrt(statistics.variance(first) / len(first) +
                            statistics.variance(second) / len(second))
    return mean, half


def main():
    given = street.options(__doc__, seeds=10)
    busy, faults = observe(given, BUSY, anywhere)
    less_busy, more_faults = observe(given, LESS_BUSY, street.straight_across)
    share = sum(one.between for one in busy) / len(busy)
    taken = [one.gap for one in busy if math.isfinite(one.gap)]
    median = statistics.median(taken) if taken else math.nan
    soon, late = (gaps(less_busy, "adult", most_wait=SHORT),
                  gaps(less_busy, "adult", least_wait=LONG))
    seniors, adults = (gaps(less_busy, kind) for kind in ("senior", "adult"))
    by_wait, by_age = difference(soon, late), difference(seniors, adults)
    print(f"{BUSY}: median gap taken {median:.1f} s")
    print(f"{LESS_BUSY}: adults who waited under {SHORT:g} s ({len(soon)}) less over {LONG:g} s "
          f"({len(late)}): {by_wait[0]:.2f} +- {by_wait[1]:.2f} s")
    print(f"{LESS_BUSY}: seniors ({len(seniors)}) less adults ({len(adults)}): {by_age[0]:.2f} +- "
          f"{by_age[1]:.2f} s")
    holds = {"over half walk to a crossing": share < 0.5,
             "median gap": LEAST <= median <= MOST,
             "shorter gaps after waiting": by_wait[0] - by_wait[1] > 0.0,
             "longer gaps of seniors": by_age[0] - by_age[1] > 0.0,
             "no faults": not faults and not more_faults}
    for name, held in holds.items():
        if not held:
            print(f"does not hold: {name}")
    sys.exit(0 if all(holds.values()) else 1)


if __name__ == "__main__":
    main()
