"""What the cases' own measures find, on positions and trips made by hand."""
import sys
import unittest
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "check"))
import cases  # noqa: E402  (found only now)
import judge  # noqa: E402
from fcd import Fcd, PersonRows, VehicleRows  # noqa: E402
from outputs import PersonTrip, Run, Stage  # noqa: E402
from overlap import ENTRY, TOLERANCE, find_overlaps  # noqa: E402

RADIUS = 0.239  # [m] of SUMO's person
PERIOD = 0.5  # [s]


def fcd_of(frames):
    """FCD of frames {who: (x, y)}, PERIOD apart."""
    rows = [(step, who, *place) for step, frame in enumerate(frames)
            for who, place in sorted(frame.items())]
    step, who, x, y = (numpy.array(column) for column in zip(*rows))
    none = numpy.zeros(0)
    zeros = numpy.zeros(len(rows))
    names = [f"p{number}" for number in range(int(max(who)) + 1)]
    people = PersonRows(names, step, who, x.astype(float), y.astype(float), zeros, zeros,
                        zeros.astype(int), ["e"])
    return Fcd(numpy.arange(len(frames)) * PERIOD, people,
               VehicleRows([], none, none, none, none, none, none, []))


def overlaps_of(frames, **options):
    fcd = fcd_of(frames)
    radius = numpy.full(len(fcd.persons.names), RADIUS)
    return find_overlaps(fcd, numpy.ones(len(fcd.persons.x), bool), radius, **options)


def approach(distance):
    """Two who are apart, and then so near, far from where they began."""
    return [{0: (-50.0, 0.0), 1: (50.0, 0.0)}, {0: (0.0, 0.0), 1: (distance, 0.0)}]


class Overlap(unittest.TestCase):
    def test_turned_bodies_may_come_as_near_as_half_their_widths(self):
        self.assertEqual(len(overlaps_of(approach(RADIUS)).first), 0)
        self.assertEqual(len(overlaps_of(approach(RADIUS - 0.009)).first), 0)

    def test_bodies_that_come_nearer_overlap(self):
        found = overlaps_of(approach(RADIUS - 0.02))
        self.assertEqual(len(found.first), 1)
        self.assertAlmostEqual(found.depth[0], 0.02)
        self.assertAlmostEqual(found.nearest, (RADIUS - 0.02) / (2 * RADIUS))

    def test_bodies_that_do_not_turn_need_their_full_widths(self):
        self.assertEqual(len(overlaps_of(approach(RADIUS), turned=1.0).first), 1)

    def test_who_begins_upon_somebody_may_until_both_have_left_the_place(self):
        pairs = [{0: (x, 0.0), 1: (x + 0.05, 0.0)} for x in (0.0, ENTRY - 0.2, ENTRY + 0.2)]
        found = overlaps_of(pairs)
        self.assertEqual(len(found.first), 1)

    def test_who_gets_off_a_bus_begins_anew(self):
        walks, rides = {0: (-50.0, 0.0), 1: (50.0, 0.0)}, {1: (0.0, 0.0)}
        gets_off = {0: (0.0, 0.05), 1: (0.0, 0.0)}
        self.assertEqual(len(overlaps_of([walks, rides, gets_off]).first), 0)

    def test_every_pair_is_found_once_wherever_it_stands(self):
        rng = numpy.random.default_rng(7)
        places = rng.uniform(-6.0, 6.0, (300, 2))
        far = {who: (100.0 * who, 0.0) for who in range(len(places))}
        found = overlaps_of([far, dict(enumerate(map(tuple, places)))])
        wanted = {(one, other) for one in range(len(places)) for other in range(one)
                  if numpy.hypot(*(places[one] - places[other])) < RADIUS - TOLERANCE}
        who = fcd_of([far, dict(enumerate(map(tuple, places)))]).persons.who
        pairs = [tuple(sorted((who[one], who[other]), reverse=True))
                 for one, other in zip(found.first, found.second)]
        self.assertEqual(len(pairs), len(set(pairs)))
        self.assertEqual(set(pairs), wanted)
        self.assertGreater(len(wanted), 10)


def run_of(arrivals, depart=0.0):
    """A run in which people walk; arrivals: {person: [s] or None}."""
    return Run("", None, {name: PersonTrip("walker", depart, [Stage("walk", depart, arrival)])
                          for name, arrival in arrivals.items()}, {})


class Judgement(unittest.TestCase):
    def broken(self, plain, own, limits=cases.Limits(), **fields):
        verdict = judge.Verdict("case", 1, walked=len(own))
        judge.compare(verdict, run_of(plain), run_of(own))
        for name, value in fields.items():
            setattr(verdict, name, value)
        return list(judge.broken_limits(limits, verdict))

    def test_as_many_in_the_same_time_hold(self):
        self.assertEqual(self.broken({"a": 100.0, "b": 90.0}, {"a": 110.0, "b": 90.0}), [])

    def test_fewer_than_99_percent_of_striping_do_not(self):
        plain = {f"p{i}": 100.0 for i in range(100)}
        self.assertEqual(self.broken(plain, {**plain, "p0": None}), [])
        self.assertEqual(len(self.broken(plain, {**plain, "p0": None, "p1": None})), 1)

    def test_who_jams_with_striping_too_is_not_asked_for(self):
        plain = {"a": 100.0, "b": None}
        self.assertEqual(self.broken(plain, plain), [])
        self.assertEqual(len(self.broken(plain, plain, cases.Limits(everybody=True))), 1)

    def test_slower_than_1_25_times_does_not(self):
        self.assertEqual(self.broken({"a": 100.0}, {"a": 125.0}), [])
        self.assertTrue(self.broken({"a": 100.0}, {"a": 126.0}))

    def test_overlaps_and_people_thrown_about_do_not(self):
        same = {"a": 100.0}
        self.assertEqual(len(self.broken(same, same, overlaps=1, jumps=1, outside=1, lost=1)), 4)

    def test_a_run_that_pedzone_had_no_part_in_does_not(self):
        self.assertEqual(len(self.broken({"a": 100.0}, {"a": 100.0}, walked=0)), 1)


class Choice(unittest.TestCase):
    def test_every_two_values_of_footways_meet_in_some_case(self):
        def pairs(footways):
            names = list(cases.FOOTWAY_VALUES)
            return {(one, getattr(footway, one), other, getattr(footway, other))
                    for footway in footways for one in names for other in names}
        self.assertEqual(pairs(cases.footways()), pairs(cases.all_footways()))

    def test_the_sample_has_every_kind(self):
        self.assertEqual({type(case) for case, _ in cases.sample()},
                         {type(case) for case in cases.all_cases()})
        self.assertEqual({case.shape for case, _ in cases.sample()
                          if isinstance(case, cases.Footway)}, set(cases.SHAPES))


if __name__ == "__main__":
    unittest.main()
