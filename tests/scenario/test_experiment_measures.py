#!/usr/bin/python3
"""The experiments' measures on tracks drawn by hand, and the shuttle's paths against their source."""

import math
import sys
import unittest

import numpy

import experiment_measures as m
from experiment_tracks import SCENARIOS, STEP, Run, Track
from line_chart import ticks

sys.path.insert(0, str(SCENARIOS))
import paths  # noqa: E402

TIMES = numpy.arange(0.0, 60.0, STEP)


def track(x, y, angle=90.0):
    """Of functions of time."""
    return Track(TIMES, numpy.array([float(x(t)) for t in TIMES]),
                 numpy.array([float(y(t)) for t in TIMES]), numpy.full(len(TIMES), angle))


def walker(start=0.0, y=lambda t: 0.0, speed=1.0):
    return track(lambda t: start + speed * t, y)


def westbound(start=80.0, speed=2.0, y=0.0):
    """A vehicle 4 m x 2 m."""
    return track(lambda t: start - speed * t, lambda t: y, 270.0)


def run(persons, vehicle=None):
    return Run(persons, {"av": vehicle} if vehicle else {}, {"av": (4.0, 2.0)})


class Measures(unittest.TestCase):
    def test_gap_to_a_rectangle(self):
        # Its front at 20 m stands; the body reaches from there to 24 m and 1 m to each side.
        for x, y, expected in ((17, 0, 3), (22, 3, 2), (28, 0, 4), (22, 0.5, 0),
                               (17, 5, 5), (27, -5, 5)):
            one = run({"a": track(lambda t: x, lambda t: y)}, westbound(20.0, 0.0))
            self.assertAlmostEqual(m.clearance(one, "av"), expected)

    def test_onset(self):
        # At 10 s it steps 1 m aside, 60 - 10 m before a vehicle that is nearest at 20 s.
        aside = run({"a": walker(y=lambda t: 2.0 if t >= 10 else 0.5)}, westbound(60.0))
        control = run({"a": walker(y=lambda t: 0.5)}, westbound(60.0))
        gap, time = m.onset(aside, control, "a", "av")
        self.assertAlmostEqual(gap, math.hypot(30.0, 1.0), delta=0.4)
        self.assertTrue(9.9 < time < 10.0 + 4 / 3 + 0.1, time)  # it takes 4/3 s to pass
        self.assertEqual(m.onset(control, control, "a", "av"), (0.0, 0.0))

    def test_likeness(self):
        def bump(at, sign=1.0):
            return lambda t: 3.0 + sign * math.exp(-((t - at) / 3.0) ** 2)

        vehicle = westbound(60.0, 1.0)
        same = run({"a": walker(0.0, bump(30)), "b": walker(10.0, bump(25))}, vehicle)
        other = run({"a": walker(0.0, bump(30)), "b": walker(10.0, bump(25, -1.0))}, vehicle)
        lines = {"a": 3.0, "b": 3.0}
        self.assertGreater(m.likeness(same, lines, "av"), 0.99)
        self.assertLess(m.likeness(other, lines, "av"), -0.99)

    def test_waits(self):
        stands = track(lambda t: min(t, 10.0) + max(0.0, t - 20.0), lambda t: 0.0)
        short = track(lambda t: min(t, 10.0) + max(0.0, t - 10.5), lambda t: 0.0)
        ends = track(lambda t: min(t, 10.0), lambda t: 0.0)
        for one, expected in ((stands, 1), (short, 0), (ends, 0), (walker(), 0)):
            both = run({"a": one, "b": walker(5.0)})
            self.assertEqual(m.waits(both, TIMES), expected)
        self.assertEqual(m.waits(run({"a": stands, "b": stands}), TIMES), 0)  # nobody walks

    def test_changes(self):
        slow, quick = walker(5.0, speed=1.0), walker(0.0, speed=1.2)
        x, _ = m.places(run({"a": slow, "b": quick}), TIMES)
        self.assertEqual(m.changes(x), 1)
        x, _ = m.places(run({"a": slow, "b": walker(5.2, speed=1.0)}), TIMES)
        self.assertEqual(m.changes(x), 0)

    def test_spread(self):
        one = run({"a": walker(), "b": walker(3.0, lambda t: 4.0), "c": walker(1.0)})
        self.assertAlmostEqual(float(m.spread(one, TIMES).max()), 5.0)

    def test_split_and_rejoin(self):
        def apart(sign):
            """Aside from 20 s to 30 s."""
            return lambda t: sign * (2.0 if 20 <= t < 30 else 0.5)

        persons = {"a": walker(0.0, apart(1)), "b": walker(1.0, apart(-1)),
                   "c": walker(2.0, apart(1))}
        one = run(persons, westbound(82.0))  # it meets them at about 27 s
        north, south, gap = m.split(one, "av", 0.0)
        self.assertEqual((north, south), (2, 1))
        self.assertAlmostEqual(gap, 82 - 2 * 20 - (20 + 2), delta=0.4)
        # Its rear is behind the last at (82 + 4) / 3 s.
        self.assertAlmostEqual(m.rejoin(one, "av", 5.0, 2.0), 30 - 86 / 3, delta=0.2)
        never = run({"a": walker(0.0, lambda t: 2.0), "b": walker(1.0, lambda t: -2.0)},
                    westbound(82.0))
        self.assertTrue(math.isnan(m.rejoin(never, "av", 5.0, 2.0)))

    def test_no_split(self):
        one = run({"a": walker(y=lambda t: 2.0), "b": walker(1.0, lambda t: 3.0)},
                  westbound(82.0))
        self.assertEqual(m.split(one, "av", 0.0)[:2], (2, 0))
        self.assertTrue(math.isnan(m.split(one, "av", 0.0)[2]))

    def test_off_course(self):
        self.assertAlmostEqual(m.off_course(walker(0.0, lambda t: t), 5.0, (40.0, 40.0)), 0.0)
        self.assertAlmostEqual(m.off_course(walker(), 5.0, (40.0, 35.0)), -45.0, delta=0.2)

    def test_box_distance(self):
        past = track(lambda t: t, lambda t: 5.0)
        self.assertAlmostEqual(m.box_distance(past, (20, 0, 30, 4)), 1.0 - 0.239)

    def test_shares(self):
        one = run({"a": walker(y=lambda t: 0.3), "b": walker(y=lambda t: 2.0 - 0.1 * (t > 9))})
        shares = m.shares(one, {"a": 0.0, "b": 2.0})
        self.assertAlmostEqual(shares["a"] / sum(shares.values()), 0.75)


class Files(unittest.TestCase):
    def test_paths_are_those_of_their_source(self):
        for name, steering in paths.STEERINGS.items():
            self.assertEqual((SCENARIOS / f"5.1-{name}.csv").read_text(), paths.steered(steering))

    def test_ticks_are_round_and_cover(self):
        for low, high in ((0, 1.25), (0, 130), (2.5, 70), (-0.3, 0.4), (0, 0.012), (3, 3)):
            found = ticks(low, high)
            self.assertLessEqual(found[0], low)
            self.assertGreaterEqual(found[-1], high)
            self.assertLessEqual(len(found), 9)
            step = (found[1] - found[0]) if len(found) > 1 else 1.0
            digits = round(step / 10 ** math.floor(math.log10(step) + 1e-9), 6)
            self.assertIn(digits, (1.0, 2.0, 5.0))


if __name__ == "__main__":
    unittest.main()
