#!/usr/bin/python3
"""The experiments' measures on tracks drawn by hand, and the shuttle's paths against their source."""

import math
import sys
import unittest

import numpy

import experiment_measures as m
from experiment_checks import Mean, Share
from experiment_tracks import SCENARIOS, STEP, Run, Track, stars, vehicle_sizes
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

    def test_split_by_a_vehicle_that_never_gets_there(self):
        one = run({"a": walker(y=lambda t: 2.0), "b": walker(1.0, lambda t: 3.0)},
                  westbound(900.0))
        self.assertTrue(math.isnan(m.split(one, "av", 0.0)[2]))

    def test_off_course(self):
        self.assertAlmostEqual(m.off_course(walker(0.0, lambda t: t), 5.0, (40.0, 40.0)), 0.0)
        self.assertAlmostEqual(m.off_course(walker(), 5.0, (40.0, 35.0)), -45.0, delta=0.2)

    def test_box_distance(self):
        past = track(lambda t: t, lambda t: 5.0)
        self.assertAlmostEqual(m.box_distance(past, (20, 0, 30, 4)), 1.0 - 0.239)

    def test_sharpest(self):
        # From 1 m/s to 3 m/s at once, beside the vehicle: 2 m/s in COURSE.
        sudden = track(lambda t: t + 2.0 * max(0.0, t - 20.0), lambda t: 3.0)
        slow = track(lambda t: t + 0.1 * max(0.0, t - 10.0) ** 2, lambda t: 3.0)
        vehicle = westbound(60.0)
        self.assertAlmostEqual(m.sharpest(run({"a": sudden}, vehicle), "a", "av"), 4.0, delta=0.5)
        self.assertAlmostEqual(m.sharpest(run({"a": slow}, vehicle), "a", "av"), 0.2, delta=0.01)
        late = track(lambda t: t + 2.0 * max(0.0, t - 50.0), lambda t: 3.0)
        self.assertAlmostEqual(m.sharpest(run({"a": late}, vehicle), "a", "av"), 0.0, delta=0.01)

    def test_foreseen(self):
        # One walks towards who stands 30 m ahead: through it, past it from 2 s and from 1.2 s before.
        stands = track(lambda t: 30.0, lambda t: 0.0)
        gap = 2 * m.RADIUS
        for aside, expected in ((99.0, [0.0]), (30.0 - gap - 2.0, []), (30.0 - gap - 1.2, [1.0])):
            walks = walker(y=lambda t, since=aside: 1.0 if t >= since else 0.0)
            found = m.foreseen(run({"a": walks, "b": stands}), TIMES)
            self.assertEqual(len(found), len(expected), aside)
            for value, right in zip(found, expected):
                self.assertAlmostEqual(value, right, delta=0.06)
        beside = run({"a": walker(y=lambda t: gap + 0.01), "b": stands})
        self.assertEqual(m.foreseen(beside, TIMES), [])

    def test_turns_and_kept_speed(self):
        def westward(y, speed=lambda t: 1.0):
            return track(lambda t: 40.0 - t * speed(t), y, 270.0)

        alone = {"a": walker(), "b": westward(lambda t: 0.0)}
        # They meet at 20 s; b is aside from 17 s on, 6 m before.
        met = run({"a": walker(), "b": westward(lambda t: 1.0 if t >= 17.0 else 0.0)})
        self.assertAlmostEqual(m.turns(met, alone, "a", "b"), 6.0, delta=0.3)
        self.assertEqual(m.turns(run(alone), alone, "a", "b"), 0.0)
        self.assertAlmostEqual(m.kept_speed(run(alone), "a", "b"), 1.0)
        held_up = track(lambda t: min(t, 19.0) + 0.25 * min(2.0, max(0.0, t - 19.0))
                        + max(0.0, t - 21.0), lambda t: 0.0)
        self.assertAlmostEqual(m.kept_speed(run({"a": held_up, "b": alone["b"]}), "a", "b"), 0.25,
                               delta=0.01)

    def test_shares(self):
        one = run({"a": walker(y=lambda t: 0.3), "b": walker(y=lambda t: 2.0 - 0.1 * (t > 9))})
        shares = m.shares(one, {"a": 0.0, "b": 2.0})
        self.assertAlmostEqual(shares["a"] / sum(shares.values()), 0.75)


class Checks(unittest.TestCase):
    def test_seeds_that_were_not_asked_do_not_count(self):
        rows = [{"x": 1.0}, {"x": None}, {"x": 3.0}]
        self.assertTrue(Share("", "x", least=0.5).result(rows)[0])
        self.assertFalse(Share("", "x", least=2.0).result(rows)[0])
        self.assertFalse(Share("", "x", least=0.5).result([{"x": None}])[0])  # nobody was asked

    def test_failed_beyond_doubt(self):
        rows = [{"x": value} for value in (1.0, 1.1, 0.9, 1.0, 1.0)]
        self.assertTrue(Mean("", "x", least=2.0).failed(rows))
        self.assertFalse(Mean("", "x", least=1.0).failed(rows))  # the interval reaches over it
        self.assertTrue(Share("", "x", least=1.05).failed(rows))
        self.assertFalse(Share("", "x", least=1.0).failed(rows))


class Files(unittest.TestCase):
    def test_paths_are_those_of_their_source(self):
        for name, steering in paths.STEERINGS.items():
            self.assertEqual((SCENARIOS / f"5.1-{name}.csv").read_text(), paths.steered(steering))

    def test_fully_steered_the_shuttle_drives_at_them(self):
        at = stars("5.1")
        last = float(paths.steered(1.0).splitlines()[-1].split(",")[2])
        self.assertAlmostEqual(last, at["goal.a"][1])
        _, width = vehicle_sizes(SCENARIOS / "5.1.rou.xml")["av"]
        self.assertLess(abs(last - at["goal.b"][1]), width / 2)

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
