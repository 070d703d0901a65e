"""TTC, DRAC and PET from Python, against formulas."""
import math
import unittest

import numpy

import pedzone

LENGTH, WIDTH, RADIUS = 4.0, 2.0, 0.25
SIZES = {"length": LENGTH, "width": WIDTH, "radius": RADIUS}


class Moments(unittest.TestCase):
    def test_a_vehicle_that_comes_up_from_behind(self):
        gaps = numpy.array([2.0, 10.0, 35.5])
        n, fast, slow = len(gaps), 8.0, 1.5
        person = numpy.stack([gaps + LENGTH / 2 + RADIUS, numpy.zeros(n)], axis=1)
        at = (person, [(slow, 0)] * n, numpy.zeros((n, 2)), [(fast, 0)] * n, numpy.zeros(n))
        numpy.testing.assert_allclose(pedzone.clearance(*at, **SIZES), gaps)
        numpy.testing.assert_allclose(pedzone.time_to_contact(*at, **SIZES), gaps / (fast - slow))
        numpy.testing.assert_allclose(pedzone.deceleration_to_avoid(*at, **SIZES),
                                      (fast - slow) ** 2 / (2 * gaps))

    def test_it_is_the_same_in_any_direction(self):
        turn, n = 2.3, 1
        axis = numpy.array([[math.cos(turn), math.sin(turn)]])
        ttc = pedzone.time_to_contact(axis * (10 + LENGTH / 2 + RADIUS), numpy.zeros((n, 2)),
                                      numpy.zeros((n, 2)), 5 * axis, [turn], **SIZES)
        self.assertAlmostEqual(ttc[0], 2.0)

    def test_those_who_never_touch_have_none(self):
        away = ([(10, 0)], [(3, 0)], [(0, 0)], [(2, 0)], [0.0])
        self.assertTrue(math.isnan(pedzone.time_to_contact(*away)[0]))
        self.assertTrue(math.isnan(pedzone.deceleration_to_avoid(*away)[0]))

    def test_other_shapes_are_refused(self):
        with self.assertRaisesRegex(ValueError, r"vehicle: shape \(2, 2\); allowed: \(1, 2\)"):
            pedzone.time_to_contact([(0, 0)], [(0, 0)], [(1, 1), (2, 2)], [(0, 0)], [0.0])
        with self.assertRaisesRegex(ValueError, "length, width, radius"):
            pedzone.clearance([(0, 0)], [(0, 0)], [(1, 1)], [(0, 0)], [0.0], radius=0)


def crossing(delay, speed=5.0, walk=1.25):
    """A person crosses at x = 0; the vehicle's front would be there `delay` seconds after it."""
    time = numpy.arange(0, 20, 0.1)
    person = numpy.stack([numpy.zeros_like(time), walk * (time - 10)], axis=1)
    front = speed * (time - 10 - delay)
    vehicle = numpy.stack([front - LENGTH / 2, numpy.zeros_like(time)], axis=1)
    return time, person, vehicle, numpy.zeros_like(time)


class Trajectories(unittest.TestCase):
    def all_of(self, *trajectories):
        return pedzone.conflicts(*trajectories, ttc=60, pet=60, drac=0, **SIZES)

    def test_pet_of_a_person_who_crosses_first(self):
        """It leaves the vehicle's lane when its rear rim has passed half the width; then the front
        comes to that place as late as the formula says. 2 cm of a corner cut: 0.01 s."""
        delay, walk, speed = 3.0, 1.25, 5.0
        one, = self.all_of(*crossing(delay))
        leaves = (WIDTH / 2 + RADIUS) / walk
        self.assertEqual(one.first, "person")
        self.assertEqual(one.type, "crossingRight")  # it walks to the north, the vehicle to the east
        # At the far side of the lane the person's rim touches; the vehicle's front reaches x = 0
        # less what the disc stands before it there.
        self.assertAlmostEqual(one.pet.value, delay - leaves, delta=RADIUS / speed + 0.02)
        self.assertIsNone(one.contact)

    def test_contact_is_told_with_its_speed(self):
        one, = self.all_of(*crossing(0.0))
        self.assertAlmostEqual(one.contact.value, math.hypot(5.0, 1.25), places=6)
        self.assertEqual(one.ttc.value, 0.0)
        self.assertLess(one.clearance.value, 0)

    def test_limits_say_what_is_told(self):
        far = crossing(4.0)
        self.assertEqual(len(self.all_of(*far)), 1)
        self.assertEqual(pedzone.conflicts(*far, ttc=0, pet=1.0, drac=100, **SIZES), [])

    def test_velocities_may_be_given(self):
        time, person, vehicle, heading = crossing(1.5)
        moving = {"person_velocity": [(0, 1.25)] * len(time), "vehicle_velocity": [(5.0, 0)] * len(time)}
        given = pedzone.conflicts(time, person, vehicle, heading, **moving, **SIZES)
        found = pedzone.conflicts(time, person, vehicle, heading, **SIZES)
        self.assertAlmostEqual(given[0].pet.value, found[0].pet.value, places=6)

    def test_mistakes_are_named(self):
        time, person, vehicle, heading = crossing(1.0)
        with self.assertRaisesRegex(ValueError, "time: allowed: each later"):
            pedzone.conflicts(time[::-1], person, vehicle, heading)
        for limit in ("ttc", "pet", "drac", "range", "horizon"):
            with self.assertRaisesRegex(ValueError, f"{limit}: -1; allowed: 0 to"):
                pedzone.conflicts(time, person, vehicle, heading, **{limit: -1})
        with self.assertRaisesRegex(ValueError, r"person: shape \(5, 2\)"):
            pedzone.conflicts(time, person[:5], vehicle, heading)


if __name__ == "__main__":
    unittest.main()
